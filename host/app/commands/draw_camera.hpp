// From where a scene is drawn: the options that say so, and the camera they mean.
#pragma once

#include <optional>
#include <string>

#include "host/app/command_line.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

struct CameraArguments {
  std::string eye;  // "X,Y,Z", as all of these; empty: not given
  std::string look_at;
  std::string orthographic;
  std::string forward;
  std::string right;
  std::string up;
  std::string vertical;
};

void add_camera_options(const Command& command, CameraArguments& arguments);

inline constexpr const char* camera_help =
    "Points and directions are whole numbers in the scene's own units (`sightline scene info` says its "
    "bounds and "
    "what\na unit stands for). Without options the scene is looked at as its file says, or from above and "
    "one side. "
    "--eye\nalone looks at the middle of the scene, or, from inside it, the way the scene's own view does.\n";

// How the scene's coordinates are meant: as --vertical says, else as the scene's own camera does. Not as the
// camera asked for: one that looks steeply down has the horizontal for its up.
[[nodiscard]] scene::SceneFrame frame_of(const CameraArguments& arguments, const scene::PolyScene& scene);

// The scene's own camera changed as the options say; in free space, unless the camera is orthographic.
// `source` names the scene in errors. Failure usage: options that contradict each other or are no vectors.
// Failure bad_input: the eye is inside a solid or on a face, which are named.
[[nodiscard]] scene::PolyCamera camera_of(const CameraArguments& arguments, const scene::PolyScene& scene,
                                          const std::string& source);

}  // namespace sightline::app
