// The hard cases of list priority, with their exact inputs: cycles, faces that hide each other, faces that
// pass through each other, coplanar and edge-on ones, extents that touch.
#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <string>

#include "tests/host/algorithms/montani_re/plane_faces.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using Areas = std::vector<double>;

Areas seen_areas(const FaceSet& set) {
  return areas_of(set, visible_regions(set));
}

const PlaneFace bar_a{{{0, 0, 0}, {30, 0, 30}, {30, 10, 30}, {0, 10, 0}}};
const PlaneFace bar_b{{{20, 0, 0}, {30, 0, 0}, {30, 30, 30}, {20, 30, 30}}};

TEST(MontaniReHardCases, M1CycleOfThree) {
  const PlaneFace g{{{0, 0, 40}, {10, 0, 30}, {10, 20, 10}, {30, 20, -10}, {30, 30, -20}, {0, 30, 10}}};
  const FaceSet set = face_set({bar_a, bar_b, g});
  const VisibleRegions seen = visible_regions(set);
  EXPECT_EQ(areas_of(set, seen), (Areas{200, 200, 400}));
  EXPECT_EQ(seen.counts.cuts, 1U);
  EXPECT_EQ(seen.counts.mutual_parts, 0U);
}

TEST(MontaniReHardCases, M1PinwheelOfFour) {
  const PlaneFace c{{{0, 20, 30}, {30, 20, 0}, {30, 30, 0}, {0, 30, 30}}};
  const PlaneFace d{{{0, 0, 30}, {10, 0, 30}, {10, 30, 0}, {0, 30, 0}}};
  const FaceSet set = face_set({bar_a, bar_b, c, d});
  const VisibleRegions seen = visible_regions(set);
  EXPECT_EQ(areas_of(set, seen), (Areas{200, 200, 200, 200}));
  EXPECT_EQ(seen.counts.cuts, 1U);
}

// Pinwheels moved apart do not disturb each other; moved over each other in depth they make one list.
TEST(MontaniReHardCases, M2CyclesApartAndBehindEachOther) {
  std::vector<PlaneFace> faces;
  const auto add_wheel = [&faces](std::int64_t x, std::int64_t z) {
    const PlaneFace g{{{0, 0, 40}, {10, 0, 30}, {10, 20, 10}, {30, 20, -10}, {30, 30, -20}, {0, 30, 10}}};
    for (PlaneFace face : {bar_a, bar_b, g}) {
      for (Vertex& v : face[0]) v = {v.x + x, v.y, v.z + z};
      faces.push_back(face);
    }
  };
  add_wheel(0, 0);
  add_wheel(100, 0);
  add_wheel(0, 1000);
  const FaceSet set = face_set(faces);
  const VisibleRegions seen = visible_regions(set);
  EXPECT_EQ(areas_of(set, seen), (Areas{200, 200, 400, 200, 200, 400, 0, 0, 0}));
  EXPECT_EQ(seen.counts.cuts, 3U);
}

// n bars about a regular hole, each before the next: 3 to 12 of them, one cut.
TEST(MontaniReHardCases, M2PinwheelsOfThreeToTwelve) {
  const std::vector<std::array<std::int64_t, 2>> ring{{100, 0},   {87, 50},  {50, 87},  {0, 100},
                                                      {-50, 87},  {-87, 50}, {-100, 0}, {-87, -50},
                                                      {-50, -87}, {0, -100}, {50, -87}, {87, -50}};
  for (const std::size_t n : {3U, 4U, 6U, 12U}) {
    std::vector<PlaneFace> faces;
    for (std::size_t k = 0; k < n; ++k) {
      const auto& p = ring[k * 12 / n];
      const auto& q = ring[(k + 1) % n * 12 / n];
      // From p, deep, beyond q, near; broad to the outside.
      const auto at = [&](std::int64_t along, std::int64_t out) {
        return Vertex{4 * p[0] + along * (q[0] - p[0]) + out * (p[0] + q[0]),
                      4 * p[1] + along * (q[1] - p[1]) + out * (p[1] + q[1]), -200 * along};
      };
      faces.push_back({{at(-1, 0), at(5, 0), at(5, 1), at(-1, 1)}});
    }
    const FaceSet set = face_set(faces);
    const VisibleRegions seen = visible_regions(set);
    const Areas areas = areas_of(set, seen);
    EXPECT_EQ(seen.counts.cuts, 1U) << n;
    TrapezoidPcs covered;
    for (const Face& face : set.faces) covered = combine(set.image, covered, face.pcs, Operation::unite);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), area(set.image, covered), 1e-6) << n;
    for (const double seen_area : areas) EXPECT_GT(seen_area, 0) << n;
  }
}

