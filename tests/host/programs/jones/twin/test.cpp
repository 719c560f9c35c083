// The twin's search and display file: cases computed by hand, among them the hard cases of the paper's method.
#include <gtest/gtest.h>

#include "host/programs/jones/twin/twin.hpp"
#include "tests/host/programs/jones/core.hpp"
#include "tests/host/programs/jones/drawing.hpp"

namespace sightline::programs::jones {
namespace {

std::vector<std::uint32_t> octal_words(const TwinView& view) {
  std::vector<std::uint32_t> words;
  for (const core::Word18 word : view.display_file) words.push_back(word.value());
  return words;
}

TEST(JonesTwinDisplayFile, OneLineIsFiveVectorsOfRoundedShares) {
  // x/z from -1/2 to 1/2: points 256 to 768 at height 512; 512 in five shares 102 103 102 103 102.
  const TwinView view = view_of(TestCore({{-50, 0, 100, {{true, 1, 100}}}}, {}));
  EXPECT_EQ(view.status, Status::complete);
  EXPECT_EQ(octal_words(view), (std::vector<std::uint32_t>{010117, 020000, 0221000, 0102400, 0200146, 0200147,
                                                           0200146, 0200147, 0600146, 003000}));
}

TEST(JonesTwinDisplayFile, AZeroComponentTakesTheSignOfItsWholeDifference) {
  // Down and to the left: dx = -51, dy = 0, then dy = -51, dx = 0.
  const TwinView view = view_of(TestCore({{10, 10, 100, {{true, 1, -10}, {true, 2, -10}}}}, {}));
  EXPECT_EQ(octal_words(view),
            (std::vector<std::uint32_t>{010117, 020000, 0221063, 0103063, 0200263, 0731400, 003000}));
}

TEST(JonesTwinDisplayFile, LinesAddedAtOnceAreNotJoined) {
  const TestCore core({{10, 10, 100, {{true, 1, -10}, {true, 2, -10}}}}, {});
  Parameters parameters;
  parameters.immediate = true;
  const TwinView view = view_of(core, parameters);
  EXPECT_EQ(octal_words(view), (std::vector<std::uint32_t>{010117, 020000, 0221063, 0103063, 0600263, 020000,
                                                           0221063, 0103000, 0731400, 003000}));
}

TEST(JonesTwinDisplayFile, StereoPairOfOneEyeIsTheSamePictureTwice) {
  // The header's box does not let the eye move: both eyes are at the origin.
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
  const TwinView view = view_of(TestCore({{}, {}}, {{0, 1, ring}}));
  EXPECT_EQ(view.status, Status::complete);
  EXPECT_EQ(view.counts.visits, 1U);
  EXPECT_EQ(view.counts.openings_tested, 1U);
  EXPECT_EQ(view.counts.openings_crossing, 0U);
  EXPECT_EQ(view.counts.lines_clipped, 4U);
  EXPECT_EQ(view.counts.pieces, 4U);
}

// J5: windows that share only a line, or only a corner.
TEST(JonesTwinSearch, AWindowWithoutAreaIsNotEntered) {
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
TEST(JonesTwinSearch, GrazingDoorwaysKeepFourVertices) {
  const TwinView view = view_of(grazing_doorways(36));
  EXPECT_EQ(view.status, Status::complete);
  EXPECT_EQ(view.counts.depth, 37);
  EXPECT_EQ(view.counts.mask_vertices, 4);
  EXPECT_EQ(view.counts.stack_words, 36 * 9);
}

// J16: the far cell's list also contains the opening just crossed.
TEST(JonesTwinSearch, NeverGoesBack) {
  const TwinView view = view_of(TestCore({{}, {}}, {{0, 1, doorway(100, -20, 20, -20, 20)}}));
  EXPECT_EQ(view.counts.visits, 2U);
  EXPECT_EQ(view.counts.openings_tested, 1U) << "the entry itself is not tested";
}

// The near plane is one unit away: a nearer opening is entered for any geometry behind it.
TEST(JonesTwinSearch, OpeningOneUnitFromTheEyeIsEntered) {
  const auto visits = [](std::int32_t z, std::size_t low, std::size_t high) {
    return view_of(TestCore({{}, {}}, {{low, high, doorway(z, -2, 2, -2, 2)}})).counts.visits;
  };
  EXPECT_EQ(visits(1, 0, 1), 2U);
  EXPECT_EQ(visits(0, 0, 1), 1U) << "in the eye's own plane";
  EXPECT_EQ(visits(-1, 1, 0), 1U) << "behind the eye";
  EXPECT_EQ(visits(100, 1, 0), 1U) << "only the eye's side of an opening leads through it";
}

TEST(JonesTwinSearch, LineOneUnitFromTheEyeIsDrawn) {
  const auto drawn = [](std::int32_t z) {
    return decode(view_of(TestCore({{0, 0, z, {{true, 1, 4}}}}, {}))).pieces;
  };
  ASSERT_EQ(drawn(1).size(), 1U);
  EXPECT_EQ(drawn(1)[0], (ScreenSegment{{512, 512}, {1023, 512}}));
  EXPECT_TRUE(drawn(0).empty()) << "in the eye's own plane";
}

// Lines of a ring are drawn by the walk that collects its corners, so those before a fault are on the screen.
TEST(JonesTwinSearch, RingIsDrawnUpToAFault) {
  const auto ring = [](std::uint32_t axis) {
    return TestChain{-20, -20, 100, {{true, 1, 40}, {true, 2, 40}, {true, axis, -40}, {true, 2, -40}}};
  };
  const TwinView whole = view_of(TestCore({{}, {}}, {{0, 1, ring(1)}}));
  EXPECT_EQ(whole.status, Status::complete);
  EXPECT_EQ(whole.counts.pieces, 4U);
  EXPECT_EQ(whole.counts.vectors, 4U) << "one walk";
  const TwinView broken = view_of(TestCore({{}, {}}, {{0, 1, ring(0)}}));
  EXPECT_EQ(broken.status, Status::bad_data_element);
  EXPECT_EQ(broken.counts.pieces, 2U);
  EXPECT_EQ(decode(broken).vectors.size(), decode(whole).vectors.size() / 2);
}

// The scene behind an opening must be visible through it completely, wherever the opening leaves the visible bound.
TEST(JonesTwinSearch, OpeningLargerThanTheBoundShowsTheWholeWindow) {
  const TestChain cross{-300, 100, 200, {{true, 1, 600}}};  // across the whole window, above the middle
  const auto drawn = [&](const TestChain& ring) {
    const Drawing drawing = decode(view_of(TestCore({{}, cross}, {{0, 1, ring}})));
    return drawing.pieces.size() == 1 ? drawing.pieces[0] : ScreenSegment{};
  };
  const ScreenSegment whole{{0, 768}, {1023, 768}};
  EXPECT_EQ(drawn(doorway(10, -400, 400, -300, 300)), whole) << "all around";
  EXPECT_EQ(drawn(doorway(10, -9, 400, -300, 300)).b, whole.b) << "around three sides";
  const TestChain above{
      -400, 40, -50, {{false, 1, 800}, {false, 3, 300}, {false, 1, -800}, {false, 3, -300}}};
  EXPECT_EQ(drawn(above), whole) << "one above the eye, beginning behind it";
  const TestChain left{
      -40, -400, -50, {{false, 3, 300}, {false, 2, 800}, {false, 3, -300}, {false, 2, -800}}};
  TestOpening lower{1, 0, left};  // entered towards lower coordinates
  const Drawing drawing = decode(view_of(TestCore({{}, cross}, {lower})));
  ASSERT_EQ(drawing.pieces.size(), 1U);
  EXPECT_EQ(drawing.pieces[0], (ScreenSegment{{0, 768}, {430, 768}})) << "40/250 of 512 left of the centre";
}

}  // namespace
}  // namespace sightline::programs::jones
