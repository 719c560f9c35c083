// Lines hidden by a surface, compared with rays: from a point towards the eye, through all triangles. The test shares with the
// program only the formulas of the box and of the direction of the eye, which are written again.
#include "host/algorithms/skala/coverage.hpp"

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

#include "host/algorithms/skala/figure_box.hpp"
#include "host/algorithms/skala/surface.hpp"
#include "host/scene/heights/function.hpp"
#include "tests/host/algorithms/skala/rays.hpp"
#include "tests/support/effort.hpp"

namespace sightline::algorithms::skala {
namespace {

using test::between;
using test::meets;
using test::Point;

// Every cell twice: divided by either diagonal. Where these disagree, there is no expectation.
class Rays {
 public:
  Rays(const scene::HeightGrid& grid, const View& view) : view_(view) {
    const double a = view.rotation * std::numbers::pi / 180;
    const double e = view.elevation * std::numbers::pi / 180;
    eye_ = {std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e)};
    const double middle = (grid.range.low + grid.range.high) / 2;
    const double half = (grid.range.high - grid.range.low) / 2;
    const auto at = [&](std::size_t i, std::size_t j) { return place({grid.x[i], grid.z[j], half > 0 ? (grid.height(i, j) - middle) / half : 0}); };
    for (std::size_t j = 0; j + 1 < grid.slices(); ++j)
      for (std::size_t i = 0; i + 1 < grid.points(); ++i) {
        const Point p = at(i, j), q = at(i + 1, j), r = at(i + 1, j + 1), s = at(i, j + 1);
        if (!std::isfinite(p[2] + q[2] + r[2] + s[2])) continue;
        for (const auto& triangle : {std::array{p, q, r}, std::array{p, r, s}}) triangles_[0].push_back(triangle);
        for (const auto& triangle : {std::array{p, q, s}, std::array{q, r, s}}) triangles_[1].push_back(triangle);
      }
  }

  [[nodiscard]] Point place(const Point& box) const { return {box[0] * view_.sides.x, box[1] * view_.sides.z, box[2] * view_.sides.height}; }
  // A point slightly to the side on the screen, and up.
  [[nodiscard]] Point beside(const Point& box, double shift, double up) const {
    const double a = view_.rotation * std::numbers::pi / 180;
    const Point p = place(box);
    return {p[0] + shift * std::cos(a), p[1] + shift * std::sin(a), p[2] + up};
  }

  [[nodiscard]] bool hidden(const Point& from, std::size_t diagonal) const {
    return std::any_of(triangles_[diagonal].begin(), triangles_[diagonal].end(), [&](const auto& t) { return meets(from, eye_, t, 1e-9); });
  }

 private:
  View view_;
  Point eye_{};
  std::array<std::vector<std::array<Point, 3>>, 2> triangles_;
};

struct Counts {
  int visible = 0;
  int hidden = 0;
  int unsure = 0;
};

// Whether the point at t of a line is hidden, including a short stretch around it. Points on the outline of the surface are not
// checked.
void expect_as_rays(const Rays& rays, const BoxPoint& from, const BoxPoint& to, double t, bool seen, Counts& counts) {
  constexpr double way = 0.004;
  int hidden = 0;
  for (const double s : {t - way, t, t + way})
    for (const std::size_t diagonal : {0U, 1U}) hidden += rays.hidden(rays.place(between(from, to, s)), diagonal) ? 1 : 0;
  for (const auto& [shift, up] : {std::pair{-way, 0.0}, {way, 0.0}, {0.0, way}, {0.0, -way}})
    for (const std::size_t diagonal : {0U, 1U}) hidden += rays.hidden(rays.beside(between(from, to, t), shift, up), diagonal) ? 1 : 0;
  if (hidden != 0 && hidden != 14) {
    ++counts.unsure;
    return;
  }
  ++(hidden == 0 ? counts.visible : counts.hidden);
  EXPECT_EQ(seen, hidden == 0) << "at " << t << " of " << from[0] << "," << from[1] << "," << from[2] << " to " << to[0] << "," << to[1] << "," << to[2];
}

scene::HeightGrid with_holes(scene::HeightGrid grid) {
  std::mt19937 dice(7);
  for (double& height : grid.heights)
    if (dice() % 9 == 0) height = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t j = 3; j < 6; ++j)
    for (std::size_t i = 3; i < 8; ++i) grid.heights[j * grid.points() + i] = std::numeric_limits<double>::quiet_NaN();
  return grid;
}

class Covering : public testing::TestWithParam<const char*> {
 protected:
  template <class Check>
  void for_views(const Check& check) {
    const scene::HeightGrid whole = sample(*scene::height_function(GetParam()), {13, 11});
    for (const auto& [rotation, elevation] : {std::pair{30.0, 30.0}, {0.0, 40.0}, {137.0, 12.0}, {330.0, 3.0}, {90.0, 25.0}, {200.0, -20.0}})
      for (const scene::HeightGrid& grid : {whole, with_holes(whole)}) {
        View view;
        view.rotation = rotation;
        view.elevation = elevation;
        view.sides = {1, 0.7, 0.5};
        SCOPED_TRACE("rotation " + std::to_string(rotation) + " elevation " + std::to_string(elevation));
        const Surface surface(grid, view, resolved_family(view));
        const scene::Interval all = scene::finite_range(grid.heights);
        const Box box{std::min(-1.0, surface.normalised_height(all.low)) - 0.6, std::max(1.0, surface.normalised_height(all.high))};
        Coverage coverage(view.columns);
        coverage.add(surface);
        check(Rays(grid, view), surface, box, coverage);
        if (HasFailure()) return;
      }
  }
};

