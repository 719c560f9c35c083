// The published segment counts and lengths of the benchmark scenes, by `exact` and, where it is fast enough, by the oracle.
#include <gtest/gtest.h>

#include <string>

#include "host/picture/line_picture_image.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"

namespace sightline::algorithms {
namespace {

struct Figure {
  const char* family;
  std::size_t size;
  std::size_t segments;
  double length;    // 0 if none is published
  bool oracle_too;  // exact_speed_test.cpp has the others
};

class Figures : public testing::TestWithParam<Figure> {};

INSTANTIATE_TEST_SUITE_P(, Figures,
                         testing::Values(Figure{"boxes", 10, 87, 3.468566282, true},
                                         Figure{"boxes", 100, 818, 16.266704474, false},
                                         Figure{"boxes", 1000, 6444, 56.470727778, false},
                                         Figure{"rooms", 4, 28, 9.537389965, true},
                                         Figure{"rooms", 10, 83, 24.182620501, false},
                                         Figure{"aligned", 4, 399, 0, true}),
                         [](const auto& figure) {
                           return std::string(figure.param.family) + std::to_string(figure.param.size);
                         });

TEST_P(Figures, EqualThePublishedFigures) {
  const Figure& figure = GetParam();
  const auto scene = *scene::generate_scene(figure.family, figure.size);
  for (const Maker& maker : {exact_maker, oracle_maker}) {
    if (maker.draw == oracle_maker.draw && !figure.oracle_too) continue;
    const picture::LinePicture drawn = maker.draw(scene, scene.camera);
    EXPECT_EQ(drawn.pieces.size(), figure.segments) << maker.name;
    if (figure.length > 0) {
      // Nine decimals are published.
      EXPECT_NEAR(picture::image_length(drawn, scene, scene.camera), figure.length, 0.6e-9) << maker.name;
    }
  }
}

}  // namespace
}  // namespace sightline::algorithms
