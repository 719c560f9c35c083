// Masks of Jones's program: the clip of a line and of a projected opening to a convex polygon on the screen.
//
// Twins of the routines of firmware/pdp7/jones that clip, in the same half points and with the same numbers.
// Source: firmware/pdp7/jones/SPECIFICATION.md section 3.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "host/harness/jones_twin_arithmetic.hpp"

namespace sightline::harness::jones {

inline constexpr int max_mask_vertices = 16;

// Convex, counter-clockwise, 3..16 vertices, with its box. What a mask shows is its box cut by the left sides
// of its sloped edges; axis-parallel edges lie on the box.
struct Mask {
  std::array<ScreenPoint, max_mask_vertices> vertices{};
  int count = 0;
  std::int32_t xlo = 0, xhi = 0, ylo = 0, yhi = 0;

  [[nodiscard]] std::span<const ScreenPoint> ring() const {
    return std::span(vertices).first(static_cast<std::size_t>(count));
  }
  friend constexpr bool operator==(const Mask&, const Mask&) = default;
};

[[nodiscard]] constexpr bool is_sloped(ScreenPoint a, ScreenPoint b) {
  return a.x != b.x && a.y != b.y;
}
[[nodiscard]] int sloped_edges(const Mask& mask);
// The first mask of a pass: the window.
[[nodiscard]] Mask mask_of(const Window& window);

// The visible part of the line a-b; nothing if none. A line on the boundary of the mask is kept.
[[nodiscard]] std::optional<ScreenSegment> clip2(const Mask& mask, const ScreenSegment& line,
                                                 Operations& operations);

// Points of a polygon while it is made.
class PolygonBuilder {
 public:
  // A point equal to the one before is dropped. False for a 17th: the polygon has too many vertices, even if
  // this last would repeat the first.
  [[nodiscard]] bool append(ScreenPoint point);
  // Drops the last point if it equals the first, unless it is the only one.
  void close();
  void reverse();
  [[nodiscard]] std::span<const ScreenPoint> points() const {
    return std::span(points_).first(static_cast<std::size_t>(count_));
  }

 private:
  std::array<ScreenPoint, max_mask_vertices> points_{};
  int count_ = 0;
};

enum class MaskOutcome : std::uint8_t { visible, empty, too_many_vertices };
struct Intersection {
  MaskOutcome outcome = MaskOutcome::empty;
  Mask mask;  // of `visible` only
};
// ring: counter-clockwise, 3..16 points.
[[nodiscard]] Intersection intersect(const Mask& mask, std::span<const ScreenPoint> ring,
                                     Operations& operations);

}  // namespace sightline::harness::jones
