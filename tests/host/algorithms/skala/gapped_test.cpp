// Lines on surfaces with holes and on several surfaces, compared with rays from points on them to the eye. The test shares with
// the
// program only the formulas of the projection, which are written again.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/skala/draw.hpp"
#include "host/scene/heights/function.hpp"
#include "tests/host/algorithms/skala/rays.hpp"
#include "tests/support/effort.hpp"

namespace sightline::algorithms::skala {
namespace {

using test::between;
using test::dot;
using test::meets;
using test::Point;

struct Triangle {
  std::array<Point, 3> corners;
  std::size_t surface, point, slice;  // of its cell
};

class SurfacesByRays {
 public:
  SurfacesByRays(const std::vector<scene::HeightGrid>& grids, const View& view) : grids_(grids) {
    const double a = view.rotation * std::numbers::pi / 180;
    const double e = view.elevation * std::numbers::pi / 180;
    eye_ = {std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e)};
    right_ = {std::cos(a), std::sin(a), 0};
    up_ = {-std::sin(a) * std::sin(e), std::cos(a) * std::sin(e), std::cos(e)};
    // The diagonal joins the side corners: the nearest corner's x and z are opposite to the eye's direction.
    const bool near_is_along = (eye_[0] > 0) == (eye_[1] > 0);
    for (std::size_t s = 0; s < grids.size(); ++s)
      for (std::size_t j = 0; j + 1 < grids[s].slices(); ++j)
        for (std::size_t i = 0; i + 1 < grids[s].points(); ++i) {
          const Point p = at(s, i, j), q = at(s, i + 1, j), r = at(s, i + 1, j + 1), t = at(s, i, j + 1);
          if (!std::isfinite(p[2] + q[2] + r[2] + t[2])) continue;
          for (const auto& corners : near_is_along ? std::array{std::array{p, q, t}, std::array{q, r, t}} : std::array{std::array{p, q, r}, std::array{p, r, t}})
            triangles_.push_back({corners, s, i, j});
        }
    for (std::size_t s = 0; s < grids.size(); ++s)
      for (std::size_t j = 0; j < grids[s].slices(); ++j)
        for (std::size_t i = 0; i < grids[s].points(); ++i) {
          const Point p = at(s, i, j);
          if (!std::isfinite(p[2])) continue;
          low_ = {std::min(low_[0], dot(p, right_)), std::min(low_[1], dot(p, up_))};
          high_ = {std::max(high_[0], dot(p, right_)), std::max(high_[1], dot(p, up_))};
        }
  }

  [[nodiscard]] Point at(std::size_t surface, std::size_t i, std::size_t j) const {
    const scene::HeightGrid& grid = grids_[surface];
    const double half = (grid.range.high - grid.range.low) / 2;
    return {grid.x[i], grid.z[j], 0.6 * (grid.height(i, j) - (grid.range.low + grid.range.high) / 2) / half};
  }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  // The height of a corner above another surface.
  [[nodiscard]] double above(std::size_t surface, const Point& corner) const {
    for (std::size_t j = 0; j < grids_[surface].slices(); ++j)
      for (std::size_t i = 0; i < grids_[surface].points(); ++i)
        if (grids_[surface].x[i] == corner[0] && grids_[surface].z[j] == corner[1]) return corner[2] - at(surface, i, j)[2];
    return std::nan("");
  }
  // On the drawing, 255 by 255.
  [[nodiscard]] std::array<double, 2> on_drawing(const Point& p) const {
    return {(dot(p, right_) - low_[0]) / (high_[0] - low_[0]) * 255, (dot(p, up_) - low_[1]) / (high_[1] - low_[1]) * 255};
  }
  // The number of triangles that a ray meets: of cells at and next to (i, j), and of others.
  struct Hits {
    int own = 0;
    int others = 0;
  };
  [[nodiscard]] Hits hits(const Point& from, std::size_t surface, std::size_t i, std::size_t j) const {
    Hits found;
    for (const Triangle& triangle : triangles_) {
      if (!meets(from, eye_, triangle.corners, 1e-7)) continue;
      const bool own = triangle.surface == surface && triangle.point + 1 >= i && triangle.point <= i + 1 && triangle.slice + 1 >= j && triangle.slice <= j + 1;
      ++(own ? found.own : found.others);
    }
    return found;
  }

