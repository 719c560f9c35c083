// Exact pictures of a scene in parallel projection along directions without y: from scratch, and from an edge
// structure by the positions of its ends (equation 5a), which are fractions.
#pragma once

#include <optional>

#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::plantinga {

// Where the viewer of a camera stands; nothing for a camera in perspective or one whose line of sight is not
// parallel to the plane of rotation. It may be rolled: what is seen does not change.
[[nodiscard]] std::optional<Sight> sight_of(const scene::PolyCamera& camera);

// The camera that looks along a sight, whose parts keep below 2^15: u to the right, y up.
[[nodiscard]] scene::PolyCamera camera_of(const Sight& sight);

// Hidden-line removal of the whole scene from scratch. The sight's parts keep below 2^15, so that parameters
// are fractions of 63 bits.
[[nodiscard]] picture::LinePicture visible_edges(const RotationModel& model, const Sight& sight);

// The same, and tells a trace about every edge.
[[nodiscard]] picture::LinePicture visible_edges(const RotationModel& model, const Sight& sight, Trace& trace);

// Appends the pieces of one edge. The structure is that of a direction, no event of the edge, within 2^15.
void append_pieces(const RotationModel& model, EdgeIndex edge, const EdgeStructure& structure,
                   const Sight& sight, std::vector<picture::LinePiece>& pieces);

}  // namespace sightline::algorithms::plantinga
