// The lessons there are, one for each algorithm: a row here, and a file of its own in this folder.
#pragma once

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
  // Of a scene of polyhedra: a checked one, seen by a camera whose eye is in free space (preconditions). `complex` is the
  // scene's own cells, null if it has none. An error says why there is no lesson.
  base::Result<Lesson> (*scene)(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                const scene::CellComplex* complex) = nullptr;
  // Of a surface over a grid; angles in degrees.
  base::Result<Lesson> (*heights)(const scene::HeightGrid& grid, double rotation, double elevation) = nullptr;
};

// One of the two functions is there.
[[nodiscard]] std::span<const Explainer> explainers();
// The lesson of a scene as it was read, with the cells it came with. Jones's of a scene of cells, with the eye in one of them, is of the
// real lines of its matter, which the program on the PDP-7 draws: those of the outer box are among them, joints of solids are not. Same
// preconditions as Explainer::scene, which `explainer` has.
[[nodiscard]] base::Result<Lesson> explain_scene(const Explainer& explainer, const scene::LoadedScene& source, const scene::PolyCamera& camera);
// Null if there is none of that name.
[[nodiscard]] const Explainer* find_explainer(std::string_view algorithm);

}  // namespace sightline::explain
