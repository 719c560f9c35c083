// Cells with thousands of lines and openings, like the space around a building: the picture is exact, and a view from a room
// visits few of them.
#include <gtest/gtest.h>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/prepared_complex.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::algorithms {
namespace {

class CrowdedBuilding : public ::testing::Test {
 protected:
  static constexpr std::int32_t rooms = 40;
  static constexpr std::int32_t pitch = 200;

  scene::PolyScene scene_ = scene::generate_big_rooms(rooms);
  scene::CellComplex complex_ = *scene::decompose(scene_, scene::DecompositionMethod::grid);
  jones::PreparedComplex prepared_{complex_};
  jones::Walker walker_{prepared_};

  [[nodiscard]] jones::View view(const scene::PolyCamera& camera) { return *walker_.visible_edges(camera); }
  [[nodiscard]] scene::PolyCamera from_room(std::int32_t x, std::int32_t y) const {
    scene::PolyCamera camera = scene_.camera;
    camera.eye = {x * pitch + 97, y * pitch + 103, 70};
    return camera;
  }
};

TEST_F(CrowdedBuilding, HasCrowdedCells) {
  const auto crowded = [this](scene::CellNumber cell) { return prepared_.find_crowded(cell) != nullptr; };
  std::size_t found = 0;
  for (scene::CellNumber c = 0; c < complex_.cells.size(); ++c) found += crowded(c) ? 1 : 0;
  EXPECT_GT(found, 0U);
  EXPECT_LT(found, complex_.cells.size());
}

TEST_F(CrowdedBuilding, IsDrawnExactlyFromWithinAndWithout) {
  EXPECT_EQ(view(scene_.camera).picture, exact::visible_edges(scene_, scene_.camera));
  for (const std::int32_t x : {0, 11, rooms - 1}) {
    for (const std::int32_t y : {0, 12, rooms - 1}) {
      scene::PolyCamera camera = from_room(x, y);
      for (int turn = 0; turn < 4; ++turn) {
        EXPECT_EQ(view(camera).picture, exact::visible_edges(scene_, camera)) << x << ' ' << y << ' ' << turn;
        camera = {true, camera.eye, camera.right, {-camera.forward[0], -camera.forward[1], 0}, camera.up};
      }
    }
  }
}

TEST_F(CrowdedBuilding, AViewThroughAnOuterDoorVisitsFewLinesOfTheWallOutside) {
  for (std::int32_t y = 0; y < rooms; ++y) {
    const jones::Counts counts = view(from_room(0, y)).counts;
    EXPECT_LT(counts.lines_clipped, 32 * counts.visits) << y;
  }
}

}  // namespace
}  // namespace sightline::algorithms
