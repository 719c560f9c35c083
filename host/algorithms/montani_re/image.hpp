// The exact image plane of a view: vertices, the lines through them, and the ordinates where lines cross. It answers the
// two questions that all trapezoid code reduces to: which of two ordinates is lower, and which of two lines is farther
// west at an ordinate.
//
// A vertex is (x, y, z) in the camera's frame: x to the right, y up, z away. Its image is (x / z, y / z) in perspective,
// otherwise (x, y). A vertex that is not in front of the eye (z <= 0 in perspective) has no image, but the lines through it do
// (window.hpp). With |x|, |y|, |z| < 2^37, a line's coefficients have 75 bits, an ordinate 151 over 151 bits, and both
// questions 303 bits, as the types of the WideIntegers derive. A question is answered in floating point if the error
// bound allows, by identity if the lines meet in the given point, and exactly otherwise.
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

// The bits of x, y and z. A scene's vertex is less than 2^19 from the eye on every axis and a camera's vectors are below
// 2^15 (poly_scene.hpp), so their product is below 3 * 2^34. Windows use the bits above.
inline constexpr unsigned vertex_bits = 37;
inline constexpr unsigned coefficient_bits = 2 * vertex_bits + 1;  // x y' - x' y

struct Vertex {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

// a X + b Y + c = 0 with a > 0, or a horizontal line with a = 0 and b > 0.
struct ImageLine {
  geometry::Int128 a = 0;
  geometry::Int128 b = 0;
  geometry::Int128 c = 0;
  std::array<double, 3> approximate{};
  std::uint32_t from = 0;  // vertices
  std::uint32_t to = 0;

  [[nodiscard]] bool horizontal() const { return a == 0; }
};

// The ordinate of a vertex (`second` is none), or of the crossing of two lines.
struct Ordinate {
  double low = 0;  // bounds of its value
  double high = 0;
  std::uint32_t first = 0;
  std::uint32_t second = none;

  [[nodiscard]] double middle() const { return low + (high - low) / 2; }
};

// The middle of an ordinate's bounds, and how far apart they are.
struct Middle {
  explicit Middle(const Ordinate& ordinate) : y(ordinate.middle()), spread(ordinate.high - ordinate.low) {}

  double y;
  double spread;
};

// Bounds of the abscissa of a line at an ordinate.
struct Abscissa {
  double low = 0;
  double high = 0;
};

class Image {
 public:
  // The divisor, positive, is the common factor that the camera's vectors contribute to a x + b y + c w, for every line
  // through two vertices of the scene and every third vertex. A smaller divisor of these sums costs time only.
  explicit Image(bool perspective, std::int64_t divisor = 1) : perspective_(perspective), divisor_(divisor) {}

  // Reserves memory. More vertices and lines may be added.
  void reserve(std::size_t vertices, std::size_t lines);
  std::uint32_t add_vertex(const Vertex& v);
  // Adds the line through two vertices. Precondition: distinct_images.
  std::uint32_t add_line(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] bool distinct_images(std::uint32_t v, std::uint32_t w) const;

  [[nodiscard]] bool perspective() const { return perspective_; }
  [[nodiscard]] std::int64_t divisor() const { return divisor_; }
  [[nodiscard]] const std::vector<Vertex>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<ImageLine>& lines() const { return lines_; }
  [[nodiscard]] std::int64_t weight(std::uint32_t v) const { return perspective_ ? vertices_[v].z : 1; }

  // Whether an end of the line is in front of the eye, and the first end that is.
  [[nodiscard]] bool before_eye(std::uint32_t line) const {
    return weight(lines_[line].from) > 0 || weight(lines_[line].to) > 0;
  }
  [[nodiscard]] std::uint32_t end_before_eye(std::uint32_t line) const {
    return weight(lines_[line].from) > 0 ? lines_[line].from : lines_[line].to;
  }

  // a x + b y + c w at a vertex (x, y) of weight w: 114 bits.
  [[nodiscard]] geometry::Int128 value_at(std::uint32_t line, std::uint32_t vertex) const {
    const ImageLine& l = lines_[line];
    const Vertex& v = vertices_[vertex];
    return l.a * v.x + l.b * v.y + l.c * weight(vertex);
  }

