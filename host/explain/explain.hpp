// The list of lessons, one for each algorithm. To add one, add a row to explain.cpp and a source to this folder.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "host/base/result.hpp"
#include "host/explain/lesson.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::explain {

struct Explainer {
  std::string_view algorithm;  // its name in the registry
  std::string_view summary;    // one line, with the paper
  // Makes the lesson of a polyhedral scene. Preconditions: the scene is checked, the eye is in free space. `complex`: the cells
  // that came with the scene, or null. An error says why there is no lesson.
  base::Result<Lesson> (*scene)(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                const scene::CellComplex* complex) = nullptr;
  // Makes the lesson of a surface over a grid; angles in degrees.
  base::Result<Lesson> (*heights)(const scene::HeightGrid& grid, double rotation, double elevation) = nullptr;
};

// Each row has exactly one of the two functions.
[[nodiscard]] std::span<const Explainer> explainers();
// The lesson of a scene as it was read, with its cells. For a cell scene with the eye in a cell, Jones's lesson shows the lines
// that the PDP-7 program draws: the real lines of the matter, with those of the outer box, without the joints of solids.
// `explainer` has the function `scene`, with the same preconditions.
[[nodiscard]] base::Result<Lesson> explain_scene(const Explainer& explainer, const scene::LoadedScene& source, const scene::PolyCamera& camera);
// The cells that came with a scene; nullopt if there are none. For a cell scene they have what a search from inside uses: the
// real lines, and no portals that lead out of the outer box.
[[nodiscard]] std::optional<scene::CellComplex> cells_of_search(const scene::LoadedScene& source);
// Null if the name is unknown.
[[nodiscard]] const Explainer* find_explainer(std::string_view algorithm);

}  // namespace sightline::explain
