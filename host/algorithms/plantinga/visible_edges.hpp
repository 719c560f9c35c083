// Exact pictures of a scene in parallel projection along directions without a y component: from scratch, or from edge
// structures, whose ends are computed as fractions (equation 5a).
#pragma once

#include <optional>

#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::plantinga {

// The sight of a camera; nullopt for a camera in perspective or with a line of sight that is not parallel to the plane of
// rotation. The camera may be rolled, which does not change visibility.
[[nodiscard]] std::optional<Sight> sight_of(const scene::PolyCamera& camera);

// The camera that looks along a sight, with u to the right and y up. Precondition: the parts of the sight are below 2^15.
[[nodiscard]] scene::PolyCamera camera_of(const Sight& sight);

// Removes the hidden lines of the whole scene from scratch. Precondition: the parts of the sight are below 2^15, so that
// parameters are fractions of 63 bits.
[[nodiscard]] picture::LinePicture visible_edges(const RotationModel& model, const Sight& sight);

// The same; reports every edge to `trace`.
[[nodiscard]] picture::LinePicture visible_edges(const RotationModel& model, const Sight& sight, Trace& trace);

// Appends the pieces of one edge. Precondition: the structure belongs to a direction with parts below 2^15 that is not an
// event of the edge.
void append_pieces(const RotationModel& model, EdgeIndex edge, const EdgeStructure& structure,
                   const Sight& sight, std::vector<picture::LinePiece>& pieces);

}  // namespace sightline::algorithms::plantinga
