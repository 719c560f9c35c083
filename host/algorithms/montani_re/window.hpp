// A rectangle of the image plane, and the part of a face's image in it, exactly.
//
// In perspective, the image of a face that is partly in front of and partly behind the eye is infinite: an edge with one end
// in front of the eye is a ray from the image of that end, and where the face passes beside the eye its image has no side at
// all. Inside a window the image is finite: rays end at the borders, and a border replaces the missing side. No new kinds
// of points arise: every corner is a vertex, a corner of the window or a crossing of two lines of the image, so the sizes
// in image.hpp hold.
//
// The borders are not edges: sides on them are not own, unless an edge lies there.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "host/algorithms/montani_re/image.hpp"
#include "host/algorithms/montani_re/trapezoid_pcs.hpp"

namespace sightline::algorithms::montani_re {

// The rectangle from low / unit to high / unit in X and Y. The unit is positive (1 in orthographic views), all are below
// 2^37.
struct WindowBounds {
  std::array<std::int64_t, 2> low{-1, -1};
  std::array<std::int64_t, 2> high{1, 1};
  std::int64_t unit = 1;
};

struct Window {
  WindowBounds bounds;
  std::uint32_t west = none;  // lines
  std::uint32_t east = none;
  Ordinate bottom;
  Ordinate top;
};

// Adds the border lines and their vertices to the image.
[[nodiscard]] Window add_window(Image& image, const WindowBounds& bounds);

// Like trapezoid_pcs, but only inside the window and in front of the eye. If the number of sides is odd, the face extends to
// infinity: to the east if `far_side` is positive, otherwise to the west.
[[nodiscard]] TrapezoidPcs clipped_pcs(const Image& image, std::span<const std::uint32_t> lines,
                                       const Window& window, int far_side);

// The range of ordinates of an edge's image, at least as far as the window's height. Precondition: the edge is not
// horizontal and has an end in front of the eye.
struct Extent {
  Ordinate low;
  Ordinate high;
};
[[nodiscard]] Extent extent_of(const Image& image, std::uint32_t line, const Window* window);

}  // namespace sightline::algorithms::montani_re
