// All methods that draw height grids on the points of Skala's board draw the same picture of a simple function, and report what
// they
// cannot draw.
#include "host/compare/height_methods.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "host/scene/heights/function.hpp"

namespace sightline::compare {
namespace {

scene::HeightGrid hills() {
  return sample(*scene::height_function("sinc"), {17, 12});
}

TEST(HeightMethods, ProgramsDrawTheOraclesDots) {
  const scene::HeightGrid grid = hills();
  algorithms::skala::View view;
  view.rotation = 30;
  const picture::PixelGrid truth = find_height_method("oracle")->draw(grid, view).dots;
  for (const HeightMethod& method : height_methods()) {
    ASSERT_FALSE(method.why_not(grid, view)) << method.name;
    const HeightPicture picture = method.draw(grid, view);
    EXPECT_EQ(picture.fault, "") << method.name;
    EXPECT_EQ(picture.drawing.has_value(), method.name == "native");
    EXPECT_EQ(picture.drawing_time.has_value(), method.name == "guest") << method.name;
    const auto metrics = picture::pixel_metrics(truth, picture.dots, {});
    if (picture.drawing) {
      EXPECT_EQ(metrics.missing_far + metrics.extra_far, 0U) << method.name;
    } else {
      EXPECT_EQ(metrics.missing + metrics.extra, 0U) << method.name;
    }
  }
}

TEST(HeightMethods, ReportWhatTheyCannotDraw) {
  scene::HeightGrid grid = hills();
  algorithms::skala::View zoomed;
  zoomed.zoom = 3;
  EXPECT_FALSE(find_height_method("guest")->why_not(grid, zoomed));
  EXPECT_TRUE(find_height_method("native")->why_not(grid, zoomed));
  EXPECT_TRUE(find_height_method("oracle")->why_not(grid, zoomed));
  grid.heights[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(find_height_method("native")->why_not(grid, {}));
  EXPECT_TRUE(find_height_method("oracle")->why_not(grid, {}));
  EXPECT_EQ(find_height_method("none"), nullptr);
}

}  // namespace
}  // namespace sightline::compare
