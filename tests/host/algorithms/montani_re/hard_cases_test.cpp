// The hard cases of list priority, on the report's inputs: cycles, faces that hide each other, faces that pass through each
// other,
// coplanar and edge-on faces, extents that touch.
#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <string>
#include <utility>

#include "tests/host/algorithms/montani_re/plane_faces.hpp"
#include "tests/host/scene/hard_case_files.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using Areas = std::vector<double>;

Areas seen_areas(const FaceSet& set) {
  return areas_of(set, visible_regions(set));
}

// One sheet per face.
FaceSet case_set(const std::string& name) {
  const scene::PolyScene scene = scene::hard_case_scene(name);
  return *faces_of(scene, scene.camera);
}

TEST(MontaniReHardCases, M1CycleOfThree) {
  const FaceSet set = case_set("M1.json");
  const VisibleRegions seen = visible_regions(set);
  EXPECT_EQ(areas_of(set, seen), (Areas{200, 200, 400}));
  EXPECT_EQ(seen.counts.cuts, 1U);
  EXPECT_EQ(seen.counts.mutual_parts, 0U);
}

TEST(MontaniReHardCases, M1PinwheelOfFour) {
  const FaceSet set = case_set("M1-four.json");
  const VisibleRegions seen = visible_regions(set);
  EXPECT_EQ(areas_of(set, seen), (Areas{200, 200, 200, 200}));
  EXPECT_EQ(seen.counts.cuts, 1U);
}

// Separate pinwheels do not affect each other; pinwheels that overlap in depth form one list.
TEST(MontaniReHardCases, M2CyclesApartAndBehindEachOther) {
  const FaceSet set = case_set("M2.json");
  const VisibleRegions seen = visible_regions(set);
  EXPECT_EQ(areas_of(set, seen), (Areas{200, 200, 400, 200, 200, 400, 0, 0, 0}));
  EXPECT_EQ(seen.counts.cuts, 3U);
}

TEST(MontaniReHardCases, M2CyclesThatShareAFace) {
  const FaceSet set = case_set("M2-shared.json");
  const VisibleRegions seen = visible_regions(set);
  EXPECT_EQ(areas_of(set, seen), (Areas{700, 200, 400, 200, 400}));
  EXPECT_EQ(seen.counts.cuts, 2U);
}