// Figure 10, two instances: the paper gives it up.
TEST(MontaniReHardCases, M3FacesThatHideEachOther) {
  const PlaneFace u{{{0, 0, 10},
                     {30, 0, 10},
                     {30, 30, 10},
                     {20, 30, 10},
                     {20, 10, 10},
                     {10, 10, 10},
                     {10, 30, 10},
                     {0, 30, 10}}};
  const PlaneFace strip{{{-5, 15, -10}, {35, 15, 30}, {35, 25, 30}, {-5, 25, -10}}};
  const FaceSet set = face_set({u, strip});
  const VisibleRegions seen = visible_regions(set);
  EXPECT_EQ(areas_of(set, seen), (Areas{700 - 100, 400 - 100}));
  EXPECT_EQ(seen.counts.mutual_parts, 2U);
  EXPECT_EQ(seen.counts.relations, 0U);
  const PlaneFace portal{
      {{0, 0, 0}, {2, 0, 0}, {2, 8, 0}, {6, 8, 0}, {6, 0, 0}, {8, 0, 0}, {8, 10, 0}, {0, 10, 0}}};
  const PlaneFace bar{{{-1, 2, -5}, {9, 2, 5}, {9, 5, 5}, {-1, 5, -5}}};
  EXPECT_EQ(seen_areas(face_set({portal, bar})), (Areas{80 - 32 - 6, 30 - 6}));
  EXPECT_EQ(seen_areas(face_set({bar, portal})), (Areas{30 - 6, 80 - 32 - 6}));
}

TEST(MontaniReHardCases, M4FacesThroughEachOtherAreNamed) {
  const PlaneFace rising{{{0, 0, 0}, {20, 0, 20}, {20, 20, 20}, {0, 20, 0}}};
  const PlaneFace falling{{{0, 0, 20}, {20, 0, 0}, {20, 20, 0}, {0, 20, 20}}};
  const VisibleRegions seen = visible_regions(face_set({rectangle(40, 0, 50, 10, 0), rising, falling}));
  ASSERT_TRUE(seen.interpenetrating.has_value());
  EXPECT_EQ(*seen.interpenetrating, (std::pair<std::uint32_t, std::uint32_t>{1, 2}));
  EXPECT_TRUE(seen.regions.empty());
}

TEST(MontaniReHardCases, M5CoplanarOverlapping) {
  // No relation: both go to the BACK list; with one silhouette the area is counted once.
  const FaceSet set = face_set({rectangle(0, 0, 10, 10, 0), rectangle(5, 5, 15, 15, 0)});
  const VisibleRegions seen = visible_regions(set, Silhouette::whole);
  EXPECT_EQ(seen.counts.relations, 0U);
  EXPECT_EQ(areas_of(set, seen), (Areas{100, 75}));
}

TEST(MontaniReHardCases, M6CoplanarNeighboursStayApart) {
  const FaceSet set = face_set({rectangle(0, 0, 10, 10, 0), rectangle(10, 0, 20, 10, 0)});
  const VisibleRegions seen = visible_regions(set, Silhouette::whole);
  EXPECT_EQ(areas_of(set, seen), (Areas{100, 100}));
}

