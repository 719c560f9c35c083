#include "host/algorithms/montani_re/image.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Int128;

constexpr double unit = 0x1p-52;  // twice the rounding error of one operation, for a safe margin

// p q - r s, with a bound of its error.
struct Estimate {
  double value = 0;
  double error = 0;
};
Estimate difference_of_products(double p, double q, double r, double s) {
  const double first = p * q;
  const double second = r * s;
  return {first - second, 4 * unit * (std::abs(first) + std::abs(second))};
}

}  // namespace

void Image::reserve(std::size_t vertices, std::size_t lines) {
  vertices_.reserve(vertices);
  points_.reserve(vertices);
  lines_.reserve(lines);
  slants_.reserve(lines);
}

std::uint32_t Image::add_vertex(const Vertex& v) {
  vertices_.push_back(v);
  Point p;
  p.x = static_cast<double>(v.x);
  p.y = static_cast<double>(v.y);
  p.weight = perspective_ ? static_cast<double>(v.z) : 1;
  if (p.weight > 0) {
    p.image_x = p.x / p.weight;
    p.image_y = p.y / p.weight;
  }
  points_.push_back(p);
  largest_.x = std::max(largest_.x, std::abs(p.x));
  largest_.y = std::max(largest_.y, std::abs(p.y));
  largest_.weight = std::max(largest_.weight, std::abs(p.weight));
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

bool Image::distinct_images(std::uint32_t v, std::uint32_t w) const {
  const Vertex& p = vertices_[v];
  const Vertex& q = vertices_[w];
  return Int128{p.x} * weight(w) != Int128{q.x} * weight(v) ||
         Int128{p.y} * weight(w) != Int128{q.y} * weight(v);
}

std::uint32_t Image::add_line(std::uint32_t from, std::uint32_t to) {
  const Vertex& p = vertices_[from];
  const Vertex& q = vertices_[to];
  ImageLine line;
  line.from = from;
  line.to = to;
  line.a = Int128{p.y} * weight(to) - Int128{q.y} * weight(from);
  line.b = Int128{q.x} * weight(from) - Int128{p.x} * weight(to);
  line.c = Int128{p.x} * q.y - Int128{q.x} * p.y;
  if (line.a < 0 || (line.a == 0 && line.b < 0)) {
    line.a = -line.a;
    line.b = -line.b;
    line.c = -line.c;
  }
  line.approximate = {static_cast<double>(line.a), static_cast<double>(line.b), static_cast<double>(line.c)};
  Slant slant;
  if (!line.horizontal()) {
    slant.slope = -line.approximate[1] / line.approximate[0];
    slant.intercept = -line.approximate[2] / line.approximate[0];
  }
  lines_.push_back(line);
  slants_.push_back(slant);
  return static_cast<std::uint32_t>(lines_.size() - 1);
}

int Image::exact_side_of(std::uint32_t line, std::uint32_t vertex) const {
  if (lines_[line].from == vertex || lines_[line].to == vertex) return 0;
  return geometry::sign(value_at(line, vertex));
}

Image::Quotient Image::exact(const Ordinate& y) const {
  using Coordinate = geometry::WideInteger<vertex_bits>;
  if (y.second == none) return {Coordinate(vertices_[y.first].y), Coordinate(weight(y.first))};
  const ImageLine& l = lines_[y.first];
  const ImageLine& m = lines_[y.second];
  const Coefficient l_a(l.a);
  const Coefficient m_a(m.a);
  Quotient q{Coefficient(l.c) * m_a - Coefficient(m.c) * l_a,
             l_a * Coefficient(m.b) - m_a * Coefficient(l.b)};
  if (q.denominator.negative()) q = {-q.numerator, -q.denominator};
  return q;
}

Ordinate Image::crossing(std::uint32_t line, std::uint32_t other) const {
  if (line > other) std::swap(line, other);
  const auto& l = lines_[line].approximate;
  const auto& m = lines_[other].approximate;
  const Estimate numerator = difference_of_products(l[2], m[0], m[2], l[0]);
  const Estimate denominator = difference_of_products(l[0], m[1], m[0], l[1]);
  double value = 0;
  double error = 0;
  if (std::abs(denominator.value) > 2 * denominator.error) {
    value = numerator.value / denominator.value;
    error = (numerator.error + std::abs(value) * denominator.error) /
            (std::abs(denominator.value) - denominator.error) * (1 + 0x1p-40);
  }
  if (!(error < 0x1p-30 * std::abs(value)) && std::abs(value) + error > 0x1p-1000) error = -1;
  if (std::abs(denominator.value) <= 2 * denominator.error || error < 0) {
    const Quotient q = exact({0, 0, line, other});
    value = q.numerator.to_double() / q.denominator.to_double();
    error = 0;
  }
  error += 8 * unit * std::abs(value);
  return {value - error, value + error, line, other};
}

int Image::compare_exactly(const Ordinate& a, const Ordinate& b) const {
  if (a.second == none && b.second == none) {
    const Int128 left = Int128{vertices_[a.first].y} * weight(b.first);
    const Int128 right = Int128{vertices_[b.first].y} * weight(a.first);
    return (left > right ? 1 : 0) - (left < right ? 1 : 0);
  }
  const Quotient p = exact(a);
  const Quotient q = exact(b);
  return (p.numerator * q.denominator - q.numerator * p.denominator).sign();
}

bool Image::made_by(std::uint32_t line, const Ordinate& y) const {
  if (y.second != none) return y.first == line || y.second == line;
  return lines_[line].from == y.first || lines_[line].to == y.first;
}

// At y, X = -(b y + c) / a for both, so the difference has the sign of p y + q below.
int Image::order_exactly_at(std::uint32_t line, std::uint32_t other, const Ordinate& y) const {
  // Nearly all remaining pairs are lines that meet in the point of y.
  if (line == other || (made_by(line, y) && made_by(other, y))) return 0;
  const auto& l = lines_[line].approximate;
  const auto& m = lines_[other].approximate;
  const Estimate p = difference_of_products(m[1], l[0], l[1], m[0]);
  const Estimate q = difference_of_products(m[2], l[0], l[2], m[0]);
  const double middle = y.middle();
  const double value = p.value * middle + q.value;
  const double error = p.error * std::abs(middle) + q.error + std::abs(p.value) * (y.high - y.low) +
                       4 * unit * (std::abs(p.value * middle) + std::abs(q.value));
  if (value > error) return 1;
  if (value < -error) return -1;
  const ImageLine& el = lines_[line];
  const ImageLine& em = lines_[other];
  const Quotient at = exact(y);
  const Coefficient l_a(el.a);
  const Coefficient m_a(em.a);
  return ((Coefficient(em.b) * l_a - Coefficient(el.b) * m_a) * at.numerator +
          (Coefficient(em.c) * l_a - Coefficient(el.c) * m_a) * at.denominator)
      .sign();
}

double Image::abscissa(std::uint32_t line, double y) const {
  const auto& l = lines_[line].approximate;
  return -(l[1] * y + l[2]) / l[0];
}

}  // namespace sightline::algorithms::montani_re
