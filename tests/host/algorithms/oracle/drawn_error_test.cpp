// The drawing metric on drawings whose error is known by construction.
#include "host/algorithms/oracle/drawn_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace sightline::algorithms::oracle {
namespace {

const std::vector<ScreenSegment> square{
    {0, 0, 100, 0}, {100, 0, 100, 100}, {100, 100, 0, 100}, {0, 100, 0, 0}};

TEST(DrawnError, OfTheSameDrawingInPiecesAndBackwardsIsZero) {
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
  EXPECT_NEAR(error.extra, 98 * 1.41421356, 1);  // minus the parts within 1 of a side at each corner
}

TEST(DrawnError, ForgivesAShiftUpToTheDistance) {
  std::vector<ScreenSegment> shifted = square;
  for (auto& s : shifted) s = {s.x0 + 0.7, s.y0 + 0.7, s.x1 + 0.7, s.y1 + 0.7};
  EXPECT_EQ(drawn_error(square, shifted, 1).missing, 0);
  EXPECT_GT(drawn_error(square, shifted, 0.5).missing, 390);
}

TEST(DrawnError, WithAnEmptyDrawingIsTheLengthOfTheOther) {
  EXPECT_DOUBLE_EQ(drawn_error(square, {}, 1).missing, 400);
  EXPECT_DOUBLE_EQ(drawn_error({}, square, 1).extra, 400);
  EXPECT_DOUBLE_EQ(drawn_error({}, {}, 1).true_length, 0);
}

TEST(DrawnError, APointHasNoLengthButCanBeNear) {
  const std::vector<ScreenSegment> point{{50, 50, 50, 50}};
  EXPECT_EQ(drawn_error(point, {}, 1).missing, 0);
  EXPECT_NEAR(drawn_error({{40, 50, 60, 50}}, point, 5).missing, 10, 0.5);
}

// The implementation finds stretches by bisection. Testing every step, as the header defines the metric, gives the same bits.
TEST(DrawnError, ByBisectionEqualsThatByEveryStep) {
  const auto near = [](double x, double y, const ScreenSegment& s, double distance) {
    const double dx = s.x1 - s.x0;
    const double dy = s.y1 - s.y0;
    const double squared = dx * dx + dy * dy;
    const double t = squared > 0 ? std::clamp(((x - s.x0) * dx + (y - s.y0) * dy) / squared, 0.0, 1.0) : 0.0;
    const double off_x = x - (s.x0 + t * dx);
    const double off_y = y - (s.y0 + t * dy);
    return off_x * off_x + off_y * off_y <= distance * distance;
  };
  const auto alone = [&](const std::vector<ScreenSegment>& lines, const std::vector<ScreenSegment>& others) {
    double total = 0;
    for (const ScreenSegment& s : lines) {
      const double length = std::hypot(s.x1 - s.x0, s.y1 - s.y0);
      const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(length / 0.25)));
      std::size_t count = 0;
      for (std::size_t n = 0; n < steps; ++n) {
        const double t = (static_cast<double>(n) + 0.5) / static_cast<double>(steps);
        const double x = s.x0 + t * (s.x1 - s.x0);
        const double y = s.y0 + t * (s.y1 - s.y0);
        count += std::none_of(others.begin(), others.end(),
                              [&](const ScreenSegment& other) { return near(x, y, other, 1.0); });
      }
      total += length * static_cast<double>(count) / static_cast<double>(steps);
    }
    return total;
  };
  std::mt19937 engine(1971);
  // Half-integer points, so that lines often run at exactly the distance from each other.
  const auto place = [&] { return static_cast<double>(engine() % 80) / 2; };
  const auto drawing = [&] {
    std::vector<ScreenSegment> lines;
    for (int i = 0; i < 12; ++i) {
      const double x = place();
      const double y = place();
      lines.push_back({x, y, i % 3 == 0 ? x : place(), i % 3 == 1 ? y : place()});
    }
    return lines;
  };
  for (int i = 0; i < 300; ++i) {
    const auto truth = drawing();
    const auto drawn = drawing();
    const DrawnError error = drawn_error(truth, drawn, 1.0);
    ASSERT_EQ(error.missing, alone(truth, drawn));
    ASSERT_EQ(error.extra, alone(drawn, truth));
  }
}

}  // namespace
}  // namespace sightline::algorithms::oracle
