// The SCENE argument and the eye's option, the same in every subcommand that has them.
#pragma once

#include <string>
#include <string_view>

#include "host/geometry/box.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::app {

inline constexpr std::string_view scene_argument_help =
    "A built-in scene (see `sightline scene list`) or a JSON file of a scene of cells";

// Throws Failure io if SCENE is neither a built-in name nor a file.
void require_scene_exists(const std::string& name_or_file);

// Read and checked. Failure io, or bad_input naming the first thing that is wrong.
[[nodiscard]] scene::CellScene load_scene(const std::string& name_or_file);
// The same from its text. Failure bad_input.
[[nodiscard]] scene::CellScene load_scene(std::string_view text, const std::string& name_or_file);

// "X,Y,Z", decimal integers below 2^15 in magnitude. Failure usage.
[[nodiscard]] geometry::Point point_argument(std::string_view option, std::string_view text);

}  // namespace sightline::app