// n bars around a regular hole, each in front of the next: 3 to 12 bars, one cut.
TEST(MontaniReHardCases, M2PinwheelsOfThreeToTwelve) {
  const std::vector<std::array<std::int64_t, 2>> ring{{100, 0},   {87, 50},  {50, 87},  {0, 100},
                                                      {-50, 87},  {-87, 50}, {-100, 0}, {-87, -50},
                                                      {-50, -87}, {0, -100}, {50, -87}, {87, -50}};
  for (const std::size_t n : {3U, 4U, 6U, 12U}) {
    std::vector<PlaneFace> faces;
    for (std::size_t k = 0; k < n; ++k) {
      const auto& p = ring[k * 12 / n];
      const auto& q = ring[(k + 1) % n * 12 / n];
      // From p, far, past q, near; wide towards the outside.
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

// Figure 10, two instances: the paper does not resolve it.
TEST(MontaniReHardCases, M3FacesThatHideEachOther) {
  const FaceSet set = case_set("M3.json");
  const VisibleRegions seen = visible_regions(set);
  EXPECT_EQ(areas_of(set, seen), (Areas{700 - 100, 400 - 100}));
  EXPECT_EQ(seen.counts.mutual_parts, 2U);
  EXPECT_EQ(seen.counts.relations, 0U);
  FaceSet portal = case_set("M3-portal.json");
  EXPECT_EQ(seen_areas(portal), (Areas{80 - 32 - 6, 30 - 6}));
  std::swap(portal.faces[0], portal.faces[1]);
  EXPECT_EQ(seen_areas(portal), (Areas{30 - 6, 80 - 32 - 6}));
}

TEST(MontaniReHardCases, M4FacesThroughEachOtherAreNamed) {
  const VisibleRegions seen = visible_regions(case_set("M4.json"));
  ASSERT_TRUE(seen.interpenetrating.has_value());
  EXPECT_EQ(*seen.interpenetrating, (std::pair<std::uint32_t, std::uint32_t>{1, 2}));
  EXPECT_TRUE(seen.regions.empty());
}

TEST(MontaniReHardCases, M5CoplanarOverlapping) {
  // Without a relation both go to the BACK list; with one silhouette the area is counted once.
  const FaceSet set = case_set("M5.json");
  const VisibleRegions seen = visible_regions(set, Silhouette::whole);
  EXPECT_EQ(seen.counts.relations, 0U);
  EXPECT_EQ(areas_of(set, seen), (Areas{100, 75}));
}

TEST(MontaniReHardCases, M6CoplanarNeighboursStayApart) {
  const FaceSet set = case_set("M6.json");
  const VisibleRegions seen = visible_regions(set, Silhouette::whole);
  EXPECT_EQ(areas_of(set, seen), (Areas{100, 100}));
}

TEST(MontaniReHardCases, M13AndM14ExtentsThatTouch) {
  EXPECT_EQ(visible_regions(case_set("M13.json")).counts.relations, 0U);
  // Touching Z extents are decided by the plane tests: a ramp from the far edge of a square backwards.
  FaceSet set = case_set("M14.json");
  for (const Areas& expected : {Areas{100, 50}, Areas{50, 100}}) {
    const VisibleRegions seen = visible_regions(set);
    EXPECT_EQ(seen.counts.decided_by[3], 0U);
    EXPECT_EQ(areas_of(set, seen), expected);
    EXPECT_EQ(seen.counts.relations, 1U);
    std::swap(set.faces[0], set.faces[1]);
  }
}

// M15: the inner loop may stop only because faces are sorted; a wide face given last hides all faces before it.
TEST(MontaniReHardCases, M15TheSortIsOnLowestX) {
  EXPECT_EQ(seen_areas(case_set("M15.json")), (Areas{0, 0, 0, 2000}));
}

TEST(MontaniReHardCases, M16EdgeOnFacesAreLeftOut) {
  const FaceSet set = case_set("M16.json");
  EXPECT_EQ(set.edge_on, 1U);
  ASSERT_EQ(set.faces.size(), 1U);
  EXPECT_EQ(seen_areas(set), (Areas{100}));
}

// M9: a triangle much flatter than anything near it is still exact.
TEST(MontaniReHardCases, M9Slivers) {
  EXPECT_EQ(seen_areas(case_set("M9.json")), (Areas{500, 20000 - 500}));
}

// M17: Figure 4 with the relations of Table 3.
TEST(MontaniReHardCases, M17Tables3And4) {
  const std::string faces = "SURFACE";
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

// The same from faces: rectangles in a row, because Figure 4 is illegible.
TEST(MontaniReHardCases, M17TheListOfTable4) {
  const scene::PolyScene scene = scene::hard_case_scene("M17.json");
  const FaceSet set = case_set("M17.json");
  const VisibleRegions seen = visible_regions(set);
  EXPECT_EQ(seen.counts.relations, 6U);
  std::string list;
  for (const PriorityClass& members : seen.list.classes()) {
    for (const std::uint32_t member : members) list += scene.bodies[set.faces[member].body].name;
    list += '/';
  }
  EXPECT_EQ(list, "SE/UC/RA/F/");
}

TEST(MontaniReHardCases, IsolatedFacesGoToTheBack) {
  const PriorityList list =
      priority_list(3, std::vector<Relation>{{0, 1}}, [](auto) { return std::vector<std::uint32_t>{}; });
  EXPECT_EQ(list.front, (std::vector<PriorityClass>{{0}}));
  EXPECT_EQ(list.back, (std::vector<PriorityClass>{{1, 2}}));
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