TEST_P(Covering, LinesOnTheFloorMatchRays) {
  Counts counts;
  std::mt19937 dice(1);
  for_views([&](const Rays& rays, const Surface& surface, const Box& box, const Coverage& coverage) {
    if (surface.to_eye()[2] < 0) return;  // from below nothing is in front of the floor
    for (int n = 0; n < tests::effort(8, 2); ++n) {
      const auto any = [&] { return static_cast<double>(dice() % 2001) / 1000 - 1; };
      const BoxPoint from{any(), any(), box.low};
      const BoxPoint to{any(), any(), box.low};
      const auto parts = coverage.visible(surface.place(from[0], from[1], from[2]), surface.place(to[0], to[1], to[2]));
      for (int k = 1; k < 12; ++k) {
        const double t = k / 12.0;
        const bool seen = std::any_of(parts.begin(), parts.end(), [t](const LinePart& part) { return part.from <= t && t <= part.to; });
        expect_as_rays(rays, from, to, t, seen, counts);
      }
    }
  });
  if (!tests::is_optimised()) return;
  EXPECT_GT(counts.visible, 150);
  EXPECT_GT(counts.hidden, 50);
  EXPECT_LT(counts.unsure, counts.visible + counts.hidden);
}

TEST_P(Covering, EdgesOfTheBoxMatchRays) {
  Counts counts;
  for_views([&](const Rays& rays, const Surface& surface, const Box& box, const Coverage& coverage) {
    const std::vector<BoxEdge> drawn = visible_box(surface, box, &coverage);
    const std::vector<BoxEdge> whole = visible_box(surface, box, nullptr);
    EXPECT_GE(whole.size(), 9U);
    EXPECT_LE(whole.size(), 11U);
    for (const BoxEdge& edge : whole)
      for (int k = 1; k < 12; k += tests::effort(1, 4)) {
        const Point p = between(edge.from, edge.to, k / 12.0);
        const auto on = [&](const BoxEdge& part) {
          for (std::size_t i = 0; i < 3; ++i)
            if (p[i] < std::min(part.from[i], part.to[i]) - 1e-9 || p[i] > std::max(part.from[i], part.to[i]) + 1e-9) return false;
          return true;
        };
        expect_as_rays(rays, edge.from, edge.to, k / 12.0, std::any_of(drawn.begin(), drawn.end(), on), counts);
      }
  });
  if (!tests::is_optimised()) return;
  EXPECT_GT(counts.visible, 500);
  EXPECT_GT(counts.hidden, 30);
  EXPECT_LT(counts.unsure * 4, counts.visible + counts.hidden);
}

INSTANTIATE_TEST_SUITE_P(Skala, Covering, testing::Values("sinc", "peaks", "step", "terrain"),
                         [](const auto& chosen) { return std::string(chosen.param); });

// One of the box's corners is nearest to the eye: the edges that meet there are omitted in every view.
TEST(VisibleBox, EdgesAtTheNearestCornerAreOmitted) {
  const scene::HeightGrid grid = sample(*scene::height_function("saddle"), {5, 5});
  for (int rotation = 5; rotation < 360; rotation += 30)
    for (const double elevation : {-60.0, -10.0, 10.0, 60.0}) {
      View view;
      view.rotation = rotation;
      view.elevation = elevation;
      const Surface surface(grid, view, resolved_family(view));
      const auto edges = visible_box(surface, {}, nullptr);
      EXPECT_EQ(edges.size(), 9U);
      const auto eye = surface.to_eye();
      const BoxPoint nearest{eye[0] > 0 ? 1.0 : -1.0, eye[1] > 0 ? 1.0 : -1.0, eye[2] > 0 ? 1.0 : -1.0};
      for (const BoxEdge& edge : edges) EXPECT_TRUE(edge.from != nearest && edge.to != nearest);
    }
}

// Ticks are on the outline: no other corner of the box is farther out.
TEST(TickEdges, AreOnTheOutline) {
  const scene::HeightGrid grid = sample(*scene::height_function("saddle"), {5, 5});
  for (int rotation = 0; rotation < 360; rotation += 15)
    for (const double elevation : {-60.0, -10.0, 10.0, 60.0}) {
      View view;
      view.rotation = rotation;
      view.elevation = elevation;
      const Surface surface(grid, view, resolved_family(view));
      const auto edges = tick_edges(surface, {});
      const auto at = [&](const BoxPoint& p) { return surface.project(p[0], p[1], p[2]); };
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto a = at(edges[axis].edge.from);
        const auto b = at(edges[axis].edge.to);
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        if (length < 1e-6) continue;
        int sides = 0;
        for (const double x : {-1.0, 1.0})
          for (const double z : {-1.0, 1.0})
            for (const double h : {-1.0, 1.0}) {
              const auto p = at({x, z, h});
              const double turn = ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / length;
              sides |= turn > 1e-9 ? 1 : turn < -1e-9 ? 2 : 0;
            }
        EXPECT_NE(sides, 3) << "axis " << axis << " rotation " << rotation << " elevation " << elevation;
      }
    }
}

}  // namespace
}  // namespace sightline::algorithms::skala
