// The lessons there are, one for each algorithm: a row here, and a file of its own in this folder.
#pragma once

#include <span>
#include <string_view>

#include "host/base/result.hpp"
#include "host/explain/lesson.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/poly_scene.hpp"

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
// Null if there is none of that name.
[[nodiscard]] const Explainer* find_explainer(std::string_view algorithm);

}  // namespace sightline::explain
