#include "host/algorithms/montani_re/edge_parameter.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Int128;
using geometry::Rational;
using geometry::WideInteger;

// Like zero_between, for numbers wider than the resulting fraction, which says where an edge meets a line of the image.
// There p and p - q are, except for a common factor, determinants of three vectors of the scene (the edge's end and two
// points of the other edge, relative to the eye; or the direction of sight and two differences of points), or the
// distance of an end from the border of a window: in lowest terms below 6 * 2^(3 * 19), which is less than 2^60.
template <unsigned bits>
Rational wide_zero_between(const WideInteger<bits>& p, const WideInteger<bits>& q) {
  const auto denominator = p - q;
  const auto divisor = geometry::common_divisor(p, denominator);
  const auto in_lowest_terms = [&](const auto& part) {
    return static_cast<std::int64_t>(
        geometry::divide(part, divisor).quotient.template narrow<60>().to_int128());
  };
  return {in_lowest_terms(p), in_lowest_terms(denominator)};
}

Rational parameter_at_line(const Image& image, std::uint32_t edge, std::uint32_t other) {
  const ImageLine& line = image.lines()[edge];
  const Int128 p = image.value_at(other, line.from);
  const Int128 q = image.value_at(other, line.to);
  const std::int64_t divisor = image.divisor();
  const Int128 part_p = p / divisor;
  const Int128 part_q = q / divisor;
  return part_p * divisor == p && part_q * divisor == q ? zero_between(part_p, part_q) : zero_between(p, q);
}

// The part of an edge that meets several linear conditions.
class Part {
 public:
  // Keeps the part where a quantity is not negative that is p at the start of the edge and q at its end.
  void keep(Int128 p, Int128 q) {
    if (p >= 0 && q >= 0) return;
    if (p < 0 && q < 0) {
      high_ = low_;
      return;
    }
    const Rational zero = zero_between(p, q);
    if (p < 0 && low_ < zero) low_ = zero;
    if (q < 0 && zero < high_) high_ = zero;
  }
  void keep_between(const Image& image, const ImageLine& edge, std::uint32_t west, std::uint32_t east) {
    if (image.perspective()) keep(image.weight(edge.from), image.weight(edge.to));
    keep(image.value_at(west, edge.from), image.value_at(west, edge.to));
    keep(-image.value_at(east, edge.from), -image.value_at(east, edge.to));
  }
  [[nodiscard]] std::optional<geometry::Interval> interval() const {
    if (!(low_ < high_)) return std::nullopt;
    return geometry::Interval{low_, high_};
  }

 private:
  Rational low_{0};
  Rational high_{1};
};

}  // namespace

Rational zero_between(Int128 p, Int128 q) {
  const Int128 denominator = p - q;
  constexpr Int128 largest = Int128{1} << 62;
  if (denominator != 0 && -largest < p && p < largest && -largest < denominator && denominator < largest)
    return {static_cast<std::int64_t>(p), static_cast<std::int64_t>(denominator)};
  const Int128 divisor = geometry::common_divisor(p, denominator);
  if (divisor == 0) return {0};
  return {static_cast<std::int64_t>(p / divisor), static_cast<std::int64_t>(denominator / divisor)};
}

std::optional<geometry::Interval> part_between(const Image& image, std::uint32_t edge, std::uint32_t west,
                                               std::uint32_t east) {
  Part part;
  part.keep_between(image, image.lines()[edge], west, east);
  return part.interval();
}

std::optional<geometry::Interval> part_within(const Image& image, std::uint32_t edge, const Window& window) {
  const ImageLine& line = image.lines()[edge];
  Part part;
  part.keep_between(image, line, window.west, window.east);
  const auto above = [&](std::int64_t bound, std::uint32_t v) {
    return Int128{image.vertices()[v].y} * window.bounds.unit - Int128{bound} * image.weight(v);
  };
  part.keep(above(window.bounds.low[1], line.from), above(window.bounds.low[1], line.to));
  part.keep(-above(window.bounds.high[1], line.from), -above(window.bounds.high[1], line.to));
  return part.interval();
}

Rational parameter_at(const Image& image, std::uint32_t edge, const Ordinate& y) {
  const ImageLine& line = image.lines()[edge];
  if (y.second == edge) return parameter_at_line(image, edge, y.first);
  if (y.second != none && y.first == edge) return parameter_at_line(image, edge, y.second);
  if (y.second == none && y.first == line.from) return {0};
  if (y.second == none && y.first == line.to) return {1};
  const Vertex& p = image.vertices()[line.from];
  const Vertex& q = image.vertices()[line.to];
  if (y.second == none) {
    const Int128 numerator = image.vertices()[y.first].y;
    const Int128 denominator = image.weight(y.first);
    return zero_between(p.y * denominator - numerator * image.weight(line.from),
                        q.y * denominator - numerator * image.weight(line.to));
  }
  const Image::Quotient at = image.exact(y);
  using Coordinate = WideInteger<vertex_bits>;
  const auto value = [&](const Vertex& v, std::int64_t weight) {
    return Coordinate(v.y) * at.denominator - at.numerator * Coordinate(weight);
  };
  return wide_zero_between(value(p, image.weight(line.from)), value(q, image.weight(line.to)));
}

}  // namespace sightline::algorithms::montani_re