  // Shifted on the screen.
  [[nodiscard]] Point shifted(const Point& p, double across, double up) const {
    return {p[0] + across * right_[0] + up * up_[0], p[1] + across * right_[1] + up * up_[1], p[2] + up * up_[2]};
  }

 private:
  const std::vector<scene::HeightGrid>& grids_;
  Point eye_{}, right_{}, up_{};
  std::array<double, 2> low_{1e9, 1e9}, high_{-1e9, -1e9};
  std::vector<Triangle> triangles_;
};

// The distance to the nearest line of the drawing with the direction from a to b.
double nearest_line(const picture::VectorDrawing& drawing, std::array<double, 2> p, std::array<double, 2> a, std::array<double, 2> b) {
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  double least = 1e9;
  for (const picture::DrawingLine& line : drawing.lines)
    for (std::uint32_t k = 0; k + 1 < line.count; ++k) {
      const picture::DrawingPoint& from = drawing.points[line.first + k];
      const picture::DrawingPoint& to = drawing.points[line.first + k + 1];
      const double ux = double{to.x} - from.x, uy = double{to.y} - from.y;
      const double square = ux * ux + uy * uy;
      if (std::abs(ux * (b[1] - a[1]) - uy * (b[0] - a[0])) > 0.05 * std::sqrt(square) * length) continue;
      const double t = square > 0 ? std::clamp(((p[0] - from.x) * ux + (p[1] - from.y) * uy) / square, 0.0, 1.0) : 0;
      least = std::min(least, std::hypot(p[0] - from.x - t * ux, p[1] - from.y - t * uy));
    }
  return least;
}

struct LineCounts {
  int visible = 0;
  int hidden = 0;
};

void compare_lines(const std::vector<scene::HeightGrid>& grids, const View& view, unsigned seed, LineCounts& counts) {
  const SurfacesByRays scene(grids, view);
  const picture::VectorDrawing drawing = draw(grids, view);
  std::mt19937 dice(seed);
  for (int n = 0; n < tests::effort(250, 40); ++n) {
    const std::size_t s = dice() % grids.size();
    const bool along_x = dice() % 2 == 0;
    const std::size_t i = dice() % (grids[s].points() - 1);
    const std::size_t j = dice() % (grids[s].slices() - 1);
    const double t = 0.1 + static_cast<double>(dice() % 1000) / 1250;
    const Point a = scene.at(s, i, j);
    const Point b = along_x ? scene.at(s, i + 1, j) : scene.at(s, i, j + 1);
    if (!std::isfinite(a[2] + b[2])) continue;
    // Certainly hidden: hidden by others, in all points around. Certainly visible: met by nothing, along the line.
    constexpr double way = 0.006;
    bool hidden = true;
    bool visible = true;
    for (const auto& [across, up] : {std::pair{0.0, 0.0}, {way, 0.0}, {-way, 0.0}, {0.0, way}, {0.0, -way}}) {
      const auto hits = scene.hits(scene.shifted(between(a, b, t), across, up), s, i, j);
      hidden = hidden && hits.others > 0;
      visible = visible && hits.others == 0;
    }
    for (const double place : {t - 0.05, t, t + 0.05}) visible = visible && scene.hits(between(a, b, place), s, i, j).own == 0;
    if (!hidden && !visible) continue;
    const auto p = scene.on_drawing(between(a, b, t));
    const double distance = nearest_line(drawing, p, scene.on_drawing(a), scene.on_drawing(b));
    if (visible) {
      EXPECT_LT(distance, 0.02) << "missing at " << p[0] << ", " << p[1] << " on surface " << s;
    } else {
      EXPECT_GT(distance, 0.003) << "not hidden at " << p[0] << ", " << p[1] << " on surface " << s;
    }
    ++(visible ? counts.visible : counts.hidden);
  }
}

// The lines in which two surfaces meet, one piece per triangle: visible at its middle if no ray from there meets anything else.
void compare_meetings(const std::vector<scene::HeightGrid>& grids, const View& view, LineCounts& counts) {
  const SurfacesByRays scene(grids, view);
  picture::VectorDrawing drawing = draw(grids, view);
  const auto layer = static_cast<std::uint32_t>(drawing.layers.size() - 1);
  std::erase_if(drawing.lines, [layer](const picture::DrawingLine& line) { return line.layer != layer; });
  for (const Triangle& triangle : scene.triangles()) {
    if (triangle.surface != 0) continue;
    std::vector<Point> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = triangle.corners[k];
      const Point& q = triangle.corners[(k + 1) % 3];
      const double a = scene.above(1, p);
      const double b = scene.above(1, q);
      if ((a > 0) != (b > 0)) ends.push_back(between(p, q, a / (a - b)));
    }
    if (ends.size() != 2 || std::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]) < 0.01) continue;
    const Point middle = between(ends[0], ends[1], 0.5);
    constexpr double way = 0.006;
    bool hidden = true;
    bool visible = true;
    for (const auto& [across, up] : {std::pair{0.0, 0.0}, {way, 0.0}, {-way, 0.0}, {0.0, way}, {0.0, -way}}) {
      int others = 0;
      int near = 0;
      for (std::size_t s = 0; s < 2; ++s) {
        const auto hits = scene.hits(scene.shifted(middle, across, up), s, triangle.point, triangle.slice);
        others = s == 0 ? hits.others : std::min(others, hits.others);
        near += hits.own;
      }
      // Cells of both surfaces near the point are excluded, because the surfaces meet there.
      hidden = hidden && others > near;
      visible = visible && others + near == 0;
    }
    visible = visible || (scene.hits(middle, 0, triangle.point, triangle.slice).others == 0 && scene.hits(middle, 0, triangle.point, triangle.slice).own == 0 &&
                          scene.hits(middle, 1, triangle.point, triangle.slice).own == 0);
    if (hidden == visible) continue;
    const double distance = nearest_line(drawing, scene.on_drawing(middle), scene.on_drawing(ends[0]), scene.on_drawing(ends[1]));
    if (visible) {
      EXPECT_LT(distance, 0.02) << "missing in the cell of " << triangle.point << ", " << triangle.slice;
    } else {
      EXPECT_GT(distance, 0.003) << "not hidden in the cell of " << triangle.point << ", " << triangle.slice;
    }
    ++(visible ? counts.visible : counts.hidden);
  }
}

