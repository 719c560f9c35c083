// Laws and hand-computed cases of the twin's arithmetic. Expectations are the laws of a routine (clipping removes exactly what is
// outside),
// or numbers computed by hand, never its own output.
#include "host/programs/jones/twin/arithmetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/support/dice.hpp"

namespace sightline::programs::jones {
namespace {

TEST(JonesMuldiv, RoundsTheQuotientHalfUp) {
  EXPECT_EQ(muldiv(7, 1, 2), 4);
  EXPECT_EQ(muldiv(5, 1, 4), 1);
  EXPECT_EQ(muldiv(0, 131071, 3), 0);
  EXPECT_EQ(muldiv(131071, 131071, 131071), 131071);
}

TEST(JonesMuldiv, IsTheNearestInteger) {
  Dice dice(1);
  for (int i = 0; i < 200000; ++i) {
    const std::int64_t a = dice(0, 0777777), b = dice(0, 0777777), c = dice(1, i % 2 ? 0777777 : 0777);
    const auto q =
        muldiv(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), static_cast<std::int32_t>(c));
    if (!q) {
      EXPECT_GE(2 * a * b + c, c << 19) << a << ' ' << b << ' ' << c;
    } else {
      const std::int64_t error = 2 * (a * b - *q * c);
      EXPECT_LE(error, c);
      EXPECT_GE(error, -c);
      EXPECT_LE(*q, 0777777);
    }
  }
}

TEST(JonesMuldiv, OverflowsLikeTheDivider) {
  EXPECT_EQ(muldiv(0777777, 1, 1), 0777777);
  EXPECT_EQ(muldiv(0400000, 2, 1), std::nullopt);
  EXPECT_EQ(muldiv(0777777, 0777777, 0777777), 0777777);
}

// Differences of coordinates must fit into a word of 18 bits: with two or three fraction bits the bound at large scales is that
// of a field
// of 90 degrees, which is then outside the window.
TEST(JonesWindow, BoundLiesOutsideTheWindowAndKeepsDifferencesInAWord) {
  for (int bits = 0; bits <= 3; ++bits) {
    for (const Pass pass : {Pass::mono, Pass::left, Pass::right}) {
      for (std::int32_t scale = 64; scale <= 4096; ++scale) {
        const Window window = window_of(pass, scale, bits);
        const std::int32_t limit = window.bound_factor * window.width_scale;
        ASSERT_GE(limit, 1024 << bits) << scale;
        ASSERT_LE(limit, 1 << 15) << scale;
        ASSERT_GE(window.bound_factor, bits < 2 ? 4 : 1) << scale;
        ASSERT_LE(window.bound_factor, 32) << scale;
      }
    }
  }
}

TEST(JonesWindow, HalvesOfAStereoPairMeetAtTheMiddleOfTheScreen) {
  for (int bits = 0; bits <= 3; ++bits) {
    const std::int32_t unit = 1 << bits;
    const auto point = [&](std::int32_t coordinate) { return (coordinate + unit / 2) >> bits; };
    const Window left = window_of(Pass::left, 513, bits);
    const Window right = window_of(Pass::right, 513, bits);
    EXPECT_EQ(left.width_scale, unit * 256);
    EXPECT_EQ(point(left.xlo) + left.centre_x, 0);
    EXPECT_EQ(point(left.xhi) + left.centre_x, 511);
    EXPECT_EQ(point(right.xlo) + right.centre_x, 512);
    EXPECT_EQ(point(right.xhi) + right.centre_x, 1023);
  }
}

TEST(JonesSeg3, KeepsExactlyThePartInsideTheBound) {
  Dice dice(2);
  for (int i = 0; i < 20000; ++i) {
    const Axis axis{static_cast<std::uint8_t>(1 + i % 3)};
    SpaceSegment vector;
    vector.p = vector.q = {dice(-300, 300), dice(-300, 300), dice(-50, 150)};
    auto& moved = axis == Axis::x ? vector.q.x : axis == Axis::y ? vector.q.y : vector.q.z;
    moved += dice(-300, 300);
    const int factor = 4 << (i % 2);
    const auto part = seg3(vector, axis, factor);
    const auto at = [&](const SpacePoint& p) { return axis == Axis::x ? p.x : axis == Axis::y ? p.y : p.z; };
    // Walk along the vector unit by unit: inside means not in front of the near plane and within K z.
    int inside = 0;
    for (std::int32_t c = std::min(at(vector.p), at(vector.q)); c <= std::max(at(vector.p), at(vector.q));
         ++c) {
      SpacePoint p = vector.p;
      (axis == Axis::x ? p.x : axis == Axis::y ? p.y : p.z) = c;
      inside += p.z >= 1 && std::abs(p.x) <= factor * p.z && std::abs(p.y) <= factor * p.z;
    }
    EXPECT_EQ(part ? std::abs(at(part->q) - at(part->p)) + 1 : 0, inside > 1 ? inside : 0);
    if (part) {
      EXPECT_EQ(at(part->q) > at(part->p), at(vector.q) > at(vector.p));
    }
  }
}

// The near plane is one unit away: points in the eye's own plane, or behind it, are invisible.
TEST(JonesSeg3, BeginsOneUnitFromTheEye) {
  const auto across = [](std::int32_t z) { return seg3({{-3, 0, z}, {3, 0, z}}, Axis::x, 4); };
  EXPECT_EQ(across(0), std::nullopt);
  EXPECT_EQ(across(1), (SpaceSegment{{-3, 0, 1}, {3, 0, 1}}));
  EXPECT_EQ(seg3({{9, 0, 1}, {-9, 0, 1}}, Axis::x, 4), (SpaceSegment{{4, 0, 1}, {-4, 0, 1}}));
  const auto along = [](std::int32_t x) { return seg3({{x, 0, -5}, {x, 0, 20}}, Axis::z, 4); };
  EXPECT_EQ(along(0), (SpaceSegment{{0, 0, 1}, {0, 0, 20}}));
  EXPECT_EQ(along(4), (SpaceSegment{{4, 0, 1}, {4, 0, 20}}));
  EXPECT_EQ(along(-5), (SpaceSegment{{-5, 0, 2}, {-5, 0, 20}}));
  EXPECT_EQ(seg3({{0, 0, -5}, {0, 0, 1}}, Axis::z, 4), std::nullopt) << "one point";
}

TEST(JonesProject, IsThePerspectiveToTheNearestHalfPoint) {
  Dice dice(3);
  Operations operations;
  for (int i = 0; i < 50000; ++i) {
    const SpacePoint p{dice(-4000, 4000), dice(-4000, 4000), dice(1000, 9000)};
    const std::int32_t scale = 2 * dice(64, 4096);
    const auto projected = project(p, scale, operations);
    ASSERT_TRUE(projected);
    EXPECT_LE(std::abs(2 * (std::int64_t{projected->x} * p.z - std::int64_t{p.x} * scale)), p.z);
    EXPECT_LE(std::abs(2 * (std::int64_t{projected->y} * p.z - std::int64_t{p.y} * scale)), p.z);
    const auto mirrored = project({-p.x, -p.y, p.z}, scale, operations);
    EXPECT_EQ(mirrored, (ScreenPoint{-projected->x, -projected->y}));
  }
  EXPECT_EQ(operations.projection.muldivs, 4U * 50000U);
}

// J12: so far outside the bound that the quotient overflows the word.
TEST(JonesProject, ReportsDivideOverflow) {
  Operations operations;
  EXPECT_EQ(project({131071, 0, 8}, 8192, operations), std::nullopt);
  EXPECT_EQ(project({0, -131071, 8}, 8192, operations), std::nullopt);
  EXPECT_EQ(project({4, -4, 1}, 8192, operations), (ScreenPoint{32768, -32768})) << "the corner of the bound";
}

}  // namespace
}  // namespace sightline::programs::jones
