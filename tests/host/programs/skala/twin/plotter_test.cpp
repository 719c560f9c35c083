// The Skala program's twin on plotters: every movement of the pen, computed by hand from the specification, and the laws of its
// path on
// random families.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tests/host/programs/skala/chain_stream.hpp"
#include "tests/host/programs/skala/family.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::skala {
namespace {

SkalaBytes picture(bool visibility = true) {
  return SkalaBytes().device(Device::calcomp, visibility).reset();
}

// "+" pen down, "-" pen up, a step as its direction on the number keys (6 right, 8 up, 9 both).
std::string path(const SkalaBytes& bytes) {
  std::string text;
  int x = 0;
  int y = 0;
  for (const PlotterMove& move : SkalaBytes(bytes).end().run().moves) {
    if (move.action == PlotterAction::pen_down) text += '+';
    if (move.action == PlotterAction::pen_up) text += '-';
    if (move.action == PlotterAction::step) text += static_cast<char>('5' + (move.x - x) + 3 * (move.y - y));
    x = move.x;
    y = move.y;
  }
  return text;
}

TEST(SkalaTwinPlotter, TravelsDiagonallyFirstAndLiftsAtTheEnd) {
  EXPECT_EQ(path(picture().move(2, 1).draw(4, 1)), "96+66-");
  EXPECT_EQ(path(picture().draw(2, 0)), "+66-");
  EXPECT_EQ(path(picture()), "");
}

TEST(SkalaTwinPlotter, ARunOfOnePointIsDropped) {
  EXPECT_EQ(path(picture().move(2, 1).draw(2, 1).move(3, 3).draw(3, 3)), "");
  const auto drawn = picture().move(2, 1).draw(2, 1).end().run();
  EXPECT_EQ(drawn.counts.points_plotted, 1U);
  EXPECT_TRUE(drawn.moves.empty());
}

TEST(SkalaTwinPlotter, ARunThatStartsWhereTheLastEndedNeedsNoLift) {
  EXPECT_EQ(path(picture().draw(2, 0).commit().draw(2, 2)), "+6688-");
  // Away and back: the run has ended, but the pen has not moved.
  EXPECT_EQ(path(picture(false).draw(2, 0).move(9, 9).move(2, 0).draw(2, 1)), "+668-");
  EXPECT_EQ(path(picture(false).draw(1, 0).move(3, 0).draw(4, 0)), "+6-66+6-");
}

// The dot at x = 2 is hidden by an earlier mark; the line is drawn in two runs.
TEST(SkalaTwinPlotter, HiddenPointsEndARun) {
  auto bytes = picture().move(2, 0).mask(2, 5).commit().move(0, 2).draw(4, 2);
  EXPECT_EQ(path(bytes), "88+6-66+6-");
}

// Rows 0..5 hide; row 5 is their border. A pen that is drawing continues along it; a pen that is not drawing does not start.
TEST(SkalaTwinPlotter, OnTheBorderAPenContinuesButDoesNotStart) {
  auto strip = picture();
  for (int x = 0; x < 6; ++x) strip.move(x, 2).mask(x, 5).commit();
  EXPECT_EQ(path(SkalaBytes(strip).move(0, 6).draw(1, 6).draw(2, 5).draw(4, 5)), "888888+6366-");
  EXPECT_EQ(path(SkalaBytes(strip).move(0, 5).draw(4, 5)), "");
  EXPECT_EQ(path(SkalaBytes(strip).move(0, 1).draw(1, 1).draw(2, 2).draw(4, 2)), "8+6966-");
  EXPECT_EQ(path(SkalaBytes(strip).move(0, 6).draw(1, 6).draw(2, 5).draw(3, 4).draw(4, 5)), "888888+63-");
  // The first point may only be remembered, and the border still continues it.
  EXPECT_EQ(path(SkalaBytes(strip).move(0, 6).draw(1, 5)), "888888+3-");
}

TEST(SkalaTwinPlotter, ResetLiftsThePenAndKeepsItsPosition) {
  EXPECT_EQ(path(picture().draw(2, 0).reset().draw(1, 0)), "+66-44+6-");
}

TEST(SkalaTwinPlotter, SurfacesAreLinesAndSilhouettesAreOmitted) {
  auto bytes = picture().send(Command::silhouette, {3}).surface({{0, 0, 1}, {2, 0, 1}}).commit();
  EXPECT_EQ(path(bytes.surface({{2, 3, 1}, {0, 3, 1}}).commit()), "+66-888+44-");
}

TEST(SkalaTwinPlotter, MaskedStepsEndARunAndTheirLastIsInkedByTheNext) {
  EXPECT_EQ(path(picture().draw(1, 0).mask(2, 0).draw(4, 0)), "+6-6+66-");
}

using Dots = std::set<std::pair<int, int>>;

// The points visited while the pen was down.
Dots covered_dots(const TwinPicture& drawn) {
  Dots dots;
  for (const PlotterMove& move : drawn.moves)
    if (move.pen_down) dots.emplace(move.x, move.y);
  return dots;
}

Dots lit(const core::Raster& raster) {
  Dots dots;
  for (int x = 0; x < 256; ++x)
    for (int y = 0; y < 256; ++y)
      if (raster.at(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)) != 0) dots.emplace(x, y);
  return dots;
}

