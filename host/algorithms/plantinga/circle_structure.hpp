// The structure of one edge, and the exact picture of a scene, from a place of the eye's circle: edge_structure.hpp and
// visible_edges.hpp for an EyeCircle instead of a direction without a y component.
#pragma once

#include <vector>

#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/algorithms/plantinga/eye_circle.hpp"
#include "host/picture/line_picture.hpp"

namespace sightline::algorithms::plantinga {

// Precondition, here and below: why_not(model, circle) is empty.
[[nodiscard]] EdgeStructure structure_at(const RotationModel& model, const EyeCircle& circle, EdgeIndex edge,
                                         const std::vector<Occluder>& occluders, const CirclePlace& place);

// Removes the hidden lines of the whole scene from scratch. Precondition: the quotients that give the ends, in lowest terms, are
// of numbers below 2^63; they are if p, q and all coordinates are small.
[[nodiscard]] picture::LinePicture visible_edges(const RotationModel& model, const EyeCircle& circle, const CirclePlace& place);

// Appends the pieces of one edge. Preconditions: the same; the structure is that of the place.
void append_pieces(const RotationModel& model, const EyeCircle& circle, EdgeIndex edge, const EdgeStructure& structure,
                   const CirclePlace& place, std::vector<picture::LinePiece>& pieces);

}  // namespace sightline::algorithms::plantinga
