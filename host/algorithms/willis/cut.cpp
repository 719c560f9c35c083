#include "host/algorithms/willis/cut.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace sightline::algorithms::willis {

namespace {

// The middle of a and b, or the nearest lattice point between them; nullopt if there is none.
std::optional<Point> middle(const Point& a, const Point& b) {
  const Vector3 d = between(b, a);
  const std::int64_t steps = std::gcd(std::gcd(d[0], d[1]), d[2]);
  if (steps < 2) return std::nullopt;
  Point m{};
  for (std::size_t i = 0; i < 3; ++i) m[i] = static_cast<std::int32_t>(a[i] + d[i] / steps * (steps / 2));
  return m;
}

Surface piece_of(const Surface& s, std::vector<Point> points) {
  Surface piece = s;
  piece.points = std::move(points);
  piece.depth = s.depth + 1;
  return piece;
}

// A possible end of a chord: a corner or the middle of an edge, in the order of the outline.
struct Stop {
  Point point{};
  std::size_t place = 0;  // 2 i for corner i, 2 i + 1 for the middle of the edge after it
};

std::vector<Stop> stops_of(const std::vector<Point>& points) {
  std::vector<Stop> stops;
  stops.reserve(2 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    stops.push_back({points[i], 2 * i});
    if (const auto m = middle(points[i], points[(i + 1) % points.size()])) stops.push_back({*m, 2 * i + 1});
  }
  return stops;
}

// spans[i * n + k]: squared diameter of stop i and the next k stops around the outline.
std::vector<std::uint64_t> spans_of(const std::vector<Stop>& stops) {
  const std::size_t n = stops.size();
  std::vector<std::uint64_t> spans(n * n);
  for (std::size_t k = 1; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint64_t chord = squared_distance(stops[i].point, stops[(i + k) % n].point);
      spans[i * n + k] = std::max({spans[i * n + k - 1], spans[(i + 1) % n * n + k - 1], chord});
    }
  }
  return spans;
}

// Whether a chord is along an edge, so that it cuts nothing off.
bool on_one_edge(std::size_t a, std::size_t b, std::size_t places) {
  const std::size_t apart = (b + places - a) % places;
  return apart <= 1 || apart + 1 >= places || (apart == 2 && a % 2 == 0) ||
         (apart + 2 == places && b % 2 == 0);
}

// Corners from `first` to `last`, inclusive, without the middles between.
std::vector<Point> part(const std::vector<Stop>& stops, std::size_t first, std::size_t last) {
  std::vector<Point> points;
  for (std::size_t i = first;; i = (i + 1) % stops.size()) {
    if (i == first || i == last || stops[i].place % 2 == 0) points.push_back(stops[i].point);
    if (i == last) return points;
  }
}

// The point where the segment p, q crosses a plane whose values there are a and b, of opposite signs.
std::optional<Point> crossing(const Point& p, const Point& q, Int128 a, Int128 b) {
  Point x{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Int128 way = (Int128{q[i]} - p[i]) * a;
    if (way % (a - b) != 0) return std::nullopt;
    x[i] = static_cast<std::int32_t>(p[i] + way / (a - b));
  }
  return x;
}

std::optional<std::array<Surface, 2>> segment_cut(const Surface& s, const std::optional<Point>& at) {
  if (!at) return std::nullopt;
  return std::array{piece_of(s, {s.points[0], *at}), piece_of(s, {*at, s.points[1]})};
}

}  // namespace

std::optional<std::array<Surface, 2>> halve(const Surface& s) {
  if (s.points.size() == 2) {
    return segment_cut(s, middle(s.points[0], s.points[1]));
  }
  const std::vector<Stop> stops = stops_of(s.points);
  const std::vector<std::uint64_t> spans = spans_of(stops);
  const std::size_t n = stops.size();
  std::pair best{~std::uint64_t{0}, ~std::uint64_t{0}};
  std::pair<std::size_t, std::size_t> chord{0, 0};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (on_one_edge(stops[i].place, stops[j].place, 2 * s.points.size())) continue;
      const auto [lesser, greater] = std::minmax(spans[i * n + (j - i)], spans[j * n + (n - j + i)]);
      if (std::pair(greater, lesser) >= best) continue;
      best = {greater, lesser};
      chord = {i, j};
    }
  }
  if (chord.second == 0) return std::nullopt;
  return std::array{piece_of(s, part(stops, chord.first, chord.second)),
                    piece_of(s, part(stops, chord.second, chord.first))};
}

std::optional<std::array<Surface, 2>> cut_by(const Surface& s, const SurfacePlane& plane) {
  std::array<std::vector<Point>, 2> points;
  const std::size_t n = s.points.size();
  // In plan there is one edge, not one in each direction.
  for (std::size_t i = 0; i < n; ++i) {
    const Point& p = s.points[i];
    const Point& q = s.points[(i + 1) % n];
    const Int128 a = plane.at(p);
    const Int128 b = plane.at(q);
    if (a >= 0) points[0].push_back(p);
    if (a <= 0) points[1].push_back(p);
    if ((n == 2 && i == 1) || !((a > 0 && b < 0) || (a < 0 && b > 0))) continue;
    const auto x = crossing(p, q, a, b);
    if (!x) return std::nullopt;
    points[0].push_back(*x);
    points[1].push_back(*x);
  }
  return std::array{piece_of(s, std::move(points[0])), piece_of(s, std::move(points[1]))};
}

}  // namespace sightline::algorithms::willis
