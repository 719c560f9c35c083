// The visible face at every pixel of a view of a common scene: by exact sight lines, and by surfaces of heights.
#pragma once

#include "host/algorithms/registry/heights.hpp"
#include "host/compare/cross_check_scenes.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::compare {

// The face that the sight line of every pixel meets first (oracle/sight_oracle.hpp): its number over all bodies + 1;
// 0 for none.
[[nodiscard]] picture::PixelGrid nearest_faces(const CommonScene& scene, const CrossCheckView& view);

// The facets of a method's surface picture, painted far to near: the number of the scene's triangle + 1, 0 outside. A
// facet that is a whole cell is divided if the picture allows it and the scene's cell is divided. The method draws
// vectors, and the scene has heights (preconditions). Empty if a facet is no cell of the scene.
[[nodiscard]] picture::PixelGrid surface_faces(const registry::HeightAlgorithm& algorithm, const CommonScene& scene,
                                               const CrossCheckView& view);

}  // namespace sightline::compare
