// The scenes that come with the program: house (Fig. 2 of the paper), roberts (after Figs. 11-12), street4,
// corridor8 and corridor32.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace sightline::scene {

// In the order in which they are shown.
[[nodiscard]] std::vector<std::string_view> builtin_scene_names();

// The scene's JSON text; empty if there is no scene of that name.
[[nodiscard]] std::optional<std::string_view> builtin_scene_text(std::string_view name);

}  // namespace sightline::scene
