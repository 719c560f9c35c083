// Masks of Jones's program: clips a line and a projected opening to a convex polygon on the screen.
//
// The twins of the clipping routines of firmware/pdp7/jones. With ShortWords, the default, the numbers are those of the
// machine; the templates compute the same with any other number of number.hpp. Source: firmware/pdp7/jones/SPECIFICATION.md
// section 3.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "host/programs/jones/twin/arithmetic.hpp"

namespace sightline::programs::jones {

inline constexpr int max_mask_vertices = 16;

// Convex, counter-clockwise, 3..16 vertices, with its box. The visible area of a mask is its box clipped by the left sides
// of its sloped edges; axis-parallel edges lie on the box.
template <class Coordinate>
struct BasicMask {
  std::array<BasicScreenPoint<Coordinate>, max_mask_vertices> vertices{};
  int count = 0;
  Coordinate xlo = 0, xhi = 0, ylo = 0, yhi = 0;

  [[nodiscard]] std::span<const BasicScreenPoint<Coordinate>> ring() const {
    return std::span(vertices).first(static_cast<std::size_t>(count));
  }
  friend constexpr bool operator==(const BasicMask&, const BasicMask&) = default;
};
using Mask = BasicMask<std::int32_t>;

template <class Coordinate>
[[nodiscard]] constexpr bool is_sloped(BasicScreenPoint<Coordinate> a, BasicScreenPoint<Coordinate> b) {
  return a.x != b.x && a.y != b.y;
}
template <class Coordinate>
[[nodiscard]] int sloped_edges(const BasicMask<Coordinate>& mask) {
  const auto ring = mask.ring();
  int count = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) count += is_sloped(ring[i], ring[(i + 1) % ring.size()]);
  return count;
}

// The mask of a polygon.
template <class Coordinate>
[[nodiscard]] BasicMask<Coordinate> mask_around(std::span<const BasicScreenPoint<Coordinate>> ring) {
  BasicMask<Coordinate> mask;
  mask.count = static_cast<int>(ring.size());
  std::copy(ring.begin(), ring.end(), mask.vertices.begin());
  mask.xlo = mask.xhi = ring.front().x;
  mask.ylo = mask.yhi = ring.front().y;
  for (const auto& p : ring) {
    mask.xlo = std::min(mask.xlo, p.x);
    mask.xhi = std::max(mask.xhi, p.x);
    mask.ylo = std::min(mask.ylo, p.y);
    mask.yhi = std::max(mask.yhi, p.y);
  }
  return mask;
}

// The first mask of a pass: the window.
template <class Coordinate>
[[nodiscard]] BasicMask<Coordinate> window_mask(const Window& window) {
  const auto xlo = static_cast<Coordinate>(window.xlo), xhi = static_cast<Coordinate>(window.xhi);
  const auto ylo = static_cast<Coordinate>(window.ylo), yhi = static_cast<Coordinate>(window.yhi);
  const std::array<BasicScreenPoint<Coordinate>, 4> corners{{{xlo, ylo}, {xhi, ylo}, {xhi, yhi}, {xlo, yhi}}};
  return mask_around(std::span<const BasicScreenPoint<Coordinate>>(corners));
}
[[nodiscard]] inline Mask mask_of(const Window& window) {
  return window_mask<std::int32_t>(window);
}

// The points of a polygon under construction.
template <class Coordinate>
class BasicPolygonBuilder {
 public:
  using Point = BasicScreenPoint<Coordinate>;