TwinPicture drawn_on(Device device, bool visibility, const std::vector<Chain>& chains) {
  SkalaBytes bytes;
  bytes.device(device, visibility).reset();
  ChainSender sender(bytes);
  for (const Chain& chain : chains) sender.send(chain);
  return bytes.end().run();
}

void expect_possible(const TwinPicture& drawn) {
  PlotterMove before;
  std::uint64_t lifts = 0;
  for (const PlotterMove& move : drawn.moves) {
    const int dx = move.x - before.x;
    const int dy = move.y - before.y;
    if (move.action == PlotterAction::step) {
      ASSERT_EQ(std::max(std::abs(dx), std::abs(dy)), 1);
      ASSERT_EQ(move.pen_down, before.pen_down);
    } else {
      ASSERT_EQ(std::pair(dx, dy), std::pair(0, 0));
      ASSERT_NE(move.pen_down, before.pen_down);
      ASSERT_EQ(move.pen_down, move.action == PlotterAction::pen_down);
      lifts += move.pen_down ? 0 : 1;
    }
    before = move;
  }
  EXPECT_FALSE(before.pen_down);
  EXPECT_EQ(drawn.counts.pen_lifts, lifts);
}

// Without chains of a single dot, which a plotter drops.
std::vector<Chain> drawable(const std::vector<Chain>& chains) {
  std::vector<Chain> kept;
  for (const Chain& chain : chains) {
    const auto& first = chain.vertices.front();
    if (std::any_of(chain.vertices.begin(), chain.vertices.end(),
                    [&](const ChainVertex& vertex) { return vertex.x != first.x || vertex.y != first.y; }))
      kept.push_back(chain);
  }
  return kept;
}

TEST(SkalaTwinPlotter, ThePathIsPossibleAndCoversThePicture) {
  NEEDS_OPTIMISED_CODE();
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const int kind = static_cast<int>(seed) % SliceFamily::kinds;
    const auto chains = drawable(SliceFamily(seed, kind).chains(SegmentRole::draw, SegmentRole::draw));
    const auto plotted = drawn_on(Device::minigraf, true, chains);
    expect_possible(plotted);
    for (const auto& [x, y] : covered_dots(plotted)) {
      ASSERT_LE(y, plotted.columns.mask_top[static_cast<std::size_t>(x)]);
      ASSERT_GE(y, plotted.columns.mask_bottom[static_cast<std::size_t>(x)]);
    }
    const auto all = drawn_on(Device::calcomp, false, chains);
    expect_possible(all);
    const auto everything = drawn_on(Device::ef9365, false, chains);
    ASSERT_EQ(covered_dots(all), lit(everything.raster(Device::ef9365)));
  }
}

}  // namespace
}  // namespace sightline::programs::skala
