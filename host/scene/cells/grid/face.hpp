// Converts an axis-parallel face to rectangles.
#pragma once

#include <optional>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct GridFace {
  std::size_t axis = 0;  // of its normal
  std::int32_t at = 0;
  bool faces_up = false;                        // the normal points to the positive end of the axis
  std::vector<geometry::Rectangle> rectangles;  // disjoint; together the face without its holes
};

// The axis of a face's normal; empty if the face is in no plane x, y or z = constant.
[[nodiscard]] std::optional<std::size_t> grid_axis_of(const PolyScene& scene, const PolyFace& face);

// Whether every side of the face is parallel to an axis.
[[nodiscard]] bool has_grid_sides(const PolyScene& scene, const PolyFace& face);

// The face is of a checked scene, with an axis and axis-parallel sides. Time k log k for k vertices, plus the
// steps between strips.
[[nodiscard]] GridFace grid_face_of(const PolyScene& scene, const PolyFace& face);

}  // namespace sightline::scene