View net_view(double rotation, double elevation) {
  View view;
  view.rotation = rotation;
  view.elevation = elevation;
  view.family = Family::both;
  // With it a cell is its two triangles, as in this test.
  view.silhouette = true;
  return view;
}

constexpr std::array views{std::pair{35.0, 30.0}, std::pair{130.0, 12.0}, std::pair{215.0, 55.0}, std::pair{300.0, -25.0}};

class GappedSurface : public testing::TestWithParam<const char*> {};

TEST_P(GappedSurface, IsSeenThroughItsHoles) {
  LineCounts counts;
  unsigned seed = 1;
  for (const auto& [rotation, elevation] : views) {
    scene::HeightGrid grid = sample(*scene::height_function(GetParam()), {17, 15});
    std::mt19937 dice(seed);
    for (double& height : grid.heights)
      if (dice() % 12 == 0) height = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t j = 3; j < 7; ++j)
      for (std::size_t i = 5; i < 10; ++i) grid.heights[j * grid.points() + i] = std::numeric_limits<double>::quiet_NaN();
    SCOPED_TRACE("rotation " + std::to_string(rotation));
    compare_lines({grid}, net_view(rotation, elevation), seed++, counts);
    if (HasFailure()) return;
  }
  if (!tests::is_optimised()) return;
  EXPECT_GT(counts.visible, 200);
  EXPECT_GT(counts.hidden, 10);
}

INSTANTIATE_TEST_SUITE_P(Skala, GappedSurface, testing::Values("sinc", "peaks", "franke", "terrain"), [](const auto& chosen) { return std::string(chosen.param); });

