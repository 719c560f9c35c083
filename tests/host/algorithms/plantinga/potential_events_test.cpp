// Potential events as exact directions: order and equality of directions that doubles cannot distinguish. hard_cases_test.cpp has
// the
// hard cases P1 to P19.
#include "host/algorithms/plantinga/potential_events.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace sightline::algorithms::plantinga {
namespace {

using Three = std::array<Segment, 3>;

TEST(PotentialEvents, TwoIrrationalRoots) {
  const Three p3{Segment{{0, -2, 1}, {0, 0, -2}}, Segment{{0, 1, 1}, {-1, -3, 2}},
                 Segment{{-3, 1, 0}, {2, -2, -2}}};
  std::vector<Direction> events = three_edge_events(p3);
  ASSERT_EQ(events.size(), 4U);
  sort_and_group(events);
  EXPECT_FALSE(events[0].rational);
  EXPECT_NEAR(std::tan(events[0].angle), -0.643692555, 1e-9);
  EXPECT_NEAR(std::tan(events[1].angle), -0.216772561, 1e-9);
  EXPECT_NEAR(events[2].angle - events[0].angle, std::numbers::pi, 1e-14);
}

TEST(PotentialEvents, EventsCloserThanDoublesCanTell) {
  const Segment axis{{0, -1, 0}, {0, 1, 0}};
  const auto first = vertex_edge_events({832040, 0, 1346269}, axis);  // P6
  const auto second = vertex_edge_events({1346269, 0, 2178309}, axis);
  ASSERT_EQ(first.size(), 2U);
  const auto front = [](const std::vector<Direction>& both) { return both[0].angle > 0 ? both[0] : both[1]; };
  // F30 F32 - F31 F31 = -1 = sin of the difference, up to positive factors.
  EXPECT_EQ(compare(front(first), front(second)), 832040LL * 2178309 - 1346269LL * 1346269 < 0 ? -1 : 1);
  EXPECT_EQ(compare(front(second), front(first)), -compare(front(first), front(second)));

  // Two more Fibonacci numbers of 50 bits, of which doubles give the same angle, and a quadratic between.
  const Int128 f72 = 498454011879264;
  const Int128 f73 = 806515533049393;
  const Int128 f74 = f72 + f73;
  const Direction a = rational_direction(f72, f73);
  const Direction b = rational_direction(f73, f74);
  EXPECT_EQ(a.angle, b.angle);
  EXPECT_NE(compare(a, b), 0);
  EXPECT_EQ(compare(a, b), -compare(b, a));
  // X^2 + X Z - Z^2 = 0 at the golden section, which lies between every two consecutive convergents.
  std::vector<Direction> golden = roots_of(QuadraticForm{1, 1, -1});
  const auto near = std::find_if(golden.begin(), golden.end(),
                                 [&](const Direction& d) { return std::abs(d.angle - a.angle) < 1e-9; });
  ASSERT_NE(near, golden.end());
  EXPECT_EQ(compare(a, *near), -compare(b, *near));
  EXPECT_EQ(compare(*near, *near), 0);
}

TEST(PotentialEvents, EqualEventsAreOne) {
  const Segment edge{{0, -1, 0}, {0, 1, 0}};
  std::vector<Direction> events = vertex_edge_events({10, 0, 20}, edge);  // P7
  const auto more = vertex_edge_events({20, 0, 40}, edge);
  events.insert(events.end(), more.begin(), more.end());
  sort_and_group(events);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1], rational_direction(1, 2));
  // A root of a form and of a multiple of that form, with either sign.
  EXPECT_EQ(roots_of(QuadraticForm{1, 1, -1}), roots_of(QuadraticForm{-6, -6, 6}));
}

// Two horizontal edges of one height and a third.
TEST(PotentialEvents, PermanentContactsAreNone) {
  EXPECT_TRUE(three_edge_events({Segment{{0, 3, 0}, {5, 3, 1}}, Segment{{-1, 3, 7}, {4, 3, 9}},
                                 Segment{{0, 0, 20}, {1, 9, 22}}})
                  .empty());
}

TEST(PotentialEvents, FormsWithoutRootsAreNone) {
  EXPECT_TRUE(roots_of(QuadraticForm{0, 0, 7}).empty());
  EXPECT_TRUE(roots_of(QuadraticForm{1, 0, 1}).empty());
}

TEST(PotentialEvents, FacesEdgeOn) {
  const auto events = face_edge_on_events({3, 0, 4});  // P15
  ASSERT_EQ(events.size(), 2U);
  EXPECT_TRUE(events[0] == rational_direction(4, -3) || events[1] == rational_direction(4, -3));
  EXPECT_TRUE(face_edge_on_events({0, 7, 0}).empty());  // P16
}

TEST(PotentialEvents, TheRangeEndsAtPi) {
  const auto events = vertex_edge_events({0, 0, 7}, {{0, -1, 0}, {0, 1, 0}});  // P19
  ASSERT_EQ(events.size(), 2U);
  std::vector<Direction> sorted = events;
  sort_and_group(sorted);
  EXPECT_EQ(sorted[0].angle, 0);
  EXPECT_EQ(sorted[1].angle, std::numbers::pi);
}

TEST(PotentialEvents, OrderIsTotalOverRandomAndDegenerateForms) {
  std::mt19937 random(18);
  std::uniform_int_distribution<int> small(-3, 3);
  std::vector<Direction> all;
  for (int i = 0; i < 400; ++i) {
    const auto quadratic = roots_of(QuadraticForm{small(random), small(random), small(random)});
    all.insert(all.end(), quadratic.begin(), quadratic.end());
    const auto linear = roots_of(LinearForm{small(random), small(random)});
    all.insert(all.end(), linear.begin(), linear.end());
  }
  sort_and_group(all);
  for (std::size_t i = 1; i < all.size(); ++i) {
    ASSERT_LT(compare(all[i - 1], all[i]), 0);
    const auto sight = sight_between(all[i - 1], all[i]);
    ASSERT_TRUE(sight);
    const Direction middle = rational_direction(sight->x, sight->z);
    EXPECT_LT(compare(all[i - 1], middle), 0);
    EXPECT_LT(compare(middle, all[i]), 0);
  }
  const auto round = sight_between(all.back(), all.front());
  ASSERT_TRUE(round);
  const Direction middle = rational_direction(round->x, round->z);
  EXPECT_TRUE(compare(all.back(), middle) < 0 || compare(middle, all.front()) < 0);
}

}  // namespace
}  // namespace sightline::algorithms::plantinga
