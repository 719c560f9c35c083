// OFF, OBJ and JSON: a written scene is read back unchanged, as far as the format can express it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/read/poly_file.hpp"
#include "tests/host/scene/poly_support.hpp"

namespace sightline::scene {
namespace {

TEST(WritePoly, AWrittenSceneIsReadBackUnchanged) {
  for (const std::string_view family : generator_names()) {
    const auto scene = *generate_scene(family, 3, 5);
    EXPECT_EQ(read(scene_text(scene, PolyFormat::json), PolyFormat::json).scene, scene) << family;
    if (family == "rooms" || family == "big_rooms") continue;  // holes
    PolyScene obj = read(scene_text(scene, PolyFormat::obj), PolyFormat::obj).scene;
    EXPECT_EQ(obj.vertices, scene.vertices) << family;
    EXPECT_EQ(obj.bodies, scene.bodies) << family;
    // OFF has no bodies: touching parts become one body, others are separate.
    if (family == "touch" || family == "bricks" || family == "corridors") continue;
    PolyScene off = read(scene_text(scene, PolyFormat::off), PolyFormat::off).scene;
    EXPECT_EQ(off.vertices, scene.vertices) << family;
    ASSERT_EQ(off.bodies.size(), scene.bodies.size()) << family;
    for (std::size_t b = 0; b < off.bodies.size(); ++b) EXPECT_EQ(off.bodies[b].faces, scene.bodies[b].faces);
  }
}

TEST(WritePoly, WiresAreKeptByObjAndJsonAndRejectedByTheOthers) {
  PolyScene scene = generate_triangles(1);
  scene.vertices.push_back({7, 8, 9});
  scene.wires = {{0, 1}, {2, 3}};
  scene.surfaces = {{{0, 0, 1}}};
  scene.surface_of = {0};
  scene.wires_on = {{1, 0}};
  ASSERT_EQ(problems(scene), "");
  EXPECT_EQ(read(scene_text(scene, PolyFormat::json), PolyFormat::json).scene, scene);
  EXPECT_EQ(read(scene_text(scene, PolyFormat::obj), PolyFormat::obj).scene.wires, scene.wires);
  for (const PolyFormat format : {PolyFormat::off, PolyFormat::stl, PolyFormat::ply}) {
    const auto text = write_poly(scene, format);
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().message(),
              "has 2 lines without faces, for which this format has no place, expected a scene of faces alone; JSON and OBJ keep the lines");
  }
  const PolyScene faces = without_wires(scene);
  EXPECT_EQ(faces.vertices, (std::vector<PolyPoint>(scene.vertices.begin(), scene.vertices.end() - 1)));
  EXPECT_EQ(faces.bodies, scene.bodies);
  EXPECT_EQ(problems(faces), "");
}

// A wall with a hatch as triangles: its area is unchanged, and only edges of its outline and hole belong to a single triangle.
TEST(WritePoly, FacesWithHolesBecomeTriangles) {
  const PolyScene scene = generate_rooms(3);
  const PolyScene off = read(scene_text(scene, PolyFormat::off), PolyFormat::off, true).scene;  // the faces of its sheets do not agree
  EXPECT_EQ(problems(off), "");
  EXPECT_EQ(off.vertices, scene.vertices);
  const auto area = [](const PolyScene& s) {
    double sum = 0;
    const auto ring_area = [&](const Ring& ring) {
      double n[3]{};
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const PolyPoint& p = s.vertices[ring[i]];
        const PolyPoint& q = s.vertices[ring[(i + 1) % ring.size()]];
        for (std::size_t a = 0; a < 3; ++a)
          n[a] += 0.5 * (1.0 * p[(a + 1) % 3] * q[(a + 2) % 3] - 1.0 * p[(a + 2) % 3] * q[(a + 1) % 3]);
      }
      return std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    };
    for (const PolyBody& body : s.bodies) {
      for (const PolyFace& face : body.faces) {
        sum += ring_area(face.outline);
        for (const auto& hole : face.holes) sum -= ring_area(hole);
      }
    }
    return sum;
  };
  EXPECT_DOUBLE_EQ(area(off), area(scene));
}

TEST(WritePoly, AFaceOfTooManyVerticesWithAHoleIsAnError) {
  PolyScene scene;
  PolyFace face;
  const auto add = [&](Ring& ring, std::int32_t x, std::int32_t y) {
    ring.push_back(static_cast<VertexIndex>(scene.vertices.size()));
    scene.vertices.push_back({x, y, 0});
  };
  for (std::int32_t i = 0; i <= 600; ++i) add(face.outline, i, i * i);
  for (std::int32_t i = 600; i-- > 0;) add(face.outline, i, 600 * i + (600 - i) * i);
  face.holes.emplace_back();
  for (const auto& [x, y] : {std::array{300, 100000}, std::array{300, 100001}, std::array{301, 100001}})
    add(face.holes[0], x, y);
  scene.bodies = {{"", true, {face}}};
  const auto result = write_poly(scene, PolyFormat::off);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().place, "body 0, face 0");
}

// Names that are equal, that look like a comment or a continued line, or that equal those of unnamed bodies.
TEST(WritePoly, ObjKeepsBodiesApart) {
  PolyScene scene = generate_boxes(6);
  const char* names[] = {"", "a  b", " a b ", "#1", "ends in \\", "body 0"};
  for (std::size_t b = 0; b < 6; ++b) scene.bodies[b].name = names[b];
  const PolyScene again = read(scene_text(scene, PolyFormat::obj), PolyFormat::obj).scene;
  ASSERT_EQ(again.bodies.size(), 6U);
  const char* written_names[] = {"body 0", "a b", "body 2", "_1", "ends in _", "body 5"};
  for (std::size_t b = 0; b < 6; ++b) {
    EXPECT_EQ(again.bodies[b].name, written_names[b]);
    EXPECT_EQ(again.bodies[b].faces, scene.bodies[b].faces);
  }
}

// OFF does not record that its two surfaces are one body.
TEST(WritePoly, ACavitySurvivesOff) {
  const PolyScene scene = hollow_box();
  for (const bool mend : {false, true}) {
    const PolyImport again = read(scene_text(scene, PolyFormat::off), PolyFormat::off, mend);
    EXPECT_EQ(problems(again.scene), "");
    ASSERT_EQ(again.scene.bodies.size(), 1U);
    EXPECT_EQ(again.scene.bodies[0].faces, scene.bodies[0].faces);
    EXPECT_EQ(again.report.faces.turned_faces, 0U);
  }
}

}  // namespace
}  // namespace sightline::scene
