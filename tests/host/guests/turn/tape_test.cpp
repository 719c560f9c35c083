// What is on the tape, and which models have none.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/host/guests/turn/turned_model.hpp"

namespace sightline::guests::turn {
namespace {

namespace plantinga = algorithms::plantinga;

TEST(TurnTape, EventsAreRoundedUpAndExactOnesAreNot) {
  for (const std::int64_t x : {-3LL, -2LL, -1LL, 0LL, 1LL, 2LL, 5LL})
    for (const std::int64_t z : {-7LL, -1LL, 1LL, 3LL}) {
      const auto direction = plantinga::rational_direction(x, z);
      const std::uint32_t word = event_word(direction);
      const double turns = std::atan2(static_cast<double>(x), static_cast<double>(z)) / (2 * std::numbers::pi) * (1 << 18);
      const double signed_word = word > (1U << 17U) ? static_cast<double>(word) - (1 << 18) : word;
      EXPECT_GE(signed_word, turns - 1e-6) << x << " " << z;
      EXPECT_LT(signed_word, turns + 1) << x << " " << z;
    }
  EXPECT_EQ(event_word(plantinga::rational_direction(0, 1)), 0U);
  EXPECT_EQ(event_word(plantinga::rational_direction(1, 1)), 1U << 15U);
  EXPECT_EQ(event_word(plantinga::rational_direction(1, 0)), 1U << 16U);
  EXPECT_EQ(event_word(plantinga::rational_direction(0, -1)), 1U << 17U);
  EXPECT_EQ(event_word(plantinga::rational_direction(-1, 1)), 7U << 15U);
}

TEST(TurnTape, SumOfAllWordsIsNothing) {
  const Tape& tape = turned(star).tape;
  core::Word18 sum(static_cast<std::uint32_t>(tape.words.size()));
  for (const core::Word18 word : tape.words) sum = sum + word;
  EXPECT_EQ(sum + checksum(tape.words), core::Word18(0));
  EXPECT_EQ(punch(tape).size(), 3 * (tape.words.size() + 2));
}

TEST(TurnTape, LayoutAddsUp) {
  for (const std::string& name : {cube, block, crossed, lshape, star}) {
    const TurnedModel& model = turned(name);
    const Tape& tape = model.tape;
    EXPECT_EQ(tape.layout.model(), tape.words.size()) << name;
    EXPECT_EQ(tape.edges, model.model.edges().size()) << name;
    EXPECT_EQ(tape.layout.events, tape.events + tape.changes) << name;
    EXPECT_LE(model_base(Memory::words_8k) + tape.words.size() + 1 + tape.files * tape.file_words, 8192U) << name;
  }
  EXPECT_EQ(turned(star).tape.edges, 100U);
  EXPECT_EQ(turned(block).tape.edges, 24U);
}

// Exclusive-ored all round, the changes leave every state as it was.
TEST(TurnTape, AWholeTurnOfChangesIsNone) {
  for (const std::string& name : {cube, block, crossed, lshape, star}) {
    const Tape& tape = turned(name).tape;
    const std::uint32_t base = model_base(tape.memory);
    std::map<std::uint32_t, std::uint32_t> sums;
    for (std::uint32_t at = tape.words[7].value() - base; at < tape.words[8].value() - base;) {
      ++at;
      std::uint32_t word = 0;
      do {
        word = tape.words[at++].value();
        sums[word & 07774U] ^= word & 0770000U;
      } while ((word & 1U) == 0);
    }
    for (const auto& [end, sum] : sums) EXPECT_EQ(sum, 0U) << name << " end " << end;
  }
}

TEST(TurnTape, SaysByHowManyWordsAModelIsTooLarge) {
  const plantinga::RotationModel model(*stand_on_axis(scene_named(grid), false));
  const auto list = plantinga::build_event_list(model);
  const auto small = encode(model, *list, Memory::words_8k);
  ASSERT_FALSE(small);
  const std::string message = small.error().message();
  EXPECT_NE(message.find(" words too many for 8K"), std::string::npos) << message;
  EXPECT_NE(message.find("for T-junctions"), std::string::npos) << message;
  EXPECT_NE(message.find("--memory 32k"), std::string::npos) << message;
  EXPECT_TRUE(encode(model, *list, Memory::words_32k));
}

TEST(TurnTape, RefusesWhatTiltingMakesTooLarge) {
  scene::PolyScene scene = scene_named(cube);
  for (auto& vertex : scene.vertices)
    for (auto& coordinate : vertex) coordinate *= 300;
  EXPECT_FALSE(stand_on_axis(scene, true));
  EXPECT_TRUE(stand_on_axis(scene, false));
}

TEST(TurnTape, TiltedEdgesKeepTheirLengthsAndAngles) {
  const scene::PolyScene& standing = turned(cube).scene;
  const scene::PolyScene given = scene_named(cube);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < 8; ++j) {
      std::int64_t a = 0;
      std::int64_t b = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        a += std::int64_t{given.vertices[i][k]} * given.vertices[j][k];
        b += std::int64_t{standing.vertices[i][k]} * standing.vertices[j][k];
      }
      EXPECT_EQ(169 * a, b);
    }
}

}  // namespace
}  // namespace sightline::guests::turn
