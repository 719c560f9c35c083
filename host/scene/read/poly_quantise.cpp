// See poly_quantise.hpp.
#include "host/scene/read/poly_quantise.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/threads.hpp"
#include "host/scene/model/file_units.hpp"

namespace sightline::scene {
namespace {

using Vertices = std::vector<std::array<double, 3>>;

constexpr double aim = 65536;        // coordinates keep at or below this in magnitude, from the origin
constexpr double most_steps = 0x1p53;  // from 0, so that the number of each step is a double

struct Bounds {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  bool whole = true;  // all coordinates are integers

  [[nodiscard]] double size() const {  // half the largest side
    double result = 0;
    for (std::size_t a = 0; a < 3; ++a) result = std::max(result, high[a] / 2 - low[a] / 2);
    return result;
  }
  [[nodiscard]] double reach() const {  // the largest coordinate
    double result = 0;
    for (std::size_t a = 0; a < 3; ++a) result = std::max({result, std::abs(low[a]), std::abs(high[a])});
    return result;
  }
};

Bounds bounds_of(const Vertices& vertices) {
  Bounds bounds;
  if (vertices.empty()) return bounds;
  bounds.low = bounds.high = vertices[0];
  for (const auto& vertex : vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      bounds.low[a] = std::min(bounds.low[a], vertex[a]);
      bounds.high[a] = std::max(bounds.high[a], vertex[a]);
      bounds.whole = bounds.whole && std::floor(vertex[a]) == vertex[a];
    }
  }
  return bounds;
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

bool is_lossless(const Vertices& vertices, const Quantisation& q, unsigned jobs) {
  const auto keeps = [&q](const std::array<double, 3>& vertex) {
    return std::all_of(vertex.begin(), vertex.end(), [&](double c) { return q.value_of(static_cast<std::int64_t>(steps(c, q.step))) == c; });
  };
  std::vector<std::uint8_t> keeps_all(jobs);
  base::for_parts(jobs, vertices.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    keeps_all[part] = std::all_of(vertices.data() + begin, vertices.data() + end, keeps) ? 1 : 0;
  });
  return std::count(keeps_all.begin(), keeps_all.end(), 0) == 0;
}

// The middle of the scene, rounded down, so that the scene is the same wherever it lies.
PolyOrigin middle_of(const Bounds& bounds, double step) {
  PolyOrigin middle{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto sum = static_cast<std::int64_t>(steps(bounds.low[a], step)) + static_cast<std::int64_t>(steps(bounds.high[a], step));
    middle[a] = sum / 2 - (sum % 2 < 0 ? 1 : 0);
  }
  return middle;
}

// What one step stands for, by the size of the scene alone.
Quantisation without_origin(const Vertices& vertices, const Bounds& bounds, unsigned jobs) {
  Quantisation result;
  const double size = bounds.size();
  const double reach = bounds.reach();
  // Whole numbers below the limit stay what they are, and so do those that are below it when they are moved to 0.
  result.as_it_is =
      bounds.whole && (reach < poly_coordinate_limit || (2 * size < poly_coordinate_limit && reach < most_steps));
  if (result.as_it_is) return result;
  for (const double step : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    if (std::round(size / step) > aim || reach / step >= most_steps) continue;
    result.step = step;
    if (is_lossless(vertices, result, jobs)) return result;
  }
  result.step = std::max(step_for(size, aim), step_for(reach, most_steps));
  return result;
}

}  // namespace

double Quantisation::value_of(std::int64_t n) const {
  return steps_in_file(n, step);
}

Quantisation quantisation_of(const Vertices& vertices, const std::optional<std::array<double, 3>>& eye, unsigned jobs) {
  const Bounds bounds = bounds_of(vertices);
  Quantisation q = without_origin(vertices, bounds, jobs);
  // Where all coordinates are small enough, they are counted from 0.
  const double room = q.as_it_is ? poly_coordinate_limit - 1 : aim;
  if (steps(bounds.reach(), q.step) > room) q.origin = middle_of(bounds, q.step);
  if (!eye || vertices.empty()) return q;
  const auto reach = [&](const std::array<double, 3>& p) {
    double most = 0;
    for (std::size_t a = 0; a < 3; ++a) most = std::max(most, std::abs(p[a] / q.step - static_cast<double>(q.origin[a])));
    return most;
  };
  const bool between = std::any_of(eye->begin(), eye->end(), [](double c) { return std::floor(c) != c; });
  if (q.as_it_is && between) {  // halves of the step lose nothing
    double most = std::max({reach(*eye), reach(bounds.low), reach(bounds.high)});
    for (; 2 * most <= aim && 2 * bounds.reach() / q.step < most_steps; most *= 2) {
      q.step /= 2;
      for (std::int64_t& o : q.origin) o *= 2;
    }
    q.as_it_is = q.step == 1;
  }
  int exponent = 0;
  const std::int64_t longer = std::frexp(q.step, &exponent) == 0.5 ? 2 : 10;  // a power of ten stays one
  while (reach(*eye) > poly_coordinate_limit - 2) {
    q.as_it_is = false;
    q.step *= static_cast<double>(longer);
    for (std::int64_t& o : q.origin) o /= longer;
  }
  return q;
}

std::int32_t quantised(double value, const Quantisation& quantisation, std::size_t axis) {
  const double count = quantisation.as_it_is ? value : steps(value, quantisation.step);
  return static_cast<std::int32_t>(static_cast<std::int64_t>(count) - quantisation.origin[axis]);
}

}  // namespace sightline::scene
