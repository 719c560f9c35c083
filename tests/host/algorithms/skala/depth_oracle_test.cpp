// Drawings compared with the oracle by depth: every drawn line at many columns of the screen where the oracle's result is the
// same
// within one mask column to either side.
#include "tests/host/algorithms/skala/depth_oracle.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "host/algorithms/skala/draw.hpp"
#include "host/scene/heights/function.hpp"

namespace {

using namespace sightline;
using algorithms::skala::Family;
using algorithms::skala::View;
using test::DepthEdge;
using test::DepthScene;
using test::Hull;

// Heights at which the drawing's lines cross x.
std::vector<double> drawn_at(const picture::VectorDrawing& drawing, double x) {
  std::vector<double> ys;
  for (const picture::DrawingLine& line : drawing.lines)
    for (std::uint32_t i = 1; i < line.count; ++i) {
      const picture::DrawingPoint a = drawing.points[line.first + i - 1];
      const picture::DrawingPoint b = drawing.points[line.first + i];
      if ((double{a.x} < x) == (double{b.x} < x)) continue;
      ys.push_back(double{a.y} +
                   (x - double{a.x}) / (double{b.x} - double{a.x}) * (double{b.y} - double{a.y}));
    }
  return ys;
}

enum class Expected { visible, hidden, unsure };

// Unsure if the result changes within one column of x.
Expected expected(const DepthScene& scene, const DepthEdge& edge, double x, double column) {
  constexpr double rounding = 0.001;
  bool ever_visible = false;
  bool ever_hidden = false;
  for (const double shift : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const double here =
        std::clamp(x + shift * column, std::min(edge.a.x, edge.b.x), std::max(edge.a.x, edge.b.x));
    const double t = (here - edge.a.x) / (edge.b.x - edge.a.x);
    const double y = edge.a.y + t * (edge.b.y - edge.a.y);
    const Hull hull = scene.nearer(here, edge.a.depth + t * (edge.b.depth - edge.a.depth), 1e-9);
    ever_visible = ever_visible || y > hull.top - rounding || y < hull.bottom + rounding;
    ever_hidden = ever_hidden || (y < hull.top + rounding && y > hull.bottom - rounding);
  }
  if (ever_visible && ever_hidden) return Expected::unsure;
  return ever_visible ? Expected::visible : Expected::hidden;
}

struct Tally {
  int visible = 0;
  int hidden = 0;
  int unsure = 0;
};

void compare(const DepthScene& scene, const picture::VectorDrawing& drawing, int columns, unsigned seed,
             Tally& tally) {
  std::mt19937 dice(seed);
  const double column = 255.0 / columns;
  for (int n = 0; n < 60; ++n) {
    const double x = static_cast<double>(dice() % 100000) / 100000 * 253 + 1;
    const std::vector<double> drawn = drawn_at(drawing, x);
    const auto has = [&](double y, double within) {
      return std::any_of(drawn.begin(), drawn.end(), [&](double d) { return std::abs(d - y) < within; });
    };
    std::vector<double> inked;
    for (const DepthEdge& edge : scene.edges()) {
      if (!edge.inked || (edge.a.x < x) == (edge.b.x < x)) continue;
      const double y = edge.a.y + (x - edge.a.x) / (edge.b.x - edge.a.x) * (edge.b.y - edge.a.y);
      const double steep = std::abs((edge.b.y - edge.a.y) / (edge.b.x - edge.a.x));
      const double rounding = 0.001 * (1 + steep);
      const Expected answer = expected(scene, edge, x, column);
      if (answer != Expected::hidden) inked.push_back(y);
      if (answer == Expected::visible) {
        ++tally.visible;
        EXPECT_TRUE(has(y, rounding)) << "missing at " << x << ", " << y;
      } else {
        ++(answer == Expected::hidden ? tally.hidden : tally.unsure);
      }
    }
    for (const double y : drawn)
      EXPECT_TRUE(std::any_of(inked.begin(), inked.end(), [&](double i) { return std::abs(i - y) < 0.02; }))
          << "extra at " << x << ", " << y;
  }
}

class Functions : public testing::TestWithParam<const char*> {};

TEST_P(Functions, LinesMatchTheDepthOracle) {
  const auto function = scene::height_function(GetParam());
  ASSERT_TRUE(function);
  Tally tally;
  unsigned seed = 0;
  for (const auto& [rotation, elevation] :
       {std::pair{0.0, 30.0}, {30.0, 30.0}, {120.0, 15.0}, {225.0, 50.0}, {300.0, -25.0}, {75.0, 60.0}}) {
    for (const Family family : {Family::along_x, Family::along_z, Family::both}) {
      const scene::HeightGrid grid = sample(*function, {19, 16});
      View view;
      view.rotation = rotation;
      view.elevation = elevation;
      view.family = family;
      DepthScene scene(grid, view);
      if (family != Family::along_z) scene.add_slices(true, true);
      if (family != Family::along_x) scene.add_slices(false, true);
      if (family != Family::both) scene.add_rims(family == Family::along_x);
      SCOPED_TRACE("rotation " + std::to_string(rotation) + " family " +
                   std::to_string(static_cast<int>(family)));
      compare(scene, draw(grid, view), view.columns, ++seed, tally);
      if (HasFailure()) return;
    }
  }
  // Guards against an empty comparison.
  EXPECT_GT(tally.visible, 5000);
  EXPECT_LT(tally.unsure * 20, tally.visible) << tally.visible << " visible, " << tally.hidden << " hidden";
}

INSTANTIATE_TEST_SUITE_P(Skala, Functions,
                         testing::Values("sinc", "rogers", "peaks", "franke", "saddle", "cosr", "step",
                                         "rosen", "spike", "gauss", "terrain"),
                         [](const auto& chosen) { return std::string(chosen.param); });

}  // namespace
