#include "host/app/camera_options.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/geometry/predicates.hpp"
#include "host/geometry/vector.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/file_units.hpp"

namespace sightline::app {
namespace {

using Vector = geometry::RealVector;

// Parses three numbers; if `whole`, whole numbers below `limit` in magnitude.
Vector vector_argument(std::string_view option, const std::string& text, bool whole, std::int32_t limit) {
  if (whole) {
    if (const auto point = base::whole_numbers<std::int32_t, 3>(text, ',', 1 - limit, limit - 1))
      return {double((*point)[0]), double((*point)[1]), double((*point)[2])};
    throw base::usage_error(fmt::format("{}: found \"{}\", expected X,Y,Z, three whole numbers from {} to {}", option,
                              text, 1 - limit, limit - 1));
  }
  Vector vector{};
  std::string_view rest = text;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t comma = rest.find(',');
    const auto number = base::decimal_number(rest.substr(0, comma));
    if (!number || (comma == std::string_view::npos) != (a == 2))
      throw base::usage_error(fmt::format("{}: found \"{}\", expected X,Y,Z, three numbers", option, text));
    vector[a] = *number;
    if (a < 2) rest.remove_prefix(comma + 1);
  }
  return vector;
}

Vector direction_argument(std::string_view option, const std::string& text) {
  const Vector direction = vector_argument(option, text, false, 0);
  if (direction == Vector{})
    throw base::usage_error(fmt::format("{}: found \"{}\", expected a direction", option, text));
  return direction;
}

scene::PolyPoint exact_vector(std::string_view option, const std::string& text) {
  const Vector vector = vector_argument(option, text, true, scene::camera_vector_limit);
  if (vector == Vector{})
    throw base::usage_error(fmt::format("{}: found \"{}\", expected a direction", option, text));
  return scene::direction_of(vector);
}

// --view also accepts the camera position of --eye.
bool is_eye(const std::string& view) {
  return view.find(',') != std::string::npos;
}

// The arguments with a camera position given by --view moved to `eye`.
CameraArguments with_eye(const CameraArguments& given) {
  CameraArguments arguments = given;
  if (!is_eye(arguments.view)) return arguments;
  if (!arguments.eye.empty()) throw base::usage_error("found --view and --eye, expected one of them");
  arguments.eye = std::exchange(arguments.view, {});
  return arguments;
}

bool has_exact_vectors(const CameraArguments& arguments) {
  return !arguments.forward.empty() || !arguments.right.empty();
}

void reject_mutually_exclusive(const CameraArguments& arguments) {
  const auto reject = [](std::string_view a, const std::string& given_a, std::string_view b,
                         const std::string& given_b) {
    if (!given_a.empty() && !given_b.empty())
      throw base::usage_error(fmt::format("found {} and {}, expected one of them", a, b));
  };
  reject("--orthographic", arguments.orthographic, "--eye", arguments.eye);
  reject("--orthographic", arguments.orthographic, "--look-at", arguments.look_at);
  reject("--orthographic", arguments.orthographic, "--forward", arguments.forward);
  reject("--look-at", arguments.look_at, "--forward", arguments.forward);
  reject("--vertical", arguments.vertical, "--forward", arguments.forward);
  reject("--view", arguments.view, "--eye", arguments.eye);
  reject("--view", arguments.view, "--look-at", arguments.look_at);
  reject("--view", arguments.view, "--orthographic", arguments.orthographic);
  reject("--view", arguments.view, "--forward", arguments.forward);
  if (arguments.perspective && arguments.view.empty())
    throw base::usage_error("found --perspective without --view, expected both: other cameras are in perspective anyway");
  if (has_exact_vectors(arguments) &&
      (arguments.forward.empty() || arguments.right.empty() || arguments.up.empty()))
    throw base::usage_error("expected --forward, --right and --up together, or --up alone, or none of them");
}

scene::PolyCamera exact_vectors(const CameraArguments& arguments, scene::PolyCamera camera) {
  camera.forward = exact_vector("--forward", arguments.forward);
  camera.right = exact_vector("--right", arguments.right);
  camera.up = exact_vector("--up", arguments.up);
  const auto square = [](const scene::PolyPoint& a, const scene::PolyPoint& b) {
    return geometry::dot(geometry::vector_of(a), geometry::vector_of(b)) == 0;
  };
  if (!square(camera.forward, camera.right) || !square(camera.forward, camera.up) ||
      !square(camera.right, camera.up)) {
    throw base::usage_error(fmt::format("found --forward {} --right {} --up {}, expected right angles "
                                               "between them",
                                               arguments.forward, arguments.right, arguments.up));
  }
  return camera;
}

// What the options ask for, except for --forward and --right.
hidden_lines::Aim aim_of(const CameraArguments& arguments) {
  hidden_lines::Aim aim{.view = arguments.view, .perspective = arguments.perspective, .vertical = arguments.vertical, .steps = arguments.steps};
  const auto point = [&](std::string_view option, const std::string& text) -> std::optional<Vector> {
    if (text.empty()) return std::nullopt;
    return vector_argument(option, text, arguments.steps, scene::poly_coordinate_limit);
  };
  const auto direction = [](std::string_view option, const std::string& text) -> std::optional<Vector> {
    if (text.empty()) return std::nullopt;
    return direction_argument(option, text);
  };
  aim.eye = point("--eye", arguments.eye);
  aim.look_at = point("--look-at", arguments.look_at);
  aim.direction = direction("--orthographic", arguments.orthographic);
  if (!has_exact_vectors(arguments)) aim.up = direction("--up", arguments.up);
  return aim;
}

// The value of a result; an error about a member of Aim is thrown with the name of the option.
template <class Value>
Value value_of_aim(base::Result<Value> result) {
  if (result) return *std::move(result);
  base::Error error = std::move(result.error());
  if (error.file == "look_at") error.file = "--look-at";
  else if (error.file == "direction") error.file = "--orthographic";
  else error.file = "--" + error.file;
  throw error;
}

// Rotates about the vertical axis by `number` of `count` parts of a turn.
Vector rotate(const scene::SceneFrame& frame, const Vector& p, int number, int count) {
  const std::size_t u = (frame.vertical + 1) % 3;
  const std::size_t v = (frame.vertical + 2) % 3;
  const double angle = 2 * std::numbers::pi * number / count;
  Vector result = p;
  result[u] = p[u] * std::cos(angle) - p[v] * std::sin(angle);
  result[v] = p[u] * std::sin(angle) + p[v] * std::cos(angle);
  return result;
}

}  // namespace

