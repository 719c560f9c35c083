#include "host/scene/heights/delaunay.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "host/geometry/integer.hpp"

namespace sightline::scene {

using geometry::Int128;
using geometry::Point2;

int in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  // Differences below 2^19, their squares below 2^39, minors below 2^40, products below 2^79.
  const auto row = [&d](const Point2& p) {
    const std::int64_t x = std::int64_t{p[0]} - d[0];
    const std::int64_t y = std::int64_t{p[1]} - d[1];
    return std::array<std::int64_t, 3>{x, y, x * x + y * y};
  };
  const auto p = row(a);
  const auto q = row(b);
  const auto r = row(c);
  const auto minor = [](const auto& m, const auto& n) { return m[0] * n[1] - m[1] * n[0]; };
  return geometry::sign(Int128{p[2]} * minor(q, r) + Int128{q[2]} * minor(r, p) + Int128{r[2]} * minor(p, q));
}

namespace {

// Directed edges: four numbers for each edge, the edge, its dual, the reversed edge and its dual. next(e) is the next edge
// counterclockwise around the origin of e.
using Edge = std::uint32_t;

class Triangulation {
 public:
  // Ascending and different, at least two.
  explicit Triangulation(std::span<const Point2> points) : points_(points) {
    static_cast<void>(build(0, static_cast<std::uint32_t>(points.size())));
  }

  [[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangles() const {
    std::vector<std::array<std::uint32_t, 3>> result;
    for (Edge e = 0; e < next_.size(); e += 2) {
      if (removed_[e / 4]) continue;
      const Edge f = left_next(e);
      const Edge g = left_next(f);
      const std::array<std::uint32_t, 3> corners{origin_[e], origin_[f], origin_[g]};
      // Each face is met three times, and written where its first corner is the least.
      if (left_next(g) != e || corners[0] > std::min(corners[1], corners[2]) || turn(corners[0], corners[1], corners[2]) <= 0)
        continue;
      result.push_back(corners);
    }
    return result;
  }

 private:
  static Edge rotated(Edge e) { return (e & ~3U) | ((e + 1) & 3U); }
  static Edge reversed(Edge e) { return e ^ 2U; }
  static Edge rotated_back(Edge e) { return (e & ~3U) | ((e + 3) & 3U); }
  [[nodiscard]] Edge next(Edge e) const { return next_[e]; }
  [[nodiscard]] Edge previous(Edge e) const { return rotated(next_[rotated(e)]); }
  [[nodiscard]] Edge left_next(Edge e) const { return rotated(next_[rotated_back(e)]); }
  [[nodiscard]] Edge right_previous(Edge e) const { return next_[reversed(e)]; }
  [[nodiscard]] std::uint32_t destination(Edge e) const { return origin_[reversed(e)]; }

  [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return geometry::sign(geometry::turn(points_[a], points_[b], points_[c]));
  }
  [[nodiscard]] bool left_of(std::uint32_t p, Edge e) const { return turn(p, origin_[e], destination(e)) > 0; }
  [[nodiscard]] bool right_of(std::uint32_t p, Edge e) const { return turn(p, destination(e), origin_[e]) > 0; }
  [[nodiscard]] bool inside(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return in_circle(points_[a], points_[b], points_[c], points_[d]) > 0;
  }

  Edge make_edge(std::uint32_t from, std::uint32_t to) {
    const auto e = static_cast<Edge>(next_.size());
    next_.insert(next_.end(), {e, e + 3, e + 2, e + 1});
    origin_.insert(origin_.end(), {from, 0, to, 0});
    removed_.push_back(false);
    return e;
  }
  void splice(Edge a, Edge b) {
    const Edge alpha = rotated(next_[a]);
    const Edge beta = rotated(next_[b]);
    std::swap(next_[a], next_[b]);
    std::swap(next_[alpha], next_[beta]);
  }
  // From the destination of a to the origin of b, on their left.
  Edge connect(Edge a, Edge b) {
    const Edge e = make_edge(destination(a), origin_[b]);
    splice(e, left_next(a));
    splice(reversed(e), b);
    return e;
  }
  void remove(Edge e) {
    splice(e, previous(e));
    splice(reversed(e), previous(reversed(e)));
    removed_[e / 4] = true;
  }

  struct Hull {
    Edge from_left;   // counterclockwise hull edge out of the leftmost point
    Edge from_right;  // clockwise hull edge out of the rightmost point
  };

  Hull build(std::uint32_t begin, std::uint32_t end) {
    if (end - begin == 2) {
      const Edge e = make_edge(begin, begin + 1);
      return {e, reversed(e)};
    }
    if (end - begin == 3) {
      const Edge a = make_edge(begin, begin + 1);
      const Edge b = make_edge(begin + 1, begin + 2);
      splice(reversed(a), b);
      const int side = turn(begin, begin + 1, begin + 2);
      if (side == 0) return {a, reversed(b)};
      const Edge c = connect(b, a);
      return side > 0 ? Hull{a, reversed(b)} : Hull{reversed(c), c};
    }
    const std::uint32_t middle = begin + (end - begin) / 2;
    return merge(build(begin, middle), build(middle, end));
  }

  Hull merge(Hull left, Hull right) {
    Edge l = left.from_right;
    Edge r = right.from_left;
    for (;;) {  // the lower common tangent
      if (left_of(origin_[r], l)) {
        l = left_next(l);
      } else if (right_of(origin_[l], r)) {
        r = right_previous(r);
      } else {
        break;
      }
    }
    Edge base = connect(reversed(r), l);
    if (origin_[l] == origin_[left.from_left]) left.from_left = reversed(base);
    if (origin_[r] == origin_[right.from_right]) right.from_right = base;
    const auto above = [this](Edge e, Edge of) { return right_of(destination(e), of); };
    for (;;) {
      Edge on_left = next(reversed(base));
      if (above(on_left, base)) {
        while (inside(destination(base), origin_[base], destination(on_left), destination(next(on_left)))) {
          const Edge following = next(on_left);
          remove(on_left);
          on_left = following;
        }
      }
      Edge on_right = previous(base);
      if (above(on_right, base)) {
        while (inside(destination(base), origin_[base], destination(on_right), destination(previous(on_right)))) {
          const Edge following = previous(on_right);
          remove(on_right);
          on_right = following;
        }
      }
      const bool left_above = above(on_left, base);
      const bool right_above = above(on_right, base);
      if (!left_above && !right_above) break;
      const bool take_right = !left_above || (right_above && inside(destination(on_left), origin_[on_left], origin_[on_right],
                                                                    destination(on_right)));
      base = take_right ? connect(on_right, reversed(base)) : connect(reversed(base), reversed(on_left));
    }
    return {left.from_left, right.from_right};
  }

  std::span<const Point2> points_;
  std::vector<Edge> next_;
  std::vector<std::uint32_t> origin_;
  std::vector<bool> removed_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> delaunay(std::span<const Point2> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  // The number decides between equal points, of which the first one stays.
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return points[a] != points[b] ? points[a] < points[b] : a < b; });
  order.erase(std::unique(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; }),
              order.end());
  if (order.size() < 3) return {};
  std::vector<Point2> sorted;
  sorted.reserve(order.size());
  for (const std::uint32_t point : order) sorted.push_back(points[point]);
  auto triangles = Triangulation(sorted).triangles();
  for (auto& triangle : triangles)
    for (std::uint32_t& corner : triangle) corner = order[corner];
  return triangles;
}

}  // namespace sightline::scene
