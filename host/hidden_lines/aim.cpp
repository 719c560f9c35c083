// See aim.hpp.
#include "host/hidden_lines/aim.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "host/base/text.hpp"
#include "host/geometry/predicates.hpp"
#include "host/geometry/vector.hpp"
#include "host/scene/model/file_units.hpp"

namespace sightline::hidden_lines {
namespace {

using Vector = geometry::RealVector;

// The standard views and their directions. Axes: right, up, and away from a viewer in front of the scene.
struct StandardView {
  std::string_view name;
  Vector direction;
};
constexpr double root_of_seven = 2.6457513110645906;  // two axes appear at equal length, the third at half of it
constexpr std::array standard_views{
    StandardView{"front", {0, 0, 1}},         StandardView{"back", {0, 0, -1}},  StandardView{"left", {1, 0, 0}},
    StandardView{"right", {-1, 0, 0}},        StandardView{"top", {0, -1, 0}},   StandardView{"bottom", {0, 1, 0}},
    StandardView{"iso", {-1, -1, 1}},         StandardView{"dimetric", {-1, -1, root_of_seven}},
    StandardView{"trimetric", {-12, -9, 20}}, StandardView{"NE", {-1, -1, -1}},  StandardView{"NW", {1, -1, -1}},
    StandardView{"SE", {-1, -1, 1}},          StandardView{"SW", {1, -1, 1}},
};

base::Error wrong(std::string_view member, std::string found, std::string expected) {
  return {.file = std::string(member), .found = "found " + std::move(found), .expected = std::move(expected), .kind = base::ErrorKind::usage};
}

std::string text_of(const Vector& v) { return fmt::format("{},{},{}", v[0], v[1], v[2]); }

std::optional<base::Error> contradiction(const Aim& aim) {
  const std::array given{std::pair{"view", !aim.view.empty()}, std::pair{"direction", aim.direction.has_value()},
                         std::pair{"eye", aim.eye.has_value()}, std::pair{"look_at", aim.look_at.has_value()}};
  for (std::size_t a = 0; a < given.size(); ++a) {
    for (std::size_t b = a + 1; b < given.size(); ++b) {
      const bool eye_and_target = a == 2 && b == 3;
      if (given[a].second && given[b].second && !eye_and_target)
        return wrong(given[b].first, fmt::format("besides {}", given[a].first), "one of them");
    }
  }
  if (aim.perspective && aim.view.empty()) return wrong("perspective", "without view", "both: other cameras are in perspective anyway");
  for (const auto& [name, value] : {std::pair{"direction", &aim.direction}, {"eye", &aim.eye}, {"look_at", &aim.look_at}, {"up", &aim.up}}) {
    if (!*value) continue;
    const Vector& v = **value;
    if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2])) return wrong(name, text_of(v), "three finite numbers");
    const bool is_direction = value == &aim.direction || value == &aim.up;
    if (is_direction && v == Vector{}) return wrong(name, text_of(v), "a direction");
  }
  return std::nullopt;
}

// A point as given, and the grid point to which it is rounded.
struct GridPoint {
  Vector given{};  // in steps
  scene::PolyPoint at{};
};

class Aiming {
 public:
  Aiming(const Aim& request, const scene::SceneFrame& frame, const scene::PolyScene& scene)
      : request_(request), frame_(frame), scene_(scene) {}

  [[nodiscard]] base::Result<AimedCamera> aim() const {
    if (!request_.view.empty()) return standard();
    if (request_.direction) return towards(bounds_of(scene_).middle(), *request_.direction, false);
    scene::PolyCamera camera = scene_.camera;
    if (!request_.vertical.empty() && !scene_.vertices.empty()) camera = three_quarter_camera(frame_, scene_);
    if (!request_.eye && !request_.look_at)
      return request_.up ? towards(camera.eye, geometry::real_vector(camera.forward), camera.perspective) : AimedCamera{camera};
    camera.perspective = true;
    GridPoint eye{geometry::real_vector(camera.eye), camera.eye};
    if (request_.eye) {
      const auto point = grid_point("eye", *request_.eye);
      if (!point) return point.error();
      eye = *point;
    }
    camera.eye = eye.at;
    const scene::PolyBounds bounds = bounds_of(scene_);
    if (!request_.look_at && bounds.contain(camera.eye))
      return request_.up ? towards(camera.eye, geometry::real_vector(camera.forward), true) : AimedCamera{camera};
    Vector target = geometry::real_vector(bounds.middle());
    if (request_.look_at) {
      const auto point = grid_point("look_at", *request_.look_at);
      if (!point) return point.error();
      if (point->at == eye.at) return wrong("look_at", "the eye itself, " + text_of(*request_.look_at), "another point");
      target = point->given;
    }
    if (target == eye.given) target = geometry::real_vector(bounds.low);
    return towards(camera.eye, geometry::difference(target, eye.given), true);
  }