// Two surfaces that do not meet, one with holes.
TEST(SeveralSurfaces, HideEachOther) {
  LineCounts counts;
  unsigned seed = 1;
  for (const auto& [rotation, elevation] : views) {
    scene::HeightGrid low = sample(*scene::height_function("peaks"), {17, 15});
    scene::HeightGrid high = low;
    for (std::size_t j = 0; j < high.slices(); ++j)
      for (std::size_t i = 0; i < high.points(); ++i) high.heights[j * high.points() + i] = 9.5 + std::cos(2 * high.x[i]) + (i > 5 && i < 9 && j > 4 && j < 9 ? std::nan("") : 0);
    low.range = high.range = {-7, 11};
    SCOPED_TRACE("rotation " + std::to_string(rotation));
    compare_lines({low, high}, net_view(rotation, elevation), seed++, counts);
    if (HasFailure()) return;
  }
  if (!tests::is_optimised()) return;
  EXPECT_GT(counts.visible, 200);
  EXPECT_GT(counts.hidden, 100);
}

// Two surfaces that pass through each other, so that in many cells each is partly on top.
TEST(SeveralSurfaces, PassThroughEachOther) {
  LineCounts counts;
  LineCounts meetings;
  unsigned seed = 1;
  for (const auto& [rotation, elevation] : views) {
    scene::HeightGrid wavy = sample(*scene::height_function("peaks"), {17, 15});
    scene::HeightGrid slope = wavy;
    for (std::size_t j = 0; j < slope.slices(); ++j)
      for (std::size_t i = 0; i < slope.points(); ++i) slope.heights[j * slope.points() + i] = 0.3 + 2 * slope.x[i] - slope.z[j] + std::sin(9 * slope.x[i]);
    wavy.range = slope.range = {-7, 8.5};
    SCOPED_TRACE("rotation " + std::to_string(rotation));
    const std::vector<scene::HeightGrid> grids{wavy, slope};
    const View view = net_view(rotation, elevation);
    compare_lines(grids, view, seed++, counts);
    compare_meetings(grids, view, meetings);
    if (HasFailure()) return;
  }
  if (!tests::is_optimised()) return;
  EXPECT_GT(counts.visible, 200);
  EXPECT_GT(counts.hidden, 100);
  EXPECT_GT(meetings.visible, 100);
  EXPECT_GT(meetings.hidden, 30);
}

// A surface that only touches another from above does not pass through it.
TEST(SeveralSurfaces, TouchWithoutALine) {
  scene::HeightGrid flat = sample(*scene::height_function("saddle"), {9, 9});
  for (double& height : flat.heights) height = 0;
  scene::HeightGrid step = flat;
  for (std::size_t i = 0; i < step.heights.size(); ++i) step.heights[i] = std::max(0.0, step.x[i % 9]);
  flat.range = step.range = {0, 1};
  for (const bool through : {false, true}) {
    if (through)
      for (std::size_t i = 0; i < step.heights.size(); ++i) step.heights[i] = step.x[i % 9];
    const picture::VectorDrawing drawing = draw(std::vector{flat, step}, net_view(35, 30));
    const auto layer = static_cast<std::uint32_t>(drawing.layers.size() - 1);
    EXPECT_EQ(drawing.layers[layer].label, "intersections");
    const auto lines = std::count_if(drawing.lines.begin(), drawing.lines.end(), [layer](const picture::DrawingLine& line) { return line.layer == layer; });
    EXPECT_EQ(lines > 0, through);
  }
}

// In any order of the surfaces.
TEST(SeveralSurfaces, OrderHasNoEffect) {
  const scene::HeightGrid a = sample(*scene::height_function("saddle"), {9, 9});
  scene::HeightGrid b = a;
  for (double& height : b.heights) height = 0.1 - height / 3;
  const View view = net_view(35, 30);
  const auto length = [](const picture::VectorDrawing& drawing) {
    double sum = 0;
    for (const picture::DrawingLine& line : drawing.lines)
      for (std::uint32_t k = 0; k + 1 < line.count; ++k)
        sum += std::hypot(double{drawing.points[line.first + k].x} - drawing.points[line.first + k + 1].x,
                          double{drawing.points[line.first + k].y} - drawing.points[line.first + k + 1].y);
    return sum;
  };
  const std::vector<scene::HeightGrid> one{a, b};
  const std::vector<scene::HeightGrid> other{b, a};
  EXPECT_NEAR(length(draw(one, view)), length(draw(other, view)), 1e-3);
  EXPECT_EQ(draw(one, view).layers.size(), 9U);
}

}  // namespace
}  // namespace sightline::algorithms::skala
