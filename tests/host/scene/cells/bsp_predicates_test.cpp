// The side of a meeting point, compared with integer points through which random planes are placed.
#include "host/scene/cells/bsp/predicates.hpp"

#include <gtest/gtest.h>

#include <random>

namespace sightline::scene {
namespace {

using geometry::Plane;
using geometry::Point3;

constexpr std::int64_t longest = (std::int64_t{1} << 39) - 1;

struct MeetingTest : testing::Test {
  std::mt19937_64 random{20240611};

  Point3 random_point() {
    std::uniform_int_distribution<std::int32_t> coordinate(-geometry::predicate_coordinate_limit,
                                                           geometry::predicate_coordinate_limit);
    return {coordinate(random), coordinate(random), coordinate(random)};
  }
  Plane random_plane(const Point3& point, std::int64_t limit) {
    std::uniform_int_distribution<std::int64_t> component(-limit, limit);
    Plane plane{{component(random), component(random), component(random)}, 0};
    plane.offset = geometry::dot(plane.normal, geometry::vector_of(point));
    return plane;
  }
};

TEST_F(MeetingTest, IsWhereTheCommonPointIs) {
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t limit = i % 2 == 0 ? longest : 2;
    const Point3 point = random_point();
    const Plane a = random_plane(point, limit);
    const Plane b = random_plane(point, limit);
    const Plane c = random_plane(point, limit);
    if (geometry::determinant(a.normal, b.normal, c.normal) == 0) continue;
    Plane plane = random_plane(i % 3 == 0 ? point : random_point(), limit);
    plane.offset += i % 5 - 2;  // just next to it
    EXPECT_EQ(side_of_meeting(plane, a, b, c), plane.side(point)) << i;
    EXPECT_EQ(side_of_meeting(plane, c, b, a), plane.side(point)) << i;
    const auto found = integer_meeting(a, b, c);
    if (limit == 2) {
      EXPECT_TRUE(found.has_value()) << i;
    }
    if (found) {
      EXPECT_EQ(*found, point) << i;
    }
  }
}

// Three planes, moved by one unit from a common point, meet near it, by Cramer's rule.
TEST_F(MeetingTest, TellsPointsBetweenIntegers) {
  const Plane x{{2, 0, 0}, 7};
  const Plane y{{0, 3, 0}, -10};
  const Plane z{{0, 0, longest}, 1};
  EXPECT_FALSE(integer_meeting(x, y, z).has_value());
  EXPECT_EQ(side_of_meeting({{1, 0, 0}, 3}, x, y, z), 1);
  EXPECT_EQ(side_of_meeting({{1, 0, 0}, 4}, x, y, z), -1);
  EXPECT_EQ(side_of_meeting({{0, 1, 0}, -3}, z, x, y), -1);
  EXPECT_EQ(side_of_meeting({{0, 0, 1}, 0}, z, x, y), 1);
  EXPECT_EQ(side_of_meeting({{0, 0, longest - 1}, 1}, z, x, y), -1);
  EXPECT_EQ(side_of_meeting({{6, 6, 0}, 1}, x, y, z), 0);
}

}  // namespace
}  // namespace sightline::scene
