// The proposition of Willis (1977), section 4, whose proof the paper omits, and that the double circle is the smallest boundary: all
// walls, eyes and points of small grids in plan, in integers.
//
// Let the line of sight from the eye O to the point A meet the wall S. If S has points that are at least as far from O as A and
// points that are at most as far, then distance does not tell which hides the other: A is ambiguous. The proposition: A is then at
// most L, the length of S, from S, and from an end D of S (AD <= L).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "host/algorithms/willis/boundary.hpp"
#include "host/geometry/integer.hpp"
#include "tests/host/algorithms/willis/walls.hpp"

namespace sightline::algorithms::willis {
namespace {

struct Place {
  std::int64_t x = 0;
  std::int64_t z = 0;

  friend Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.z - b.z}; }
  friend bool operator==(const Place&, const Place&) = default;
};
std::int64_t dot(const Place& a, const Place& b) { return a.x * b.x + a.z * b.z; }
std::int64_t cross(const Place& a, const Place& b) { return a.x * b.z - a.z * b.x; }
std::int64_t square(const Place& a) { return dot(a, a); }

// Whether the ray from o through a meets the segment from c to d in one point.
bool sight_meets(const Place& o, const Place& a, const Place& c, const Place& d) {
  const std::int64_t from = cross(a - o, c - o);
  const std::int64_t to = cross(a - o, d - o);
  if (from == to || (from > 0 && to > 0) || (from < 0 && to < 0)) return false;
  // The point is c + (d - c) from / (from - to); ahead of o, if its product with the ray is positive.
  const std::int64_t whole = from - to;
  const geometry::Int128 ahead = geometry::Int128{dot(a - o, c - o)} * whole + geometry::Int128{dot(a - o, d - c)} * from;
  return whole > 0 ? ahead > 0 : ahead < 0;
}

// Whether the segment has a point at most as far from o as `squared`.
bool has_near_point(const Place& o, const Place& c, const Place& d, std::int64_t squared) {
  const std::int64_t foot = dot(o - c, d - c);
  const std::int64_t length = square(d - c);
  if (foot > 0 && foot < length) {
    const geometry::Int128 across = cross(d - c, o - c);
    return across * across <= geometry::Int128{squared} * length;
  }
  return std::min(square(c - o), square(d - o)) <= squared;
}

bool is_ambiguous(const Place& o, const Place& a, const Place& c, const Place& d) {
  const std::int64_t far = square(a - o);
  return sight_meets(o, a, c, d) && std::max(square(c - o), square(d - o)) >= far && has_near_point(o, c, d, far);
}

Surface wall_of(const Place& c, const Place& d) {
  const auto plan = [](const Place& p) { return PlanPoint{static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.z)}; };
  return wall(plan(c), plan(d));
}
Point point_of(const Place& p) { return on_lattice({static_cast<std::int32_t>(p.x), 0, static_cast<std::int32_t>(p.z)}); }

// Every wall of at most 5 along each axis, every point within 6 of it, every eye within 8.
TEST(WillisProposition, AnAmbiguousPointIsWithinTheLengthOfAnEnd) {
  constexpr std::int64_t most = 5;
  std::int64_t ambiguous = 0;
  for (std::int64_t dx = 0; dx <= most; ++dx) {
    for (std::int64_t dz = 0; dz <= dx; ++dz) {  // the others are mirror images
      const Place c{0, 0};
      const Place d{dx, dz};
      if (c == d) continue;
      const std::int64_t length = square(d - c);
      const Surface surface = wall_of(c, d);
      for (std::int64_t x = -6; x <= dx + 6; ++x) {
        for (std::int64_t z = -6; z <= dz + 6; ++z) {
          const Place a{x, z};
          bool here = false;
          for (std::int64_t ex = -8; ex <= dx + 8; ++ex) {
            for (std::int64_t ez = -8; ez <= dz + 8; ++ez) here = here || is_ambiguous({ex, ez}, a, c, d);
          }
          if (!here) continue;
          ++ambiguous;
          EXPECT_LE(std::min(square(a - c), square(a - d)), length) << dx << ' ' << dz << ": " << x << ' ' << z;
          EXPECT_TRUE(has_near_point(a, c, d, length));
          EXPECT_TRUE(in_boundary(surface, point_of(a), BoundaryShape::ball)) << dx << ' ' << dz << ": " << x << ' ' << z;
          EXPECT_TRUE(in_boundary(surface, point_of(a), BoundaryShape::oval));
        }
      }
    }
  }
  EXPECT_GT(ambiguous, 500);
}

// Every point within the double circle, but on the line of the wall, is ambiguous from some eye beside an end: no smaller boundary
// will do. Outside it the first test has found none.
TEST(WillisProposition, EveryPointOfTheDoubleCircleIsAmbiguous) {
  constexpr std::int64_t finer = 1000;
  constexpr std::int64_t scale = finer * finer;  // eyes are on a finer grid
  int inside = 0;
  int outside = 0;
  for (std::int64_t dx = 1; dx <= 7; ++dx) {
    for (std::int64_t dz = 0; dz <= dx; ++dz) {
      const Place c{0, 0};
      const Place d{scale * dx, scale * dz};
      const Surface surface = wall_of(c, {dx, dz});
      for (std::int64_t x = -8; x <= dx + 8; ++x) {
        for (std::int64_t z = -8; z <= dz + 8; ++z) {
          const Place a{scale * x, scale * z};
          if (cross(d - c, a - c) == 0) continue;
          bool found = false;
          for (const auto& [end, other] : {std::array{c, d}, std::array{d, c}}) {
            // A point of the wall beside the end, and an eye just beyond it as A sees it.
            const Place p{end.x + (other.x - end.x) / finer, end.z + (other.z - end.z) / finer};
            const Place o{p.x + (p.x - a.x) / finer, p.z + (p.z - a.z) / finer};
            found = found || is_ambiguous(o, a, c, d);
          }
          const std::int64_t length = square(d - c);
          const bool within = std::min(square(a - c), square(a - d)) < length;
          EXPECT_EQ(found, within) << dx << ' ' << dz << ": " << x << ' ' << z;
          EXPECT_TRUE(!within || in_boundary(surface, point_of({x, z}), BoundaryShape::ball));
          ++(within ? inside : outside);
        }
      }
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

}  // namespace
}  // namespace sightline::algorithms::willis
