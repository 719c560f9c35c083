// Finds all directions at which the structure of one edge may change, and few others:
//
//   one of the edge's own faces is edge-on, or the plane of the edge and an edge that meets it in a vertex is;
//   a nearer vertex is on the edge, or an end of the edge is behind a nearer edge (EV);
//   a face before the edge is edge-on and the edge crosses its image (FE);
//   two nearer contours cross on the edge (EEE); if they meet in a vertex, their plane is edge-on.
// An event changes only the structure of its farthest edge; on other edges nothing starts or ends there.
#pragma once

#include <vector>

#include "host/algorithms/plantinga/candidate_filter.hpp"

namespace sightline::algorithms::plantinga {

class Trace;

// Ascending, without duplicates. `trace`, if given, receives each of them and those that the filter drops.
[[nodiscard]] std::vector<Direction> candidates_of(const RotationModel& model, const ConvexParts& parts,
                                                   EdgeIndex edge, const std::vector<Occluder>& occluders,
                                                   Trace* trace = nullptr);

}  // namespace sightline::algorithms::plantinga
