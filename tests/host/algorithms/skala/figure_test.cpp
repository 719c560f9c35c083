// Figures: everything is on the page, proportions are correct, ticks are at their values, labels lie in gaps of their lines, and
// the
// areas of vector files equal the facets of images.
#include "host/algorithms/skala/figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "host/algorithms/skala/draw.hpp"
#include "host/scene/heights/function.hpp"
#include "tests/support/effort.hpp"

namespace sightline::algorithms::skala {
namespace {

using picture::DrawingPoint;
using picture::VectorDrawing;

scene::HeightGrid grid_of(std::string_view name, std::size_t points = 25, std::size_t slices = 21) {
  return sample(*scene::height_function(name), {points, slices});
}

Figure figure_of(const scene::HeightGrid& grid, const View& view, const FigureOptions& options) {
  return figure(std::span(&grid, 1), view, options);
}

std::vector<std::vector<DrawingPoint>> lines_of(const VectorDrawing& drawing, std::string_view layer) {
  std::vector<std::vector<DrawingPoint>> lines;
  for (const picture::DrawingLine& line : drawing.lines)
    if (drawing.layers[line.layer].label.starts_with(layer))
      lines.emplace_back(drawing.points.begin() + line.first, drawing.points.begin() + line.first + line.count);
  return lines;
}

TEST(SkalaFigure, EverythingIsOnThePage) {
  FigureOptions options;
  options.axes = options.floor = options.contour_labels = options.legend = true;
  options.title = "A title that says what it is";
  options.names = {"the first axis", "the second", "height above sea level"};
  for (const auto& [width, height] : {std::pair{190.0, 277.0}, {277.0, 190.0}, {120.0, 110.0}}) {
    options.width = width;
    options.height = height;
    for (const std::string_view name : {"peaks", "flat", "step"})
      for (int rotation = 0; rotation < 360; rotation += tests::effort(36, 120))
        for (const double elevation : {-35.0, 0.0, 25.0, 90.0}) {
          View view;
          view.subject = Subject::contours;
          view.colouring = Colouring::heights;
          view.rotation = rotation;
          view.elevation = elevation;
          const Figure result = figure_of(grid_of(name, 9, 7), view, options);
          EXPECT_EQ(result.scale[0], result.scale[1]);
          for (const DrawingPoint& p : result.drawing.points) {
            ASSERT_TRUE(p.x >= -0.3 && p.y >= -0.3 && p.x <= width + 0.3 && p.y <= height + 0.3)
                << p.x << "," << p.y << " of " << width << "x" << height << " " << name << " rotation " << rotation << " elevation " << elevation;
          }
        }
  }
}

// Seen from above and not turned: x to the right and the second axis upwards, with equal units.
TEST(SkalaFigure, TicksAreAtTheirValues) {
  View view;
  view.rotation = 0;
  view.elevation = 90;
  view.sides = {1, 0.5, 0.6};
  FigureOptions options;
  options.axes = true;
  options.width = options.height = 200;
  scene::HeightGrid grid = grid_of("saddle");
  grid.domain_x = {0, 40};
  grid.domain_z = {-1, 1};
  const Figure result = figure_of(grid, view, options);
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
  for (const auto& line : lines_of(result.drawing, "lines along x"))
    for (const DrawingPoint& p : line) left = std::min<double>(left, p.x), right = std::max<double>(right, p.x), bottom = std::min<double>(bottom, p.y), top = std::max<double>(top, p.y);
  EXPECT_NEAR(top - bottom, (right - left) / 2, 0.01);
  std::vector<double> across;
  std::vector<double> upwards;
  for (const auto& line : lines_of(result.drawing, "axes")) {
    ASSERT_EQ(line.size(), 2U);
    const double length = std::hypot(double{line[0].x} - line[1].x, double{line[0].y} - line[1].y);
    if (length > 3) continue;  // an edge of the box
    EXPECT_NEAR(length, 0.6 * options.text, 0.001);
    if (std::abs(line[0].x - line[1].x) < 0.001) {
      across.push_back(line[0].x);
    } else {
      EXPECT_NEAR(line[0].x, right, 0.001);
      upwards.push_back(line[0].y);
    }
  }
  std::sort(across.begin(), across.end());
  std::sort(upwards.begin(), upwards.end());
  ASSERT_EQ(across.size(), 5U);  // 0 10 20 30 40
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(across[i], left + (right - left) * static_cast<double>(i) / 4, 0.01);
  for (const double y : upwards) {
    const double value = -1 + 2 * (y - bottom) / (top - bottom);
    EXPECT_NEAR(value * 10, std::round(value * 10), 0.001) << value;
  }
  EXPECT_GE(upwards.size(), 4U);
}

TEST(SkalaFigure, LabelsLieInGapsOfTheirLines) {
  View view;
  view.subject = Subject::contours;
  view.rotation = 40;
  view.elevation = 50;
  view.silhouette = true;
  FigureOptions options;
  options.contour_labels = options.floor = true;
  const Figure plain = figure_of(grid_of("peaks", 41, 41), view, {.floor = true});
  const Figure result = figure_of(grid_of("peaks", 41, 41), view, options);
  const auto text = lines_of(result.drawing, "text");
  ASSERT_GT(text.size(), 20U);
  double least = 1e9;
  for (const char* layer : {"contour", "floor", "silhouette", "rims"})
    for (const auto& line : lines_of(result.drawing, layer))
      for (std::size_t k = 0; k + 1 < line.size(); ++k)
        for (const auto& stroke : text)
          for (const DrawingPoint& p : stroke) {
            const double ux = double{line[k + 1].x} - line[k].x, uy = double{line[k + 1].y} - line[k].y;
            const double t = std::clamp(((p.x - line[k].x) * ux + (p.y - line[k].y) * uy) / (ux * ux + uy * uy + 1e-12), 0.0, 1.0);
            least = std::min(least, std::hypot(p.x - line[k].x - t * ux, p.y - line[k].y - t * uy));
          }
  EXPECT_GT(least, 0.1) << "mm between a label and a line";
  // Only the gaps for labels are missing.
  const auto length = [](const Figure& of) {
    double sum = 0;
    for (const char* layer : {"contour", "floor"})
      for (const auto& line : lines_of(of.drawing, layer))
        for (std::size_t k = 0; k + 1 < line.size(); ++k) sum += std::hypot(double{line[k + 1].x} - line[k].x, double{line[k + 1].y} - line[k].y);
    return sum;
  };
  EXPECT_LT(length(result), length(plain));
  EXPECT_GT(length(result), 0.75 * length(plain));
}

// --- Areas

// The winding number of the outline around a point.
int winding(const VectorDrawing& drawing, std::uint32_t first, std::uint32_t count, double x, double y) {
  int turns = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const DrawingPoint a = drawing.points[first + i];
    const DrawingPoint b = drawing.points[first + (i + 1) % count];
    if ((a.y <= y) == (b.y <= y)) continue;
    const double at = a.x + (y - a.y) / (double{b.y} - a.y) * (double{b.x} - a.x);
    if (at > x) turns += a.y <= y ? 1 : -1;
  }
  return turns;
}

// The shape painted last at a point; null if there is none.
template <class Shape>
const Shape* shape_at(const VectorDrawing& drawing, const std::vector<Shape>& shapes, double x, double y) {
  for (auto shape = shapes.rbegin(); shape != shapes.rend(); ++shape)
    if (winding(drawing, shape->first, shape->count, x, y) != 0) return &*shape;
  return nullptr;
}
template <class Shape>
std::optional<picture::Colour> colour_at(const VectorDrawing& drawing, const std::vector<Shape>& shapes, double x, double y) {
  const Shape* shape = shape_at(drawing, shapes, x, y);
  return shape == nullptr ? std::nullopt : std::optional(shape->colour);
}

bool share_an_edge(const VectorDrawing& drawing, const picture::DrawingFacet& a, const picture::DrawingFacet& b) {
  int shared = 0;
  for (std::uint32_t i = 0; i < a.count; ++i)
    for (std::uint32_t k = 0; k < b.count; ++k) shared += drawing.points[a.first + i] == drawing.points[b.first + k] ? 1 : 0;
  return shared >= 2;
}

class Areas : public testing::TestWithParam<const char*> {
 protected:
  template <class Check>
  void for_views(const Check& check) {
    for (const auto& [rotation, elevation] : {std::pair{30.0, 30.0}, {200.0, 12.0}, {120.0, -25.0}})
      for (const bool holes : {false, true}) {
        scene::HeightGrid grid = grid_of(GetParam(), 21, 19);
        if (holes)
          for (std::size_t j = 6; j < 11; ++j)
            for (std::size_t i = 4; i < 9; ++i) grid.heights[j * grid.points() + i] = std::numeric_limits<double>::quiet_NaN();
        View view;
        view.subject = Subject::surface;
        view.colouring = Colouring::heights;
        view.rotation = rotation;
        view.elevation = elevation;
        SCOPED_TRACE("rotation " + std::to_string(rotation) + (holes ? " with holes" : ""));
        check(grid, view, draw(grid, view));
      }
  }
};

// Each area extends under nearer areas, which are painted over it: the picture equals that of the facets.
TEST_P(Areas, EqualTheFacets) {
  std::mt19937 dice(11);
  int painted = 0;
  for_views([&](const scene::HeightGrid&, const View&, const VectorDrawing& drawing) {
    ASSERT_FALSE(drawing.areas.empty());
    EXPECT_LE(drawing.areas.size(), 2 * drawing.facets.size());
    for (int n = 0; n < tests::effort(400, 60); ++n) {
      const double x = static_cast<double>(dice() % 255000) / 1000 + 0.0003;
      const double y = static_cast<double>(dice() % 255000) / 1000 + 0.0007;
      const auto facet = colour_at(drawing, drawing.facets, x, y);
      painted += facet ? 1 : 0;
      EXPECT_EQ(facet, colour_at(drawing, drawing.areas, x, y)) << "at " << x << ", " << y;
    }
  });
  EXPECT_GT(painted, tests::effort(500, 50));
}

// Where two visible facets share an edge, some area covers both sides of it, so that no paper shows through.
TEST_P(Areas, HaveNoSeams) {
  std::mt19937 dice(12);
  int edges = 0;
  for_views([&](const scene::HeightGrid&, const View&, const VectorDrawing& drawing) {
    for (int n = 0; n < tests::effort(300, 60); ++n) {
      const picture::DrawingFacet& facet = drawing.facets[dice() % drawing.facets.size()];
      const auto k = static_cast<std::uint32_t>(dice() % facet.count);
      const DrawingPoint a = drawing.points[facet.first + k];
      const DrawingPoint b = drawing.points[facet.first + (k + 1) % facet.count];
      const double length = std::hypot(double{b.x} - a.x, double{b.y} - a.y);
      if (length < 0.5) continue;
      const double t = 0.2 + 0.6 * static_cast<double>(dice() % 1000) / 1000;
      const double x = a.x + t * (double{b.x} - a.x), y = a.y + t * (double{b.y} - a.y);
      const double dx = 0.02 * (double{b.y} - a.y) / length, dy = -0.02 * (double{b.x} - a.x) / length;
      const auto* here = shape_at(drawing, drawing.facets, x - dx, y - dy);
      const auto* there = shape_at(drawing, drawing.facets, x + dx, y + dy);
      if (here == nullptr || there == nullptr || here == there || !share_an_edge(drawing, *here, *there)) continue;
      ++edges;
      EXPECT_TRUE(std::any_of(drawing.areas.begin(), drawing.areas.end(),
                              [&](const picture::DrawingArea& area) {
                                return winding(drawing, area.first, area.count, x - dx, y - dy) != 0 && winding(drawing, area.first, area.count, x + dx, y + dy) != 0;
                              }))
          << "at " << x << ", " << y;
    }
  });
  EXPECT_GT(edges, tests::effort(150, 20));
}

INSTANTIATE_TEST_SUITE_P(Skala, Areas, testing::Values("sinc", "peaks", "terrain"), [](const auto& chosen) { return std::string(chosen.param); });

}  // namespace
}  // namespace sightline::algorithms::skala
