// An integer box around the intersection of several half-spaces: never too small, and exact if all planes are parallel to
// the axes.
#pragma once

#include <span>

#include "host/geometry/box.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/model/cell_complex.hpp"

namespace sightline::algorithms::jones {

// Shrinks `box` with each half-space in turn, rounding outwards. The half-spaces index `planes`. The result is empty
// (some low above its high) only if no point of the box is in all half-spaces.
[[nodiscard]] geometry::Box enclosing_box(geometry::Box box, std::span<const geometry::Plane> planes,
                                          std::span<const scene::HalfSpace> halves);

[[nodiscard]] constexpr bool is_empty(const geometry::Box& box) {
  return box.low[0] > box.high[0] || box.low[1] > box.high[1] || box.low[2] > box.high[2];
}

}  // namespace sightline::algorithms::jones