  // The sign of value_at.
  [[nodiscard]] int side_of(std::uint32_t line, std::uint32_t vertex) const {
    const double at = approximate_value_at(line, vertex);
    if (std::abs(at) > error_of(line)) return at > 0 ? 1 : -1;
    return exact_side_of(line, vertex);
  }
  // value_at, with an error of at most error_of(line).
  [[nodiscard]] double approximate_value_at(std::uint32_t line, std::uint32_t vertex) const {
    const auto& l = lines_[line].approximate;
    const Point& p = points_[vertex];
    return l[0] * p.x + l[1] * p.y + l[2] * p.weight;
  }
  // Six roundings of at most 2^-53 of the largest possible terms; the bound is more than twice that.
  [[nodiscard]] double error_of(std::uint32_t line) const {
    const auto& l = lines_[line].approximate;
    return 0x1p-49 * (std::abs(l[0]) * largest_.x + std::abs(l[1]) * largest_.y + std::abs(l[2]) * largest_.weight);
  }
  // X and Y of the image of a vertex in front of the eye, each with a relative error of at most 2^-52.
  [[nodiscard]] double approximate_x(std::uint32_t vertex) const { return points_[vertex].image_x; }
  [[nodiscard]] double approximate_y(std::uint32_t vertex) const { return points_[vertex].image_y; }

  // Precondition: the vertex is in front of the eye.
  [[nodiscard]] Ordinate ordinate_of(std::uint32_t vertex) const {
    const double value = points_[vertex].image_y;
    const double error = std::abs(value) * 0x1p-52;
    return {value - error, value + error, vertex, none};
  }
  // Precondition: the lines are neither parallel nor horizontal.
  [[nodiscard]] Ordinate crossing(std::uint32_t line, std::uint32_t other) const;

  // Negative, zero or positive: a is below, level with, above b.
  [[nodiscard]] int compare(const Ordinate& a, const Ordinate& b) const {
    if (a.high < b.low) return -1;
    if (a.low > b.high) return 1;
    return a.first == b.first && a.second == b.second ? 0 : compare_exactly(a, b);
  }
  // Negative, zero or positive: at y, `line` is to the west of, on, to the east of `other`. Precondition: neither is
  // horizontal.
  [[nodiscard]] int order_at(std::uint32_t line, std::uint32_t other, const Ordinate& y) const {
    return order_at(line, abscissa_at(line, y), other, abscissa_at(other, y), y);
  }
  // The same, for lines whose bounds at y are known.
  [[nodiscard]] int order_at(std::uint32_t line, const Abscissa& at, std::uint32_t other, const Abscissa& other_at,
                             const Ordinate& y) const {
    if (at.high < other_at.low) return -1;
    if (at.low > other_at.high) return 1;
    return order_exactly_at(line, other, y);
  }
  // Precondition: the line is not horizontal. Two roundings of at most 2^-51 and three of 2^-53 are less than 2^-50 of
  // the terms; the bound is twice that, plus the uncertainty of y.
  [[nodiscard]] Abscissa abscissa_at(std::uint32_t line, const Ordinate& y) const { return abscissa_at(line, Middle(y)); }
  [[nodiscard]] Abscissa abscissa_at(std::uint32_t line, const Middle& middle) const {
    const Slant& slant = slants_[line];
    const double part = slant.slope * middle.y;
    const double x = part + slant.intercept;
    const double error =
        0x1p-49 * (std::abs(part) + std::abs(slant.intercept)) + std::abs(slant.slope) * middle.spread;
    return {x - error, x + error};
  }
  // The approximate abscissa of a line at an ordinate.
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
  // Whether the line passes through the point of y: y is the ordinate of its end or of its crossing with another line.
  [[nodiscard]] bool made_by(std::uint32_t line, const Ordinate& y) const;

  [[nodiscard]] int exact_side_of(std::uint32_t line, std::uint32_t vertex) const;

  // A vertex in floating point. Only the image is rounded.
  struct Point {
    double x = 0;
    double y = 0;
    double weight = 0;
    double image_x = 0;
    double image_y = 0;
  };
  // X = slope Y + intercept, each with a relative error of at most 2^-51; 0 for a horizontal line. Most questions are
  // answered from these alone, so they are in an array of their own.
  struct Slant {
    double slope = 0;
    double intercept = 0;
  };

  bool perspective_;
  std::int64_t divisor_;
  std::vector<Vertex> vertices_;
  std::vector<Point> points_;  // by vertex
  Point largest_;              // the largest magnitude of each coordinate over all vertices
  std::vector<ImageLine> lines_;
  std::vector<Slant> slants_;  // by line
};

}  // namespace sightline::algorithms::montani_re
