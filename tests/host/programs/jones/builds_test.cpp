// The builds of Jones's program with other fraction bits, and with truncated quotients: the machine compared with the native
// twin, bit for
// bit, with and without the EAE, on every scene.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "host/programs/jones/jones.hpp"
#include "tests/firmware/jones_path_watch.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"
#include "tools/asm/pdp7.hpp"

namespace sightline::programs::jones {
namespace {

const int views = tests::effort(4, 2);

struct SceneBuild {
  std::string scene;
  bool eae;
  std::uint32_t fraction_bits;
  bool truncate;
};

Program assemble_build(const SceneBuild& build) {
  auto program = assemble_program(scene::builtin_scene(build.scene), {build.eae, build.fraction_bits, build.truncate});
  if (!program) {
    ADD_FAILURE() << program.error().message();
    return {};
  }
  return std::move(*program);
}

Parameters twin_parameters(const SceneBuild& build) {
  Parameters parameters;
  parameters.fraction_bits = static_cast<int>(build.fraction_bits);
  parameters.truncate = build.truncate;
  return parameters;
}

class JonesBuilds : public testing::TestWithParam<std::tuple<std::string, bool, std::uint32_t, bool>> {
 protected:
  static SceneBuild build() {
    const auto& [scene, eae, fraction_bits, truncate] = GetParam();
    return {scene, eae, fraction_bits, truncate};
  }
};

TEST_P(JonesBuilds, GuestAndTwinAgree) {
  Program program = assemble_build(build());
  ASSERT_FALSE(program.core.empty());
  const geometry::Box& limits = program.scene.view.limits;
  Dice dice(1971);
  for (int i = 0; i < views; ++i) {
    Parameters parameters = twin_parameters(build());
    // Scales at which the bound factor is 32, 16, 8, 4 and, with three fraction bits, 1.
    parameters.scale = i == 0 ? 512 : i % 2 == 0 ? dice(64, 4096) : i % 4 == 1 ? 4096 : 64;
    parameters.stereo = i == 3;
    if (i > 0) {
      put_eye(program, {dice(limits.low[0], limits.high[0]), dice(limits.low[1], limits.high[1]),
                        dice(limits.low[2], limits.high[2])});
    }
    SCOPED_TRACE("view " + std::to_string(i) + " scale " + std::to_string(parameters.scale));
    const TwinView expected = twin_view(program, parameters);
    const DarkView view = dark_view(program, build().eae, parameters);
    ASSERT_EQ(name(view.status), name(expected.status));
    EXPECT_EQ(view.status, Status::complete);
    ASSERT_TRUE(same_words(view.display_file, expected.display_file));
    EXPECT_EQ(view.visits, expected.counts.visits);
  }
}

TEST_P(JonesBuilds, PiecesOnTheMachineEqualThoseOfTheTwin) {
  const Program program = assemble_build(build());
  ASSERT_FALSE(program.core.empty());
  const TwinView expected = twin_view(program, twin_parameters(build()));
  Order order;
  order.clock = false;
  order.views = 1;
  order.display = false;
  order.pieces = true;
  const Outcome outcome = outcome_of(program, order);
  ASSERT_EQ(outcome.views.size(), 1U);
  const View& pieces = outcome.view();
  EXPECT_EQ(pieces.status, Status::complete);
  ASSERT_EQ(pieces.clipped.size(), expected.clipped.size());
  ASSERT_EQ(pieces.on_display.size(), pieces.clipped.size());
  const ShortWords number(machine_word_bits, static_cast<int>(build().fraction_bits), build().truncate);
  const Window window;
  const auto point = [&](const ScreenPoint& p) {
    return ScreenPoint{number.point(p.x) + window.centre_x, number.point(p.y) + window.centre_y};
  };
  for (std::size_t i = 0; i < pieces.clipped.size(); ++i) {
    ASSERT_TRUE(pieces.clipped[i] == expected.clipped[i]) << "piece " << i;
    const ScreenSegment& line = pieces.clipped[i].line;
    EXPECT_EQ(pieces.on_display[i], (ScreenSegment{point(line.a), point(line.b)}));
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesBuilds,
                         testing::Combine(testing::ValuesIn(std::vector<std::string>(scene_names.begin(),
                                                                                     scene_names.end())),
                                          testing::Bool(), testing::Values(0U, 1U, 2U, 3U), testing::Bool()),
                         [](const auto& p) {
                           return std::get<0>(p.param) + (std::get<1>(p.param) ? "_Eae_F" : "_NoEae_F") +
                                  std::to_string(std::get<2>(p.param)) +
                                  (std::get<3>(p.param) ? "_Truncated" : "");
                         });

// By hand: at scale 512 a point at x/z = 2/3 is 341 1/3 points from the centre, one at 1/3 is 170 2/3.
TEST(JonesFractionBits, CoordinatesAreTruncatedToTheirFraction) {
  Operations operations;
  const auto x_of = [&](int fraction_bits, bool truncate, std::int32_t x) {
    const ShortWords number(machine_word_bits, fraction_bits, truncate);
    return project(number, {x, 0, 3}, 512 << fraction_bits, operations)->x;
  };
  EXPECT_EQ(x_of(0, false, 2), 341);
  EXPECT_EQ(x_of(0, false, 1), 171);
  EXPECT_EQ(x_of(0, true, 1), 170);
  EXPECT_EQ(x_of(0, true, -1), -170) << "in magnitude";
  EXPECT_EQ(x_of(2, false, 1), 683) << "170.75";
  EXPECT_EQ(x_of(2, true, 1), 682) << "170.5";
  EXPECT_EQ(x_of(3, false, -2), -2731) << "-341.375";
}

TEST(JonesFractionBits, PointsAreRoundedHalfUpOrTruncated) {
  EXPECT_EQ(ShortWords(18, 1, false).point(-1), 0) << "-0.5";
  EXPECT_EQ(ShortWords(18, 1, true).point(-1), -1);
  EXPECT_EQ(ShortWords(18, 3, false).point(12), 2) << "1.5";
  EXPECT_EQ(ShortWords(18, 3, false).point(11), 1) << "1.375";
  EXPECT_EQ(ShortWords(18, 3, true).point(15), 1) << "1.875";
  EXPECT_EQ(ShortWords(18, 0, false).point(-7), -7);
}

TEST(JonesFractionBits, NothingOverflowsTheWordAtAnyScale) {
  for (int f = 0; f <= 3; ++f) {
    for (std::int32_t scale = 64; scale <= 4096; ++scale) {
      for (const Pass pass : {Pass::mono, Pass::left}) {
        const Window window = window_of(pass, scale, f);
        const std::int64_t farthest = std::int64_t{window.bound_factor} * window.width_scale;
        ASSERT_LE(2 * farthest, largest_word) << "the difference of two coordinates";
        ASSERT_GE(farthest, std::int64_t{1024} << f) << "twice the window";
        ASSERT_TRUE(fits(window, f, machine_word_bits));
      }
    }
  }
}

std::string errors_with(std::uint32_t fraction) {
  std::vector<assembler::SourceFile> sources;
  for (const auto& [file, text] : firmware_tapes()) sources.push_back({std::string(file), std::string(text)});
  assembler::Options options;
  options.defines = {{"EAE", 1}, {"FRACTION", fraction}};
  std::string found;
  for (const auto& diagnostic : assembler::assemble_pdp7(sources, options).diagnostics)
    found += to_string(diagnostic) + "\n";
  return found;
}

TEST(JonesFractionBits, MoreThanThreeDoNotAssemble) {
  EXPECT_NE(errors_with(4).find("'not'"), std::string::npos) << errors_with(4);
  EXPECT_EQ(errors_with(3).find("'not'"), std::string::npos) << errors_with(3);
}

}  // namespace
}  // namespace sightline::programs::jones
