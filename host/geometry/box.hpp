// Integer points, boxes and rectangles parallel to the axes.
//
// Coordinates are below 2^15 in magnitude (coordinate_limit, checked when files are read), so differences fit in 17 bits,
// products of two in 34, and a volume in 51: int32 holds a coordinate, int64 everything computed from three. Axes 0, 1, 2
// are x (right), y (up), z (away from the viewer), in the paper i, j, k.
//
// Laws: a contains b iff it contains both corners of b; a overlaps b iff b overlaps a, and iff the box of the greater low
// and the lesser high coordinates has a volume; an empty box overlaps nothing; the six faces of a box bound it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sightline::geometry {

inline constexpr std::int32_t coordinate_limit = 1 << 15;  // every |coordinate| is less than this

using Point = std::array<std::int32_t, 3>;

// The interval low..high on one axis.
struct Span {
  std::int32_t low = 0;
  std::int32_t high = 0;

  [[nodiscard]] constexpr bool empty() const { return low >= high; }
  [[nodiscard]] constexpr std::int64_t length() const { return std::int64_t{high} - low; }
  // Ends included.
  [[nodiscard]] constexpr bool contains(std::int32_t c) const { return low <= c && c <= high; }
  [[nodiscard]] constexpr bool contains(Span s) const { return low <= s.low && s.high <= high; }
  // Whether they have more than a point in common.
  [[nodiscard]] constexpr bool overlaps(Span s) const {
    return (low > s.low ? low : s.low) < (high < s.high ? high : s.high);
  }
  friend constexpr bool operator==(const Span&, const Span&) = default;
};

struct Box {
  Point low{};
  Point high{};

  [[nodiscard]] constexpr Span span(std::size_t axis) const { return {low[axis], high[axis]}; }
  [[nodiscard]] constexpr bool empty() const { return span(0).empty() || span(1).empty() || span(2).empty(); }
  [[nodiscard]] constexpr std::int64_t volume() const {
    return empty() ? 0 : span(0).length() * span(1).length() * span(2).length();
  }
  // Surface included.
  [[nodiscard]] constexpr bool contains(const Point& p) const {
    return span(0).contains(p[0]) && span(1).contains(p[1]) && span(2).contains(p[2]);
  }
  [[nodiscard]] constexpr bool contains(const Box& b) const {
    return span(0).contains(b.span(0)) && span(1).contains(b.span(1)) && span(2).contains(b.span(2));
  }
  // Without the surface.
  [[nodiscard]] constexpr bool contains_inside(const Point& p) const {
    bool inside = true;
    for (std::size_t a = 0; a < 3; ++a) inside = inside && low[a] < p[a] && p[a] < high[a];
    return inside;
  }
  // Whether they have a common volume, not just a common surface.
  [[nodiscard]] constexpr bool overlaps(const Box& b) const {
    return span(0).overlaps(b.span(0)) && span(1).overlaps(b.span(1)) && span(2).overlaps(b.span(2));
  }
  friend constexpr bool operator==(const Box&, const Box&) = default;
};

// The two axes other than `axis`, ascending: the order in which a rectangle's sides are given.
[[nodiscard]] constexpr std::array<std::size_t, 2> other_axes(std::size_t axis) {
  return {axis == 0 ? std::size_t{1} : std::size_t{0}, axis == 2 ? std::size_t{1} : std::size_t{2}};
}

// A rectangle in the plane where coordinate `axis` is `at`; sides on other_axes(axis).
struct Rectangle {
  std::size_t axis = 0;
  std::int32_t at = 0;
  std::array<Span, 2> sides{};

  [[nodiscard]] constexpr bool empty() const { return sides[0].empty() || sides[1].empty(); }
  // Whether they have a common area.
  [[nodiscard]] constexpr bool overlaps(const Rectangle& r) const {
    return axis == r.axis && at == r.at && sides[0].overlaps(r.sides[0]) && sides[1].overlaps(r.sides[1]);
  }
  // The rectangle as a box without depth.
  [[nodiscard]] constexpr Box bounds() const {
    const auto [u, v] = other_axes(axis);
    Box box;
    box.low[axis] = box.high[axis] = at;
    box.low[u] = sides[0].low;
    box.high[u] = sides[0].high;
    box.low[v] = sides[1].low;
    box.high[v] = sides[1].high;
    return box;
  }
  friend constexpr bool operator==(const Rectangle&, const Rectangle&) = default;
};

// The face of `box` on its low or high side of `axis`.
[[nodiscard]] constexpr Rectangle face_of(const Box& box, std::size_t axis, bool high) {
  const auto [u, v] = other_axes(axis);
  return {axis, high ? box.high[axis] : box.low[axis], {box.span(u), box.span(v)}};
}

}  // namespace sightline::geometry
