// Potential events as exact directions: the hard cases P1 to P19 with their exact inputs, order and equality
// of directions that doubles cannot tell apart.
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
using Coefficients = std::array<int, 3>;

QuadraticForm form_of_three(const Three& edges) {
  return meeting_form(crossing_of(edges[0], edges[1]), crossing_of(edges[0], edges[2]));
}

// Equal but for the sign of the whole, which says nothing.
void expect_form(const Three& edges, const Coefficients& expected) {
  const QuadraticForm form = form_of_three(edges);
  const int sign = (form.xx != 0 ? form.xx : form.xz != 0 ? form.xz : form.zz) < 0 ? -1 : 1;
  const auto first = std::find_if(expected.begin(), expected.end(), [](int n) { return n != 0; });
  const int wanted = first != expected.end() && *first < 0 ? -1 : 1;
  EXPECT_TRUE(form.xx * sign == expected[0] * wanted && form.xz * sign == expected[1] * wanted &&
              form.zz * sign == expected[2] * wanted)
      << static_cast<long>(form.xx) << ' ' << static_cast<long>(form.xz) << ' ' << static_cast<long>(form.zz);
}

Three scaled(Three edges, std::int64_t by) {
  for (Segment& edge : edges) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      edge.from[axis] *= by;
      edge.to[axis] *= by;
    }
  }
  return edges;
}

const Three p1{Segment{{-1, 1, -1}, {3, -3, 1}}, Segment{{1, 2, 1}, {-1, -2, 1}},
               Segment{{0, -4, 3}, {0, 4, -2}}};
const Three p1b{Segment{{3, -4, -2}, {-2, 4, 4}}, Segment{{-1, 2, 2}, {3, -4, 1}},
                Segment{{1, 2, 0}, {1, -2, -2}}};
const Three p1c{Segment{{2, 0, 2}, {0, 2, -2}}, Segment{{2, 2, 2}, {1, -1, -2}},
                Segment{{0, -3, 3}, {2, 2, -3}}};
const Three p1d{Segment{{-3, -2, 3}, {3, 1, -2}}, Segment{{1, 2, -3}, {1, -1, 3}},
                Segment{{-1, -2, 2}, {3, 1, 2}}};

TEST(PotentialEvents, DoubleRootsAreNone) {
  expect_form(p1, {-88, 0, 0});
  expect_form(p1b, {-256, -128, -16});
  expect_form(p1c, {-196, 56, -4});
  expect_form(p1d, {-81, 108, -36});
  for (const Three& edges : {p1, p1b, p1c, p1d}) {
    EXPECT_TRUE(roots_of(form_of_three(edges)).empty());
    EXPECT_TRUE(three_edge_events(edges).empty());
  }
}

TEST(PotentialEvents, NearlyDoubleRootsAreDecidedExactly) {
  Three apart = scaled(p1, 1000000);
  apart[0].from[0] += 1;
  const std::vector<Direction> two = three_edge_events(apart);
  ASSERT_EQ(two.size(), 4U);
  std::vector<Direction> sorted = two;
  sort_and_group(sorted);
  ASSERT_EQ(sorted.size(), 4U);
  // Two near 0 and two near pi, which lie on either side of the end of the range.
  EXPECT_NEAR(sorted[2].angle - sorted[1].angle, 1.5e-3, 5e-5);
  EXPECT_LT(sorted[1].angle, 0);
  EXPECT_GT(sorted[2].angle, 0);
  Three none = scaled(p1, 1000000);
  none[0].from[0] -= 1;
  EXPECT_TRUE(three_edge_events(none).empty());

  Three other = scaled(p1b, 1000000);
  other[0].from[0] -= 1;
  EXPECT_EQ(three_edge_events(other).size(), 4U);
  other[0].from[0] += 2;
  EXPECT_TRUE(three_edge_events(other).empty());
}

TEST(PotentialEvents, TwoIrrationalRoots) {
  const Three p3{Segment{{0, -2, 1}, {0, 0, -2}}, Segment{{0, 1, 1}, {-1, -3, 2}},
                 Segment{{-3, 1, 0}, {2, -2, -2}}};
  expect_form(p3, {129, 111, 18});
  std::vector<Direction> events = three_edge_events(p3);
  ASSERT_EQ(events.size(), 4U);
  sort_and_group(events);
  EXPECT_FALSE(events[0].rational);
  EXPECT_NEAR(std::tan(events[0].angle), -0.643692555, 1e-9);
  EXPECT_NEAR(std::tan(events[1].angle), -0.216772561, 1e-9);
  EXPECT_NEAR(events[2].angle - events[0].angle, std::numbers::pi, 1e-14);
}

