// See draw_camera.hpp.
#include "host/app/commands/draw_camera.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

#include "host/base/number.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_bounds.hpp"

namespace sightline::app {

namespace {

// Three whole numbers, their magnitudes below `limit`.
scene::PolyPoint vector_argument(std::string_view option, const std::string& text, std::int32_t limit) {
  if (const auto point = base::whole_numbers<std::int32_t, 3>(text, ',', 1 - limit, limit - 1)) return *point;
  throw Failure(ExitCode::usage,
                fmt::format("{}: found \"{}\", expected X,Y,Z, three whole numbers from {} to {}", option,
                            text, 1 - limit, limit - 1));
}

scene::PolyPoint direction_argument(std::string_view option, const std::string& text, std::int32_t limit) {
  const scene::PolyPoint direction = vector_argument(option, text, limit);
  if (direction == scene::PolyPoint{})
    throw Failure(ExitCode::usage, fmt::format("{}: found \"{}\", expected a direction", option, text));
  return direction;
}

void refuse_together(const CameraArguments& arguments) {
  const auto refuse = [](std::string_view a, const std::string& given_a, std::string_view b,
                         const std::string& given_b) {
    if (!given_a.empty() && !given_b.empty())
      throw Failure(ExitCode::usage, fmt::format("found {} and {}, expected one of them", a, b));
  };
  refuse("--orthographic", arguments.orthographic, "--eye", arguments.eye);
  refuse("--orthographic", arguments.orthographic, "--look-at", arguments.look_at);
  refuse("--orthographic", arguments.orthographic, "--forward", arguments.forward);
  refuse("--look-at", arguments.look_at, "--forward", arguments.forward);
  refuse("--vertical", arguments.vertical, "--forward", arguments.forward);
  if (arguments.forward.empty() != arguments.right.empty() || arguments.right.empty() != arguments.up.empty())
    throw Failure(ExitCode::usage, "expected --forward, --right and --up together, or none of them");
}

scene::PolyCamera exact_vectors(const CameraArguments& arguments, scene::PolyCamera camera) {
  camera.forward = direction_argument("--forward", arguments.forward, scene::camera_vector_limit);
  camera.right = direction_argument("--right", arguments.right, scene::camera_vector_limit);
  camera.up = direction_argument("--up", arguments.up, scene::camera_vector_limit);
  const auto square = [](const scene::PolyPoint& a, const scene::PolyPoint& b) {
    return geometry::dot(geometry::vector_of(a), geometry::vector_of(b)) == 0;
  };
  if (!square(camera.forward, camera.right) || !square(camera.forward, camera.up) ||
      !square(camera.right, camera.up)) {
    throw Failure(ExitCode::usage, fmt::format("found --forward {} --right {} --up {}, expected right angles "
                                               "between them",
                                               arguments.forward, arguments.right, arguments.up));
  }
  return camera;
}

scene::PolyCamera aimed(const CameraArguments& arguments, const scene::PolyScene& scene) {
  const scene::SceneFrame frame = frame_of(arguments, scene);
  if (!arguments.orthographic.empty()) {
    return aimed_camera(
        frame, bounds_of(scene).middle(),
        direction_argument("--orthographic", arguments.orthographic, scene::poly_coordinate_limit), false);
  }
  scene::PolyCamera camera = scene.camera;
  if (!arguments.vertical.empty() && !scene.vertices.empty()) camera = three_quarter_camera(frame, scene);
  if (arguments.eye.empty() && arguments.look_at.empty()) return camera;
  if (!arguments.eye.empty())
    camera.eye = vector_argument("--eye", arguments.eye, scene::poly_coordinate_limit);
  camera.perspective = true;
  const scene::PolyBounds bounds = bounds_of(scene);
  if (arguments.look_at.empty() && bounds.contain(camera.eye)) return camera;
  scene::PolyPoint target = bounds.middle();
  if (!arguments.look_at.empty())
    target = vector_argument("--look-at", arguments.look_at, scene::poly_coordinate_limit);
  scene::PolyPoint direction{};
  for (std::size_t a = 0; a < 3; ++a) direction[a] = target[a] - camera.eye[a];
  if (direction == scene::PolyPoint{}) {
    throw Failure(ExitCode::usage,
                  fmt::format("--look-at: found the eye itself, {},{},{}", target[0], target[1], target[2]));
  }
  return aimed_camera(frame, camera.eye, direction);
}

}  // namespace

void add_camera_options(const Command& command, CameraArguments& arguments) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    command.option(name, value, help).value("X,Y,Z").group("View");
  };
  add("--eye", arguments.eye, "Look from this point");
  add("--look-at", arguments.look_at, "Look at this point");
  add("--orthographic", arguments.orthographic, "No perspective: look in this direction");
  add("--forward", arguments.forward,
      "With --right and --up: the camera's vectors themselves, at right angles");
  add("--right", arguments.right, "See --forward");
  add("--up", arguments.up, "See --forward");
  command.option("--vertical", arguments.vertical, "Which axis points up, such as z or -y")
      .one_of({"x", "y", "z", "-x", "-y", "-z"})
      .value("AXIS")
      .group("View");
}

scene::SceneFrame frame_of(const CameraArguments& arguments, const scene::PolyScene& scene) {
  scene::SceneFrame frame = scene::frame_of(scene.camera);
  if (arguments.vertical.empty()) return frame;
  frame.downwards = arguments.vertical.size() == 2;
  frame.vertical = static_cast<std::size_t>(arguments.vertical.back() - 'x');
  return frame;
}

scene::PolyCamera camera_of(const CameraArguments& arguments, const scene::PolyScene& scene,
                            const std::string& source) {
  refuse_together(arguments);
  scene::PolyCamera camera;
  if (arguments.forward.empty()) {
    camera = aimed(arguments, scene);
  } else {
    camera = exact_vectors(arguments, scene.camera);
    if (!arguments.eye.empty()) {
      camera.eye = vector_argument("--eye", arguments.eye, scene::poly_coordinate_limit);
      camera.perspective = true;
    }
  }
  if (auto error = scene::eye_error(scene, camera)) {
    error->file = source;
    throw Failure(ExitCode::bad_input, error->message());
  }
  return camera;
}

}  // namespace sightline::app
