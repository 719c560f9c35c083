// The published segment counts and lengths of the benchmark scenes, by native Jones with grid and with BSP, and the picture of
// `exact`, piece by piece. A thousand boxes have too many units for a grid.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::algorithms {
namespace {

struct Figure {
  const char* family;
  std::size_t size;
  std::size_t segments;
  double length;
  bool by_grid;
};

class JonesFigures : public testing::TestWithParam<Figure> {};

TEST_P(JonesFigures, EqualThePublishedFigures) {
  const Figure& figure = GetParam();
  const auto scene = *scene::generate_scene(figure.family, figure.size);
  const picture::LinePicture exact = exact::visible_edges(scene, scene.camera);
  for (const auto method : {scene::DecompositionMethod::grid, scene::DecompositionMethod::bsp}) {
    if (method == scene::DecompositionMethod::grid && !figure.by_grid) continue;
    const auto complex = scene::decompose(scene, method);
    ASSERT_TRUE(complex);
    const auto result = jones::visible_edges(*complex, scene.camera);
    ASSERT_TRUE(result);
    const picture::LinePicture& drawn = result->picture;
    EXPECT_EQ(drawn.pieces.size(), figure.segments);
    // Nine decimals are published.
    EXPECT_NEAR(picture::image_length(drawn, scene, scene.camera), figure.length, 0.6e-9);
    EXPECT_TRUE(drawn == exact);
  }
}

std::string name_of(const testing::TestParamInfo<Figure>& figure) {
  return figure.param.family + std::to_string(figure.param.size);
}

INSTANTIATE_TEST_SUITE_P(Small, JonesFigures,
                         testing::Values(Figure{"boxes", 10, 87, 3.468566282, true},
                                         Figure{"boxes", 100, 818, 16.266704474, true},
                                         Figure{"rooms", 4, 28, 9.537389965, true},
                                         Figure{"rooms", 10, 83, 24.182620501, true}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Large, JonesFigures,
                         testing::Values(Figure{"boxes", 1000, 6444, 56.470727778, false}), name_of);

}  // namespace
}  // namespace sightline::algorithms
