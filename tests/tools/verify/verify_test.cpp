// The verifier: proves the certificates of drawings, refutes those that are false, and rejects those that are malformed.
#include "tools/verify/verify.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <map>
#include <string>

#include "host/scene/generate/scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"
#include "tests/host/algorithms/exact/turned_solids.hpp"
#include "tests/support/effort.hpp"
#include "tests/tools/verify/certificate_scenes.hpp"
#include "tests/tools/verify/certificate_truth.hpp"

namespace sightline::tests {
namespace {

using scene::PolyCamera;
using verifier::Verdict;
using Kind = Verdict::Kind;

void expect_proved(const hidden_lines::Scene& scene, const PolyCamera& camera, const hidden_lines::EdgeOptions& edges = {}) {
  const Drawn drawn = draw_with_proof(scene, camera, edges);
  const Verdict verdict = verifier::verify(drawn.certificate);
  EXPECT_EQ(verdict.kind, Kind::proved) << scene.name << ": " << sentence(verdict);
  EXPECT_EQ(verdict.edges, drawn.edges) << scene.name;
  EXPECT_EQ(verdict.visible, drawn.pieces) << scene.name;
}

// From the front, from above, from the right and obliquely, without perspective.
std::array<PolyCamera, 4> standard_views(const scene::PolyScene& scene) {
  const scene::PolyPoint eye = scene::bounds_of(scene).middle();
  return {PolyCamera{false, eye, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, {false, eye, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
          {false, eye, {-1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {false, eye, {-1, -1, -1}, {1, 0, -1}, {-1, 2, -1}}};
}

void expect_proved_from_around(const scene::PolyScene& scene, std::uint32_t seed, int views, const hidden_lines::EdgeOptions& edges = {}) {
  const hidden_lines::Scene source = loaded(scene);
  algorithms::RandomCameras cameras(scene, seed);
  for (int i = 0; i < views; ++i) {
    expect_proved(source, cameras.outside(true), edges);
    expect_proved(source, cameras.outside(false), edges);
  }
  for (const PolyCamera& camera : standard_views(scene)) expect_proved(source, camera, edges);
}

TEST(Verify, ProvesBoxesBricksSheetsAndTowns) {
  for (std::uint32_t seed = 1; seed <= effort(6U, 2U); ++seed) {
    expect_proved_from_around(scene::generate_boxes(20, seed), seed, 3);
    expect_proved_from_around(scene::generate_bricks(10, seed), seed, 3);
    expect_proved_from_around(scene::generate_triangles(15, seed), seed, 3);
    expect_proved_from_around(scene::generate_town(5, seed), seed, 2);
  }
}

TEST(Verify, ProvesSolidsThatTouchAndViewsInLineWithThem) {
  for (const std::size_t n : {1U, 2U}) {
    for (scene::PolyScene scene : {scene::generate_touch(n), scene::generate_aligned(n)}) {
      for (auto& vertex : scene.vertices)
        for (std::int32_t& c : vertex) c /= 250;
      expect_proved_from_around(scene, 1, 6);
    }
  }
  expect_proved_from_around(scene::generate_edgeon(10), 1, 2);
}

TEST(Verify, ProvesRoomsFromWithinWithMuchBehindTheEye) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const scene::PolyScene scene = scene::generate_rooms(2, seed);
    algorithms::RandomCameras cameras(scene, seed);
    for (int i = 0; i < 6; ++i) expect_proved(loaded(scene), cameras.inside(1000));
  }
  const auto house = hidden_lines::load("house");
  ASSERT_TRUE(house);
  expect_proved(*house, house->scene.camera);
}

// Three bars, each over the next one.
TEST(Verify, ProvesACyclicOverlap) {
  scene::PolyScene scene;
  const auto bar = [&scene](std::vector<scene::PolyPoint> outline) { algorithms::add_sheet(scene, outline); };
  bar({{-60, -10, 100}, {60, -10, 160}, {60, 10, 160}, {-60, 10, 100}});
  bar({{20, -60, 100}, {40, -60, 100}, {40, 60, 160}, {20, 60, 160}});
  bar({{-40, 60, 100}, {-20, 60, 100}, {30, -60, 190}, {10, -60, 190}});
  expect_proved_from_around(scene, 3, 10);
  expect_proved(loaded(scene), {});
}

// A plate of hexagonal prisms, each a solid with six sides, that touch along their sides.
scene::PolyScene honeycomb(int columns, int rows) {
  scene::PolyScene scene;
  constexpr std::array<std::array<std::int32_t, 2>, 6> corners{{{20, 0}, {10, 17}, {-10, 17}, {-20, 0}, {-10, -17}, {10, -17}}};
  scene::PolyBody plate;
  // Vertices of the plate are shared by the cells; walls between two cells are faces of both.
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      const std::int32_t x = 30 * column;
      const std::int32_t y = 34 * row + (column % 2) * 17;
      const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
      for (const std::int32_t z : {0, 25})
        for (const auto& [dx, dy] : corners) scene.vertices.push_back({x + dx, y + dy, z});
      scene::PolyBody cell;
      scene::PolyFace low;
      scene::PolyFace high;
      for (scene::VertexIndex i = 0; i < 6; ++i) {
        const scene::VertexIndex next = (i + 1) % 6;
        cell.faces.push_back({{first + i, first + next, first + 6 + next, first + 6 + i}, {}});
        high.outline.push_back(first + 6 + i);
        low.outline.insert(low.outline.begin(), first + i);
      }
      cell.faces.push_back(low);
      cell.faces.push_back(high);
      scene.bodies.push_back(cell);
    }
  }
  return scene;
}

TEST(Verify, ProvesAHoneycombPlateInStandardViews) {
  const scene::PolyScene plate = honeycomb(effort(24, 6), effort(20, 5));
  for (const PolyCamera& camera : standard_views(plate)) expect_proved(loaded(plate), camera);
}

TEST(Verify, ProvesAThousandBoxes) {
  const scene::PolyScene scene = scene::generate_boxes(effort(1000U, 100U));
  expect_proved(loaded(scene), scene.camera);
  for (const PolyCamera& camera : standard_views(scene)) expect_proved(loaded(scene), camera);
}

TEST(Verify, ProvesSolidsThatPassThroughEachOther) {
  scene::PolyScene scene = scene::generate_boxes(6, 1);
  for (std::size_t v = 8; v < scene.vertices.size(); ++v)
    for (std::size_t a = 0; a < 3; ++a) scene.vertices[v][a] = scene.vertices[v - 8][a] + static_cast<std::int32_t>(a + 1) * 31;
  expect_proved_from_around(scene, 2, 10);
  expect_proved_from_around(scene, 3, 5, {"feature", 10});
}

TEST(Verify, ProvesMeshesWithChosenEdges) {
  std::size_t meshes = 0;
  for (const std::string folder : {SIGHTLINE_TEST_DATA "/drawing", SIGHTLINE_TEST_DATA "/meshes", SIGHTLINE_SOURCE_DIR "/host/scene/read/builtin"}) {
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      const auto mesh = hidden_lines::load(file.path().string());
      if (!mesh || mesh->scene.bodies.empty() || scene::face_count(mesh->scene) > 20000) continue;
      ++meshes;
      for (const PolyCamera& camera : standard_views(mesh->scene)) expect_proved(*mesh, camera);
      expect_proved(*mesh, mesh->scene.camera, {"all", {}});
    }
  }
  EXPECT_GE(meshes, 10U);
}

TEST(Verify, ProvesHardCases) {
  std::size_t cases = 0;
  for (const auto& file : std::filesystem::directory_iterator(std::string(SIGHTLINE_SOURCE_DIR) + "/host/compare/hard_cases/data")) {
    const auto given = hidden_lines::load(file.path().string());
    if (!given || scene::eye_error(given->scene, given->scene.camera)) continue;
    ++cases;
    expect_proved(*given, given->scene.camera);
    for (const PolyCamera& camera : standard_views(given->scene)) expect_proved(*given, camera);
  }
  EXPECT_GE(cases, 20U);
}

// Prisms in any direction through each other, read as a mesh: their faces are planar only to the accuracy of the grid, and the ends of
// their intersections are fractions.
TEST(Verify, ProvesTurnedPrismsThroughEachOtherAndLinesOnTheirFaces) {
  using namespace algorithms::turned_solids;
  Dice dice(5);
  std::size_t intersections = 0;
  for (int round = 0; round < effort(60, 10); ++round) {
    Solid solid;
    add_prism(solid, dice, {0, 0, 0});
    const auto first = solid.vertices.size();
    add_prism(solid, dice, {dice(-20, 20) / 10.0, dice(-20, 20) / 10.0, dice(-30, 10) / 10.0});
    const Matrix turn = random_turn(dice);
    for (std::size_t v = first; v < solid.vertices.size(); ++v) solid.vertices[v] = rotate(turn, solid.vertices[v]);
    scene::PolyMesh mesh;
    const Matrix whole = random_turn(dice);
    for (const Point& p : solid.vertices) mesh.vertices.push_back(rotate(whole, p));
    mesh.bodies.emplace_back();
    for (const auto& outline : solid.faces) {
      mesh.bodies[0].faces.push_back({outline, {}});
      mesh.wires.push_back({outline[0], outline[outline.size() / 2]});
    }
    const auto source = hidden_lines::load(mesh);
    ASSERT_TRUE(source) << source.error().message();
    algorithms::RandomCameras cameras(source->scene, static_cast<std::uint32_t>(round));
    for (const bool perspective : {true, false}) {
      const PolyCamera camera = cameras.outside(perspective);
      const Drawn drawn = draw_with_proof(*source, camera);
      const Verdict verdict = verifier::verify(drawn.certificate);
      EXPECT_EQ(verdict.kind, Kind::proved) << round << ": " << sentence(verdict);
      EXPECT_EQ(verdict.visible, drawn.pieces);
      for (std::size_t at = 0; (at = drawn.certificate.find("\nintersection", at)) != std::string::npos; ++at) ++intersections;
    }
  }
  EXPECT_GT(intersections, effort(200U, 20U));
}

// --- Certificates by hand: a triangle z = 100 before the line from vertex 3 to 4 at z = 200. The eye sees the triangle from x = -10 to 10
// where the line is, at y = 0, which is from x = -20 to 20 on the line: from 1/4 to 3/4 of it.

std::string triangle_and(const std::string& claims) {
  return "sightline-certificate 1\nview perspective\neye 0 0 0\nforward 0 0 1\nrightward 1 0 0\nupward 0 1 0\n"
         "vertex -20 -10 100\nvertex 20 -10 100\nvertex 0 10 100\nvertex -40 0 200\nvertex 40 0 200\nvertex 0 0 900\n"
         "sheet\nface 0 0 1 2\nwire 3 4\n" +
         claims + "end\n";
}

TEST(Verify, ByHand) {
  EXPECT_EQ(sentence(verifier::verify(triangle_and("both 1/4 3/4 0\n"))), "proved: 1 edges, 2 visible intervals, 0 edges hidden");
  EXPECT_EQ(sentence(verifier::verify(triangle_and("both 1/4 1/2 0\nboth 1/2 3/4 0\n"))), "proved: 1 edges, 2 visible intervals, 0 edges hidden");
  EXPECT_EQ(sentence(verifier::verify(triangle_and("left 1/4 3/4 0\nright 1/4 3/4 0\n"))), "proved: 1 edges, 2 visible intervals, 0 edges hidden");
  const std::string hidden = "line 15: face 0 hides a part that is claimed to be visible from the ";
  EXPECT_EQ(sentence(verifier::verify(triangle_and(""))), hidden + "left");
  EXPECT_EQ(sentence(verifier::verify(triangle_and("left 1/4 3/4 0\n"))), hidden + "right");
  EXPECT_EQ(sentence(verifier::verify(triangle_and("both 1/4 1/2 0\n"))), hidden + "left");
  EXPECT_EQ(sentence(verifier::verify(triangle_and("both 1/4 4/5 0\n"))), "line 16: the face does not hide the interval");
  EXPECT_EQ(sentence(verifier::verify(triangle_and("both 1/4 3/4 behind\n"))), "line 16: the interval is not behind the eye");
  EXPECT_EQ(sentence(verifier::verify(triangle_and("point\n"))), "line 15: the edge is not seen as a point");
  EXPECT_EQ(verifier::verify(triangle_and("turned\n")).kind, Kind::refuted);
  EXPECT_EQ(verifier::verify(triangle_and("both 1/4 3/4 1\n")).kind, Kind::malformed);
  EXPECT_EQ(verifier::verify(triangle_and("both 3/4 1/4 0\n")).kind, Kind::malformed);
  EXPECT_EQ(verifier::verify(triangle_and("both 1/4 3/4 0\npoint\n")).kind, Kind::malformed);
  EXPECT_EQ(verifier::verify(triangle_and("both 1/4 3/4 0\n") + "\n").kind, Kind::malformed);
  EXPECT_EQ(verifier::verify("").kind, Kind::malformed);
}

// Two squares through each other: z = 100 with |x| and |y| up to 20, and x = 0 with |y| up to 10 and z from 80 to 120. They meet from
// (0, -10, 100) to (0, 10, 100), and nothing is before that line.
TEST(Verify, AnIntersectionByHandLiesInBothFaces) {
  const auto verdict_of = [](const std::string& ends) {
    return sentence(verifier::verify("sightline-certificate 1\nview parallel\neye 0 0 0\nforward 1 0 1\nrightward 1 0 -1\nupward 0 1 0\n"
                                     "vertex -20 -20 100\nvertex 20 -20 100\nvertex 20 20 100\nvertex -20 20 100\n"
                                     "vertex 0 -10 80\nvertex 0 10 80\nvertex 0 10 120\nvertex 0 -10 120\n"
                                     "sheet\nface 0 0 1 2 3\nsheet\nface 1 4 5 6 7\nintersection 0 1 " + ends + "\nend\n"));
  };
  const std::string proved = "proved: 1 edges, 1 visible intervals, 0 edges hidden";
  EXPECT_EQ(verdict_of("0 -10 100 1 0 10 100 1"), proved);
  EXPECT_EQ(verdict_of("0 -30 300 3 0 70 700 7"), proved);
  EXPECT_EQ(verdict_of("0 -9 100 1 0 10 100 1"), proved) << "a part of it";
  const std::string refuted = "line 19: the intersection does not lie in both faces";
  EXPECT_EQ(verdict_of("0 -11 100 1 0 10 100 1"), refuted);
  EXPECT_EQ(verdict_of("0 -30 300 3 0 71 700 7"), refuted);
  EXPECT_EQ(verdict_of("1 -10 100 1 0 10 100 1"), refuted);
  EXPECT_EQ(verdict_of("0 -10 101 1 0 10 100 1"), refuted);
  EXPECT_EQ(verdict_of("0 -10 100 1 0 -10 100 1"), refuted) << "a point";
  EXPECT_EQ(verdict_of("0 -10 100 0 0 10 100 1"), "line 19: expected a positive denominator");
}

// --- Random changes

TEST(Verify, AcceptsNoChangeThatMakesACertificateFalse) {
  const std::vector<std::string> certificates = certificates_to_change();
  std::map<std::string, int> contain;
  for (const std::string& certificate : certificates) {
    ASSERT_EQ(verifier::verify(certificate).kind, Kind::proved);
    ASSERT_EQ(falsehood_in(certificate), "") << certificate;
    for (const char* what : {"\nleft ", "\nboth ", " behind\n", "\nturned\n", "\npoint\n", "\nintersection ", " on ", "\nsheet\n"})
      contain[what] += certificate.find(what) != std::string::npos ? 1 : 0;
  }
  for (const auto& [what, count] : contain) EXPECT_GT(count, 0) << what;
  Dice dice(20261128);
  std::map<Kind, int> verdicts;
  for (int i = 0; i < effort(4000, 400); ++i) {
    const std::string& certificate = certificates[static_cast<std::size_t>(dice(0, static_cast<std::int32_t>(certificates.size()) - 1))];
    const std::string other = changed(certificate, dice);
    if (other == certificate) continue;
    const Verdict verdict = verifier::verify(other);
    ++verdicts[verdict.kind];
    if (verdict.kind == Kind::proved) { EXPECT_EQ(falsehood_in(other), "") << other; }
  }
  for (const Kind kind : {Kind::proved, Kind::refuted, Kind::malformed}) EXPECT_GT(verdicts[kind], effort(200, 20));
}

}  // namespace
}  // namespace sightline::tests
