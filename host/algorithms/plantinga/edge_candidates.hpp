// The directions at which the structure of one edge may change: all of them, and few others.
//
//   the edge's own faces edge-on, and planes of the edge and one that meets it in a vertex;
//   a nearer vertex on the edge, an end of the edge behind a nearer edge (EV);
//   a face before it edge-on (FE), where the edge crosses its image;
//   two nearer contours that cross on the edge (EEE); of two that meet in a vertex the plane edge-on.
// An event changes the structure of its farthest edge only: on the others nothing starts or ends there.
#pragma once

#include <vector>

#include "host/algorithms/plantinga/candidate_filter.hpp"

namespace sightline::algorithms::plantinga {

class Trace;

// Ascending, each once. `trace`, if given, is told of each and of those that the filter drops.
[[nodiscard]] std::vector<Direction> candidates_of(const RotationModel& model, const ConvexParts& parts,
                                                   EdgeIndex edge, const std::vector<Occluder>& occluders,
                                                   Trace* trace = nullptr);

}  // namespace sightline::algorithms::plantinga
