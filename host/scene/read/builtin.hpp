// The scenes that come with the program.
//
// Scenes of cells: house (Fig. 2 of Jones 1971), roberts (after Figs. 11-12), street4, corridor8 and corridor32.
// Models: squares, grid, objects, bars, tori and spring, with the numbers of vertices, edges and faces that Table 1 of
// Plantinga, Seales and Dyer (1990) gives. The paper does not say where their parts are; these places were chosen, with
// integer coordinates, exactly planar faces, and y as the axis of rotation.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace sightline::scene {

// The scenes of cells, in the order in which they are shown.
[[nodiscard]] std::vector<std::string_view> builtin_scene_names();
// The models, in the order of Table 1.
[[nodiscard]] std::vector<std::string_view> builtin_model_names();

// The text of a scene of cells (JSON) or of a model (OFF); empty if there is none of that name.
[[nodiscard]] std::optional<std::string_view> builtin_scene_text(std::string_view name);

}  // namespace sightline::scene
