// Lines without faces: visible parts computed by hand, and `exact` compared with the oracle on random scenes with lines inside,
// outside and through bodies, on their faces and along their edges.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "host/picture/edge_choice.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "host/scene/model/vertex_pool.hpp"
#include "host/scene/read/poly_import.hpp"
#include "tests/host/algorithms/agreement/random_scene.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"

namespace sightline::algorithms {
namespace {

using geometry::Interval;
using Intervals = std::vector<Interval>;
using picture::EdgeKind;
using scene::PolyPoint;
using scene::PolyScene;

Interval part(std::int64_t low, std::int64_t high, std::int64_t over) { return {{low, over}, {high, over}}; }

// A box from 0, 0, 0 to 10, 6, 4, seen along -1, -1, -1: its faces at x = 10, y = 6 and z = 4 face the eye. A point p behind it
// is
// hidden if p + t (1, 1, 1) is in the box for some t > 0.
class Wires : public testing::TestWithParam<Maker> {
 protected:
  Wires() {
    builder_.add_box("", {0, 0, 0}, {10, 6, 4});
    builder_.scene().camera = {false, {}, {-1, -1, -1}, {1, 0, -1}, {-1, 2, -1}};
  }

  // From `a` to `b`, in the direction of drawing.
  Intervals seen(const PolyPoint& a, const PolyPoint& b) {
    const scene::VertexIndex from = builder_.vertex(a);
    const scene::VertexIndex to = builder_.vertex(b);
    PolyScene& scene = builder_.scene();
    scene.wires = {{from, to}};
    EXPECT_TRUE(from < to);
    return seen_of(GetParam().draw(scene, scene.camera), from, to);
  }

