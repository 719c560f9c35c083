// The surfaces of a scene: its faces in convex pieces, as seen from outside; those of sheets from both sides.
#pragma once

#include <vector>

#include "host/algorithms/willis/surface.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

// The scene is a checked one (precondition). Faces that are not convex, or have holes, are made of triangles
// between their own corners, joined as long as they stay convex. An error names a face with too many corners.
[[nodiscard]] base::Result<std::vector<Surface>> surfaces_of(const scene::PolyScene& scene);

// The walls in plan, as the paper has them. An error names a face that is neither a rectangle with two
// vertical sides nor level; level faces (roofs, floors) have no part in a plan and are left out.
[[nodiscard]] base::Result<std::vector<Surface>> walls_of(const scene::PolyScene& scene,
                                                          std::size_t vertical);

// Number of a face counted over all bodies -> its body, and its number there.
struct FacePlace {
  std::size_t body = 0;
  std::size_t face = 0;
};
[[nodiscard]] std::vector<FacePlace> face_places(const scene::PolyScene& scene);

}  // namespace sightline::algorithms::willis
