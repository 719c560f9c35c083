// Outlines and holes of exact regions. Their areas are summed in rational numbers, by loops and by trapezoids; the two sums share
// only the corners.
#include "host/algorithms/montani_re/region_boundary.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "host/algorithms/montani_re/pyramids.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/montani_re/plane_faces.hpp"
#include "tests/host/geometry/gmp_integer.hpp"

namespace sightline::algorithms::montani_re {
namespace {

template <unsigned top, unsigned bottom>
mpq_class rational(const Image::QuotientOf<top, bottom>& q) {
  mpq_class value(geometry::to_gmp(q.numerator), geometry::to_gmp(q.denominator));
  value.canonicalize();
  return value;
}

std::array<mpq_class, 2> point(const Image& image, const RegionCorner& corner) {
  const auto coefficient = [](const auto& value) { return mpq_class(geometry::to_gmp(Image::Coefficient(value))); };
  const ImageLine& line = image.lines()[corner.line];
  const mpq_class y = rational(image.exact(corner.y));
  return {-(coefficient(line.b) * y + coefficient(line.c)) / coefficient(line.a), y};
}

mpq_class exact_area(const Image& image, const RegionLoop& loop) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto p = point(image, loop[i]);
    const auto q = point(image, loop[(i + 1) % loop.size()]);
    sum += p[0] * q[1] - q[0] * p[1];
  }
  return sum / 2;
}

mpq_class exact_area(const Image& image, const TrapezoidPcs& region) {
  mpq_class sum = 0;
  for (const Band& band : region.bands) {
    const auto sides = region.sides_of(band);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const auto low = point(image, {sides[k].line, band.low});
      const auto high = point(image, {sides[k].line, band.high});
      const mpq_class part = (low[0] + high[0]) * (high[1] - low[1]) / 2;
      sum += k % 2 == 0 ? mpq_class(-part) : part;
    }
  }
  return sum;
}

// Whether no three consecutive corners are collinear.
bool all_corners_turn(const Image& image, const RegionLoop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto a = point(image, loop[i]);
    const auto b = point(image, loop[(i + 1) % loop.size()]);
    const auto c = point(image, loop[(i + 2) % loop.size()]);
    if ((b[0] - a[0]) * (c[1] - a[1]) == (b[1] - a[1]) * (c[0] - a[0])) return false;
  }
  return loop.size() >= 3;
}

void expect_law(const Image& image, const TrapezoidPcs& region, const std::string& name) {
  mpq_class sum = 0;
  for (const RegionLoop& loop : boundary_of(image, region)) {
    const mpq_class part = exact_area(image, loop);
    sum += part;
    EXPECT_TRUE(all_corners_turn(image, loop)) << name;
    EXPECT_NEAR(signed_area(image, loop), part.get_d(), 1e-9 * (1 + std::abs(part.get_d()))) << name;
  }
  EXPECT_EQ(sum, exact_area(image, region)) << name;
}

TEST(MontaniReRegionBoundary, LoopsHaveTheAreaOfTheirStripes) {
  for (const scene::PolyScene& scene :
       {scene::generate_boxes(40), scene::generate_town(16), scene::generate_bricks(12),
        scene::generate_triangles(40), scene::generate_rooms(3)}) {
    for (const FaceSet& set : faces_before_eye(scene, scene.camera)) {
      const VisibleRegions seen = visible_regions(set);
      for (const TrapezoidPcs& region : seen.regions) expect_law(set.image, region, scene.name);
    }
  }
}

std::vector<Vertex> square_ring(std::int64_t low, std::int64_t high) {
  return rectangle(low, low, high, high, 0)[0];
}

// M7
TEST(MontaniReRegionBoundary, NestedHoles) {
  const FaceSet set = face_set({{square_ring(0, 100), square_ring(10, 90), square_ring(20, 80),
                                 square_ring(30, 70), square_ring(40, 60)}});
  const auto loops = boundary_of(set.image, set.faces[0].pcs);
  ASSERT_EQ(loops.size(), 5U);
  mpq_class sum = 0;
  int holes = 0;
  for (const RegionLoop& loop : loops) {
    EXPECT_EQ(loop.size(), 4U);
    sum += exact_area(set.image, loop);
    if (signed_area(set.image, loop) < 0) ++holes;
  }
  EXPECT_EQ(sum, 6000);
  EXPECT_EQ(holes, 2);
}

// M6: two squares side by side, face by face and as one class.
TEST(MontaniReRegionBoundary, AClassLosesTheEdgesItsFacesShare) {
  const FaceSet set = face_set({rectangle(0, 0, 10, 10, 0), rectangle(10, 0, 20, 10, 0)});
  const VisibleRegions seen = visible_regions(set);
  ASSERT_EQ(seen.list.classes().size(), 1U);
  EXPECT_EQ(boundary_of(set.image, seen.regions[0]).size(), 1U);
  const auto loops = boundary_of(set.image, unite_regions(set.image, seen.list.classes()[0], seen.regions));
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].size(), 4U);
  EXPECT_EQ(exact_area(set.image, loops[0]), 200);
}

// M8: squares that touch in a corner are two loops; a hole that touches the outline becomes part of it.
TEST(MontaniReRegionBoundary, LoopsThatOnlyTouchAreApart) {
  const FaceSet set = face_set({rectangle(0, 0, 10, 10, 0), rectangle(10, 10, 20, 20, 0)});
  const std::array<TrapezoidPcs, 2> regions{set.faces[0].pcs, set.faces[1].pcs};
  const std::array<std::uint32_t, 2> both{0, 1};
  EXPECT_EQ(boundary_of(set.image, unite_regions(set.image, both, regions)).size(), 2U);
  const FaceSet pinched = face_set(
      {{{{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}}, {{10, 0, 0}, {15, 5, 0}, {10, 10, 0}, {5, 5, 0}}}});
  const auto loops = boundary_of(pinched.image, pinched.faces[0].pcs);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].size(), 9U);  // one corner occurs twice
  EXPECT_EQ(exact_area(pinched.image, loops[0]), 350);
}

TEST(MontaniReRegionBoundary, OfAnEmptyRegionIsEmpty) {
  EXPECT_TRUE(boundary_of(Image(false), {}).empty());
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
