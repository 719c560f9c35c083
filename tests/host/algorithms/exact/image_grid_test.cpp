// The grid over the image stays small for any occluders and finds every occluder at its position.
#include "host/algorithms/exact/image_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

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
      count += grid.entries_at(column, row).size();
  }
  return count;
}

TEST(ImageGrid, OccludersOverTheWholeImageTakeFewEntries) {
  const ImageBounds everywhere{{0, 0}, {exact::last_step, exact::last_step}};
  const std::vector<ImageBounds> bounds(20000, everywhere);
  const std::vector<std::uint32_t> depths(bounds.size());
  const std::size_t needed = entries(ImageGrid(bounds, depths), everywhere);
  EXPECT_GE(needed, bounds.size());
  EXPECT_LE(needed, 32 * bounds.size() + 4096);
}

TEST(ImageGrid, SmallOccludersKeepSmallCells) {
  std::vector<ImageBounds> bounds;
  for (std::uint16_t i = 0; i < 400; ++i) {
    const auto x = static_cast<std::uint16_t>(i % 20 * 1640);
    const auto y = static_cast<std::uint16_t>(i / 20 * 1640);
    const auto far = [](std::uint16_t low) { return static_cast<std::uint16_t>(low + 800); };
    bounds.push_back({{x, y}, {far(x), far(y)}});
  }
  const std::vector<std::uint32_t> depths(bounds.size());
  const ImageGrid grid(bounds, depths);
  EXPECT_EQ(grid.side(), 10U);
  EXPECT_EQ(entries(grid, {{0, 0}, {exact::last_step, exact::last_step}}), 400U);
  EXPECT_EQ(entries(grid, bounds[0]), 4U);
}

// The law of a query: each occluder whose bounds touch a rectangle is visited once, in one of the cells, and no other; in a cell
// the nearest comes first. For any number of threads.
TEST(ImageGrid, EveryOccluderThatTouchesARectangleIsVisitedOnce) {
  std::mt19937 generator(3);
  const auto below = [&generator](std::uint32_t limit) { return static_cast<std::uint32_t>(generator()) % limit; };
  for (int round = 0; round < 60; ++round) {
    const auto random_bounds = [&below](std::uint32_t longest) {
      ImageBounds bounds;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::uint32_t low = below(8) == 0 ? 0 : below(exact::last_step + 1U);
        const std::uint32_t high = std::min<std::uint32_t>(low + below(longest), exact::last_step);
        bounds.low[axis] = static_cast<std::uint16_t>(low);
        bounds.high[axis] = static_cast<std::uint16_t>(high);
      }
      return bounds;
    };
    std::vector<ImageBounds> bounds(below(300));
    std::vector<std::uint32_t> depths;
    for (ImageBounds& box : bounds) {
      box = random_bounds(round % 2 == 0 ? 3000 : 33000);
      depths.push_back(below(5) == 0 ? 7 : below(1U << 31));
    }
    const ImageGrid grid(bounds, depths, 1 + static_cast<unsigned>(round % 3));
    for (int query_number = 0; query_number < 20; ++query_number) {
      const ImageBounds rectangle = random_bounds(12000);
      ImageGrid::Query query(grid, rectangle);
      std::vector<int> passed(bounds.size());
      for (std::uint32_t row = query.cells().low[1]; row <= query.cells().high[1]; ++row) {
        for (std::uint32_t column = query.cells().low[0]; column <= query.cells().high[0]; ++column) {
          query.enter(column, row);
          std::uint32_t before = 0;
          const ImageGrid::Entries cell = grid.entries_at(column, row);
          for (std::size_t i = 0; i < cell.size(); ++i) {
            const std::uint32_t occluder = grid.occluder(cell.ranks[i]);
            EXPECT_LE(before, depths[occluder]);
            before = depths[occluder];
            if (query.passes(cell.bounds[i])) ++passed[occluder];
          }
        }
      }
      for (std::size_t i = 0; i < bounds.size(); ++i) {
        bool touches = true;
        for (std::size_t axis = 0; axis < 2; ++axis)
          touches = touches && bounds[i].low[axis] <= rectangle.high[axis] && rectangle.low[axis] <= bounds[i].high[axis];
        ASSERT_EQ(passed[i], touches ? 1 : 0) << "round " << round << ", occluder " << i;
      }
    }
  }
}

// Ranks ascend with depth; the occluders up to a depth are the first ranks.
TEST(ImageGrid, RanksSayWhichOccludersAreUpToADepth) {
  std::mt19937 generator(5);
  for (int round = 0; round < 50; ++round) {
    std::vector<ImageBounds> bounds(generator() % 400);
    std::vector<std::uint32_t> depths;
    const auto any = [&] { return static_cast<std::uint32_t>(generator()) >> (generator() % 32); };
    for (std::size_t i = 0; i < bounds.size(); ++i) depths.push_back(any());
    const ImageGrid grid(bounds, depths);
    for (int query = 0; query < 200; ++query) {
      const std::uint32_t depth = query % 2 == 0 || depths.empty() ? any() : depths[generator() % depths.size()];
      const auto nearer = std::count_if(depths.begin(), depths.end(), [depth](std::uint32_t d) { return d <= depth; });
      const std::uint32_t count = grid.count_up_to(depth);
      ASSERT_EQ(count, nearer) << "round " << round << ", depth " << depth;
      for (std::uint32_t rank = 0; rank < depths.size(); ++rank) ASSERT_EQ(depths[grid.occluder(rank)] <= depth, rank < count);
    }
  }
}

// One behind the other: all but the first are hidden.
TEST(ImageGrid, ThousandsOfSheetsInAStack) {
  scene::PolyScene scene;
  for (std::int32_t i = 0; i < 3000; ++i) add_sheet(scene, square(8000, 10000 + i));
  EXPECT_EQ(exact_maker.draw(scene, scene::PolyCamera{}).pieces.size(), 4U);
}

}  // namespace
}  // namespace sightline::algorithms