void add_camera_options(const Command& command, CameraArguments& arguments) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    command.option(name, value, help).value("X,Y,Z").group("View");
  };
  add("--eye", arguments.eye, "Look from this point, in the unit of the scene's file");
  add("--look-at", arguments.look_at, "Look at this point");
  add("--orthographic", arguments.orthographic, "No perspective: look in this direction");
  command
      .option("--view", arguments.view,
              fmt::format("A standard view in parallel projection: {}; or the camera position, as --eye", base::joined(hidden_lines::view_names(), ", ")))
      .value("NAME")
      .group("View");
  command.flag("--perspective", arguments.perspective, "Show the view of --view in perspective").group("View");
  add("--up", arguments.up, "The direction that points up in the picture, as nearly as possible; or see --forward");
  add("--forward", arguments.forward,
      "With --right and --up: the vectors of the camera, whole numbers, at right angles");
  add("--right", arguments.right, "See --forward");
  command.flag("--steps", arguments.steps, "Points are given in steps of the scene's grid, see `sightline scene info`")
      .group("View");
  command.option("--vertical", arguments.vertical, "Which axis points up, such as z or -y")
      .one_of({"x", "y", "z", "-x", "-y", "-z"})
      .value("AXIS")
      .group("View");
}

void add_field_option(const Command& command, std::optional<double>& field, const std::string& default_value) {
  command
      .option("--field,--fov", field,
              "The field of view across the shorter side: degrees, or in parallel projection a length in the unit of the "
              "scene's file")
      .default_value(default_value)
      .value("ANGLE")
      .group("View");
}

std::optional<double> image_field(const std::optional<double>& field, const scene::PolyScene& scene,
                                  const scene::PolyCamera& camera) {
  if (!field) return std::nullopt;
  require_finite("--field", *field);
  constexpr double widest = 1e9;  // steps; larger than the image of any scene
  const double extent = camera.perspective ? *field : *field / scene.step;
  if (!(extent > 0) || extent > (camera.perspective ? 170 : widest)) {
    throw base::usage_error(fmt::format("--field: found {}, expected {}", *field,
                              camera.perspective
                                  ? "degrees above 0, at most 170"
                                  : fmt::format("a length above 0, at most {:g}, in the unit of the file", widest * scene.step)));
  }
  return extent;
}

