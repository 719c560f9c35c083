// The errors of a drawing: cases computed by hand, and the same lengths as by sampling.
#include "host/compare/wrong_stretches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "tests/support/dice.hpp"

namespace sightline::compare {
namespace {

namespace oracle = algorithms::oracle;

constexpr geometry::Point eye{0, 0, 0};

// With S = 512 and z = 512 a unit is a point: the line y = 100 at that depth is row 612.
ImagePiece row_piece(double from, double to, std::int32_t y = 100, std::int32_t z = 512) {
  const double row = 512 + 512.0 * y / z;
  return {{0, {y, z}}, {from, row, to, row}};
}

WrongStretches wrong_of(const std::vector<ImagePiece>& truth, const std::vector<ImagePiece>& drawn) {
  return wrong_stretches(truth, drawn, 1, eye, {});
}

TEST(WrongStretches, APictureIsRightWithinTheDistance) {
  const std::vector<ImagePiece> truth{row_piece(600, 700)};
  EXPECT_EQ(wrong_of(truth, truth).length(), 0);
  ImagePiece beside = truth[0];
  beside.at.y0 += 0.9;
  beside.at.y1 += 0.9;
  EXPECT_EQ(wrong_of(truth, {beside}).length(), 0);
  beside.at.y0 += 0.2;
  beside.at.y1 += 0.2;
  EXPECT_NEAR(wrong_of(truth, {beside}).missing, 100, 1e-9);
  EXPECT_NEAR(wrong_of(truth, {beside}).extra, 100, 1e-9);
}

// A point beyond each end of a drawn piece is tolerated.
TEST(WrongStretches, AGapIsMissingExceptForAPointAtItsEnds) {
  const WrongStretches wrong = wrong_of({row_piece(600, 700)}, {row_piece(600, 620), row_piece(650, 700)});
  EXPECT_NEAR(wrong.true_length, 100, 1e-9);
  EXPECT_NEAR(wrong.missing, 28, 1e-9);
  EXPECT_EQ(wrong.extra, 0);
  ASSERT_EQ(wrong.stretches.size(), 1U);
  const ScreenStretch& stretch = wrong.stretches[0];
  EXPECT_FALSE(stretch.extra);
  EXPECT_EQ(stretch.line, (AxisLine{0, {100, 512}}));
  EXPECT_NEAR(std::min(stretch.at.x0, stretch.at.x1), 621, 1e-9);
  EXPECT_NEAR(std::max(stretch.at.x0, stretch.at.x1), 649, 1e-9);
  EXPECT_NEAR(stretch.at.y0, 612, 1e-9);
}

// The lines y = 100, z = 512 and y = 200, z = 1024 have the same image, and so have, from an eye at their height, a line parallel
// to x
// and one parallel to z.
TEST(WrongStretches, LinesWithTheSameImageCountOnce) {
  const std::vector<ImagePiece> truth{row_piece(600, 700), row_piece(650, 750, 200, 1024)};
  EXPECT_NEAR(wrong_of(truth, {}).true_length, 150, 1e-9);
  EXPECT_NEAR(wrong_of(truth, {}).missing, 150, 1e-9);
  EXPECT_NEAR(wrong_of({}, truth).extra, 150, 1e-9);
  const ImagePiece level = row_piece(600, 700, 0);
  const ImagePiece deep{{2, {300, 0}}, {620, 512, 800, 512}};
  EXPECT_NEAR(wrong_of({level, deep}, {}).true_length, 200, 1e-9);
  const ImagePiece column{{1, {0, 512}}, {512, 600, 512, 650}};
  const ImagePiece upright{{2, {0, 70}}, {512, 640, 512, 700}};
  EXPECT_NEAR(wrong_of({column, upright}, {}).true_length, 100, 1e-9);
}

TEST(WrongStretches, TheShortestAreOmitted) {
  EXPECT_EQ(wrong_of({row_piece(600, 601.2)}, {row_piece(600, 600)}).length(), 0);
  EXPECT_NEAR(wrong_of({row_piece(600, 601.3)}, {row_piece(600, 600)}).missing, 0.3, 1e-9);
}

// Sampled in steps of a 200th of a point: the oracle's measure of the picture enlarged 50 times.
TEST(WrongStretches, EqualThoseFoundBySampling) {
  constexpr double enlarged = 50;
  programs::jones::Dice dice(7);
  const auto place = [&dice] { return dice(0, 400) / 4.0; };
  for (int round = 0; round < 50; ++round) {
    // Rows, and lines along z, whose images start at the middle of the screen; no two have the same image.
    std::vector<ImagePiece> pieces;
    for (std::int32_t n = 0; n < 6; ++n) {
      const double a = place(), b = place();
      pieces.push_back(row_piece(512 + a, 512 + b, 8 * dice(0, 2) + n));
      const std::int32_t rise = 16 * dice(0, 2) + n + 1;
      const double c = place(), d = place();
      pieces.push_back({{2, {100, rise}}, {512 + c, 512 + c * rise / 100, 512 + d, 512 + d * rise / 100}});
    }
    const std::vector<ImagePiece> truth(pieces.begin(), pieces.begin() + 6);
    const std::vector<ImagePiece> drawn(pieces.begin() + 6, pieces.end());
    const auto sampled = [](const std::vector<ImagePiece>& of) {
      std::vector<oracle::ScreenSegment> segments;
      for (const ImagePiece& piece : of)
        segments.push_back(
            {piece.at.x0 * enlarged, piece.at.y0 * enlarged, piece.at.x1 * enlarged, piece.at.y1 * enlarged});
      return segments;
    };
    const oracle::DrawnError error = oracle::drawn_error(sampled(truth), sampled(drawn), enlarged);
    const WrongStretches wrong = wrong_of(truth, drawn);
    EXPECT_NEAR(wrong.true_length, error.true_length / enlarged, 1e-6) << "round " << round;
    // Omitted stretches are shorter than a quarter of a point.
    EXPECT_NEAR(wrong.missing, error.missing / enlarged, 1.5) << "round " << round;
    EXPECT_NEAR(wrong.extra, error.extra / enlarged, 1.5) << "round " << round;
  }
}

}  // namespace
}  // namespace sightline::compare
