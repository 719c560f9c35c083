// A rectangle of the image plane, and the part of a face's image in it, exactly.
//
// In perspective a face that reaches from before the eye to behind it has an infinite image:
// an edge with one end before the eye is a ray from the image of that end, and where the face passes beside
// the eye its image has no side at all. Inside a window all of it is finite: rays end at the borders, and the
// missing side is a border. Nothing new is computed: every corner is a vertex, a corner of the window or a
// crossing of two lines of the image, so that the sizes in image.hpp hold.
//
// The borders are no edges: sides on them are not own, unless an edge lies there.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "host/algorithms/montani_re/image.hpp"
#include "host/algorithms/montani_re/trapezoid_pcs.hpp"

namespace sightline::algorithms::montani_re {

// From low / unit to high / unit, X and Y; unit positive (1 without perspective), all below 2^37.
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

// Adds two lines and their vertices to the image.
[[nodiscard]] Window add_window(Image& image, const WindowBounds& bounds);

// As trapezoid_pcs, inside the window; only what is before the eye. Where the number of sides is odd, the
// face goes on to infinity: to the east if `far_side` is positive, else to the west.
[[nodiscard]] TrapezoidPcs clipped_pcs(const Image& image, std::span<const std::uint32_t> lines,
                                       const Window& window, int far_side);

// The ordinates between which the image of an edge lies in the window's height, or beyond it; the edge is not
// horizontal and has an end before the eye.
struct Extent {
  Ordinate low;
  Ordinate high;
};
[[nodiscard]] Extent extent_of(const Image& image, std::uint32_t line, const Window* window);

}  // namespace sightline::algorithms::montani_re
