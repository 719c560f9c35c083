// Hard cases of native Jones beyond the report's (host/compare/hard_cases/data): other views, other descriptions of the same
// opening, and invalid views.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/stretch.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/scene/cells/grid/decompose.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/builtin.hpp"
#include "tests/host/algorithms/jones/hard_scenes.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::algorithms {
namespace {

jones::View view_of(const scene::CellComplex& complex, const scene::PolyCamera& camera) {
  auto result = jones::visible_edges(complex, camera);
  if (!result) {
    ADD_FAILURE() << result.error().message();
    return {};
  }
  return std::move(*result);
}

// J3: of two rooms the one in the viewing direction is visible, as far as it is in front of the eye.
TEST(JonesHardCases, EyeOnAWallIsOnTheSideOfTheViewingDirection) {
  const geometry::Box left{{-50, -50, -100}, {0, 50, 100}};
  const geometry::Box right{{0, -50, -100}, {50, 50, 100}};
  scene::PolyScene scene;
  add_walls_around(scene, left);  // vertices 0 to 23
  add_walls_around(scene, right);
  const auto complex = complex_of_boxes(scene, {left.low, right.high}, {left, right}, {});
  const auto rooms_seen = [&](const scene::PolyPoint& forward, const scene::PolyPoint& to_right,
                              const scene::PolyPoint& up) {
    const jones::View view = view_of(complex, {true, {0, 0, 0}, forward, to_right, up});
    EXPECT_EQ(view.counts.visits, 1U);
    std::set<std::int32_t> x;
    for (const auto& piece : view.picture.pieces) x.insert(scene.vertices[piece.edge.from][0]);
    return x;
  };
  const std::set<std::int32_t> the_left{-50, 0};
  const std::set<std::int32_t> the_right{0, 50};
  EXPECT_EQ(rooms_seen({-1, 0, 9}, {9, 0, 1}, {0, 1, 0}), the_left);
  EXPECT_EQ(rooms_seen({1, 0, 9}, {9, 0, -1}, {0, 1, 0}), the_right);
  EXPECT_EQ(rooms_seen({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), the_right) << "to the right";
  EXPECT_EQ(rooms_seen({0, 0, 1}, {0, 1, 0}, {-1, 0, 0}), the_left) << "up";
}

// J4: the edges through the eye are points; the nine others are visible completely.
TEST(JonesHardCases, EyeInACornerSeesNineEdges) {
  scene::PolyScene scene;
  const geometry::Box room{{0, 0, 0}, {100, 100, 100}};
  add_wall(scene, face_of(room, 0, true));
  add_wall(scene, face_of(room, 1, true));
  add_wall(scene, face_of(room, 2, true));
  scene.vertices.push_back({0, 0, 0});
  for (const scene::PolyPoint& end : {scene::PolyPoint{100, 0, 0}, {0, 100, 0}, {0, 0, 100}}) {
    const auto last = static_cast<scene::VertexIndex>(scene.vertices.size());
    scene.vertices.push_back(end);
    scene.bodies.push_back({"", true, {{{12, last, last}, {}}}});  // a line from the corner at the eye
  }
  const auto complex = complex_of_boxes(scene, room, {room}, {});
  const jones::View view = view_of(complex, {true, {0, 0, 0}, {1, 1, 1}, {1, -1, 0}, {1, 1, -2}});
  std::set<std::set<scene::PolyPoint>> lines;
  for (const auto& piece : view.picture.pieces) {
    EXPECT_EQ(piece.low, geometry::Rational(0));
    EXPECT_EQ(piece.high, geometry::Rational(1));
    lines.insert({scene.vertices[piece.edge.from], scene.vertices[piece.edge.to]});
  }
  EXPECT_EQ(lines.size(), 9U);
}

// J6: on a wall behind a portal, a line that only touches the mask's corner is not drawn; a line inside is.
TEST(JonesHardCases, ALineThatTouchesACornerOfTheMaskIsNotDrawn) {
  HardCase hard = corridor({portal(100, {-10, 10}, {-10, 10}), portal(200, {-4, 4}, {-4, 4})}, 300);
  const auto first = static_cast<scene::VertexIndex>(hard.scene.vertices.size());
  for (const scene::PolyPoint& corner : {scene::PolyPoint{20, 20, 200}, {20, 45, 200}, {5, 5, 200}})
    hard.scene.vertices.push_back(corner);
  hard.scene.bodies.push_back({"", true, {{{first, first + 1, first + 2}, {}}}});
  const jones::View view = view_of(hard.complex(), hard.camera);
  EXPECT_TRUE(view.picture == exact::visible_edges(hard.scene, hard.camera));
  std::set<picture::LineEdge> drawn;
  for (const auto& piece : view.picture.pieces) drawn.insert(piece.edge);
  EXPECT_FALSE(drawn.contains({first, first + 1})) << "touches";
  EXPECT_TRUE(drawn.contains({first, first + 2})) << "goes inwards";
  EXPECT_TRUE(drawn.contains({first + 1, first + 2}));
}

// J9, J16: the paths of Fig. 5; the kitchen is visited twice.
TEST(JonesHardCases, TheHouseIsSearchedAsInThePaper) {
  const scene::CellScene cells = scene::builtin_scene("house");
  const scene::PolyScene scene = scene::poly_scene_of(cells);
  const jones::View view = view_of(complex_by_hand(cells, scene), scene.camera);
  EXPECT_EQ(view.counts.visits, 4U);
  EXPECT_EQ(view.counts.cells, 3U);
  EXPECT_EQ(view.counts.depth, 3U);
}

// J10: the plane through (0,0) and (131071,1) and the line from (0,0) to (131070,1) cross only at (0,0).
TEST(JonesHardCases, NearlyParallelLinesCrossExactly) {
  const std::int64_t at_end = std::int64_t{131071} * 1 - std::int64_t{131070} * 1;
  jones::Stretch<std::int64_t> above{{0, 1}, {1, 1}};
  EXPECT_TRUE(above.keep_not_negative(0, at_end));
  EXPECT_FALSE(jones::less({0, 1}, above.low));
  EXPECT_FALSE(jones::less(above.high, {1, 1}));
  jones::Stretch<std::int64_t> below{{0, 1}, {1, 1}};
  EXPECT_FALSE(below.keep_not_negative(0, -at_end));
}

// J14: the eye exactly in line with walls of no thickness.
TEST(JonesHardCases, EyeInLineWithWalls) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const scene::PolyScene scene = scene::generate_rooms(3, seed);
    const auto complex = scene::decompose_grid(scene);
    ASSERT_TRUE(complex);
    scene::PolyCamera camera = scene.camera;
    for (const std::int32_t y : {0, 1000, 2000, 3000}) {
      camera.eye[1] = y;
      const jones::View view = view_of(*complex, camera);
      EXPECT_TRUE(view.picture == exact::visible_edges(scene, camera)) << seed << ", y " << y;
    }
  }
}

