// The arithmetic of Jones's program on the PDP-7, routine by routine: MULDIV, perspective, the cut of a
// vector to the visible bound, the clip of a line and of a projected opening to a convex mask.
//
// Each function is the twin of one routine of firmware/pdp7/jones and gives the same numbers, so that a test
// can call the machine's routine through its label and compare. Source: firmware/pdp7/jones/SPECIFICATION.md
// sections 1 to 3. Space is in object units relative to the eye, the screen in half points relative to the
// centre of the window. Every number fits a word of 18 bits, or a double word of 36 where that is said; debug
// builds assert it. The searching and the display file are in jones_twin.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace sightline::harness::jones {

inline constexpr int max_mask_vertices = 16;
inline constexpr std::int32_t near_z = 8;
inline constexpr std::int32_t separation = 5;  // half the distance between the eyes of a stereo pair

struct SpacePoint {
  std::int32_t x = 0, y = 0, z = 0;
  friend constexpr bool operator==(const SpacePoint&, const SpacePoint&) = default;
};
struct SpaceSegment {
  SpacePoint p, q;
  friend constexpr bool operator==(const SpaceSegment&, const SpaceSegment&) = default;
};
struct ScreenPoint {
  std::int32_t x = 0, y = 0;
  friend constexpr bool operator==(const ScreenPoint&, const ScreenPoint&) = default;
};
struct ScreenSegment {
  ScreenPoint a, b;
  friend constexpr bool operator==(const ScreenSegment&, const ScreenSegment&) = default;
};

enum class Axis : std::uint8_t { x = 1, y = 2, z = 3 };  // A of a vector word: i, j, k

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

// What is shown on one half of a stereo pair, or on the whole screen.
struct Window {
  std::int32_t xlo = -1024, xhi = 1022, ylo = -1024, yhi = 1022;  // half points relative to the centre
  std::int32_t centre_x = 512, centre_y = 512;                    // points of the screen
  std::int32_t width_scale = 1024;                                // W: half points per unit of x/z
  std::int32_t bound_factor = 4;                                  // K: lines are cut at |x|, |y| <= K z

  [[nodiscard]] Mask mask() const;
};
enum class Pass : std::uint8_t { mono, left, right };
// scale: S, 64..4096. Section 1.
[[nodiscard]] Window window_of(Pass pass, std::int32_t scale);

// What one kind of work cost.
struct Work {
  std::uint64_t muldivs = 0;
  std::uint64_t products = 0;  // plain products with a double word for a result
};
struct Operations {
  Work projection, line_box, line_sloped, mask_box, mask_sloped, mask_area, display;
};

// floor((a b + floor(c/2)) / c) for a, b in 0..2^18-1, c in 1..2^18-1; nothing if the quotient does not fit
// 18 bits (the divide overflow of the machine).
[[nodiscard]] std::optional<std::int32_t> muldiv(std::int32_t a, std::int32_t b, std::int32_t c);

// B(z) = min(K z, 131071), z >= 0.
[[nodiscard]] std::int32_t bound(std::int32_t bound_factor, std::int32_t z);

// The least z of the near plane or beyond at which a coordinate of this magnitude is inside the bound.
[[nodiscard]] std::int32_t depth_inside(std::int32_t magnitude, std::int32_t bound_factor);

// The part of the axis-parallel vector p-q inside z >= near_z, |x| <= B(z), |y| <= B(z); nothing if no length
// is left.
[[nodiscard]] std::optional<SpaceSegment> seg3(const SpaceSegment& vector, Axis axis,
                                               std::int32_t bound_factor);

// Perspective of a point with z >= near_z; nothing on divide overflow.
[[nodiscard]] std::optional<ScreenPoint> project(const SpacePoint& point, std::int32_t width_scale,
                                                 Operations& operations);

// The visible part of the line a-b; nothing if none. A line on the boundary of the mask is kept.
[[nodiscard]] std::optional<ScreenSegment> clip2(const Mask& mask, const ScreenSegment& line,
                                                 Operations& operations);

// Points of a polygon while it is made: one more than a mask may keep, since the last may repeat the first.
class PolygonBuilder {
 public:
  // A point equal to the one before is dropped. False if there is no room: the polygon has too many vertices.
  [[nodiscard]] bool append(ScreenPoint point);
  // Drops the last point if it equals the first. False if more than 16 are left.
  [[nodiscard]] bool close();
  void reverse();
  [[nodiscard]] std::span<const ScreenPoint> points() const {
    return std::span(points_).first(static_cast<std::size_t>(count_));
  }

 private:
  std::array<ScreenPoint, max_mask_vertices + 1> points_{};
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
