// Tests a scene and its complex made by BSP with random points and straight lines: which cells and solids a point is in, and
// which cells,
// openings and faces a line meets.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "host/scene/cells/bsp/decompose.hpp"
#include "tests/host/scene/cells/complex_probe.hpp"

namespace sightline::scene {

// In the order of the parameter, from cell to cell.
struct Passage {
  CellNumber cell = 0;
  Stretch stretch;
};

class Prober {
 public:
  explicit Prober(PolyScene scene)
      : scene_(std::move(scene)), complex_(*decompose_bsp(scene_)), triangles_(triangles_of(scene_)) {}

  [[nodiscard]] const CellComplex& complex() const { return complex_; }

  PolyPoint random_point() {
    PolyPoint p{};
    for (std::size_t a = 0; a < 3; ++a) {
      p[a] = std::uniform_int_distribution(complex_.outer.low[a] + 1, complex_.outer.high[a] - 1)(random_);
    }
    return p;
  }

  // The number of cells that contain the point; nothing if it is on the surface of one.
  [[nodiscard]] std::optional<int> cells_with(const PolyPoint& p) const {
    int count = 0;
    for (const ComplexCell& cell : complex_.cells) {
      int most = -1;
      for (const HalfSpace& half : complex_.bounds_of(cell)) {
        const int side = complex_.planes[half.plane].side(p);
        most = std::max(most, half.turned ? -side : side);
      }
      if (most == 0) return std::nullopt;
      if (most < 0) ++count;
    }
    return count;
  }

  // The number of solids that contain the point, by a line to a point outside the box; nothing if the line is degenerate.
  [[nodiscard]] std::optional<int> solids_with(const PolyPoint& p) {
    PolyPoint far = random_point();
    far[1] = complex_.outer.high[1];
    int count = 0;
    for (const SceneTriangle& triangle : triangles_) {
      if (triangle.sheet) continue;
      const std::optional<int> through = crossing(triangle, {p, far});
      if (!through) return std::nullopt;
      count -= *through;
    }
    return count;
  }

  [[nodiscard]] std::vector<Passage> passages(const Segment& segment) const {
    std::vector<Passage> passages;
    for (CellNumber c = 0; c < complex_.cells.size(); ++c) {
      const Stretch stretch = stretch_in(complex_, complex_.bounds_of(complex_.cells[c]), segment);
      if (stretch.has_length()) passages.push_back({c, stretch});
    }
    std::sort(passages.begin(), passages.end(),
              [](const Passage& a, const Passage& b) { return a.stretch.low < b.stretch.low; });
    return passages;
  }

  // The number of openings between the cells through which the segment passes at s.
  [[nodiscard]] int openings_at(const Segment& segment, CellNumber a, CellNumber b, const Rational& s) const {
    int count = 0;
    for (const std::uint32_t number : complex_.openings_of(complex_.cells[a])) {
      const ComplexOpening& opening = complex_.openings[number];
      const geometry::Plane& plane = complex_.planes[opening.plane];
      const bool upwards = plane.at(segment.from) < plane.at(segment.to);
      const std::array<CellNumber, 2> cells{upwards ? a : b, upwards ? b : a};
      if (opening.cells != cells) continue;
      const std::int64_t from = plane.at(segment.from);
      if (Rational(from, from - plane.at(segment.to)) != s) continue;
      const Stretch inside = stretch_in(complex_, complex_.sides_of(opening), segment);
      if (inside.low <= s && s <= inside.high) ++count;
    }
    return count;
  }

  // The number of faces that the segment crosses; nothing if it meets a boundary.
  [[nodiscard]] std::optional<int> faces_met(const Segment& segment) const {
    int count = 0;
    for (const SceneTriangle& triangle : triangles_) {
      const std::optional<int> through = crossing(triangle, segment);
      if (!through) return std::nullopt;
      if (*through != 0) ++count;
    }
    return count;
  }

 private:
  PolyScene scene_;
  CellComplex complex_;
  std::vector<SceneTriangle> triangles_;
  std::mt19937 random_{7};
};

}  // namespace sightline::scene
