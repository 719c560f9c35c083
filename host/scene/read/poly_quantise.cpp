// See poly_quantise.hpp.
#include "host/scene/read/poly_quantise.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::scene {
namespace {

using Vertices = std::vector<std::array<double, 3>>;

constexpr double aim = 65536;         // coordinates keep at or below this in magnitude
constexpr double furthest = 1 << 30;  // an origin keeps below this

template <class Test>
bool all_coordinates(const Vertices& vertices, Test test) {
  for (const auto& vertex : vertices)
    for (const double c : vertex)
      if (!test(c)) return false;
  return true;
}

// The smallest power of two (positive, not subnormal) that goes into `length` at most `count` times.
double step_for(double length, double count) {
  int exponent = 0;
  static_cast<void>(std::frexp(length / count, &exponent));  // length / count <= 2^exponent
  double step = std::ldexp(1.0, std::max(exponent - 1, -1000));
  while (length > step * count) step *= 2;
  return step;
}

double steps(double value, double step) {
  return std::round(value / step);
}

bool lossless(const Vertices& vertices, const Quantisation& q) {
  return all_coordinates(vertices, [&](double c) {
    const double n = steps(c, q.step);
    return std::abs(n) <= aim && q.value_of(static_cast<std::int64_t>(n)) == c;
  });
}

}  // namespace

double Quantisation::value_of(std::int64_t n) const {
  // A division by 1000 is rounded once, a multiplication by 0.001 twice.
  const double inverse = std::round(1 / step);
  const bool part_of_one = step < 1 && inverse < 1e15 && 1 / inverse == step;
  return part_of_one ? static_cast<double>(n) / inverse : static_cast<double>(n) * step;
}

Quantisation quantisation_of(const Vertices& vertices) {
  Quantisation result;
  result.as_it_is = all_coordinates(
      vertices, [](double c) { return std::abs(c) < poly_coordinate_limit && std::floor(c) == c; });
  if (result.as_it_is) return result;
  for (const double step : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    result.step = step;
    if (lossless(vertices, result)) return result;
  }
  std::array<double, 3> low = vertices[0];
  std::array<double, 3> high = low;
  for (const auto& vertex : vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], vertex[a]);
      high[a] = std::max(high[a], vertex[a]);
    }
  }
  double size = 0;   // half the largest side
  double reach = 0;  // the largest coordinate
  for (std::size_t a = 0; a < 3; ++a) {
    size = std::max(size, high[a] / 2 - low[a] / 2);
    reach = std::max({reach, std::abs(low[a]), std::abs(high[a])});
  }
  const bool far = reach > 4 * size;
  // Half a step of rounding at either end: one less than the aim.
  result.step = far ? std::max(step_for(size, aim - 1), step_for(reach, furthest)) : step_for(reach, aim);
  for (std::size_t a = 0; a < 3 && far; ++a)
    result.origin[a] = static_cast<std::int32_t>(std::round((low[a] / 2 + high[a] / 2) / result.step));
  return result;
}

std::int32_t quantised(double value, const Quantisation& quantisation, std::size_t axis) {
  return static_cast<std::int32_t>(steps(value, quantisation.step) - quantisation.origin[axis]);
}

double file_coordinate(const PolyScene& scene, const PolyPoint& p, std::size_t axis) {
  const Quantisation q{false, scene.step, scene.origin};
  return q.value_of(std::int64_t{p[axis]} + scene.origin[axis]);
}

}  // namespace sightline::scene
