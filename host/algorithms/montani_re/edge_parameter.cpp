#include "host/algorithms/montani_re/edge_parameter.hpp"

#include <gmpxx.h>

#include <cassert>
#include <utility>

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Int128;
using geometry::Rational;

mpz_class big(const Image::Number& n) {
  const bool negative = n.sign() < 0;
  const Image::Number magnitude = negative ? Image::Number{} - n : n;
  mpz_class value = 0;
  for (std::size_t i = 5; i-- > 0;) {
    mpz_class limb;
    const std::uint64_t part = magnitude.limb(i);
    mpz_import(limb.get_mpz_t(), 1, 1, sizeof part, 0, 0, &part);
    value = (value << 64) + limb;
  }
  return negative ? mpz_class(-value) : value;
}

// As zero_between. Both numbers are longer than the fraction, which is one of where an edge meets a line of
// the image. There p and p - q are, but for a common factor, determinants of three vectors of the scene (the
// edge's end and two points of the other edge, from the eye; or the direction of sight and two differences
// of points), or what separates an end from the border of a window: less than 2^60 in lowest terms.
Rational wide_zero_between(const mpz_class& p, const mpz_class& q) {
  mpz_class numerator = p;
  mpz_class denominator = p - q;
  const mpz_class divisor = gcd(numerator, denominator);
  numerator /= divisor;
  denominator /= divisor;
  assert(numerator.fits_slong_p() && denominator.fits_slong_p());
  return {numerator.get_si(), denominator.get_si()};
}

Rational parameter_at_line(const Image& image, std::uint32_t edge, std::uint32_t other) {
  const ImageLine& line = image.lines()[edge];
  return zero_between(image.value_at(other, line.from), image.value_at(other, line.to));
}

// What is left of an edge after conditions that are linear along it.
class Part {
 public:
  // A quantity must not be negative that is p at the start of the edge and q at its end.
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
  Int128 numerator = p;
  Int128 denominator = p - q;
  Int128 a = numerator < 0 ? -numerator : numerator;
  Int128 b = denominator < 0 ? -denominator : denominator;
  while (b != 0) a = std::exchange(b, a % b);
  if (a == 0) return {0};
  return {static_cast<std::int64_t>(numerator / a), static_cast<std::int64_t>(denominator / a)};
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
  const mpz_class numerator = big(at.numerator);
  const mpz_class denominator = big(at.denominator);
  const auto value = [&](const Vertex& v, std::int64_t weight) {
    return mpz_class(mpz_class(static_cast<long>(v.y)) * denominator -
                     numerator * mpz_class(static_cast<long>(weight)));
  };
  return wide_zero_between(value(p, image.weight(line.from)), value(q, image.weight(line.to)));
}

}  // namespace sightline::algorithms::montani_re
