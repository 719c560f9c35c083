// The drawing metric on drawings whose error is known by construction.
#include "host/algorithms/oracle/drawn_error.hpp"

#include <gtest/gtest.h>

namespace sightline::algorithms::oracle {
namespace {

const std::vector<ScreenSegment> square{
    {0, 0, 100, 0}, {100, 0, 100, 100}, {100, 100, 0, 100}, {0, 100, 0, 0}};

TEST(DrawnError, OfTheSameDrawingInPiecesAndBackwardsIsNothing) {
  const std::vector<ScreenSegment> pieces{{40, 0, 0, 0},      {40, 0, 100, 0}, {100, 100, 100, 0},
                                          {0, 100, 100, 100}, {0, 100, 0, 0},  {20, 0, 60, 0}};
  const DrawnError error = drawn_error(square, pieces, 0.01);
  EXPECT_DOUBLE_EQ(error.true_length, 400);
  EXPECT_DOUBLE_EQ(error.drawn_length, 440);
  EXPECT_EQ(error.missing, 0);
  EXPECT_EQ(error.extra, 0);
}

TEST(DrawnError, CountsAMissingSideWithoutItsEnds) {
  const std::vector<ScreenSegment> three(square.begin(), square.end() - 1);
  const DrawnError error = drawn_error(square, three, 1);
  EXPECT_NEAR(error.missing, 98, 0.5);
  EXPECT_EQ(error.extra, 0);
}

TEST(DrawnError, CountsAnExtraDiagonal) {
  std::vector<ScreenSegment> five = square;
  five.push_back({0, 0, 100, 100});
  const DrawnError error = drawn_error(square, five, 1);
  EXPECT_EQ(error.missing, 0);
  EXPECT_NEAR(error.extra, 98 * 1.41421356, 1);  // less what is within 1 of a side at each corner
}

TEST(DrawnError, ForgivesAShiftUpToTheDistance) {
  std::vector<ScreenSegment> shifted = square;
  for (auto& s : shifted) s = {s.x0 + 0.7, s.y0 + 0.7, s.x1 + 0.7, s.y1 + 0.7};
  EXPECT_EQ(drawn_error(square, shifted, 1).missing, 0);
  EXPECT_GT(drawn_error(square, shifted, 0.5).missing, 390);
}

TEST(DrawnError, WithAnEmptySideIsAllOfTheOther) {
  EXPECT_DOUBLE_EQ(drawn_error(square, {}, 1).missing, 400);
  EXPECT_DOUBLE_EQ(drawn_error({}, square, 1).extra, 400);
  EXPECT_DOUBLE_EQ(drawn_error({}, {}, 1).true_length, 0);
}

TEST(DrawnError, APointHasNoLengthButCanBeNear) {
  const std::vector<ScreenSegment> point{{50, 50, 50, 50}};
  EXPECT_EQ(drawn_error(point, {}, 1).missing, 0);
  EXPECT_NEAR(drawn_error({{40, 50, 60, 50}}, point, 5).missing, 10, 0.5);
}

}  // namespace
}  // namespace sightline::algorithms::oracle
