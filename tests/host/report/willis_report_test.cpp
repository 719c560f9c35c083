// Willis in the report: the measures detect a wrong picture.
#include <gtest/gtest.h>

#include <utility>

#include "host/algorithms/willis/model.hpp"
#include "host/compare/hard_cases/willis_views.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::report {
namespace {

using compare::FaceErrors;
using compare::TrueFaces;
using compare::cameras_around;

namespace willis = algorithms::willis;

willis::Model model_of(const scene::PolyScene& scene, const willis::ModelOptions& options = {}) {
  auto made = willis::make_model(scene, options);
  return std::move(*made);
}

TEST(WillisViews, AWrongOrderIsCounted) {
  const scene::PolyScene scene = scene::generate_boxes(5);
  const TrueFaces truth(scene, cameras_around(scene, 487), 64);
  ASSERT_EQ(truth.cameras().size(), 4U);
  const FaceErrors right = truth.errors_of(model_of(scene));
  EXPECT_EQ(right.wrong_inside, 0U);
  EXPECT_EQ(right.points, 4U * 64 * 64);
  EXPECT_GT(right.inside, right.points / 2);
  picture::PixelGrid blank(64, 64);
  const FaceErrors nothing = truth.errors_of(blank, 0);
  EXPECT_GT(nothing.wrong_inside, 0U);
  EXPECT_GT(nothing.inside_per_cent(), 0);
}

// Faces change exactly at the edges that the measure excludes.
TEST(WillisViews, FacesChangeOnlyNextToEdges) {
  const scene::PolyScene scene = scene::generate_boxes(5);
  const TrueFaces truth(scene, cameras_around(scene, 487), 64);
  for (std::size_t view = 0; view < truth.cameras().size(); ++view) {
    picture::PixelGrid moved = truth.truth(view);
    for (int row = 0; row < 64; ++row)
      for (int column = 0; column + 1 < 64; ++column)
        moved.set(column, row, truth.truth(view).at(column + 1, row));
    const FaceErrors errors = truth.errors_of(moved, view);
    EXPECT_GT(errors.wrong_on_edges, 0U);
    EXPECT_LE(errors.wrong_inside, errors.wrong_on_edges) << view;
  }
}

}  // namespace
}  // namespace sightline::report
