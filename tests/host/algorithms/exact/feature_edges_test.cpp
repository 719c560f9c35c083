// Feature edges of solids that are turned together with the camera: always the same edges of the file, whatever the rounding; and
// their visible parts, by `exact` and by the oracle.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/eye_place.hpp"
#include "tests/host/algorithms/exact/turned_solids.hpp"

namespace sightline::algorithms {
namespace {

using namespace turned_solids;

// No face is nearly edge-on and no bend is near 30 degrees, where the rounding of the camera would decide.
bool is_decided(const Solid& solid, const Point& direction) {
  std::vector<Point> normals;
  for (const auto& face : solid.faces) {
    const Point& a = solid.vertices[face[0]];
    const Point& b = solid.vertices[face[1]];
    const Point& c = solid.vertices[face[2]];
    normals.push_back(unit(cross({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, {c[0] - a[0], c[1] - a[1], c[2] - a[2]})));
  }
  for (const Point& n : normals)
    if (std::abs(dot(n, unit(direction))) < 0.02) return false;
  for (const Point& n : normals)
    for (const Point& m : normals)
      if (std::abs(std::acos(std::min(1.0, dot(n, m))) * 180 / std::numbers::pi - 30) < 0.1) return false;
  return true;
}

using Edges = std::set<std::pair<picture::LineEdge, picture::EdgeKind>>;

Edges edges_of(const picture::ChosenEdges& chosen) {
  Edges edges;
  for (std::size_t e = 0; e < chosen.edges.size(); ++e) edges.emplace(chosen.edges[e], chosen.kinds[e]);
  return edges;
}

TEST(FeatureEdges, OfTurnedSolidsAreTheSameEdgesOfTheFile) {
  Dice dice(16);
  int compared = 0;
  std::size_t pieces = 0;
  while (compared < 200) {
    Solid solid;
    add_prism(solid, dice, {0, 0, 0});
    if (compared % 2 == 1) add_prism(solid, dice, {dice(70, 90) / 10.0, dice(-40, 40) / 10.0, dice(-20, 20) / 10.0});
    const Point direction = random_direction(dice);
    const Point up = random_direction(dice);
    if (std::abs(dot(direction, up)) > 0.9 || !is_decided(solid, direction)) continue;
    ++compared;
    const Matrix turn = random_turn(dice);
    const Point shift{dice(-500, 500) / 100.0, dice(-500, 500) / 100.0, dice(-500, 500) / 100.0};
    const auto chosen_of = [&](const Matrix& matrix, const Point& by, bool compare_pieces) {
      const scene::PolyScene scene = scene_of(solid, matrix, by);
      const scene::PolyCamera camera =
          scene::turned_camera({}, scene::bounds_of(scene).low, rotate(matrix, direction), rotate(matrix, up), false);
      const picture::EdgeChooser chooser(scene, {});
      picture::ChosenEdges chosen = chooser.at(camera);
      if (compare_pieces) {
        const exact::EdgeMesh mesh = exact::make_edge_mesh(scene);
        const picture::LinePicture fast = exact::visible_edges(mesh, camera, &chosen);
        EXPECT_TRUE(fast == oracle::visible_edges(scene, camera, chosen)) << compared;
        pieces += fast.pieces.size();
      }
      return edges_of(chosen);
    };
    const Edges as_it_is = chosen_of({Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}, {0, 0, 0}, false);
    EXPECT_EQ(as_it_is, chosen_of(turn, shift, true)) << compared;
    // The diagonals of the sides are not feature edges.
    for (const auto& [edge, kind] : as_it_is) EXPECT_NE(kind, picture::EdgeKind::flat);
  }
  EXPECT_GT(pieces, 200U * 9);
}

// In perspective, too, and with a near eye; the pictures only need to agree.
TEST(FeatureEdges, ExactAndOracleSeeTheSame) {
  Dice dice(5);
  int compared = 0;
  for (int round = 0; compared < 60 && round < 400; ++round) {
    Solid solid;
    for (int i = 0; i < 3; ++i) add_prism(solid, dice, {6.5 * i, dice(-40, 40) / 10.0, dice(-20, 20) / 10.0});
    const Matrix turn = random_turn(dice);
    scene::PolyScene scene = scene_of(solid, turn, {0, 0, 0});
    if (round % 3 == 0) {  // open: seen from both sides
      for (scene::PolyBody& body : scene.bodies) body.sheet = true;
    }
    const Point direction = random_direction(dice);
    scene::PolyCamera camera = scene::camera_outside({}, scene, direction, true);
    if (scene::eye_error(scene, camera)) continue;
    ++compared;
    picture::EdgeChoice choice;
    choice.crease = dice(0, 60);
    const picture::ChosenEdges chosen = picture::EdgeChooser(scene, choice).at(camera);
    const exact::EdgeMesh mesh = exact::make_edge_mesh(scene);
    EXPECT_TRUE(exact::visible_edges(mesh, camera, &chosen) == oracle::visible_edges(scene, camera, chosen)) << round;
  }
  EXPECT_EQ(compared, 60);
}

}  // namespace
}  // namespace sightline::algorithms