TEST(PotentialEvents, RightAnglesAreOrdinary) {
  const Three p4{Segment{{1, 1, 3}, {3, 0, -2}}, Segment{{3, 3, 0}, {3, -1, 0}},
                 Segment{{3, 1, 0}, {-3, -2, 0}}};
  expect_form(p4, {0, -72, -48});
  std::vector<Direction> roots = roots_of(form_of_three(p4));
  sort_and_group(roots);
  ASSERT_EQ(roots.size(), 4U);
  EXPECT_TRUE(std::find(roots.begin(), roots.end(), rational_direction(1, 0)) != roots.end());
  EXPECT_TRUE(std::find(roots.begin(), roots.end(), rational_direction(-1, 0)) != roots.end());
  EXPECT_TRUE(std::find(roots.begin(), roots.end(), rational_direction(-2, 3)) != roots.end());

  const auto ev = vertex_edge_events({5, 0, 7}, {{0, -1, 7}, {0, 1, 7}});  // P5
  ASSERT_EQ(ev.size(), 2U);
  EXPECT_TRUE((ev[0] == rational_direction(1, 0)) != (ev[1] == rational_direction(1, 0)));
  EXPECT_DOUBLE_EQ(std::abs(ev[0].angle), std::numbers::pi / 2);
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
  // X^2 + X Z - Z^2 = 0 at the golden section, which lies between all neighbours.
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
  // A root of a form and of twice that form, whichever way it is turned.
  EXPECT_EQ(roots_of(QuadraticForm{1, 1, -1}), roots_of(QuadraticForm{-6, -6, 6}));
}

TEST(PotentialEvents, PermanentContactsAreNone) {
  EXPECT_TRUE(vertex_edge_events({0, 3, 5}, {{-1, 3, 0}, {1, 3, 0}}).empty());  // P8
  // P9: two horizontal edges of one height and a third.
  EXPECT_TRUE(three_edge_events({Segment{{0, 3, 0}, {5, 3, 1}}, Segment{{-1, 3, 7}, {4, 3, 9}},
                                 Segment{{0, 0, 20}, {1, 9, 22}}})
                  .empty());
  // P10: two vertical edges: every vertex of one against the other in the same direction.
  std::vector<Direction> whole = vertex_edge_events({4, 0, 9}, {{1, 0, 3}, {1, 5, 3}});
  const auto top = vertex_edge_events({4, 5, 9}, {{1, 0, 3}, {1, 5, 3}});
  EXPECT_EQ(whole, top);
  EXPECT_EQ(whole[0].angle > 0 ? whole[0] : whole[1], rational_direction(1, 2));
  // P11, P12: a vertex on the axis, an edge on the axis.
  EXPECT_EQ(vertex_edge_events({0, 0, 0}, {{3, -1, 4}, {3, 1, 4}}).size(), 2U);
  EXPECT_EQ(vertex_edge_events({3, 0, 4}, {{0, -1, 0}, {0, 1, 0}}).size(), 2U);
}

TEST(PotentialEvents, FormsThatVanishAreNone) {
  const Segment first{{0, 0, 0}, {1, 2, 3}};  // P13
  EXPECT_TRUE(roots_of(form_of_three({first, Segment{{0, 0, 0}, {3, -1, 2}}, Segment{{0, 0, 0}, {-2, 2, 1}}}))
                  .empty());
  EXPECT_TRUE(
      roots_of(form_of_three({first, Segment{{5, 1, 0}, {6, 3, 3}}, Segment{{0, 4, 2}, {1, 6, 5}}})).empty());
  EXPECT_TRUE(roots_of(QuadraticForm{0, 0, 7}).empty());  // P14
  EXPECT_TRUE(roots_of(QuadraticForm{1, 0, 1}).empty());
}

TEST(PotentialEvents, FacesEdgeOn) {
  const auto events = face_edge_on_events({3, 0, 4});  // P15
  ASSERT_EQ(events.size(), 2U);
  EXPECT_TRUE(events[0] == rational_direction(4, -3) || events[1] == rational_direction(4, -3));
  EXPECT_TRUE(face_edge_on_events({0, 7, 0}).empty());  // P16
}

TEST(PotentialEvents, AMeetingAtAnEndIsAnEventOfTheVertex) {
  // P17: the first edge begins where the second and third cross in the image from the front.
  const Three edges{Segment{{0, 0, 0}, {3, 5, 1}}, Segment{{-2, -1, 4}, {2, 1, 4}},
                    Segment{{-3, 2, 9}, {3, -2, 9}}};
  const auto roots = roots_of(form_of_three(edges));
  EXPECT_TRUE(std::find(roots.begin(), roots.end(), rational_direction(0, 1)) != roots.end());
  for (const Direction& event : three_edge_events(edges)) EXPECT_NE(event, rational_direction(0, 1));
  const auto ev = vertex_edge_events(edges[0].from, edges[1]);
  EXPECT_TRUE(std::find(ev.begin(), ev.end(), rational_direction(0, 1)) != ev.end());
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
