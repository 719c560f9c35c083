// Montani and Re's algorithm compared with `exact`, and with its variant that uses one silhouette for the whole scene.
#include "tests/host/algorithms/montani_re/agreement.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace sightline::algorithms::montani_re {
namespace {

void expect_agreement(const std::string& family, const Agreement& agreement) {
  EXPECT_EQ(agreement.first_wrong, "") << family;
  EXPECT_EQ(agreement.equal + agreement.same_image, agreement.views) << family;
  EXPECT_GT(agreement.equal, agreement.views / 4) << family;
}

TEST(MontaniReAgreement, GeneratedScenes) {
  for (const auto& [family, agreement] : compare_generated_set(10, 3)) {
    expect_agreement(family, agreement);
  }
}

TEST(MontaniReAgreement, CubesThatTouchAndCubesInLine) {
  for (const std::size_t n : {1U, 2U, 3U}) {
    for (const scene::PolyScene& scene : {scene::generate_touch(n), scene::generate_aligned(n)}) {
      Agreement agreement;
      compare_view(scene, scene.camera, agreement);
      RandomCameras cameras(scene, 5);
      for (int i = 0; i < 6; ++i) compare_view(scene, cameras.outside(i % 2 == 0), agreement);
      EXPECT_EQ(agreement.first_wrong, "") << scene.name;
      EXPECT_GT(agreement.equal + agreement.same_image, 3) << scene.name;
    }
  }
}

// In general position no picture may need the weaker comparison.
TEST(MontaniReAgreement, ScenesInGeneralPositionAreEqualPieceByPiece) {
  for (const scene::PolyScene& scene :
       {scene::generate_boxes(100), scene::generate_town(25), scene::generate_triangles(100)}) {
    Agreement agreement;
    compare_view(scene, scene.camera, agreement);
    EXPECT_EQ(agreement.equal, 1) << scene.name << ' ' << agreement.first_wrong;
  }
}

TEST(MontaniReAgreement, OneSilhouetteOrNeighboursIsTheSame) {
  for (const scene::PolyScene& scene :
       {scene::generate_boxes(12), scene::generate_bricks(8), scene::generate_triangles(16)}) {
    const auto faces = faces_of(scene, scene.camera);
    const auto& set = *faces;
    const VisibleRegions by_neighbours = visible_regions(set);
    const VisibleRegions by_silhouette = visible_regions(set, Silhouette::whole);
    EXPECT_TRUE(edges_of_regions(set, by_neighbours.regions) == edges_of_regions(set, by_silhouette.regions))
        << scene.name;
    // I9: the visible parts add up to the union of all faces.
    TrapezoidPcs covered;
    double sum = 0;
    for (std::size_t f = 0; f < set.faces.size(); ++f) {
      covered = combine(set.image, covered, set.faces[f].pcs, Operation::unite);
      sum += area(set.image, by_neighbours.regions[f]);
    }
    EXPECT_NEAR(sum, area(set.image, covered), 1e-9 * sum) << scene.name;
  }
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