std::optional<std::array<double, 3>> eye_of(const CameraArguments& arguments) {
  const std::string& eye = arguments.eye.empty() && is_eye(arguments.view) ? arguments.view : arguments.eye;
  if (eye.empty() || arguments.steps) return std::nullopt;
  return vector_argument(arguments.eye.empty() ? "--view" : "--eye", eye, false, 0);
}

scene::SceneFrame frame_of(const CameraArguments& arguments, const scene::PolyScene& scene) {
  return value_of_aim(hidden_lines::frame_of({.vertical = arguments.vertical}, scene));
}

AimedCamera camera_anywhere(const CameraArguments& given, const scene::PolyScene& scene) {
  const CameraArguments arguments = with_eye(given);
  reject_mutually_exclusive(arguments);
  AimedCamera aimed = value_of_aim(hidden_lines::aimed_camera(aim_of(arguments), scene));
  if (!has_exact_vectors(arguments)) return aimed;
  return {exact_vectors(arguments, aimed.camera)};
}

void require_free_eye(const scene::PolyScene& scene, const scene::PolyCamera& camera, const std::string& source) {
  auto error = scene::eye_error(scene, camera);
  if (!error) return;
  error->file = source;
  throw base::bad_input(error->message());
}

AimedCamera aimed_camera_of(const CameraArguments& arguments, const scene::PolyScene& scene, const std::string& source) {
  const AimedCamera aimed = camera_anywhere(arguments, scene);
  require_free_eye(scene, aimed.camera, source);
  return aimed;
}

scene::PolyCamera camera_of(const CameraArguments& arguments, const scene::PolyScene& scene,
                            const std::string& source) {
  return aimed_camera_of(arguments, scene, source).camera;
}

std::optional<scene::PolyPoint> eye_of_turn(const scene::SceneFrame& frame, const scene::PolyScene& scene,
                                           const scene::PolyCamera& camera, int number, int count) {
  const scene::PolyPoint middle = bounds_of(scene).middle();
  const Vector moved = rotate(frame, geometry::difference(geometry::real_vector(camera.eye), geometry::real_vector(middle)), number, count);
  scene::PolyPoint eye{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double place = std::round(middle[a] + moved[a]);
    if (!(std::abs(place) < scene::poly_coordinate_limit)) return std::nullopt;
    eye[a] = static_cast<std::int32_t>(place);
  }
  return eye;
}

scene::PolyCamera view_of_turn(const scene::SceneFrame& frame, const scene::PolyScene& scene,
                               const scene::PolyCamera& camera, int number, int count) {
  if (number == 0) return camera;
  scene::PolyPoint eye = camera.eye;
  if (camera.perspective) {
    const auto moved = eye_of_turn(frame, scene, camera, number, count);
    if (!moved) {
      throw base::usage_error(fmt::format("view {} of the turn: the eye leaves the coordinates of the scene; --eye nearer", number + 1));
    }
    eye = *moved;
  }
  const Vector direction = rotate(frame, geometry::real_vector(camera.forward), number, count);
  // A level camera stays level.
  scene::PolyPoint upright{};
  upright[frame.vertical] = 1;
  const auto across = geometry::cross(geometry::vector_of(upright), geometry::vector_of(camera.right));
  const bool is_upright = camera.right[frame.vertical] == 0 && !geometry::is_zero(across);
  if (is_upright && camera.up[frame.vertical] * (frame.downwards ? -1 : 1) > 0)
    return aimed_camera(frame, eye, scene::direction_of(direction), camera.perspective);
  return turned_camera(frame, eye, direction, rotate(frame, geometry::real_vector(camera.up), number, count), camera.perspective);
}

base::Json camera_json(const scene::PolyScene& scene, const AimedCamera& aimed) {
  const scene::PolyCamera& camera = aimed.camera;
  return {{"perspective", camera.perspective},
          {"eye", scene::file_point(scene, camera.eye)},
          {"eye_steps", camera.eye},
          {"forward", camera.forward},
          {"right", camera.right},
          {"up", camera.up},
          {"error_degrees", aimed.error}};
}

}  // namespace sightline::app
