// The twin on the built-in scenes, from many positions.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "host/programs/jones/encode.hpp"
#include "host/programs/jones/twin/twin.hpp"
#include "host/scene/read/cell_scene.hpp"
#include "tests/host/programs/jones/core.hpp"
#include "tests/host/programs/jones/drawing.hpp"

namespace sightline::programs::jones {
namespace {

class JonesTwinScenes : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto loaded = scene::load_cell_scene(GetParam());
    ASSERT_TRUE(loaded);
    cells_ = loaded->cells.size();
    const auto encoded = programs::jones::encode(*loaded, {}, TestCore::header);
    ASSERT_TRUE(encoded);
    const auto& image = *encoded;
    limits_ = image.view.limits;
    for (std::size_t i = 0; i < image.words.size(); ++i) {
      words_.at(image.base + i) = core::Word18(image.words[i].value);
    }
  }
  std::vector<core::Word18> words_ = std::vector<core::Word18>(core_words);
  std::size_t cells_ = 0;
  geometry::Box limits_;
};

TEST_P(JonesTwinScenes, EveryViewIsCompleteAndStaysOnTheScreen) {
  std::mt19937 engine(71);
  for (int i = 0; i < 200; ++i) {
    Parameters parameters = default_parameters(words_, TestCore::header);
    const auto place = [&](std::size_t axis) {
      const auto room = static_cast<std::uint32_t>(limits_.high[axis] - limits_.low[axis]) + 1;
      return limits_.low[axis] + static_cast<std::int32_t>(engine() % room);
    };
    if (i > 0) parameters.eye = {place(0), place(1), place(2)};
    parameters.stereo = i % 5 == 4;
    parameters.immediate = i % 7 == 6;
    parameters.scale = i % 3 == 2 ? 64 + static_cast<std::int32_t>(engine() % 4033) : 512;
    const TwinView view = run_twin(words_, TestCore::header, parameters);
    EXPECT_EQ(view.status, Status::complete) << name(view.status);
    EXPECT_LE(view.counts.depth, static_cast<int>(std::min<std::size_t>(cells_, 16)));
    EXPECT_LE(view.counts.distinct_cells, cells_);
    EXPECT_EQ(view.counts.pieces, view.pieces.size());
    EXPECT_TRUE(decode(view).well_formed);
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesTwinScenes,
                         testing::Values("house", "roberts", "street4", "corridor8", "corridor32"),
                         [](const auto& scene) { return std::string(scene.param); });

using JonesTwinHouse = JonesTwinScenes;
// Fig. 5 of the paper: the kitchen is visible through its door, and through the dining room's door and the hatch.
TEST_P(JonesTwinHouse, SeesTheKitchenTwice) {
  const TwinView view = run_twin(words_, TestCore::header, default_parameters(words_, TestCore::header));
  EXPECT_EQ(view.counts.visits, 4U);
  EXPECT_EQ(view.counts.distinct_cells, 3U);
  EXPECT_EQ(view.counts.depth, 3);
}
INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesTwinHouse, testing::Values("house"));

}  // namespace
}  // namespace sightline::programs::jones
