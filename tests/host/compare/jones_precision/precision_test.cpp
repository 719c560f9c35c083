// Jones's program in other arithmetic, and the measure of the resulting error.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "host/compare/jones_precision/study.hpp"
#include "host/programs/jones/twin/search.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::compare::jones_precision {
namespace {

using namespace programs::jones;

namespace oracle = algorithms::oracle;

PrecisionStudy study_of(const SixViews& views) {
  auto study = PrecisionStudy::of(scene::builtin_scene(views.scene), views.eyes);
  EXPECT_TRUE(study);
  return std::move(*study);
}

SceneInCore in_core(const char* scene) {
  const auto loaded = scene::builtin_scene(scene);
  return *scene_in_core(loaded, loaded.default_view);
}

class JonesPrecision : public testing::TestWithParam<const char*> {};

TEST_P(JonesPrecision, EighteenBitsEqualTheTwin) {
  const SceneInCore scene = in_core(GetParam());
  for (int f = 0; f <= 3; ++f) {
    for (const bool truncate : {false, true}) {
      Parameters parameters = default_parameters(scene.core, 0);
      parameters.fraction_bits = f;
      parameters.truncate = truncate;
      const TwinView twin = run_twin(scene.core, 0, parameters);
      const PreciseView view =
          run_precisely(scene.core, 0, parameters, {NumberKind::fixed_point, 18, f, truncate});
      EXPECT_EQ(view.status, Status::complete);
      ASSERT_EQ(view.pieces.size(), twin.clipped.size());
      const double unit = 1 << f;
      for (std::size_t i = 0; i < view.pieces.size(); ++i) {
        EXPECT_EQ(view.pieces[i].vector_address, twin.clipped[i].vector_address);
        EXPECT_EQ(view.pieces[i].line.x0, twin.clipped[i].line.a.x / unit + 512);
        EXPECT_EQ(view.pieces[i].line.y1, twin.clipped[i].line.b.y / unit + 512);
      }
    }
  }
}

// With all roundings of the machine the pieces equal the machine's; with none they equal those of 36 bits.
TEST_P(JonesPrecision, MixedWordsEqualThoseOfTheirRoundings) {
  const SceneInCore scene = in_core(GetParam());
  const auto expect_same = [](const PreciseView& a, const PreciseView& b) {
    ASSERT_EQ(a.pieces.size(), b.pieces.size());
    for (std::size_t i = 0; i < a.pieces.size(); ++i) {
      EXPECT_EQ(a.pieces[i].vector_address, b.pieces[i].vector_address);
      EXPECT_EQ(a.pieces[i].line.x0, b.pieces[i].line.x0);
      EXPECT_EQ(a.pieces[i].line.y0, b.pieces[i].line.y0);
      EXPECT_EQ(a.pieces[i].line.x1, b.pieces[i].line.x1);
      EXPECT_EQ(a.pieces[i].line.y1, b.pieces[i].line.y1);
    }
  };
  for (int f = 0; f <= 3; ++f) {
    for (const bool truncate : {false, true}) {
      Parameters parameters = default_parameters(scene.core, 0);
      parameters.fraction_bits = f;
      parameters.truncate = truncate;
      expect_same(run_mixed(scene.core, 0, parameters, {true, true, true}),
                  run_precisely(scene.core, 0, parameters, {NumberKind::fixed_point, 18, f, truncate}));
      expect_same(run_mixed(scene.core, 0, parameters, {false, false, false}),
                  run_precisely(scene.core, 0, parameters, {NumberKind::fixed_point, 36, 8, truncate}));
    }
  }
}

// The result must not depend on the width of the integers behind the words.
TEST_P(JonesPrecision, LongAndShortWordsGiveTheSame) {
  const SceneInCore scene = in_core(GetParam());
  const Parameters parameters = default_parameters(scene.core, 0);
  for (const int bits : {12, 14, 18, 19, 24, 30}) {
    for (const int f : {0, 1, 4, 8}) {
      const auto narrow = Search(scene.core, 0, parameters, ShortWords(bits, f)).run();
      const auto wide = Search(scene.core, 0, parameters, LongWords(bits, f)).run();
      EXPECT_EQ(narrow.status, wide.status) << bits << " bits, f=" << f;
      EXPECT_TRUE(narrow.display_file == wide.display_file) << bits << " bits, f=" << f;
      EXPECT_EQ(narrow.clipped.size(), wide.clipped.size());
    }
  }
}

TEST_P(JonesPrecision, AWordMustHoldTheWindow) {
  const SceneInCore scene = in_core(GetParam());
  const Parameters parameters = default_parameters(scene.core, 0);
  for (int f = 0; f <= most_fraction_bits; ++f) {
    for (int bits = shortest_word; bits < 12 + f; ++bits) {
      const auto view = run_precisely(scene.core, 0, parameters, {NumberKind::fixed_point, bits, f, false});
      EXPECT_EQ(view.status, Status::arithmetic_overflow) << bits << " bits, f=" << f;
      EXPECT_TRUE(view.pieces.empty());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesPrecision,
                         testing::Values("house", "roberts", "street4", "corridor8", "corridor32"),
                         [](const auto& scene) { return std::string(scene.param); });

// At scale 512 a word needs 12 bits plus the fraction to hold the window, and it must hold the visible coordinates: the house and
// Roberts's solids are within 2047 units of the eye, and so are the visible rooms of the corridor; the street is 2980 units long.
TEST(JonesPrecisionStudy, FirstWordLengthOfEachScene) {
  EXPECT_EQ(study_of(six_views[0]).shortest_complete_word(0, false), 12);
  EXPECT_EQ(study_of(six_views[0]).shortest_complete_word(1, true), 13);
  EXPECT_EQ(study_of(six_views[1]).shortest_complete_word(0, false), 12);
  EXPECT_EQ(study_of(six_views[2]).shortest_complete_word(0, false), 13);
  EXPECT_EQ(study_of(six_views[3]).shortest_complete_word(0, false), 12);
  EXPECT_EQ(study_of(six_views[3]).shortest_complete_word(8, false), 20);
}

TEST(JonesPrecisionStudy, EachFractionBitHalvesTheErrorOfAnyWordLength) {
  for (const SixViews& views : six_views) {
    const PrecisionStudy study = study_of(views);
    for (const int bits : {22, 36}) {
      double before = 0;
      for (int f = 2; f <= most_fraction_bits; f += 2) {
        const Measured measured = study.measure({NumberKind::fixed_point, bits, f, false});
        EXPECT_TRUE(measured.clipped.complete());
        EXPECT_TRUE(measured.clipped.named.empty());
        const double share = measured.clipped.share();
        if (f > 2) {
          EXPECT_GT(before / share, 3.0) << views.scene << ' ' << bits << " bits, f=" << f;
          EXPECT_LT(before / share, 5.0) << views.scene << ' ' << bits << " bits, f=" << f;
        }
        before = share;
      }
    }
  }
}

// The oracle and the program share no code; here they agree to the last digits.
TEST(JonesPrecisionStudy, FloatingPointIsExactBeyondTheVisibleResolution) {
  for (const SixViews& views : six_views) {
    const PrecisionStudy study = study_of(views);
    const Measured as_double = study.measure({NumberKind::double_float, 0, 0, false});
    const Measured as_float = study.measure({NumberKind::single_float, 0, 0, false});
    EXPECT_LT(as_double.clipped.longest, 1e-10) << views.scene;
    EXPECT_LT(as_float.clipped.longest, 1e-3) << views.scene;
    EXPECT_GT(as_float.clipped.longest, as_double.clipped.longest) << views.scene;
    EXPECT_GT(as_double.clipped.visible, 10000) << "something is visible";
    EXPECT_GT(as_double.muldivs, 1000U);
  }
}

// A line along x at y = 100, z = 100 seen from the origin at scale 512: y = 1024 on the screen, outside the window; at z = 200
// and
// y = 50 it is at 512 + 128.
class JonesLineError : public testing::Test {
 protected:
  const SceneLine line{0, {0, 50, 200}, {100, 50, 200}};
  const geometry::Point eye{0, 0, 0};
  const oracle::Window window{};
  // From x = 0 to x = 50 the line is visible: points 512 to 640.
  const std::vector<oracle::VisibleLine> truth{
      {line.from, {50, 50, 200}, geometry::IntervalSet(geometry::Rational(0), geometry::Rational(1))}};
  [[nodiscard]] DrawnLine drawn(double from, double to, double y = 640) const {
    return {line, {from, y, to, y}};
  }
  [[nodiscard]] LineError error_of(const std::vector<DrawnLine>& pieces) const {
    return line_error(truth, pieces, eye, window, 20);
  }
};

TEST_F(JonesLineError, ThePiecesOfALineHaveNoError) {
  const LineError error = error_of({drawn(600, 512, 641), drawn(600, 640), drawn(550, 610)});
  EXPECT_DOUBLE_EQ(error.visible, 128);
  EXPECT_DOUBLE_EQ(error.missing, 0);
  EXPECT_DOUBLE_EQ(error.extra, 0);
  EXPECT_TRUE(error.wrong.empty());
}

TEST_F(JonesLineError, MissingAndExtraAreDistinguished) {
  const LineError error = error_of({drawn(542, 650)});
  EXPECT_DOUBLE_EQ(error.missing, 30);
  EXPECT_DOUBLE_EQ(error.extra, 10);
  EXPECT_DOUBLE_EQ(error.longest, 30);
  EXPECT_DOUBLE_EQ(error.share(), 40.0 / 128);
  ASSERT_EQ(error.wrong.size(), 1U) << "only one is longer than 20";
  EXPECT_FALSE(error.wrong[0].extra);
  EXPECT_DOUBLE_EQ(error.wrong[0].where.x0, 512);
  EXPECT_DOUBLE_EQ(error.wrong[0].where.x1, 542);
  EXPECT_TRUE(error.wrong[0].line == line);
}

TEST_F(JonesLineError, APieceOfAHiddenLineIsWrongEvenOnAVisibleOne) {
  DrawnLine hidden = drawn(512, 640);
  hidden.line = {0, {0, 75, 300}, {100, 75, 300}};  // the same place on the screen
  const LineError error = error_of({drawn(512, 640), hidden});
  EXPECT_DOUBLE_EQ(error.extra, 128);
  ASSERT_EQ(error.wrong.size(), 1U);
  EXPECT_TRUE(error.wrong[0].extra);
  EXPECT_EQ(error.wrong[0].line.from[2], 300);
}

}  // namespace
}  // namespace sightline::compare::jones_precision