  // Drops a point equal to the one before. False for a 17th: the polygon has too many vertices, even if this last would
  // repeat the first.
  [[nodiscard]] bool append(Point point) {
    if (count_ > 0 && points_[count_ - 1] == point) return true;
    if (count_ == points_.size()) return false;
    points_[count_++] = point;
    return true;
  }
  // Drops the last point if it equals the first, unless it is the only one.
  void close() {
    if (count_ > 1 && points_[count_ - 1] == points_.front()) --count_;
  }
  // Keeps only the corners at which a counter-clockwise ring turns left, if there are three.
  void drop_hollow_corners() {
    for (std::size_t i = 0, straight = 0; count_ > 3 && straight < count_; i = (i + 1) % count_) {
      const Point a = points_[(i + count_ - 1) % count_], b = points_[i], c = points_[(i + 1) % count_];
      const auto turn = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
      ++straight;
      if (turn > 0) continue;
      std::copy(points_.begin() + static_cast<std::ptrdiff_t>(i) + 1, points_.begin() + static_cast<std::ptrdiff_t>(count_),
                points_.begin() + static_cast<std::ptrdiff_t>(i));
      --count_;
      straight = 0;
      i = (i + count_ - 1) % count_;
    }
  }
  void reverse() { std::reverse(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(count_)); }
  [[nodiscard]] std::span<const Point> points() const { return std::span(points_).first(count_); }

 private:
  std::array<Point, max_mask_vertices> points_{};
  std::size_t count_ = 0;
};
using PolygonBuilder = BasicPolygonBuilder<std::int32_t>;

enum class MaskOutcome : std::uint8_t { visible, empty, too_many_vertices };
template <class Coordinate>
struct BasicIntersection {
  MaskOutcome outcome = MaskOutcome::empty;
  BasicMask<Coordinate> mask;  // only if `visible`
};
using Intersection = BasicIntersection<std::int32_t>;

// Masks in the arithmetic of one number type, which also records overflow.
template <class Number>
class MaskClip {
 public:
  using Coordinate = typename Number::Coordinate;
  using Point = BasicScreenPoint<Coordinate>;

  MaskClip(Number& number, Operations& operations) : number_(number), operations_(operations) {}

  // The visible part of the line a-b; empty if none. A line on the boundary of the mask is kept.
  [[nodiscard]] std::optional<BasicScreenSegment<Coordinate>> clip2(
      const BasicMask<Coordinate>& mask, const BasicScreenSegment<Coordinate>& line);
  // ring: counter-clockwise, 3..16 points.
  [[nodiscard]] BasicIntersection<Coordinate> intersect(const BasicMask<Coordinate>& mask,
                                                        std::span<const Point> ring);

 private:
  using Distance = typename Number::Distance;
  // A clip line: one side of the box of a mask, or one of its sloped edges.
  struct BoxLine {
    Coordinate Point::*axis;
    Coordinate value;
    bool low;
  };
  struct SlopedLine {
    Point a, b;
  };

  static std::array<BoxLine, 4> box_lines(const BasicMask<Coordinate>& mask);
  Coordinate difference(Coordinate a, Coordinate b) { return number_.word(Distance{a} - b); }
  Distance product(Coordinate a, Coordinate b, Work& work);
  Distance distance(const BoxLine& line, Point p, Work& work);
  Distance distance(const SlopedLine& line, Point p, Work& work);
  Coordinate between(Coordinate from, Coordinate to, Share<Coordinate> share, Work& work);
  Point cross(const BoxLine& line, Point p, Point q, Distance dp, Distance dq, Work& work);
  Point cross(const SlopedLine& line, Point p, Point q, Distance dp, Distance dq, Work& work);
  // False if no part of the line is on the inner side.
  template <class ClipLine>
  bool clip_at(const ClipLine& at, BasicScreenSegment<Coordinate>& line, Work& work);
  template <class ClipLine>
  MaskOutcome clip_at(const ClipLine& at, BasicPolygonBuilder<Coordinate>& polygon, Work& work);
  Distance doubled_area(std::span<const Point> ring);

  Number& number_;
  Operations& operations_;
};
extern template class MaskClip<ShortWords>;
extern template class MaskClip<LongWords>;
extern template class MaskClip<MixedWords>;
extern template class MaskClip<SingleFloat>;
extern template class MaskClip<DoubleFloat>;

// With the machine's arithmetic.
[[nodiscard]] std::optional<ScreenSegment> clip2(const Mask& mask, const ScreenSegment& line,
                                                 Operations& operations);
[[nodiscard]] Intersection intersect(const Mask& mask, std::span<const ScreenPoint> ring,
                                     Operations& operations);

}  // namespace sightline::programs::jones
