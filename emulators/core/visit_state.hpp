// How a machine shows its state to a snapshot: each class with state has one member template
//
//   template <class Visitor>
//   void visit_state(Visitor& visit);
//
// that names its members in a fixed order. The same function serves saving, restoring and describing, so that they
// cannot differ; the visitor is the caller's (host/guests/run/state.hpp is one), and this file is the contract.
//
//   visit(name, member)                   a bool, integer, core::Word, TickCount or TickInstant
//   visit(name, member, most)             an integer or enumerator from 0 to `most`
//   visit.count(name, member, most)       the same for a std::size_t, which has another width elsewhere
//   visit.words(name, span)               core memory; its size is a part of the configuration
//   visit.bytes(name, span, most)         the same for bytes of 0 to `most`
//   visit.part(name, what)                what.visit_state(visit), or what(visit) for a callable
//   visit.section(name, what)             the same; a section has a name and a length in the snapshot
//   visit.list(name, vector, each)        each(element) visits an element; elements are default-constructed
//   visit.present(name, optional, each)   likewise, for none or one
//   visit.input(name, span)               bytes that the configuration supplies: only length and checksum are stored
//   visit.output(name, vector, before)    what the machine has produced: only the count of it is stored. `before` counts
//                                         what was produced before the vector begins, because the machine was restored
//   visit.require(holds, name, expected)  a relation of members; on restoring, the snapshot is refused if it is false
//   Visitor::restores                     true: members are being assigned, and what follows from them is to be set again
//
// A member that a constructor sets and nothing changes is configuration, not state, and is not visited. A restored
// member is within its bounds, but relations hold only after `require`: until then no member may be used as an index.
#pragma once
