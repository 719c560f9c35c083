// Makes a camera from what a user knows: the name of a standard view, a direction, or an eye and what it looks at.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::hidden_lines {

// A request for a camera. Without view, direction, eye and look_at it is the scene's own camera.
struct Aim {
  std::string view = {};     // one of view_names(), in parallel projection
  bool perspective = false;  // show `view` in perspective
  std::optional<std::array<double, 3>> direction = {};  // parallel projection, looking in this direction
  // Perspective, in the unit of the file. An eye outside the scene looks at its middle, one inside in the direction of the scene's
  // camera, unless look_at is given.
  std::optional<std::array<double, 3>> eye = {};
  std::optional<std::array<double, 3>> look_at = {};
  std::optional<std::array<double, 3>> up = {};  // points up in the picture, as nearly as possible
  std::string vertical = {};                     // the axis that points up: x, y, z, -x, -y or -z; empty: as in the scene's camera
  bool steps = false;                            // eye and look_at are in steps of the scene's grid
};

// A camera, and the angle between its direction and the requested one.
struct AimedCamera {
  scene::PolyCamera camera;
  double error = 0;  // degrees
};

// front, back, left, right, top, bottom, iso, dimetric, trimetric, NE, NW, SE, SW.
[[nodiscard]] std::vector<std::string> view_names();

// The vertical axis of the scene: the requested one, otherwise that of the scene's own camera. The camera requested by `aim` is not
// used, because the up vector of a camera that looks steeply down is nearly horizontal. Error usage (Error::file is "vertical"): no axis.
[[nodiscard]] base::Result<scene::SceneFrame> frame_of(const Aim& aim, const scene::PolyScene& scene);

// The camera, wherever its eye is: see scene::eye_error. Error usage, with the name of the member in Error::file: members that
// contradict each other, no view of this name, a number that is not finite, a direction 0, an eye or look_at outside the
// scene's coordinates.
[[nodiscard]] base::Result<AimedCamera> aimed_camera(const Aim& aim, const scene::PolyScene& scene);

}  // namespace sightline::hidden_lines
