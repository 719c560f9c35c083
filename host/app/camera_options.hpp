// The camera options, the same in every command that has a camera.
//
// Points are in the unit of the scene's file and are rounded to the grid of the scene; with --steps they are in steps of
// that grid.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "host/app/command_line.hpp"
#include "host/base/json.hpp"
#include "host/hidden_lines/aim.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::app {

struct CameraArguments {
  std::string eye;  // "X,Y,Z", like the next five; empty: not given
  std::string look_at;
  std::string orthographic;
  std::string forward;
  std::string right;
  std::string up;
  std::string vertical;
  std::string view;  // the name of a view, or the camera position "X,Y,Z"
  bool perspective = false;
  bool steps = false;
};

void add_camera_options(const Command& command, CameraArguments& arguments);

// --field, also called --fov.
void add_field_option(const Command& command, std::optional<double>& field, const std::string& default_value);
// Converts the value of --field to degrees, or in parallel projection from the unit of the file to steps of the scene's
// grid. Error usage: not a number, or out of range.
[[nodiscard]] std::optional<double> image_field(const std::optional<double>& field, const scene::PolyScene& scene,
                                                const scene::PolyCamera& camera);

// The camera position of --eye or --view in the unit of the file, which the reader of a scene must know; empty if not given or
// in steps. Error usage: no point.
[[nodiscard]] std::optional<std::array<double, 3>> eye_of(const CameraArguments& arguments);

// The vertical axis of the scene: that of --vertical, else that of the scene's own camera. The requested camera is not used,
// because the up vector of a camera that looks steeply down is nearly horizontal.
[[nodiscard]] scene::SceneFrame frame_of(const CameraArguments& arguments, const scene::PolyScene& scene);

using hidden_lines::AimedCamera;

// The scene's own camera, changed by the options, wherever its eye is. Error usage: options that contradict each other or are no vectors.
[[nodiscard]] AimedCamera camera_anywhere(const CameraArguments& arguments, const scene::PolyScene& scene);
// Error bad_input: the eye is inside a solid or on a face, which the error names. `source` is the scene's name in errors.
void require_free_eye(const scene::PolyScene& scene, const scene::PolyCamera& camera, const std::string& source);

// The scene's own camera, changed by the options; in free space, unless it is orthographic. `source` is the scene's name in
// errors. Error usage: options that contradict each other or are no vectors. Error bad_input: the eye is inside a solid or
// on a face, which the error names.
[[nodiscard]] AimedCamera aimed_camera_of(const CameraArguments& arguments, const scene::PolyScene& scene,
                                          const std::string& source);
[[nodiscard]] scene::PolyCamera camera_of(const CameraArguments& arguments, const scene::PolyScene& scene,
                                          const std::string& source);

// View `number` of `count` around the vertical axis through the middle of the scene; view 0 is `camera` itself. Error usage:
// the eye is outside the scene's coordinates.
[[nodiscard]] scene::PolyCamera view_of_turn(const scene::SceneFrame& frame, const scene::PolyScene& scene,
                                             const scene::PolyCamera& camera, int number, int count);

// The eye of that view; empty if it is outside the scene's coordinates.
[[nodiscard]] std::optional<scene::PolyPoint> eye_of_turn(const scene::SceneFrame& frame, const scene::PolyScene& scene,
                                                         const scene::PolyCamera& camera, int number, int count);

// "eye" and "target direction" in the unit of the file, the camera's vectors, the error.
[[nodiscard]] base::Json camera_json(const scene::PolyScene& scene, const AimedCamera& camera);

}  // namespace sightline::app
