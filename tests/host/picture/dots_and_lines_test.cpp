// Dots and lines, computed by hand; rounding is part of the error.
#include "host/picture/dots_and_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sightline::picture {
namespace {

TEST(DotsAndLines, ACorrectRasterIsHalfADotAway) {
  // A horizontal line at 4.4: dots at 4, 0.4 away; the line is up to (0.5, 0.4) from a dot.
  PixelGrid dots(32, 16);
  for (int x = 2; x <= 12; ++x) dots.set(x, 4, 1);
  const DotsAndLines d = dots_and_lines(dots, {{{2, 4.4}, {12, 4.4}}});
  EXPECT_EQ(d.dots, 11U);
  EXPECT_EQ(d.dots_beyond_1, 0U);
  EXPECT_DOUBLE_EQ(d.length, 10);
  EXPECT_DOUBLE_EQ(d.length_beyond_1, 0);
  EXPECT_NEAR(d.hausdorff.greatest, std::hypot(0.5, 0.4), 0.1);
  EXPECT_GE(d.hausdorff.greatest, 0.4) << "not 0";
}

TEST(DotsAndLines, MissingAndExtra) {
  PixelGrid dots(32, 16);
  for (int x = 0; x <= 10; ++x) dots.set(x, 8, 1);
  dots.set(5, 11, 1);  // 3 away
  dots.set(5, 6, 1);   // 2 away, which is beyond 1 only
  // The line continues to 20: of 10 points, those from 11 on are beyond 1, from 12 on beyond 2.
  const DotsAndLines d = dots_and_lines(dots, {{{0, 8}, {20, 8}}});
  EXPECT_EQ(d.dots, 13U);
  EXPECT_EQ(d.dots_beyond_1, 2U);
  EXPECT_EQ(d.dots_beyond_2, 1U);
  EXPECT_NEAR(d.length_beyond_1, 9, 0.26);
  EXPECT_NEAR(d.length_beyond_2, 8, 0.26);
  EXPECT_DOUBLE_EQ(d.hausdorff.greatest, 10) << "the end of the line";
}

TEST(DotsAndLines, OneMovedDotIsFound) {
  PixelGrid dots(64, 64);
  for (int i = 0; i < 64; ++i) dots.set(i, i, 1);
  const std::vector<PixelSegment> lines{{{0, 0}, {63, 63}}};
  const DotsAndLines right = dots_and_lines(dots, lines);
  dots.set(30, 30, 0);
  dots.set(30, 33, 1);
  const DotsAndLines moved = dots_and_lines(dots, lines);
  EXPECT_EQ(right.dots_beyond_1, 0U);
  EXPECT_EQ(moved.dots_beyond_1, 1U);
  EXPECT_NEAR(moved.hausdorff.greatest, 3 / std::sqrt(2.0), 1e-9);
  EXPECT_LT(right.hausdorff.greatest, 0.8);
}

TEST(DotsAndLines, OfEmptyPictures) {
  const PixelGrid nothing(8, 8);
  const DotsAndLines lost = dots_and_lines(nothing, {{{1, 1}, {5, 1}}});
  EXPECT_DOUBLE_EQ(lost.length_beyond_2, 4);
  EXPECT_EQ(lost.hausdorff.greatest, std::numeric_limits<double>::infinity());
  PixelGrid dot(8, 8);
  dot.set(2, 2, 1);
  EXPECT_EQ(dots_and_lines(dot, {}).dots_beyond_2, 1U);
  EXPECT_EQ(dots_and_lines(nothing, {}).hausdorff.greatest, 0);
}

}  // namespace
}  // namespace sightline::picture
