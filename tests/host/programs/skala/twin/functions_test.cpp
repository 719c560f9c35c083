// The eight functions, drawn by the Skala program's twin, compared with the column oracle, which knows only the projected points
// and
// their depths: this also tests the order of the host's stream, its rims and its margins.
#include <gtest/gtest.h>

#include <string>

#include "host/scene/heights/function.hpp"
#include "tests/host/programs/skala/view_oracle.hpp"

namespace sightline::programs::skala {
namespace {

constexpr scene::GridSize size{25, 22};

class SkalaTwinFunctions : public testing::TestWithParam<std::size_t> {
 protected:
  // Calls check(grid, view) for all rotations and elevations.
  template <class Check>
  void for_views(Subject picture, Family family, Check&& check) {
    const auto& function = scene::height_functions()[GetParam()];
    const auto grid = scene::sample(function, size);
    View view;
    view.subject = picture;
    view.family = family;
    view.levels = 7;
    for (int rotation = 0; rotation < 360; rotation += 15) {
      for (const double elevation : {-20.0, 0.0, 35.0}) {
        SCOPED_TRACE(testing::Message() << function.name << " A " << rotation << " E " << elevation);
        view.rotation = rotation;
        view.elevation = elevation;
        check(grid, view);
      }
    }
  }
};

TEST_P(SkalaTwinFunctions, Lines) {
  for_views(Subject::lines, Family::automatic, expect_as_oracle);
}

TEST_P(SkalaTwinFunctions, BothFamilies) {
  for_views(Subject::lines, Family::both, expect_as_oracle);
}

TEST_P(SkalaTwinFunctions, Surfaces) {
  for_views(Subject::surface, Family::automatic, expect_as_oracle);
}

TEST_P(SkalaTwinFunctions, Contours) {
  for_views(Subject::contours, Family::automatic, expect_as_oracle);
}

INSTANTIATE_TEST_SUITE_P(Figure, SkalaTwinFunctions, testing::Range(std::size_t{0}, scene::figure_functions),
                         [](const auto& parameter) {
                           return std::string(scene::height_functions()[parameter.param].name);
                         });

}  // namespace
}  // namespace sightline::programs::skala
