// The grid over the image stays small whatever covers it, and still has every occluder where it is.
#include "host/algorithms/exact/image_grid.hpp"

#include <gtest/gtest.h>

#include "tests/host/algorithms/exact/edge_scenes.hpp"

namespace sightline::algorithms {
namespace {

using exact::ImageBounds;
using exact::ImageGrid;

std::size_t entries(const ImageGrid& grid, const ImageBounds& bounds) {
  const ImageGrid::Cells cells = grid.cells_of(bounds);
  std::size_t count = 0;
  for (std::uint32_t row = cells.low[1]; row <= cells.high[1]; ++row) {
    for (std::uint32_t column = cells.low[0]; column <= cells.high[0]; ++column)
      count += grid.occluders_at(column, row).size();
  }
  return count;
}

TEST(ImageGrid, OccludersOverTheWholeImageTakeFewEntries) {
  const ImageBounds everywhere{{-1e9, -1e9}, {1e9, 1e9}};
  exact::View view;
  view.occluders.resize(20000);
  for (exact::Occluder& occluder : view.occluders) occluder.bounds = everywhere;
  const std::size_t needed = entries(ImageGrid(view), everywhere);
  EXPECT_GE(needed, view.occluders.size());
  EXPECT_LE(needed, 32 * view.occluders.size() + 4096);
}

TEST(ImageGrid, SmallOccludersKeepSmallCells) {
  exact::View view;
  for (int i = 0; i < 100; ++i) {
    exact::Occluder occluder;
    const double x = i % 10;
    const double y = i / 10;
    occluder.bounds = {{x + 0.25, y + 0.25}, {x + 0.75, y + 0.75}};
    view.occluders.push_back(occluder);
  }
  const ImageGrid grid(view);
  EXPECT_EQ(entries(grid, {{0, 0}, {9, 9}}), 100U);
  EXPECT_EQ(entries(grid, {{3.5, 4.5}, {3.5, 4.5}}), 1U);
}

// One behind the other, so that all but the first are hidden.
TEST(ImageGrid, ThousandsOfSheetsInAStack) {
  scene::PolyScene scene;
  for (std::int32_t i = 0; i < 3000; ++i) add_sheet(scene, square(8000, 10000 + i));
  EXPECT_EQ(exact_maker.draw(scene, scene::PolyCamera{}).pieces.size(), 4U);
}

}  // namespace
}  // namespace sightline::algorithms
