// The surfaces of a scene: its faces divided into convex pieces, seen from outside; those of sheets from both sides.
#pragma once

#include <vector>

#include "host/algorithms/willis/surface.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

// Precondition: the scene is checked. Faces that are not convex, or have holes, are divided into triangles between their
// corners, which are joined as long as the result is convex. The error names a face with too many corners.
[[nodiscard]] base::Result<std::vector<Surface>> surfaces_of(const scene::PolyScene& scene);

// The walls in plan, as in the paper. The error names a face that is neither level nor a rectangle with two vertical
// sides. Level faces (roofs, floors) are omitted.
[[nodiscard]] base::Result<std::vector<Surface>> walls_of(const scene::PolyScene& scene,
                                                          std::size_t vertical);

// Maps the number of a face, counted over all bodies, to its body and its number there.
struct FacePlace {
  std::size_t body = 0;
  std::size_t face = 0;
};
[[nodiscard]] std::vector<FacePlace> face_places(const scene::PolyScene& scene);

}  // namespace sightline::algorithms::willis
