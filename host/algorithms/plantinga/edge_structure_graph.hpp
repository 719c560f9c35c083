// The edge structure graph (ESG) of one view and its steps through the events of a turn: the on-line phase of
// Plantinga, Seales and Dyer (1990), section 4.
//
// Pieces are in one array with holes, those of an edge linked; a step touches only the edges that change.
// Every step checks that what it removes is there: a list from which an event was lost is found out.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/plantinga/event_list.hpp"

namespace sightline::algorithms::plantinga {

inline constexpr std::uint32_t no_edge = 0xFFFFFFFF;

struct LivePiece {
  EdgeIndex edge = no_edge;  // no_edge: a hole
  Piece piece;
  std::uint32_t next = no_edge;  // of the same edge
};

class EdgeStructureGraph {
 public:
  // Before the first event: just after -pi. The list outlives the graph and belongs to a model whose edges
  // are as many as list.first.
  explicit EdgeStructureGraph(const EventList& list);

  // Events passed since -pi, of list.events.size().
  [[nodiscard]] std::size_t passed() const { return passed_; }
  [[nodiscard]] std::span<const LivePiece> pieces() const { return pieces_; }
  [[nodiscard]] std::size_t piece_count() const { return count_; }
  [[nodiscard]] EdgeStructure structure_of(EdgeIndex edge) const;

  // Over one event, round the circle. False, and nothing done, if the list does not fit the graph.
  bool step_forward();
  bool step_backward();
  // The shorter way to an angle in radians, events at or before it being passed. False as above.
  bool turn_to(double angle);
  // The shorter way to where `passed` events are passed, at most list.events.size(). False as above.
  bool turn_to_place(std::size_t passed);

 private:
  bool apply(const Event& event, bool forward);
  void replace(EdgeIndex edge, std::span<const Piece> pieces);
  [[nodiscard]] bool is(EdgeIndex edge, std::span<const Piece> pieces) const;

  const EventList& list_;
  std::vector<double> angles_;  // of the events
  std::vector<LivePiece> pieces_;
  std::vector<std::uint32_t> first_;  // piece of an edge
  std::uint32_t hole_ = no_edge;      // holes are linked too
  std::size_t passed_ = 0;
  std::size_t count_ = 0;
};

}  // namespace sightline::algorithms::plantinga
