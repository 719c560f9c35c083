// The image plane of a view, exactly: vertices, the lines through them, ordinates where lines cross, and the
// two questions that everything built on trapezoids comes down to: which of two ordinates is lower, and which
// of two lines is farther west at an ordinate.
//
// A vertex is (x, y, z) in the camera's frame: x to the right, y up, z away. Its image is (x / z, y / z) in
// perspective, else (x, y). A vertex that is not before the eye (z <= 0 in perspective) has no image, but the
// lines through it have: window.hpp. Sizes, |x|, |y|, |z| < 2^37: a line's coefficients 75 bits, an ordinate
// 151 over 151 bits, both questions 303 bits, as the types of the WideIntegers derive. The questions are
// answered in floating point where its error bound allows, or by the point's name where the lines meet in it,
// else exactly.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/geometry/wide_integer.hpp"

namespace sightline::algorithms::montani_re {

inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// Of x, y and z. A scene's vertex is less than 2^19 from the eye on every axis and a camera's vectors are
// below 2^15 (poly_scene.hpp), so that a product of the two is below 3 * 2^34; windows have the bits above
// for their own.
inline constexpr unsigned vertex_bits = 37;
inline constexpr unsigned coefficient_bits = 2 * vertex_bits + 1;  // x y' - x' y

struct Vertex {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

// a X + b Y + c = 0, a > 0, or a = 0 and b > 0 for a line of one ordinate; no common factor.
struct ImageLine {
  geometry::Int128 a = 0;
  geometry::Int128 b = 0;
  geometry::Int128 c = 0;
  std::array<double, 3> approximate{};
  double slope = 0;  // X = slope Y + intercept, unless it is horizontal: each wrong by at most one part in
  double intercept = 0;    // 2^51
  std::uint32_t from = 0;  // vertices
  std::uint32_t to = 0;

  [[nodiscard]] bool horizontal() const { return a == 0; }
};

// Of a vertex (`second` none), or of the crossing of two lines.
struct Ordinate {
  double low = 0;  // bounds of its value
  double high = 0;
  std::uint32_t first = 0;
  std::uint32_t second = none;

  [[nodiscard]] double middle() const { return low + (high - low) / 2; }
};

class Image {
 public:
  explicit Image(bool perspective) : perspective_(perspective) {}

  std::uint32_t add_vertex(const Vertex& v);
  // Two vertices whose images differ (precondition: distinct_images).
  std::uint32_t add_line(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] bool distinct_images(std::uint32_t v, std::uint32_t w) const;

  [[nodiscard]] bool perspective() const { return perspective_; }
  [[nodiscard]] const std::vector<Vertex>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<ImageLine>& lines() const { return lines_; }
  [[nodiscard]] std::int64_t weight(std::uint32_t v) const { return perspective_ ? vertices_[v].z : 1; }

  // Whether an end of the line is before the eye, and which: the first that is.
  [[nodiscard]] bool before_eye(std::uint32_t line) const {
    return weight(lines_[line].from) > 0 || weight(lines_[line].to) > 0;
  }
  [[nodiscard]] std::uint32_t end_before_eye(std::uint32_t line) const {
    return weight(lines_[line].from) > 0 ? lines_[line].from : lines_[line].to;
  }

  // a x + b y + c w of a vertex (x, y; weight w): 114 bits.
  [[nodiscard]] geometry::Int128 value_at(std::uint32_t line, std::uint32_t vertex) const {
    const ImageLine& l = lines_[line];
    const Vertex& v = vertices_[vertex];
    return l.a * v.x + l.b * v.y + l.c * weight(vertex);
  }

  // Of a vertex before the eye.
  [[nodiscard]] Ordinate ordinate_of(std::uint32_t vertex) const;
  // Of two lines that are neither parallel nor horizontal.
  [[nodiscard]] Ordinate crossing(std::uint32_t line, std::uint32_t other) const;

  // Negative, zero or positive: a is lower than, as high as, higher than b.
  [[nodiscard]] int compare(const Ordinate& a, const Ordinate& b) const {
    if (a.high < b.low) return -1;
    if (a.low > b.high) return 1;
    return a.first == b.first && a.second == b.second ? 0 : compare_exactly(a, b);
  }
  // Negative, zero or positive: at y, `line` is to the west of, on, to the east of `other`. None horizontal.
  [[nodiscard]] int order_at(std::uint32_t line, std::uint32_t other, const Ordinate& y) const {
    const ImageLine& l = lines_[line];
    const ImageLine& m = lines_[other];
    const double middle = y.middle();
    const double apart = l.slope - m.slope;
    const double value = apart * middle + (l.intercept - m.intercept);
    const double size = (std::abs(l.slope) + std::abs(m.slope)) * std::abs(middle) + std::abs(l.intercept) +
                        std::abs(m.intercept);
    // Less than eight roundings of at most 2^-53 of `size`, and what y is not known by; twice that, to be on
    // the safe side.
    const double error = 0x1p-49 * size + std::abs(apart) * (y.high - y.low);
    if (std::abs(value) > error) return value > 0 ? 1 : -1;
    return order_exactly_at(line, other, y);
  }
  // The abscissa of a line there, in floating point.
  [[nodiscard]] double abscissa(std::uint32_t line, double y) const;

  using Coefficient = geometry::WideInteger<coefficient_bits>;
  template <unsigned numerator_bits, unsigned denominator_bits>
  struct QuotientOf {
    geometry::WideInteger<numerator_bits> numerator;
    geometry::WideInteger<denominator_bits> denominator;  // positive
  };
  using Quotient = QuotientOf<2 * coefficient_bits + 1, 2 * coefficient_bits + 1>;
  [[nodiscard]] Quotient exact(const Ordinate& y) const;

 private:
  [[nodiscard]] int compare_exactly(const Ordinate& a, const Ordinate& b) const;
  [[nodiscard]] int order_exactly_at(std::uint32_t line, std::uint32_t other, const Ordinate& y) const;
  // The line passes the point of which y is the ordinate, its end or its crossing with another.
  [[nodiscard]] bool made_by(std::uint32_t line, const Ordinate& y) const;

  bool perspective_;
  std::vector<Vertex> vertices_;
  std::vector<ImageLine> lines_;
};

}  // namespace sightline::algorithms::montani_re
