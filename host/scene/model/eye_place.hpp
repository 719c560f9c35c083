// The position of an eye relative to the bodies of a scene: in free space, on a face, or inside a solid.
//
// Decided exactly: a ray is sent along +x, moved aside by an infinitely small amount (less in y than in z) so
// that it meets no edge and no vertex; the eye is inside a solid iff the ray crosses the solid's faces an odd
// number of times. A cavity is therefore outside its solid, and solids that overlap are each tested
// separately. Sheets have no inside.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct EyePlace {
  enum class Kind { free, on_face, inside };
  Kind kind = Kind::free;
  std::size_t body = 0;  // where it is not free
  std::size_t face = 0;  // of on_face

  friend bool operator==(const EyePlace&, const EyePlace&) = default;
};

// The first face of the scene, in its order, that contains the eye, border included; else the first solid
// around it. The scene is a checked one, the eye's coordinates are below poly_coordinate_limit
// (precondition). Linear in the size of the scene.
[[nodiscard]] EyePlace eye_place(const PolyScene& scene, const PolyPoint& eye);

// Whether the scene can be drawn from this camera by those that need an eye in free space: an error naming
// body and face if not. The eye of an orthographic camera is no place, so it can be anywhere.
[[nodiscard]] std::optional<base::Error> eye_error(const PolyScene& scene, const PolyCamera& camera);

// Whether the ray along +x from a point, moved aside as above, crosses a face without holes, on whose plane the point is not; false
// if it is.
[[nodiscard]] bool ray_crosses(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> outline, const PolyPoint& from);

// Which cell is a point in?

// The number of the cell whose closed box contains the point. Where several do: if the point is in an opening
// (closed), the lower-numbered of the two cells of the lowest-numbered such opening; else, on an opaque face,
// the lowest-numbered cell on the side looked into (+z). An error if the point is in a solid or outside
// everything.
[[nodiscard]] base::Result<std::size_t> locate(const CellScene& scene, const geometry::Point& point);

}  // namespace sightline::scene