// J17: a side given twice, by two planes through the same line.
TEST(JonesHardCases, SidesInOneLineAreMerged) {
  const HardCase hard = corridor({portal(100, {0, 40}, {0, 20})}, 200);
  scene::CellComplex complex = hard.complex();
  scene::ComplexOpening& opening = complex.openings.back();
  ASSERT_EQ(opening.side_count, 4U);
  const auto sides = complex.sides_of(opening);
  std::vector<scene::HalfSpace> five(sides.begin(), sides.end());
  const auto bottom = std::find_if(five.begin(), five.end(), [&](const scene::HalfSpace& half) {
    return half.turned && complex.planes[half.plane].normal[1] != 0;
  });
  ASSERT_NE(bottom, five.end());
  complex.planes.push_back({{0, 1, 1}, 100});  // y + z = 100
  five.insert(bottom, {static_cast<std::uint32_t>(complex.planes.size() - 1), true});
  opening.first_side = static_cast<std::uint32_t>(complex.sides.size());
  opening.side_count = 5;
  complex.sides.insert(complex.sides.end(), five.begin(), five.end());
  const jones::View view = view_of(complex, hard.camera);
  EXPECT_TRUE(view.picture == exact::visible_edges(hard.scene, hard.camera));
  EXPECT_EQ(view.counts.mask_sides, 4U);
}

TEST(JonesHardCases, AnInvalidEyeIsAnError) {
  const scene::PolyScene scene = scene::generate_boxes(1);
  const auto result = scene::decompose_grid(scene);
  const auto& complex = *result;
  scene::PolyCamera camera = scene.camera;
  const geometry::Box box = scene::outer_box_of(scene);  // of the one solid, plus 1
  camera.eye = {box.low[0] + 10, box.low[1] + 10, box.low[2] + 10};
  EXPECT_EQ(jones::visible_edges(complex, camera).error(), base::bad_input(jones::eye_in_solid));
  camera.eye[0] = 1 << 18;
  EXPECT_EQ(jones::visible_edges(complex, camera).error(), base::bad_input(jones::eye_too_far));
}

}  // namespace
}  // namespace sightline::algorithms
