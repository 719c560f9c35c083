// The position of an eye relative to the bodies of a scene: in free space, on a face, or inside a solid.
//
// The test is exact. A ray along +x is perturbed by an infinitely small amount (less in y than in z), so that
// it meets no edge and no vertex. The eye is inside a solid if the ray crosses the solid's faces an odd
// number of times. A cavity is therefore outside its solid, and overlapping solids are tested separately.
// Sheets have no inside.
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
  std::size_t body = 0;  // if not free
  std::size_t face = 0;  // if on_face

  friend bool operator==(const EyePlace&, const EyePlace&) = default;
};

// The first face of the scene, in its order, that contains the eye, border included; otherwise the first
// solid around it. The scene is a checked one, and the eye's coordinates are below poly_coordinate_limit
// (precondition). Linear in the size of the scene.
[[nodiscard]] EyePlace eye_place(const PolyScene& scene, const PolyPoint& eye);

// An error that names body and face if the scene cannot be drawn from this camera by algorithms that need the
// eye in free space. The eye of an orthographic camera is not a position, so it may be anywhere.
[[nodiscard]] std::optional<base::Error> eye_error(const PolyScene& scene, const PolyCamera& camera);

// Whether the ray along +x from a point, perturbed as above, crosses a face without holes. False if the point is on the
// face's plane.
[[nodiscard]] bool ray_crosses(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> outline, const PolyPoint& from);

// Which cell contains a point?

// The number of the cell whose closed box contains the point. If there are several and the point is in an
// opening (closed), the lower-numbered cell of the lowest-numbered such opening; otherwise, on an opaque
// face, the lowest-numbered cell on the +z side, in the direction of view. An error if the point is in a
// solid or outside all cells.
[[nodiscard]] base::Result<std::size_t> locate(const CellScene& scene, const geometry::Point& point);

}  // namespace sightline::scene
