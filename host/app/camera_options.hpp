// The options that say from where a scene is looked at, the same in every command that has a camera.
//
// Points are in the unit of the scene's file, and are rounded to the grid of the scene; --steps counts in steps
// of that grid instead.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "host/app/command_line.hpp"
#include "host/base/json.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::app {

struct CameraArguments {
  std::string eye;  // "X,Y,Z", as all of these; empty: not given
  std::string look_at;
  std::string orthographic;
  std::string forward;
  std::string right;
  std::string up;
  std::string vertical;
  std::string view;  // a preset; or the eye, "X,Y,Z"
  bool perspective = false;
  bool steps = false;
};

void add_camera_options(const Command& command, CameraArguments& arguments);

// --field and --fov: how much is shown.
void add_field_option(const Command& command, std::optional<double>& field, const std::string& default_value);
// As the camera's image has it: degrees, or without perspective steps of the scene's grid, of a field in the unit of the
// file. Error usage: no number, or none that a camera can show.
[[nodiscard]] std::optional<double> image_field(const std::optional<double>& field, const scene::PolyScene& scene,
                                                const scene::PolyCamera& camera);

// The eye that was asked for, so that the scene can be read with room for it. Error usage: no point.
[[nodiscard]] std::optional<std::array<double, 3>> eye_of(const CameraArguments& arguments);

// How the scene's coordinates are meant: as --vertical says, else as the scene's own camera does. Not as the
// camera asked for: one that looks steeply down has the horizontal for its up.
[[nodiscard]] scene::SceneFrame frame_of(const CameraArguments& arguments, const scene::PolyScene& scene);

// A camera, and how far its direction is from the one asked for.
struct AimedCamera {
  scene::PolyCamera camera;
  double error = 0;  // degrees
};

// The scene's own camera changed as the options say; in free space, unless the camera is orthographic.
// `source` names the scene in errors. Error usage: options that contradict each other or are no vectors.
// Error bad_input: the eye is inside a solid or on a face, which are named.
[[nodiscard]] AimedCamera aimed_camera_of(const CameraArguments& arguments, const scene::PolyScene& scene,
                                          const std::string& source);
[[nodiscard]] scene::PolyCamera camera_of(const CameraArguments& arguments, const scene::PolyScene& scene,
                                          const std::string& source);

// Once around the upright through the middle of the scene: view `number` of `count`, the first of which is the
// camera itself. Error usage: an eye beyond the scene's coordinates.
[[nodiscard]] scene::PolyCamera turned_about(const scene::SceneFrame& frame, const scene::PolyScene& scene,
                                             const scene::PolyCamera& camera, int number, int count);

// Where its eye is then; empty if that is beyond the scene's coordinates.
[[nodiscard]] std::optional<scene::PolyPoint> turned_eye(const scene::SceneFrame& frame, const scene::PolyScene& scene,
                                                         const scene::PolyCamera& camera, int number, int count);

// "eye" and "target direction" in the unit of the file, the camera's vectors, the error.
[[nodiscard]] base::Json camera_json(const scene::PolyScene& scene, const AimedCamera& camera);

}  // namespace sightline::app
