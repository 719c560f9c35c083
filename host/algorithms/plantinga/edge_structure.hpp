// The structure of one edge in one view: its visible pieces and the kind of each of their ends.
//
// A piece of the edge structure graph ends in a vertex of its edge or in a T-junction with the edge that hides the rest.
// A piece of an edge parallel to the plane of rotation may end at a vertex of the same height, which stays on the line of
// the edge as the scene turns (a permanent contact; the paper has no name for it). If solids touch, a piece may also end
// where the edge passes through the plane of a face, at a point of the face's boundary.
//
// Rule, as for all exact pictures here: a point of an edge is hidden iff it is hidden in the limit from both sides of the
// image line of the edge by faces strictly nearer. If several edges end a hidden part at the same point, the one with the
// least number is recorded, so that equal views have equal structures.
//
// From scratch (the paper's "standard hidden-line removal"): the edge is compared with every face that may hide part of
// it, and the hidden parts are united; the rest is visible. Exact: 64 and 128 bits for directions below sight_limit,
// WideIntegers beyond.
#pragma once

#include <cstdint>
#include <vector>

#include "host/algorithms/plantinga/candidate_filter.hpp"
#include "host/algorithms/plantinga/direction.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"

namespace sightline::algorithms::plantinga {

enum class EndKind : std::uint32_t { vertex = 0, junction = 1, contact = 2, passage = 3 };

// Two bits for the kind, thirty for the index of a vertex (vertex, contact), an edge (junction) or a face (passage).
struct End {
  std::uint32_t bits = 0;

  [[nodiscard]] static constexpr End of(EndKind kind, std::uint32_t index) {
    return {(static_cast<std::uint32_t>(kind) << 30U) | index};
  }
  [[nodiscard]] constexpr EndKind kind() const { return static_cast<EndKind>(bits >> 30U); }
  [[nodiscard]] constexpr std::uint32_t index() const { return bits & 0x3FFFFFFFU; }

  friend constexpr bool operator==(const End&, const End&) = default;
};

struct Piece {
  End low;  // the end towards the lower vertex of the edge
  End high;

  friend bool operator==(const Piece&, const Piece&) = default;
};

// The visible pieces of one edge, in its direction.
using EdgeStructure = std::vector<Piece>;

// The position of a piece: fractions of the edge, not in lowest terms, with parts below 2^63.
struct PieceRange {
  std::int64_t low = 0;
  std::int64_t low_of = 1;
  std::int64_t high = 1;
  std::int64_t high_of = 1;
};

// Precondition: the parts of the sight are below sight_limit. `ranges`, if given, receives the positions of the pieces.
[[nodiscard]] EdgeStructure structure_at(const RotationModel& model, EdgeIndex edge,
                                         const std::vector<Occluder>& occluders, const Sight& sight,
                                         std::vector<PieceRange>* ranges = nullptr);

class Trace;

// The same; reports to `trace`.
[[nodiscard]] EdgeStructure structure_at(const RotationModel& model, EdgeIndex edge,
                                         const std::vector<Occluder>& occluders, const Sight& sight,
                                         std::vector<PieceRange>* ranges, Trace& trace);

// The structure between two different directions, the second after the first. Uses small integers if possible.
[[nodiscard]] EdgeStructure structure_between(const RotationModel& model, EdgeIndex edge,
                                              const std::vector<Occluder>& occluders, const Direction& a,
                                              const Direction& b);

// The same, always with long integers. Precondition: b is ahead of a by less than pi.
[[nodiscard]] EdgeStructure wide_structure_between(const RotationModel& model, EdgeIndex edge,
                                                   const std::vector<Occluder>& occluders, const Direction& a,
                                                   const Direction& b);

// The history of one edge in a full turn: its structure before the first event, and after each event.
//
// Algorithm A of the asp specification: potential events of the edge with everything that may hide part of it are
// filtered, ordered exactly, and grouped if equal; between every two, the edge's hidden lines are removed from scratch;
// events without a change are dropped. The result is the visible part of the edge's surface (u, v)(s, theta) in aspect
// space, from which the paper subtracts the aspect representations of all faces: V_e = [0, 1] x circle without the hidden
// parts, stored as slices between critical angles.

struct EdgeChange {
  Direction direction;
  EdgeStructure after;
};

struct EdgeHistory {
  EdgeStructure first;              // just after -pi, and again after the last change
  std::vector<EdgeChange> changes;  // ascending by direction
  std::uint64_t candidates = 0;     // directions at which the structure was computed
};

// `trace`, if given, receives the steps.
[[nodiscard]] EdgeHistory history_of(const RotationModel& model, const ConvexParts& parts, EdgeIndex edge,
                                     Trace* trace = nullptr);

}  // namespace sightline::algorithms::plantinga
