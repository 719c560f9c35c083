// All that happens to one edge in a full turn: its structure before the first event, and after each.
//
// Algorithm A of the asp specification: potential events of the edge with everything that may hide some of
// it, filtered, ordered exactly, equal ones grouped; hidden-line removal of the edge from scratch between
// each two; events without a change dropped. This is the visible part of the edge's surface (u, v)(s, theta)
// in aspect space, of which the paper subtracts the aspect representations of all faces: V_e = [0, 1] x
// circle less what faces hide, kept as its slices between critical angles.
#pragma once

#include <cstdint>
#include <vector>

#include "host/algorithms/plantinga/candidate_filter.hpp"
#include "host/algorithms/plantinga/edge_structure.hpp"

namespace sightline::algorithms::plantinga {

struct EdgeChange {
  Direction direction;
  EdgeStructure after;
};

struct EdgeHistory {
  EdgeStructure first;              // just after -pi, and again after the last change
  std::vector<EdgeChange> changes;  // ascending by direction
  std::uint64_t candidates = 0;     // directions at which the structure was looked at
};

[[nodiscard]] EdgeHistory history_of(const RotationModel& model, const ConvexParts& parts, EdgeIndex edge);

}  // namespace sightline::algorithms::plantinga