 private:
  [[nodiscard]] base::Result<GridPoint> grid_point(std::string_view member, const Vector& given) const {
    GridPoint point;
    point.given = given;
    if (!request_.steps)
      for (std::size_t a = 0; a < 3; ++a) point.given[a] = given[a] / scene_.step - static_cast<double>(scene_.origin[a]);
    constexpr std::int32_t most = scene::poly_coordinate_limit - 1;
    std::optional<scene::PolyPoint> at;
    if (!request_.steps) {
      at = scene::grid_point(scene_, given);
    } else if (std::abs(given[0]) <= most && std::abs(given[1]) <= most && std::abs(given[2]) <= most) {
      at = scene::direction_of(given);
    }
    if (!at)
      return wrong(member, text_of(given),
                   fmt::format("a point between {} and {}", scene::file_point_text(scene_, {-most, -most, -most}),
                               scene::file_point_text(scene_, {most, most, most})));
    point.at = *at;
    return point;
  }

  [[nodiscard]] base::Result<AimedCamera> standard() const {
    for (const StandardView& each : standard_views) {
      if (each.name != request_.view) continue;
      const scene::SceneSides sides = sides_of(frame_);
      Vector direction{};
      for (std::size_t a = 0; a < 3; ++a)
        direction[a] = each.direction[0] * sides.right[a] + each.direction[1] * sides.up[a] + each.direction[2] * sides.away[a];
      const scene::PolyCamera camera = camera_outside(frame_, scene_, direction, request_.perspective);
      // `up` does not change the direction of view.
      auto aimed = request_.up ? towards(camera.eye, geometry::real_vector(camera.forward), camera.perspective) : AimedCamera{camera};
      if (!aimed) return aimed;
      return AimedCamera{aimed->camera, angle_to(aimed->camera, direction)};
    }
    return wrong("view", fmt::format("\"{}\"", request_.view), base::joined(view_names(), ", "));
  }

  [[nodiscard]] base::Result<AimedCamera> towards(const scene::PolyPoint& eye, const Vector& direction, bool perspective) const {
    if (!request_.up) {
      const scene::PolyCamera camera = scene::aimed_camera(frame_, eye, scene::direction_of(direction), perspective);
      return AimedCamera{camera, angle_to(camera, direction)};
    }
    const scene::PolyPoint a = scene::direction_of(*request_.up);
    const scene::PolyPoint b = scene::direction_of(direction);
    if (geometry::is_zero(geometry::cross(geometry::vector_of(a), geometry::vector_of(b))))
      return wrong("up", text_of(*request_.up) + ", along the line of sight", "another direction");
    const scene::PolyCamera camera = scene::turned_camera(frame_, eye, direction, *request_.up, perspective);
    return AimedCamera{camera, angle_to(camera, direction)};
  }

  const Aim& request_;
  const scene::SceneFrame& frame_;
  const scene::PolyScene& scene_;
};

}  // namespace

std::vector<std::string> view_names() {
  std::vector<std::string> names;
  for (const StandardView& each : standard_views) names.emplace_back(each.name);
  return names;
}

base::Result<scene::SceneFrame> frame_of(const Aim& aim, const scene::PolyScene& scene) {
  scene::SceneFrame frame = scene::frame_of(scene.camera);
  if (aim.vertical.empty()) return frame;
  frame.downwards = aim.vertical.size() == 2 && aim.vertical[0] == '-';
  const char axis = aim.vertical.back();
  if (axis < 'x' || axis > 'z' || aim.vertical.size() != (frame.downwards ? 2U : 1U))
    return wrong("vertical", fmt::format("\"{}\"", aim.vertical), "x, y, z, -x, -y or -z");
  frame.vertical = static_cast<std::size_t>(axis - 'x');
  return frame;
}

base::Result<AimedCamera> aimed_camera(const Aim& aim, const scene::PolyScene& scene) {
  if (auto error = contradiction(aim)) return std::move(*error);
  const auto frame = frame_of(aim, scene);
  if (!frame) return frame.error();
  return Aiming(aim, *frame, scene).aim();
}

}  // namespace sightline::hidden_lines
