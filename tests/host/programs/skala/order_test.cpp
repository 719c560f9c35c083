// The order rule tested by its purpose: what is drawn later is never nearer in the same vertical line of the screen.
#include <algorithm>
#include <array>

#include "host/programs/skala/projection.hpp"
#include "host/programs/skala/stream_chain.hpp"
#include "tests/host/programs/skala/stream_support.hpp"

namespace sightline::programs::skala {
namespace {

constexpr double rounding = 1e-9;

// Every quadrant, its borders exactly and slightly next to them.
std::vector<double> rotations() {
  std::vector<double> result;
  for (int degrees = -360; degrees <= 360; degrees += 15) {
    for (const double beside : {-1e-3, -1e-7, 0.0, 1e-7, 1e-3}) result.push_back(degrees + beside);
  }
  return result;
}

struct Depths {
  double near = HUGE_VAL;
  double far = -HUGE_VAL;
};

// The depths of the polyline or closed outline of these vertices at a screen x.
Depths depths_at(const std::vector<const Vertex*>& vertices, double x) {
  Depths depths;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    const Vertex& a = *vertices[i];
    const Vertex& b = *vertices[i + 1];
    if (x < std::min(a.x, b.x) || x > std::max(a.x, b.x) || a.x == b.x) continue;
    const double depth = a.depth + (x - a.x) / (b.x - a.x) * (b.depth - a.depth);
    depths.near = std::min(depths.near, depth);
    depths.far = std::max(depths.far, depth);
  }
  return depths;
}

class SliceOrder : public testing::TestWithParam<Family> {};

TEST_P(SliceOrder, LaterSlicesAreFarther) {
  const scene::HeightGrid grid = stream_test::named("flat", {6, 5});
  for (const double rotation : rotations()) {
    const Projection projection(grid, {.rotation = rotation});
    const DrawingOrder order = slice_order(projection, GetParam());
    std::vector<std::vector<const Vertex*>> slices(order.rows);
    for (std::size_t row = 0; row < order.rows; ++row) {
      for (std::size_t column = 0; column < order.columns; ++column) {
        const GridIndex index = order.index(row, column);
        slices[row].push_back(&projection.at(index.point, index.slice));
        if (column == 0) continue;
        ASSERT_LE(slices[row][column - 1]->x, slices[row][column]->x) << rotation;
      }
    }
    // Slices seen nearly end-on have no common vertical line except by rounding.
    if (slices[0].back()->x - slices[0].front()->x < 1e-3) continue;
    std::size_t shared = 0;
    for (std::size_t near = 0; near < order.rows; ++near) {
      for (std::size_t far = near + 1; far < order.rows; ++far) {
        for (double x = 0.5; x < 255; x += 4) {
          const Depths a = depths_at(slices[near], x);
          const Depths b = depths_at(slices[far], x);
          if (a.far == -HUGE_VAL || b.far == -HUGE_VAL) continue;
          ++shared;
          ASSERT_LE(a.far, b.near + rounding) << rotation << " slices " << near << " and " << far;
        }
      }
    }
    EXPECT_TRUE(shared > 0 || order.column_shift < std::abs(order.row_shift));
  }
}

TEST_P(SliceOrder, TheShiftHasTheDirectionOfTheSlices) {
  const scene::HeightGrid grid = stream_test::named("flat", {6, 5});
  for (const double rotation : rotations()) {
    const Projection projection(grid, {.rotation = rotation});
    const DrawingOrder order = slice_order(projection, GetParam());
    const auto x = [&](std::size_t row, std::size_t column) {
      const GridIndex index = order.index(row, column);
      return projection.at(index.point, index.slice).x;
    };
    const double step = x(1, 0) - x(0, 0);
    // Shifts too small to be visible may vanish in the fit.
    EXPECT_TRUE(order.row_shift == 0 ? step == 0 : order.row_shift * step >= 0) << rotation;
    EXPECT_TRUE(std::abs(order.row_shift) < 1e-6 || step != 0) << rotation;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, SliceOrder, testing::Values(Family::along_x, Family::along_z));

TEST(CellOrder, LaterCellsAreFarther) {
  const scene::HeightGrid grid = stream_test::named("flat", {5, 4});
  for (const double rotation : rotations()) {
    const Projection projection(grid, {.rotation = rotation});
    const Cells cells(projection);
    std::vector<std::vector<const Vertex*>> outlines;
    for (std::size_t row = 0; row + 1 < cells.rows(); ++row) {
      for (std::size_t column = 0; column + 1 < cells.columns(); ++column) {
        const Cell cell = cells.cell(row, column);
        std::vector<const Vertex*> outline;
        for (const GridIndex& corner : {cell.nearest, cell.left, cell.farthest, cell.right, cell.nearest})
          outline.push_back(&cells.at(corner));
        // N nearest, F farthest, both between L and R on the screen.
        ASSERT_LE(outline[0]->depth, std::min(outline[1]->depth, outline[3]->depth) + rounding);
        ASSERT_GE(outline[2]->depth, std::max(outline[1]->depth, outline[3]->depth) - rounding);
        for (const std::size_t middle : {0U, 2U}) {
          ASSERT_LE(outline[1]->x, outline[middle]->x) << rotation;
          ASSERT_GE(outline[3]->x, outline[middle]->x) << rotation;
        }
        outlines.push_back(outline);
      }
    }
    for (std::size_t near = 0; near < outlines.size(); ++near) {
      for (std::size_t far = near + 1; far < outlines.size(); ++far) {
        for (double x = 0.5; x < 255; x += 4) {
          const Depths a = depths_at(outlines[near], x);
          const Depths b = depths_at(outlines[far], x);
          if (a.far == -HUGE_VAL || b.far == -HUGE_VAL) continue;
          ASSERT_LE(a.far, b.near + 1e-4) << rotation << " cells " << near << " and " << far;
        }
      }
    }
  }
}

TEST(CellOrder, EveryCellOnceAndItsFarBorders) {
  const scene::HeightGrid grid = stream_test::named("flat", {5, 4});
  for (const double rotation : rotations()) {
    const Projection projection(grid, {.rotation = rotation});
    const Cells cells(projection);
    std::vector<std::array<std::size_t, 2>> seen;
    int borders = 0;
    for (std::size_t row = 0; row + 1 < cells.rows(); ++row) {
      for (std::size_t column = 0; column + 1 < cells.columns(); ++column) {
        const Cell cell = cells.cell(row, column);
        seen.push_back({std::min(cell.nearest.point, cell.farthest.point),
                        std::min(cell.nearest.slice, cell.farthest.slice)});
        const auto on_border = [&](GridIndex a, GridIndex b) {
          return (a.point == b.point && (a.point == 0 || a.point == 4)) ||
                 (a.slice == b.slice && (a.slice == 0 || a.slice == 3));
        };
        EXPECT_EQ(cell.left_margin_is_border, on_border(cell.left, cell.farthest));
        EXPECT_EQ(cell.right_margin_is_border, on_border(cell.right, cell.farthest));
        borders += cell.left_margin_is_border + cell.right_margin_is_border;
      }
    }
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(std::unique(seen.begin(), seen.end()) - seen.begin(), 12);
    EXPECT_EQ(borders, 4 + 3);
  }
}

TEST(LessEndOn, TakesTheFamilyAcrossTheLineOfSight) {
  const auto family = [](double degrees) { return less_end_on(sine_and_cosine(degrees)); };
  for (const double turn : {-180.0, 0.0, 180.0}) {
    EXPECT_EQ(family(turn), Family::along_x);
    EXPECT_EQ(family(turn + 45), Family::along_x);
    EXPECT_EQ(family(turn - 45), Family::along_x);
    EXPECT_EQ(family(turn + 45.001), Family::along_z);
    EXPECT_EQ(family(turn + 90), Family::along_z);
    EXPECT_EQ(family(turn + 134.999), Family::along_z);
  }
}

}  // namespace
}  // namespace sightline::programs::skala
