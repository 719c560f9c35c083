// See poly_quantise.hpp.
#include "host/scene/read/poly_quantise.hpp"

#include <algorithm>
#include <cmath>

#include "host/scene/model/file_units.hpp"

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
  return steps_in_file(n, step);
}

namespace {

Quantisation without_eye(const Vertices& vertices) {
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

}  // namespace

Quantisation quantisation_of(const Vertices& vertices, const std::optional<std::array<double, 3>>& eye) {
  Quantisation q = without_eye(vertices);
  if (!eye || vertices.empty()) return q;
  const auto reach = [&](const std::array<double, 3>& p) {
    double most = 0;
    for (std::size_t a = 0; a < 3; ++a) most = std::max(most, std::abs(p[a] / q.step - q.origin[a]));
    return most;
  };
  const bool between = std::any_of(eye->begin(), eye->end(), [](double c) { return std::floor(c) != c; });
  if (q.as_it_is && between) {  // halves of the step lose nothing
    double most = reach(*eye);
    for (const auto& vertex : vertices) most = std::max(most, reach(vertex));
    for (; 2 * most <= aim; most *= 2) q.step /= 2;
    q.as_it_is = q.step == 1;
  }
  int exponent = 0;
  const double longer = std::frexp(q.step, &exponent) == 0.5 ? 2 : 10;  // a power of ten stays one
  while (reach(*eye) > poly_coordinate_limit - 2) {
    q.as_it_is = false;
    q.step *= longer;
    for (std::int32_t& o : q.origin) o = static_cast<std::int32_t>(std::round(o / longer));
  }
  return q;
}

std::int32_t quantised(double value, const Quantisation& quantisation, std::size_t axis) {
  return static_cast<std::int32_t>(steps(value, quantisation.step) - quantisation.origin[axis]);
}

}  // namespace sightline::scene
