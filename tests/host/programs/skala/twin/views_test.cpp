// Hard views and small grids through the host's stream and the Skala program's twin, compared with the column oracle; and the
// invariance
// under a rotation by a quarter turn.
#include <gtest/gtest.h>

#include <string_view>

#include "host/scene/heights/function.hpp"
#include "tests/host/programs/skala/view_oracle.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::skala {
namespace {

scene::HeightGrid grid_of(std::string_view function, scene::GridSize size) {
  return scene::sample(*scene::height_function(function), size);
}

// Every angle at which the order changes or a family is end-on, and angles next to them.
TEST(SkalaTwinViews, AnglesWhereTheOrderTurns) {
  const auto grid = grid_of("peaks", {19, 16});
  for (int eighth = 0; eighth < 8; eighth += tests::effort(1, 3)) {
    for (const double beside : {-0.001, 0.0, 0.001}) {
      for (const double elevation : {-90.0, -30.0, 0.0, 90.0}) {
        View view;
        view.rotation = 45 * eighth + beside;
        view.elevation = elevation;
        SCOPED_TRACE(testing::Message() << "A " << view.rotation << " E " << elevation);
        expect_as_oracle(grid, view);
        view.subject = Subject::surface;
        expect_as_oracle(grid, view);
      }
    }
  }
}

TEST(SkalaTwinViews, SmallFlatAndSpikedGrids) {
  for (const std::string_view function : {"flat", "spike", "terrain", "step"}) {
    for (const scene::GridSize size :
         {scene::GridSize{2, 2}, {1, 9}, {9, 1}, {1, 1}, {2, 40}, {40, 2}, {13, 12}}) {
      const auto grid = grid_of(function, size);
      for (int rotation = 0; rotation < 360; rotation += tests::effort(60, 150)) {
        SCOPED_TRACE(testing::Message()
                     << function << " " << size.points << " x " << size.slices << " A " << rotation);
        View view;
        view.rotation = rotation;
        expect_as_oracle(grid, view);
        view.family = Family::both;
        expect_as_oracle(grid, view);
        view.subject = Subject::surface;
        view.family = Family::automatic;
        expect_as_oracle(grid, view);
      }
    }
  }
}

// x' = z, z' = -x: the surface turned by a quarter, to be seen from an angle 90 degrees less.
scene::HeightGrid rotate_grid(const scene::HeightGrid& grid) {
  scene::HeightGrid result{grid.z, grid.x, {}, grid.domain_z, grid.domain_x, grid.range};
  for (std::size_t slice = 0; slice < grid.points(); ++slice)
    for (std::size_t point = 0; point < grid.slices(); ++point)
      result.heights.push_back(grid.height(grid.points() - 1 - slice, point));
  return result;
}

TEST(SkalaTwinViews, AQuarterTurnOfDataAndEyeChangesNothing) {
  for (const std::string_view function : {"sinc", "rogers", "peaks", "terrain"}) {
    const auto grid = grid_of(function, {23, 18});
    for (const double rotation : {0.0, 20.0, 70.0, 90.0, 110.0, 200.0, 290.0, 340.0}) {
      SCOPED_TRACE(testing::Message() << function << " A " << rotation);
      View view;
      view.rotation = rotation;
      View turned_view = view;
      turned_view.rotation = rotation - 90;
      EXPECT_TRUE(twin_raster(grid, view) == twin_raster(rotate_grid(grid), turned_view));
    }
  }
}

}  // namespace
}  // namespace sightline::programs::skala
