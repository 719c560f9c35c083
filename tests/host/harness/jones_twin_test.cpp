// The twin's search and display file: cases worked out by hand (among them the hard cases of the paper's
// method), every status, and the built-in scenes from many places.
#include "host/harness/jones_twin.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <variant>

#include "host/scene/encode.hpp"
#include "host/scene/read.hpp"
#include "tests/host/harness/jones_core.hpp"

namespace sightline::harness::jones {
namespace {

View view_of(const TestCore& core, const Parameters& parameters = {}) {
  return run(core.words, TestCore::header, parameters);
}

std::vector<std::uint32_t> octal_words(const View& view) {
  std::vector<std::uint32_t> words;
  for (const core::Word18 word : view.display_file) words.push_back(word.value());
  return words;
}

// Where the beam goes, by the word formats of the Type 340 alone.
struct Drawing {
  std::vector<ScreenSegment> pieces;  // one an unbroken chain of vector words, points of the screen
  bool well_formed = true;
};
Drawing decode(const View& view) {
  Drawing drawing;
  ScreenPoint beam;
  enum class Mode { parameter, point_y, point_x, vector } mode = Mode::parameter;
  bool stopped = false;
  for (std::size_t i = 0; i < view.display_file.size(); ++i) {
    const core::Word18 word = view.display_file[i];
    const auto expect = [&](bool holds) { drawing.well_formed = drawing.well_formed && holds; };
    expect(!stopped);
    if (mode == Mode::parameter) {
      if (word.bit(7)) stopped = true;
      expect(word.field(2, 4) == 0 || word.field(2, 4) == 1);
      if (word.field(2, 4) == 1) mode = Mode::point_y;
    } else if (mode == Mode::point_y) {
      expect(word.bit(1) && word.field(2, 4) == 1 && !word.bit(7));
      beam.y = static_cast<std::int32_t>(word.field(8, 17));
      mode = Mode::point_x;
    } else if (mode == Mode::point_x) {
      expect(!word.bit(1) && word.field(2, 4) == 4 && word.bit(7));
      beam.x = static_cast<std::int32_t>(word.field(8, 17));
      drawing.pieces.push_back({beam, beam});
      mode = Mode::vector;
    } else {
      const auto dy = static_cast<std::int32_t>(word.field(3, 9)),
                 dx = static_cast<std::int32_t>(word.field(11, 17));
      beam.y += word.bit(2) ? -dy : dy;
      beam.x += word.bit(10) ? -dx : dx;
      expect(word.bit(1) && dx + dy > 0);
      expect(0 <= beam.x && beam.x <= 1023 && 0 <= beam.y && beam.y <= 1023);
      drawing.pieces.back().b = beam;
      if (word.bit(0)) mode = Mode::parameter;
    }
  }
  drawing.well_formed = drawing.well_formed && stopped;
  return drawing;
}

TEST(JonesTwinDisplayFile, OneLineIsFiveVectorsOfRoundedShares) {
  // x/z from -1/2 to 1/2: points 256 to 768 at height 512; 512 in five shares 102 103 102 103 102.
  const View view = view_of(TestCore({{-50, 0, 100, {{true, 1, 100}}}}, {}));
  EXPECT_EQ(view.status, Status::complete);
  EXPECT_EQ(octal_words(view), (std::vector<std::uint32_t>{010117, 020000, 0221000, 0102400, 0200146, 0200147,
                                                           0200146, 0200147, 0600146, 003000}));
}

TEST(JonesTwinDisplayFile, AZeroComponentTakesTheSignOfItsWholeDifference) {
  // Down and to the left: dx = -51, dy = 0, and then dy = -51, dx = 0.
  const View view = view_of(TestCore({{10, 10, 100, {{true, 1, -10}, {true, 2, -10}}}}, {}));
  EXPECT_EQ(octal_words(view),
            (std::vector<std::uint32_t>{010117, 020000, 0221063, 0103063, 0200263, 0731400, 003000}));
}

TEST(JonesTwinDisplayFile, LinesAddedAtOnceAreNotJoined) {
  const TestCore core({{10, 10, 100, {{true, 1, -10}, {true, 2, -10}}}}, {});
  Parameters parameters;
  parameters.immediate = true;
  const View view = view_of(core, parameters);
  EXPECT_EQ(octal_words(view), (std::vector<std::uint32_t>{010117, 020000, 0221063, 0103063, 0600263, 020000,
                                                           0221063, 0103000, 0731400, 003000}));
}

TEST(JonesTwinDisplayFile, StereoPairOfOneEyeIsTheSamePictureTwice) {
  // The header's box leaves the eye no room: both eyes stand at the origin.
  const TestCore core({{-10, 0, 100, {{true, 1, 20}, {true, 2, 20}, {false, 1, 5}, {true, 3, 50}}}}, {});
  Parameters parameters;
  parameters.stereo = true;
  const Drawing both = decode(view_of(core, parameters));
  ASSERT_TRUE(both.well_formed);
  ASSERT_EQ(both.pieces.size(), 4U);
  for (std::size_t i = 0; i < 2; ++i) {
    const ScreenSegment left = both.pieces[i], right = both.pieces[i + 2];
    EXPECT_EQ(right, (ScreenSegment{{left.a.x + 512, left.a.y}, {left.b.x + 512, left.b.y}}));
  }
}

TEST(JonesTwinDisplayFile, EyesOfAStereoPairAreTenUnitsApart) {
  TestCore core({{0, 0, 100, {{true, 2, 10}}}}, {});
  core.put(TestCore::header + 5, static_cast<std::uint32_t>(-100));
  core.put(TestCore::header + 6, 100);
  Parameters parameters;
  parameters.stereo = true;
  const Drawing both = decode(view_of(core, parameters));
  ASSERT_EQ(both.pieces.size(), 2U);
  EXPECT_EQ(both.pieces[0].a.x, 256 + 13) << "5/100 of 256 is 12.8 to the right of the centre";
  EXPECT_EQ(both.pieces[1].a.x, 768 - 13);
}

// J1: the eye in the plane of an opening.
TEST(JonesTwinSearch, EdgeOnOpeningIsDrawnButNotEntered) {
  const TestChain ring{0, -5, 50, {{true, 2, 10}, {true, 3, 30}, {true, 2, -10}, {true, 3, -30}}};
  const View view = view_of(TestCore({{}, {}}, {{0, 1, ring}}));
  EXPECT_EQ(view.status, Status::complete);
  EXPECT_EQ(view.counts.visits, 1U);
  EXPECT_EQ(view.counts.openings_tested, 1U);
  EXPECT_EQ(view.counts.openings_crossing, 0U);
  EXPECT_EQ(view.counts.lines_clipped, 4U);
  EXPECT_EQ(view.counts.pieces, 4U);
}

// J5: windows that share only a line, or only a corner.
TEST(JonesTwinSearch, WindowOfNoAreaIsNotEntered) {
  const auto visits = [](const TestChain& first, const TestChain& second) {
    return view_of(TestCore({{}, {}, {}}, {{0, 1, first}, {1, 2, second}})).counts.visits;
  };
  EXPECT_EQ(visits(doorway(100, -20, 0, -20, 20), doorway(200, 0, 20, -20, 20)), 2U);
  EXPECT_EQ(visits(doorway(100, -20, 1, -20, 20), doorway(200, 0, 20, -20, 20)), 3U);
  EXPECT_EQ(visits(doorway(100, -20, 0, -20, 0), doorway(200, 0, 20, 0, 20)), 2U);
}

// J6: lines from a corner that is exactly behind a corner of the mask.
TEST(JonesTwinSearch, LinesFromACornerOnTheMask) {
  const auto pieces = [](const TestVector& line) {
    return view_of(TestCore({{}, {20, 20, 200, {line}}}, {{0, 1, doorway(100, -10, 10, -10, 10)}}))
        .counts.pieces;
  };
  EXPECT_EQ(pieces({true, 2, 40}), 0U) << "outside, touching in one point";
  EXPECT_EQ(pieces({true, 1, 40}), 0U);
  EXPECT_EQ(pieces({true, 1, -15}), 1U) << "on the boundary of the mask";
  EXPECT_EQ(pieces({true, 3, 100}), 1U) << "inside";
}

// J7: a row of doorways whose left sides lie on one ray through the eye.
TestCore grazing_doorways(std::int32_t count) {
  std::vector<TestChain> cells(static_cast<std::size_t>(count) + 1);
  std::vector<TestOpening> openings;
  for (std::int32_t i = 1; i <= count; ++i) {
    openings.push_back(
        {static_cast<std::size_t>(i) - 1, static_cast<std::size_t>(i), doorway(100 * i, i, 40, -20, 20)});
  }
  return {cells, openings};
}
TEST(JonesTwinSearch, GrazingDoorwaysKeepFourVertices) {
  const View view = view_of(grazing_doorways(36));
  EXPECT_EQ(view.status, Status::complete);
  EXPECT_EQ(view.counts.depth, 37);
  EXPECT_EQ(view.counts.mask_vertices, 4);
  EXPECT_EQ(view.counts.stack_words, 37 * 12);
}

// J16: the opening just come through is in the far cell's list as well.
TEST(JonesTwinSearch, NeverGoesBack) {
  const View view = view_of(TestCore({{}, {}}, {{0, 1, doorway(100, -20, 20, -20, 20)}}));
  EXPECT_EQ(view.counts.visits, 2U);
  EXPECT_EQ(view.counts.openings_tested, 1U) << "the entry itself is not tested";
}

// What lies behind an opening must be seen through it whole, wherever the opening leaves the visible bound.
TEST(JonesTwinSearch, OpeningLargerThanTheBoundShowsTheWholeWindow) {
  const TestChain cross{-300, 100, 200, {{true, 1, 600}}};  // across the whole window, above the middle
  const auto drawn = [&](const TestChain& ring) {
    const Drawing drawing = decode(view_of(TestCore({{}, cross}, {{0, 1, ring}})));
    return drawing.pieces.size() == 1 ? drawing.pieces[0] : ScreenSegment{};
  };
  const ScreenSegment whole{{0, 768}, {1023, 768}};
  EXPECT_EQ(drawn(doorway(10, -400, 400, -300, 300)), whole) << "all around";
  EXPECT_EQ(drawn(doorway(10, -9, 400, -300, 300)).b, whole.b) << "around three sides";
  const TestChain above{-400, 40, -50, {{false, 1, 800}, {false, 3, 300}, {false, 1, -800}, {false, 3, -300}}};
  EXPECT_EQ(drawn(above), whole) << "one above the eye, beginning behind it";
  const TestChain left{-40, -400, -50, {{false, 3, 300}, {false, 2, 800}, {false, 3, -300}, {false, 2, -800}}};
  TestOpening lower{1, 0, left};  // entered towards lower coordinates
  const Drawing drawing = decode(view_of(TestCore({{}, cross}, {lower})));
  ASSERT_EQ(drawing.pieces.size(), 1U);
  EXPECT_EQ(drawing.pieces[0], (ScreenSegment{{0, 768}, {430, 768}})) << "40/250 of 512 left of the centre";
}

TEST(JonesTwinStatus, StackOverflow) {
  const View view = view_of(grazing_doorways(39));
  EXPECT_EQ(view.status, Status::stack_overflow);
  EXPECT_EQ(view.counts.depth, 37) << "37 masks of 12 words fit 450";
  EXPECT_TRUE(decode(view).well_formed);
}

TEST(JonesTwinStatus, DisplayFileOverflowLeavesRoomForTheStop) {
  TestChain chain{0, 0, 100, {}};
  for (int i = 0; i < 600; ++i) {
    chain.vectors.push_back({true, 1, i % 2 ? -10 : 10});
    chain.vectors.push_back({false, 2, i % 2 ? -10 : 10});
  }
  const View view = view_of(TestCore({chain}, {}));
  EXPECT_EQ(view.status, Status::display_file_overflow);
  EXPECT_EQ(view.counts.pieces, 399U) << "four words each in 1598";
  EXPECT_EQ(view.display_file.size(), 1598U);
  EXPECT_TRUE(decode(view).well_formed);
}

TEST(JonesTwinStatus, TooManyMaskVertices) {
  // Stairs: `steps` steps up and to the right, then back along the outside.
  const auto status = [](int steps, bool split) {
    TestChain ring{-20, -20, 100, {{false, 1, 40}, {false, 2, 40}}};
    for (int i = 0; i < steps; ++i) {
      ring.vectors.push_back({false, 1, i + 1 < steps ? -2 : -40 + 2 * (steps - 1)});
      ring.vectors.push_back({false, 2, i + 1 < steps ? -2 : -40 + 2 * (steps - 1)});
    }
    if (split) {
      ring.vectors[0].magnitude = 20;
      ring.vectors.insert(ring.vectors.begin(), {false, 1, 20});
    }
    return view_of(TestCore({{}, {}}, {{0, 1, ring}})).status;
  };
  EXPECT_EQ(status(7, false), Status::complete) << "16 corners";
  EXPECT_EQ(status(7, true), Status::too_many_mask_vertices) << "17 corners";
  EXPECT_EQ(status(8, false), Status::too_many_mask_vertices) << "18 corners";
}

TEST(JonesTwinStatus, DeeperThanTheNumberOfCells) {
  TestCore core({{}, {}}, {{0, 1, doorway(100, -20, 20, -20, 20)}});
  core.put(TestCore::header + 1, 1);
  EXPECT_EQ(view_of(core).status, Status::deeper_than_cells);
}

TEST(JonesTwinStatus, BadDataElement) {
  EXPECT_EQ(view_of(TestCore({{0, 0, 100, {{false, 0, 10}}}}, {})).status, Status::bad_data_element);
  const auto ring_status = [](std::vector<TestVector> vectors) {
    return view_of(TestCore({{}, {}}, {{0, 1, {0, 0, 100, std::move(vectors)}}})).status;
  };
  EXPECT_EQ(ring_status({}), Status::bad_data_element);
  EXPECT_EQ(ring_status({{false, 1, 10}, {false, 1, -10}}), Status::bad_data_element);
  EXPECT_EQ(ring_status({{false, 1, 10}, {false, 0, 10}}), Status::bad_data_element);
  EXPECT_EQ(ring_status({{false, 1, 10}, {false, 2, 10}, {true, 0, -10}}), Status::bad_data_element);
}

TEST(JonesTwinStatus, ArithmeticOverflowCannotComeFromAScene) {
  // What is projected is inside the bound, so the farthest corner at the largest scale still divides.
  Parameters parameters;
  parameters.scale = 4096;
  const View view = view_of(
      TestCore(
          {{-16000,
            -16000,
            near_z,
            {{true, 1, 16383}, {true, 2, 16383}, {true, 3, 16383}, {true, 1, 16383}, {true, 3, -16383}}}},
          {}),
      parameters);
  EXPECT_EQ(view.status, Status::complete);
  EXPECT_LE(view.counts.largest_coordinate, 1 << 15);
}

TEST(JonesTwinStatus, GivesUpOnAListWithoutEnd) {
  TestCore core({{}}, {});
  core.put(TestCore::header + 11 + 4, 0);  // an entry that is not the last, and zeros all around core
  Parameters parameters;
  parameters.limit = 1000;
  EXPECT_NE(view_of(core, parameters).status, Status::complete);
}

TEST(JonesTwinStatus, AnyCoreEndsWithSomeStatus) {
  std::mt19937 engine(7);
  std::set<Status> seen;
  for (int i = 0; i < 2000; ++i) {
    TestCore core({{}}, {});
    for (std::uint32_t at = 0; at < core_words; ++at) core.put(at, static_cast<std::uint32_t>(engine()));
    core.put(TestCore::header, static_cast<std::uint32_t>(engine()));
    for (std::uint32_t at = 3; at < core_words; at += 4) core.put(at, engine() % 8);
    Parameters parameters;
    parameters.limit = 20000;
    const View view = run(core.words, static_cast<std::uint32_t>(engine()) & 017777, parameters);
    seen.insert(view.status);
    EXPECT_LE(view.display_file.size(), display_file_words);
    EXPECT_TRUE(decode(view).well_formed);
  }
  EXPECT_GT(seen.size(), 1U);
}

class JonesTwinScenes : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto loaded = scene::load_cell_scene(GetParam());
    ASSERT_TRUE(std::holds_alternative<scene::CellScene>(loaded));
    cells_ = std::get<scene::CellScene>(loaded).cells.size();
    const auto encoded = scene::encode(std::get<scene::CellScene>(loaded), {}, TestCore::header);
    ASSERT_TRUE(std::holds_alternative<scene::EncodedScene>(encoded));
    const auto& image = std::get<scene::EncodedScene>(encoded);
    limits_ = image.eye_limits;
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
    const View view = run(words_, TestCore::header, parameters);
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
// Fig. 5 of the paper: the kitchen is seen by its door, and by the dining room's door and the hatch.
TEST_P(JonesTwinHouse, SeesTheKitchenTwice) {
  const View view = run(words_, TestCore::header, default_parameters(words_, TestCore::header));
  EXPECT_EQ(view.counts.visits, 4U);
  EXPECT_EQ(view.counts.distinct_cells, 3U);
  EXPECT_EQ(view.counts.depth, 3);
}
INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesTwinHouse, testing::Values("house"));

}  // namespace
}  // namespace sightline::harness::jones