  scene::PolyBuilder builder_;
};

INSTANTIATE_TEST_SUITE_P(, Wires, testing::Values(exact_maker, oracle_maker), [](const auto& maker) { return maker.param.name; });

// In front of the face x = 10 from 15/20 on; behind the box, where z + t <= 4 at x + t = 0, from x = -2 on.
TEST_P(Wires, ALineThroughABoxIsHiddenInItAndBehindIt) {
  EXPECT_EQ(seen({-5, 3, 2}, {15, 3, 2}), (Intervals{part(0, 3, 20), part(3, 4, 4)}));
}

TEST_P(Wires, ALineOnAFaceIsSeenIfTheFaceIs) {
  EXPECT_EQ(seen({1, 1, 4}, {9, 5, 4}), Intervals{part(0, 1, 1)});  // inside z = 4
  EXPECT_EQ(seen({10, 0, 1}, {10, 9, 1}), Intervals{part(0, 1, 1)});
  EXPECT_EQ(seen({0, 1, 1}, {0, 5, 3}), Intervals{});               // inside x = 0, turned away
  EXPECT_EQ(seen({1, 0, 1}, {1, 0, -9}), Intervals{part(7, 10, 10)});  // y = 0: out of the box at t = 6, in at t = -z
}

TEST_P(Wires, LinesAlongEdges) {
  EXPECT_EQ(seen({10, 6, 1}, {10, 6, 3}), Intervals{part(0, 1, 1)});
  EXPECT_EQ(seen({0, 0, 1}, {0, 0, 3}), Intervals{});
  EXPECT_EQ(seen({0, 0, -1}, {0, 0, -9}), Intervals{part(5, 8, 8)});  // likewise, from z = -6 on
}

TEST_P(Wires, NothingButLines) {
  PolyScene scene;
  scene.vertices = {{0, 0, 0}, {5, 5, 9}, {9, 0, 0}};
  scene.wires = {{1, 0}, {1, 2}, {0, 1}};
  scene.camera = builder_.scene().camera;
  const picture::LinePicture seen = GetParam().draw(scene, scene.camera);
  EXPECT_EQ(seen.pieces, (std::vector<picture::LinePiece>{{{0, 1}, 0, 1}, {{1, 2}, 0, 1}}));
}

// A square of two triangles: a wire makes its diagonal visible; its sides are drawn as they are without a wire.
TEST(WireKinds, AFlatEdgeAndASeparateLine) {
  PolyScene scene;
  scene.vertices = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {4, 4, 7}};
  scene.bodies = {{"", true, {{{0, 1, 2}, {}}, {{0, 2, 3}, {}}}}};
  scene.camera = {false, {}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
  const auto kinds = [&scene](std::string_view choice) {
    const picture::ChosenEdges chosen = picture::EdgeChooser(scene, *picture::edge_choice_named(choice)).at(scene.camera);
    std::string text;
    for (std::size_t e = 0; e < chosen.edges.size(); ++e) {
      text += std::to_string(chosen.edges[e].from) + std::to_string(chosen.edges[e].to) + " ";
      text += std::string(picture::edge_kind_names[static_cast<std::size_t>(chosen.kinds[e])]) + (chosen.turned_away[e] != 0 ? " away\n" : "\n");
    }
    return text;
  };
  EXPECT_EQ(kinds("wire"), "");
  scene.wires = {{2, 0}, {1, 0}, {3, 4}};
  ASSERT_TRUE(scene::check_poly_scene(scene).empty());
  EXPECT_EQ(kinds("wire"), "02 wire\n34 wire\n");
  EXPECT_EQ(kinds("feature"), "01 boundary\n02 wire\n03 boundary\n12 boundary\n23 boundary\n34 wire\n");
  EXPECT_EQ(kinds("boundary"), "01 boundary\n03 boundary\n12 boundary\n23 boundary\n");
}

using Point = std::array<double, 3>;

// A cube of side 3 with a wire inside each face, in coordinates of the file.
scene::PolyMesh cube_with_wires(Point (*placed)(const Point&)) {
  const std::vector<std::vector<scene::VertexIndex>> faces{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::vector<Point> corners{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 3}, {3, 0, 3}, {3, 3, 3}, {0, 3, 3}};
  scene::PolyMesh mesh;
  mesh.source = "test";
  mesh.bodies.emplace_back();
  for (const auto& face : faces) {
    mesh.bodies[0].faces.push_back({face, {}});
    const auto first = static_cast<scene::VertexIndex>(corners.size());
    mesh.wires.push_back({first, first + 1});
    for (const auto& [u, v] : {std::array{0.2, 0.3}, {0.7, 0.6}}) {
      Point p{};
      for (std::size_t a = 0; a < 3; ++a)
        p[a] = corners[face[0]][a] * (1 - u - v) + corners[face[1]][a] * u + corners[face[3]][a] * v;
      corners.push_back(p);
    }
  }
  for (const Point& corner : corners) mesh.vertices.push_back(placed(corner));
  return mesh;
}

// How many wires are visible completely, and partly; the same by `exact` and by the oracle.
std::array<std::size_t, 2> wires_seen(const PolyScene& scene, const scene::PolyCamera& camera) {
  const picture::ChosenEdges chosen = picture::EdgeChooser(scene, *picture::edge_choice_named("wire")).at(camera);
  const picture::LinePicture picture = exact::visible_edges(exact::make_edge_mesh(scene), camera, &chosen);
  EXPECT_TRUE(picture == oracle::visible_edges(scene, camera, chosen));
  std::array<std::size_t, 2> counts{};
  for (const picture::LinePiece& piece : picture.pieces) ++counts[piece.low == 0 && piece.high == 1 ? 0 : 1];
  return counts;
}

// Turned, so that rounding leaves no wire in the plane of its face: always three faces face the eye.
TEST(RoundedWires, AreSeenOnTheirFaces) {
  const auto mesh = cube_with_wires([](const Point& p) -> Point {
    return {(2 * p[0] - 2 * p[1] + p[2]) / 3, (-0.4 * p[0] + p[1] + 2.8 * p[2]) / 3, (2.2 * p[0] + 2 * p[1] - 0.4 * p[2]) / 3};
  });
  const auto import = import_poly(mesh, {.mend = true});
  ASSERT_TRUE(import);
  ASSERT_EQ(import->scene.wires.size(), 6U);
  ASSERT_EQ(import->scene.surfaces.size(), 6U);
  scene::PolyCamera camera{false, {}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(wires_seen(import->scene, camera), (std::array<std::size_t, 2>{3, 0}));
  camera.forward = {0, 0, 1};
  EXPECT_EQ(wires_seen(import->scene, camera), (std::array<std::size_t, 2>{3, 0}));
}

// A tenth behind the face is behind it, if the file's numbers have one decimal.
TEST(RoundedWires, NumbersWithFewDecimalsAreExact) {
  scene::PolyMesh mesh = cube_with_wires([](const Point& p) -> Point { return p; });
  const scene::PolyCamera camera{false, {}, {-1, -1, -1}, {1, 0, -1}, {-1, 2, -1}};
  const auto seen = [&] {
    const auto import = import_poly(mesh, {.mend = true});
    EXPECT_TRUE(import);
    EXPECT_EQ(import->scene.step, 0.1);
    return wires_seen(import->scene, camera);
  };
  for (Point& p : mesh.vertices) p = {std::round(p[0] * 10) / 10, std::round(p[1] * 10) / 10, std::round(p[2] * 10) / 10};
  EXPECT_EQ(seen(), (std::array<std::size_t, 2>{3, 0}));
  for (const scene::VertexIndex v : mesh.wires[1]) mesh.vertices[v][2] = 2.9;
  EXPECT_EQ(seen(), (std::array<std::size_t, 2>{2, 0}));
}

// Anywhere, at a vertex, between two vertices of a face, or on the extension of the line through two.
PolyPoint random_end(Dice& dice, const PolyScene& scene, std::int32_t size) {
  const auto& body = scene.bodies[dice.below(scene.bodies.size())];
  const auto& ring = body.faces[dice.below(body.faces.size())].outline;
  const PolyPoint& p = scene.vertices[ring[dice.below(ring.size())]];
  const PolyPoint& q = scene.vertices[ring[dice.below(ring.size())]];
  PolyPoint end = p;
  const std::size_t kind = dice.below(4);
  if (kind == 0) return dice.point(-size / 2, size + size / 2);
  for (std::size_t a = 0; a < 3; ++a) {
    if (kind == 2) end[a] = (p[a] + q[a]) / 2;
    if (kind == 3) end[a] = 2 * q[a] - p[a];
  }
  return end;
}

PolyScene with_random_wires(const PolyScene& scene, std::uint32_t seed) {
  Dice dice(seed);
  std::int32_t size = 1;
  PolyScene result = scene;
  result.vertices.clear();
  scene::VertexPool<std::int32_t> pool(result.vertices);
  for (const PolyPoint& p : scene.vertices) {
    pool.add(p);
    for (const std::int32_t c : p) size = std::max(size, c);
  }
  for (std::int32_t w = dice.between(1, 6); w > 0; --w) {
    const PolyPoint a = random_end(dice, scene, size);
    const PolyPoint b = random_end(dice, scene, size);
    if (a != b) result.wires.push_back({pool.add(a), pool.add(b)});
  }
  return result;
}

TEST(RandomWireScenes, ExactAndOracleAgree) {
  std::size_t seen = 0;
  std::size_t hidden = 0;
  for (std::uint32_t seed = 1; seed <= 150; ++seed) {
    RandomScene random(seed);
    PolyScene scene = with_random_wires(random.scene(), seed);
    EXPECT_TRUE(scene::check_poly_scene(scene).empty());
    for (int view = 0; view < 3 && random.look(); ++view) {
      scene.camera = random.scene().camera;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", view " + std::to_string(view));
      const picture::LinePicture truth = oracle::visible_edges(scene, scene.camera);
      EXPECT_TRUE(exact::visible_edges(scene, scene.camera) == truth);
      const exact::EdgeMesh mesh = exact::make_edge_mesh(scene);
      for (const char* choice : {"all", "wire"}) {
        const picture::ChosenEdges chosen = picture::EdgeChooser(scene, *picture::edge_choice_named(choice)).at(scene.camera);
        EXPECT_TRUE(exact::visible_edges(mesh, scene.camera, &chosen) == oracle::visible_edges(scene, scene.camera, chosen)) << choice;
      }
      for (const scene::PolyWire& wire : scene.wires) {
        const auto pieces = seen_of(truth, std::min(wire[0], wire[1]), std::max(wire[0], wire[1]));
        (pieces.empty() ? hidden : seen) += 1;
      }
    }
  }
  EXPECT_GT(seen, 200U);
  EXPECT_GT(hidden, 200U);
}

}  // namespace
}  // namespace sightline::algorithms