TEST(MontaniReHardCases, M13AndM14ExtentsThatTouch) {
  const PlaneFace near = rectangle(0, 0, 10, 10, 0);
  EXPECT_EQ(visible_regions(face_set({near, rectangle(10, 0, 20, 10, 5)})).counts.relations, 0U);
  // Z extents that touch fall to the plane tests, which know: a ramp from the far edge of a square backwards.
  const PlaneFace ramp{{{5, 0, 0}, {15, 0, 10}, {15, 10, 10}, {5, 10, 0}}};
  for (const auto& faces : {std::vector<PlaneFace>{near, ramp}, std::vector<PlaneFace>{ramp, near}}) {
    const FaceSet set = face_set(faces);
    const VisibleRegions seen = visible_regions(set);
    EXPECT_EQ(seen.counts.decided_by[3], 0U);
    const Areas areas = areas_of(set, seen);
    EXPECT_EQ(areas[0] + areas[1], 150);
    EXPECT_EQ(seen.counts.relations, 1U);
  }
}

// M15: the inner loop may stop only because faces are sorted; a wide face given last hides all before it.
TEST(MontaniReHardCases, M15TheSortIsOnLowestX) {
  const FaceSet set = face_set({rectangle(50, 0, 60, 10, 5), rectangle(20, 0, 30, 10, 5),
                                rectangle(90, 0, 99, 10, 5), rectangle(0, -5, 100, 15, 0)});
  EXPECT_EQ(seen_areas(set), (Areas{0, 0, 0, 2000}));
}

TEST(MontaniReHardCases, M16EdgeOnFacesAreLeftOut) {
  const FaceSet set =
      face_set({{{{0, 0, 0}, {0, 10, 0}, {0, 10, 10}, {0, 0, 10}}}, rectangle(-5, 0, 5, 10, 20)});
  EXPECT_EQ(set.edge_on, 1U);
  ASSERT_EQ(set.faces.size(), 1U);
  EXPECT_EQ(seen_areas(set), (Areas{100}));
}

// M9: a triangle far lower than anything near it is exact all the same.
TEST(MontaniReHardCases, M9Slivers) {
  const FaceSet set =
      face_set({{{{0, 0, 0}, {1000, 0, 0}, {1000, 1, 0}}}, rectangle(0, -1000, 1000, 1000, 5)});
  EXPECT_EQ(seen_areas(set), (Areas{500, 2000000 - 500}));
}

// M17: Figure 4 with the relations of Table 3.
TEST(MontaniReHardCases, M17Tables3And4) {
  const std::string faces = "SURFACE";  // the second F does not occur: faces are S U R F A C E
  const auto face = [&faces](char name) { return static_cast<std::uint32_t>(faces.find(name)); };
  const std::vector<Relation> table_3{{face('S'), face('U')}, {face('U'), face('R')}, {face('R'), face('F')},
                                      {face('A'), face('F')}, {face('C'), face('A')}, {face('E'), face('C')}};
  const PriorityList list = priority_list(7, table_3, [](auto) { return std::vector<std::uint32_t>{}; });
  const auto named = [&faces](const std::vector<PriorityClass>& classes) {
    std::string text;
    for (const PriorityClass& members : classes) {
      for (const std::uint32_t member : members) text += faces[member];
      text += '/';
    }
    return text;
  };
  EXPECT_EQ(named(list.front), "SE/UC/");
  EXPECT_EQ(named(list.back), "RA/F/");
  EXPECT_EQ(named(list.classes()), "SE/UC/RA/F/");
}

TEST(MontaniReHardCases, IsolatedFacesGoToTheBack) {
  const PriorityList list =
      priority_list(3, std::vector<Relation>{{0, 1}}, [](auto) { return std::vector<std::uint32_t>{}; });
  EXPECT_EQ(list.front, (std::vector<PriorityClass>{{0}}));
  EXPECT_EQ(list.back, (std::vector<PriorityClass>{{1, 2}}));
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
