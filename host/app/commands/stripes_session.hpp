// What `sightline stripes` and `demo` share: a view of a scene drawn by the program of stripes on the 8080, and checked.
#pragma once

#include <optional>
#include <string>

#include "host/programs/stripes/session.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

// All of the scene before the camera, or `extent` across (as registry::face_window has it), in the machine's picture.
[[nodiscard]] programs::stripes::View stripes_view(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                 std::optional<double> extent = {});

// `source` names the scene in errors. Error bad_input: the scene does not fit, which part and by how much, or its faces pass
// through each other; differs: the picture is not the twin's; guest_failed: the program did not end, or a device complains.
[[nodiscard]] programs::stripes::DrawnScene draw_stripes(const programs::stripes::Session& session, const scene::PolyScene& scene,
                                                       const std::string& source, const programs::stripes::View& view,
                                                       const programs::stripes::StreamOptions& options);

}  // namespace sightline::app
