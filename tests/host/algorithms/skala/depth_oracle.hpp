// The visible part of a height grid at one column of the screen, by depth alone: everything that crosses a vertical line of the
// screen
// is sorted by depth, and each is compared with the extremes of what is nearer. It shares with the program under test only the
// formulas of the projection, which are written again.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "host/algorithms/skala/view.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::test {

struct DepthPoint {
  double x = 0;
  double y = 0;
  double depth = 0;
};

struct DepthEdge {
  DepthPoint a;
  DepthPoint b;
  bool inked = false;
  bool hides = true;
};

struct Hull {
  double top = -std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
};

// 255 x 255, as drawn.
class DepthScene {
 public:
  DepthScene(const scene::HeightGrid& grid, const algorithms::skala::View& view) : grid_(grid) {
    const double a = view.rotation * std::numbers::pi / 180;
    const double e = view.elevation * std::numbers::pi / 180;
    const double middle = (grid.range.low + grid.range.high) / 2;
    const double half = (grid.range.high - grid.range.low) / 2;
    double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9;
    for (std::size_t j = 0; j < grid.slices(); ++j)
      for (std::size_t i = 0; i < grid.points(); ++i) {
        const double h = half > 0 ? (grid.height(i, j) - middle) / half : 0 * grid.height(i, j);
        DepthPoint p{grid.x[i] * std::cos(a) + grid.z[j] * std::sin(a), 0,
                     grid.z[j] * std::cos(a) - grid.x[i] * std::sin(a)};
        p.y = 0.6 * h * std::cos(e) + p.depth * std::sin(e);
        points_.push_back(p);
        if (!std::isfinite(p.y)) continue;
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
      }
    for (DepthPoint& p : points_) {
      p.x = x1 - x0 > 1e-9 ? (p.x - x0) / (x1 - x0) * 255 : 127.5;
      p.y = y1 - y0 > 1e-9 ? (p.y - y0) / (y1 - y0) * 255 : (std::isfinite(p.y) ? 127.5 : p.y);
    }
  }

  [[nodiscard]] const DepthPoint& at(std::size_t i, std::size_t j) const {
    return points_[j * grid_.points() + i];
  }
  void add(const DepthPoint& a, const DepthPoint& b, bool inked, bool hides = true) {
    if (std::isfinite(a.y) && std::isfinite(b.y)) edges_.push_back({a, b, inked, hides});
  }
  void add_slices(bool along_x, bool inked) {
    for (std::size_t j = 0; j < grid_.slices(); ++j)
      for (std::size_t i = 0; i < grid_.points(); ++i) {
        if (along_x && i + 1 < grid_.points()) add(at(i, j), at(i + 1, j), inked);
        if (!along_x && j + 1 < grid_.slices()) add(at(i, j), at(i, j + 1), inked);
      }
  }
  // Adds the lines that join the ends of slices.
  void add_rims(bool slices_along_x) {
    if (slices_along_x) {
      for (std::size_t j = 0; j + 1 < grid_.slices(); ++j)
        for (const std::size_t i : {std::size_t{0}, grid_.points() - 1}) add(at(i, j), at(i, j + 1), true);
      return;
    }
    for (std::size_t i = 0; i + 1 < grid_.points(); ++i)
      for (const std::size_t j : {std::size_t{0}, grid_.slices() - 1}) add(at(i, j), at(i + 1, j), true);
  }
  [[nodiscard]] const std::vector<DepthEdge>& edges() const { return edges_; }

  // The extremes at x of all occluders that are nearer than `depth` by more than `tolerance`.
  [[nodiscard]] Hull nearer(double x, double depth, double tolerance) const {
    Hull hull;
    for (const DepthEdge& edge : edges_) {
      if (!edge.hides || x < std::min(edge.a.x, edge.b.x) || x > std::max(edge.a.x, edge.b.x)) continue;
      if (edge.a.x == edge.b.x) continue;
      const double t = (x - edge.a.x) / (edge.b.x - edge.a.x);
      if (edge.a.depth + t * (edge.b.depth - edge.a.depth) >= depth - tolerance) continue;
      const double y = edge.a.y + t * (edge.b.y - edge.a.y);
      hull.top = std::max(hull.top, y);
      hull.bottom = std::min(hull.bottom, y);
    }
    return hull;
  }

 private:
  const scene::HeightGrid& grid_;
  std::vector<DepthPoint> points_;
  std::vector<DepthEdge> edges_;
};

}  // namespace sightline::test
