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

// The values of --view and their directions of view. Axes: right, up, and away from a viewer in front of the scene.
struct Preset {
  std::string_view name;
  Vector direction;
};
constexpr double root_of_seven = 2.6457513110645906;  // two axes appear at equal length, the third at half of it
constexpr std::array presets{
    Preset{"front", {0, 0, 1}},         Preset{"back", {0, 0, -1}},  Preset{"left", {1, 0, 0}},
    Preset{"right", {-1, 0, 0}},        Preset{"top", {0, -1, 0}},   Preset{"bottom", {0, 1, 0}},
    Preset{"iso", {-1, -1, 1}},         Preset{"dimetric", {-1, -1, root_of_seven}},
    Preset{"trimetric", {-12, -9, 20}}, Preset{"NE", {-1, -1, -1}},  Preset{"NW", {1, -1, -1}},
    Preset{"SE", {-1, -1, 1}},          Preset{"SW", {1, -1, 1}},
};

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

// A point as given, and the grid point to which it is rounded.
struct GridPoint {
  Vector given{};  // in steps
  scene::PolyPoint at{};
};

GridPoint grid_point_argument(std::string_view option, const std::string& text, const CameraArguments& arguments,
                         const scene::PolyScene& scene) {
  const Vector given = vector_argument(option, text, arguments.steps, scene::poly_coordinate_limit);
  if (arguments.steps) return {given, scene::direction_of(given)};
  GridPoint point;
  for (std::size_t a = 0; a < 3; ++a) point.given[a] = given[a] / scene.step - static_cast<double>(scene.origin[a]);
  const auto at = scene::grid_point(scene, given);
  if (!at) {
    const std::int32_t most = scene::poly_coordinate_limit - 1;
    throw base::usage_error(fmt::format("{}: found {}, expected a point between {} and {}", option, text,
                              scene::file_point_text(scene, {-most, -most, -most}),
                              scene::file_point_text(scene, {most, most, most})));
  }
  point.at = *at;
  return point;
}

class Aiming {
 public:
  Aiming(const CameraArguments& arguments, const scene::PolyScene& scene)
      : arguments_(arguments), scene_(scene), frame_(frame_of(arguments, scene)) {}

  [[nodiscard]] AimedCamera aim() const {
    if (!arguments_.view.empty()) return preset();
    if (!arguments_.orthographic.empty()) {
      const scene::PolyPoint middle = bounds_of(scene_).middle();
      return towards(middle, direction_argument("--orthographic", arguments_.orthographic), false);
    }
    scene::PolyCamera camera = scene_.camera;
    if (!arguments_.vertical.empty() && !scene_.vertices.empty()) camera = three_quarter_camera(frame_, scene_);
    if (arguments_.eye.empty() && arguments_.look_at.empty()) {
      return arguments_.up.empty() ? AimedCamera{camera} : towards(camera.eye, geometry::real_vector(camera.forward), camera.perspective);
    }
    camera.perspective = true;
    GridPoint eye{geometry::real_vector(camera.eye), camera.eye};
    if (!arguments_.eye.empty()) eye = grid_point_argument("--eye", arguments_.eye, arguments_, scene_);
    camera.eye = eye.at;
    const scene::PolyBounds bounds = bounds_of(scene_);
    if (arguments_.look_at.empty() && bounds.contain(camera.eye)) return {camera};
    Vector target = geometry::real_vector(bounds.middle());
    if (!arguments_.look_at.empty()) {
      const GridPoint point = grid_point_argument("--look-at", arguments_.look_at, arguments_, scene_);
      if (point.at == eye.at)
        throw base::usage_error(fmt::format("--look-at: found the eye itself, {}", arguments_.look_at));
      target = point.given;
    }
    if (target == eye.given) target = geometry::real_vector(bounds.low);
    return towards(camera.eye, geometry::difference(target, eye.given), true);
  }

 private:
  [[nodiscard]] AimedCamera preset() const {
    for (const Preset& each : presets) {
      if (each.name != arguments_.view) continue;
      const scene::SceneSides sides = sides_of(frame_);
      Vector direction{};
      for (std::size_t a = 0; a < 3; ++a) {
        direction[a] = each.direction[0] * sides.right[a] + each.direction[1] * sides.up[a] +
                       each.direction[2] * sides.away[a];
      }
      const scene::PolyCamera camera = camera_outside(frame_, scene_, direction, arguments_.perspective);
      // --up does not change the direction of view.
      const AimedCamera aimed =
          arguments_.up.empty() ? AimedCamera{camera} : towards(camera.eye, geometry::real_vector(camera.forward), camera.perspective);
      return {aimed.camera, angle_to(aimed.camera, direction)};
    }
    throw base::usage_error(fmt::format("--view: found \"{}\", expected {}, or the eye, X,Y,Z", arguments_.view,
                                               base::joined(preset_names(), ", ")));
  }

  [[nodiscard]] AimedCamera towards(const scene::PolyPoint& eye, const Vector& direction, bool perspective) const {
    if (arguments_.up.empty()) {
      const scene::PolyCamera camera = aimed_camera(frame_, eye, scene::direction_of(direction), perspective);
      return {camera, angle_to(camera, direction)};
    }
    const Vector up = direction_argument("--up", arguments_.up);
    const scene::PolyPoint a = scene::direction_of(up);
    const scene::PolyPoint b = scene::direction_of(direction);
    if (geometry::is_zero(geometry::cross(geometry::vector_of(a), geometry::vector_of(b))))
      throw base::usage_error(fmt::format("--up: found {}, along the line of sight; expected another direction", arguments_.up));
    const scene::PolyCamera camera = turned_camera(frame_, eye, direction, up, perspective);
    return {camera, angle_to(camera, direction)};
  }

  const CameraArguments& arguments_;
  const scene::PolyScene& scene_;
  scene::SceneFrame frame_;
};

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

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const Preset& each : presets) names.emplace_back(each.name);
  return names;
}

void add_camera_options(const Command& command, CameraArguments& arguments) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    command.option(name, value, help).value("X,Y,Z").group("View");
  };
  add("--eye", arguments.eye, "Look from this point, in the unit of the scene's file");
  add("--look-at", arguments.look_at, "Look at this point");
  add("--orthographic", arguments.orthographic, "No perspective: look in this direction");
  command
      .option("--view", arguments.view,
              fmt::format("A standard view in parallel projection: {}; or the camera position, as --eye", base::joined(preset_names(), ", ")))
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
  scene::SceneFrame frame = scene::frame_of(scene.camera);
  if (arguments.vertical.empty()) return frame;
  frame.downwards = arguments.vertical.size() == 2;
  frame.vertical = static_cast<std::size_t>(arguments.vertical.back() - 'x');
  return frame;
}

AimedCamera camera_anywhere(const CameraArguments& given, const scene::PolyScene& scene) {
  const CameraArguments arguments = with_eye(given);
  reject_mutually_exclusive(arguments);
  AimedCamera aimed;
  if (!has_exact_vectors(arguments)) {
    aimed = Aiming(arguments, scene).aim();
  } else {
    aimed.camera = exact_vectors(arguments, scene.camera);
    if (!arguments.eye.empty()) {
      aimed.camera.eye = grid_point_argument("--eye", arguments.eye, arguments, scene).at;
      aimed.camera.perspective = true;
    }
  }
  return aimed;
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
