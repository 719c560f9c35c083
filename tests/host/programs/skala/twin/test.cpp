// The Skala program's twin compared with cases computed by hand from its specification: receipt, lines, masks, surfaces,
// contours.
#include <gtest/gtest.h>

#include <utility>

#include "host/programs/skala/twin/twin.hpp"
#include "tests/host/programs/skala/twin/support.hpp"

namespace sightline::programs::skala {
namespace {

using Rows = std::vector<std::string>;
using enum Command;

SkalaBytes picture() {
  return SkalaBytes().device(Device::ef9365).reset();
}

Rows window(const SkalaBytes& bytes, int x0, int y0, int x1, int y1) {
  const auto drawn = SkalaBytes(bytes).end().run();
  EXPECT_EQ(drawn.status, Status::complete);
  return skala_window(drawn.raster(Device::ef9365), x0, y0, x1, y1);
}

void expect_stop(const SkalaBytes& bytes, Status status, std::size_t taken) {
  const auto drawn = bytes.run();
  EXPECT_EQ(drawn.status, status) << text_of(drawn.status);
  EXPECT_EQ(drawn.bytes_taken, taken);
}

TEST(SkalaTwinReceipt, NamesTheByteThatStopsIt) {
  expect_stop(SkalaBytes(), Status::running, 0);
  expect_stop(SkalaBytes().end().byte(0xFF), Status::complete, 1);
  expect_stop(SkalaBytes().move(1, 2), Status::running, 3);
  expect_stop(SkalaBytes().move(1, 2).byte(0x0F), Status::unknown_command, 4);
  expect_stop(SkalaBytes().byte(0xFF).end(), Status::unknown_command, 1);
  expect_stop(SkalaBytes().byte(2).byte(9), Status::running, 2);
  expect_stop(SkalaBytes().send(Command::device, {4}).end(), Status::argument_out_of_range, 2);
  expect_stop(SkalaBytes().send(Command::device, {0xFC}).end(), Status::argument_out_of_range, 2);
  expect_stop(SkalaBytes().send(Command::device, {0x83}).end(), Status::complete, 3);
}

TEST(SkalaTwinReceipt, RejectsColumnsBeyondTheScreenAtTheCount) {
  expect_stop(SkalaBytes().send(curve, {1, 0}), Status::argument_out_of_range, 3);
  expect_stop(SkalaBytes().send(curve, {254, 3}), Status::argument_out_of_range, 3);
  expect_stop(SkalaBytes().send(curve, {254, 2, 7, 7}).end(), Status::complete, 6);
  expect_stop(SkalaBytes().send(gap, {200, 57}), Status::argument_out_of_range, 3);
  expect_stop(SkalaBytes().send(gap, {200, 56}).end(), Status::complete, 4);
  expect_stop(SkalaBytes().send(gap, {0, 0}).end(), Status::complete, 4);
}

TEST(SkalaTwinReceipt, CommandsBufferedBeforeAnErrorAreNotDrawn) {
  const auto drawn = SkalaBytes().move(9, 9).draw(20, 9).byte(0x77).run();
  EXPECT_EQ(lit_dots(drawn.raster(Device::ef9365)), 0U);
  EXPECT_EQ(drawn.counts.points_walked, 0U);
}

// 49,152 bytes of buffer: drawn when fewer than 800 of them are free after a command.
TEST(SkalaTwinReceipt, AFullBufferIsDrawn) {
  const auto lit_after = [](int filled) {
    SkalaBytes bytes;
    bytes.move(9, 9).draw(20, 9);
    for (int used = 6; used < filled; ++used) bytes.commit();
    return lit_dots(bytes.byte(0x77).run().raster(Device::ef9365));
  };
  EXPECT_EQ(lit_after(48'352), 0U);
  EXPECT_EQ(lit_after(48'353), 12U);
}

TEST(SkalaTwinReceipt, AMissingDeviceIsFoundWhenItIsDrawn) {
  const Equipment boards{{true, true, false, false}};
  const auto drawn =
      run_twin(SkalaBytes().move(3, 3).draw(5, 3).device(Device::calcomp).end().bytes(), boards);
  EXPECT_EQ(drawn.status, Status::device_missing);
  EXPECT_EQ(drawn.bytes_taken, 8U);
  EXPECT_EQ(lit_dots(drawn.raster(Device::ef9365)), 3U);
  const auto minigraf = run_twin(SkalaBytes().device(Device::minigraf).end().bytes(), boards);
  EXPECT_EQ(minigraf.status, Status::complete);
}

TEST(SkalaTwinLines, FirstPointIsDrawnOnceAndAPointCanStandAlone) {
  const auto drawn = picture().move(4, 4).draw(4, 4).draw(4, 4).end().run();
  EXPECT_EQ(drawn.counts.points_walked, 1U);
  EXPECT_EQ(drawn.raster(Device::ef9365).at(4, 4), 7);
  EXPECT_EQ(lit_dots(drawn.raster(Device::ef9365)), 1U);
}

// After RESET the pen is at (0, 0) and fresh; MOVE there changes nothing.
TEST(SkalaTwinLines, ResetMakesTheCornerFresh) {
  EXPECT_EQ(window(picture().draw(2, 0), 0, 0, 3, 0), (Rows{"777."}));
  EXPECT_EQ(window(picture().move(0, 0).draw(2, 0), 0, 0, 3, 0), (Rows{"777."}));
  EXPECT_EQ(window(picture().draw(0, 0).send(colour, {1}).move(0, 0).draw(2, 1), 0, 0, 2, 1),
            (Rows{".11", "7.."}));
}

// u = 4, v = 2: dots 1 and 3 are halfway between two rows. Seen from the left end they go to the farther row.
TEST(SkalaTwinLines, TiesAreTheSameInBothDirections) {
  const Rows rising{"...77", ".77..", "7...."};
  EXPECT_EQ(window(picture().move(10, 10).draw(14, 12), 10, 10, 14, 12), rising);
  EXPECT_EQ(window(picture().move(14, 12).draw(10, 10), 10, 10, 14, 12), rising);
  const Rows falling{"7....", ".77..", "...77"};
  EXPECT_EQ(window(picture().move(10, 12).draw(14, 10), 10, 10, 14, 12), falling);
  EXPECT_EQ(window(picture().move(14, 10).draw(10, 12), 10, 10, 14, 12), falling);
  const Rows steep{"..7", "..7", ".7.", ".7.", "7.."};
  EXPECT_EQ(window(picture().move(1, 1).draw(3, 5), 1, 1, 3, 5), steep);
  EXPECT_EQ(window(picture().move(3, 5).draw(1, 1), 1, 1, 3, 5), steep);
}

TEST(SkalaTwinLines, CurveIsDrawnFromColumnToColumn) {
  EXPECT_EQ(window(picture().send(curve, {3, 3, 1, 4, 4}), 3, 1, 5, 4), (Rows{".77", ".7.", "7..", "7.."}));
  EXPECT_EQ(window(picture().send(curve, {255, 1, 8}), 254, 7, 255, 8), (Rows{".7", ".."}));
}

TEST(SkalaTwinMasks, LinesBetweenTwoSlicesAreHidden) {
  auto bytes = picture().move(0, 2).draw(4, 2).commit().move(0, 5).draw(4, 5).commit().send(colour, {1});
  EXPECT_EQ(window(bytes.move(0, 7).draw(4, 3).commit(), 0, 1, 4, 7),
            (Rows{"1....", ".1...", "77777", ".....", ".....", "77777", "....."}));
}

// A steep run in its first column is tested against the masks before it: dots of a slice never hide each other.
TEST(SkalaTwinMasks, ASliceDoesNotHideItself) {
  EXPECT_EQ(window(picture().move(1, 1).draw(1, 4).draw(2, 4).draw(2, 1), 1, 1, 2, 4),
            (Rows{"77", "77", "77", "77"}));
}

TEST(SkalaTwinMasks, TheFirstDotOfAColumnIsVisibleAtBothEndsOfTheScreen) {
  const auto rows =
      window(picture().move(0, 0).draw(1, 0).commit().move(3, 255).draw(4, 255).commit(), 0, 0, 4, 255);
  EXPECT_EQ(rows.front(), "...77");
  EXPECT_EQ(rows.back(), "77...");
}

TEST(SkalaTwinMasks, MaskHidesWithoutInk) {
  EXPECT_EQ(window(picture().move(0, 3).mask(2, 3).commit().move(1, 3).draw(4, 3), 0, 3, 4, 3),
            (Rows{"...77"}));
}

// A dot of slack: the border row and the row inside it are visible; farther in it is hidden. It does not mask anything.
TEST(SkalaTwinMasks, TestDrawHasOneRowOfSlackAndLeavesNoTrace) {
  auto bytes = picture().move(0, 2).mask(0, 8).commit();
  EXPECT_EQ(window(bytes.move(0, 10).test(0, 0), 0, 0, 0, 10),
            (Rows{"7", "7", "7", "7", ".", ".", ".", "7", "7", "7", "7"}));
  auto corners = picture().move(0, 0).mask(0, 0).commit().move(1, 255).mask(1, 255).commit();
  const auto drawn = corners.move(0, 0).test(0, 0).move(1, 255).test(1, 255).end().run();
  EXPECT_EQ(lit_dots(drawn.raster(Device::ef9365)), 2U);
  const auto unvisited = picture().move(5, 5).test(5, 5).test(6, 5).end().run();
  EXPECT_EQ(unvisited.columns.mask_top[5], 0);
  EXPECT_EQ(unvisited.columns.mask_bottom[5], 255);
}

// A bar in rows 2 to 8 between a lower and a higher one: a dot of it is visible at the end of the adjacent bar, that is on its
// last row,
// not on an inner row.
TEST(SkalaTwinMasks, TestDrawIsVisibleNextToAShorterColumn) {
  const auto bars = [] {
    auto bytes = picture().move(10, 2).mask(10, 5).commit();
    return bytes.move(11, 2).mask(11, 8).commit().move(12, 4).mask(12, 9).commit();
  };
  EXPECT_EQ(window(bars().move(11, 10).test(11, 0), 11, 0, 11, 10),
            (Rows{"7", "7", "7", "7", "7", "7", "7", "7", "7", "7", "7"}));
  EXPECT_EQ(window(bars().move(12, 4).mask(12, 3).commit().move(11, 10).test(11, 0), 11, 0, 11, 10),
            (Rows{"7", "7", "7", "7", "7", "7", ".", "7", "7", "7", "7"}));
  EXPECT_EQ(window(bars().move(10, 9).mask(10, 9).commit().move(11, 10).test(11, 0), 11, 0, 11, 10),
            (Rows{"7", "7", "7", "7", ".", ".", "7", "7", "7", "7", "7"}));
}

// An adjacent column that was never visited, or that is beyond the border, makes nothing visible.
TEST(SkalaTwinMasks, TestDrawIsNotVisibleNextToColumnsWithoutAMask) {
  for (const int x : {0, 20, 255}) {
    auto bytes = picture().move(x, 2).mask(x, 8).commit();
    const auto drawn = bytes.move(x, 5).test(x, 6).end().run();
    EXPECT_EQ(lit_dots(drawn.raster(Device::ef9365)), 0U) << x;
  }
  // The columns at opposite borders are not adjacent.
  auto bytes = picture().move(0, 2).mask(0, 8).commit().move(255, 5).mask(255, 5).commit();
  EXPECT_EQ(lit_dots(bytes.move(0, 5).test(0, 6).end().run().raster(Device::ef9365)), 0U);
}

TEST(SkalaTwinMasks, WithoutVisibilityEverythingIsInkAndNothingIsMasked) {
  auto bytes = SkalaBytes().device(Device::ef9365, false).reset();
  const auto drawn = bytes.move(0, 5)
                         .draw(3, 5)
                         .commit()
                         .move(0, 5)
                         .mask(3, 5)
                         .move(0, 4)
                         .test(3, 4)
                         .mask(3, 9)
                         .draw(4, 9)
                         .end()
                         .run();
  EXPECT_EQ(skala_window(drawn.raster(Device::ef9365), 0, 4, 4, 9),
            (Rows{"...77", ".....", ".....", ".....", "7777.", "7777."}));
  EXPECT_EQ(drawn.columns.mask_top[3], 0);
  EXPECT_EQ(drawn.columns.mask_bottom[3], 255);
}

// Along the slice: L = 4, D = 5, g from -2. Levels 2 and 4 are next to each other: the level steps by two where the term allows
// it.
TEST(SkalaTwinSurface, LevelsChangeAlongTheSlice) {
  EXPECT_EQ(window(picture().surface({{0, 1, 1}, {4, 1, 6}}), 0, 1, 4, 1), (Rows{"12456"}));
  EXPECT_EQ(window(picture().surface({{0, 1, 0x0F}, {3, 1, 7}}), 0, 1, 3, 1), (Rows{"7777"}));
}

TEST(SkalaTwinSurface, LevelsChangeDownTheColumn) {
  // N = 5, D = 5: one level per row.
  auto bytes = picture().surface({{0, 1, 2}, {1, 1, 2}}).commit();
  EXPECT_EQ(window(bytes.surface({{0, 6, 7}, {1, 6, 7}}).commit(), 0, 1, 1, 6),
            (Rows{"77", "66", "55", "44", "33", "22"}));
  // N = 2, D = 5: g from -1, three levels in the first step.
  EXPECT_EQ(
      window(picture().surface({{0, 1, 2}, {0, 1, 2}}).commit().surface({{0, 3, 7}, {0, 3, 7}}), 0, 1, 0, 3),
      (Rows{"7", "4", "2"}));
  // Downwards, and with equal levels.
  EXPECT_EQ(
      window(picture().surface({{0, 5, 3}, {0, 5, 3}}).commit().surface({{0, 2, 3}, {0, 2, 3}}), 0, 2, 0, 5),
      (Rows{"3", "3", "3", "3"}));
}

// The third slice is hidden, but the fourth is filled towards it, up to the strip.
TEST(SkalaTwinSurface, AFillStopsAtTheStrip) {
  auto bytes = picture();
  for (const auto& [y, level] : {std::pair{1, 2}, {4, 5}, {2, 4}, {7, 6}})
    bytes.surface({{0, y, level}, {0, y, level}}).commit();
  EXPECT_EQ(window(bytes, 0, 1, 0, 7), (Rows{"6", "6", "5", "5", "4", "3", "2"}));
}

TEST(SkalaTwinSurface, FillsOnceInAColumnAndNeverFromARim) {
  auto flat = picture().surface({{0, 1, 1}, {1, 1, 1}}).commit();
  // The steep run enters column 0 at y = 3 and fills there; its other dots are only plotted.
  EXPECT_EQ(window(SkalaBytes(flat).surface({{0, 3, 4}, {0, 6, 4}}).commit(), 0, 1, 1, 6),
            (Rows{"4.", "4.", "4.", "4.", "2.", "11"}));
  const SkalaBytes rims = SkalaBytes(flat).move(0, 4).send(rim, {0, 4, 5}).send(rim, {1, 4, 5}).commit();
  EXPECT_EQ(window(rims, 0, 1, 1, 4), (Rows{"55", "..", "..", "11"}));
  EXPECT_EQ(window(SkalaBytes(rims).surface({{0, 6, 5}, {1, 6, 5}}), 0, 1, 1, 6),
            (Rows{"55", "55", "55", "..", "..", "11"}));
  // After the slice the pen is not fresh: the rim continues from there.
  EXPECT_EQ(window(SkalaBytes(flat).send(rim, {1, 3, 1}), 0, 1, 1, 3), (Rows{".1", ".1", "11"}));
}

TEST(SkalaTwinSurface, AGapIsNotFilled) {
  auto bytes = picture().surface({{0, 1, 2}, {2, 1, 2}}).commit().send(gap, {1, 1});
  EXPECT_EQ(window(bytes.surface({{0, 3, 2}, {2, 3, 2}}), 0, 1, 2, 3), (Rows{"222", "2.2", "222"}));
}

TEST(SkalaTwinSurface, TheColourOfLinesIsKept) {
  auto bytes = picture().send(colour, {3}).surface({{0, 1, 6}, {1, 1, 6}}).commit();
  EXPECT_EQ(window(bytes.draw(2, 1), 0, 1, 2, 1), (Rows{"663"}));
}

SkalaBytes margins(std::initializer_list<int> heights) {
  auto bytes = picture().send(silhouette, {0x0B}).move(4, 0);
  for (const int y : heights) bytes.move(4, y).mask(4, y).commit();
  return bytes;
}

TEST(SkalaTwinContours, TheSurfaceFoldsWhereItStaysInsideAfterARise) {
  EXPECT_EQ(window(margins({5, 9, 8}), 4, 5, 4, 9), (Rows{".", ".", ".", ".", "."}));
  EXPECT_EQ(window(margins({5, 9, 8, 7, 6}), 4, 5, 4, 9), (Rows{"3", ".", ".", ".", "."}));
  EXPECT_EQ(window(margins({9, 5}), 4, 5, 4, 9), (Rows{".", ".", ".", ".", "."}));
  EXPECT_EQ(window(margins({9, 5, 6}), 4, 5, 4, 9), (Rows{".", ".", ".", ".", "."}));
  EXPECT_EQ(window(margins({9, 5, 7}), 4, 5, 4, 9), (Rows{".", ".", ".", ".", "3"}));
}

TEST(SkalaTwinContours, SilhouettesAreOffByDefault) {
  auto bytes = picture();
  for (const int y : {5, 9, 6}) bytes.move(4, y).mask(4, y).commit();
  EXPECT_EQ(lit_dots(bytes.end().run().raster(Device::ef9365)), 0U);
}

// Along the top to the right, down the right side, back along the bottom and up the left side.
TEST(SkalaTwinContours, OutlineGoesAroundEachRunOfVisitedColumns) {
  auto bytes =
      picture().move(3, 2).mask(3, 5).mask(4, 5).mask(4, 2).commit().move(6, 7).mask(6, 7).send(colour, {2});
  EXPECT_EQ(window(bytes.send(outline), 3, 2, 6, 7), (Rows{"...2", "....", "22..", "22..", "22..", "22.."}));
}

}  // namespace
}  // namespace sightline::programs::skala
