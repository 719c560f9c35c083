// OFF, OBJ and JSON: what they say is what is read; every kind of damage is named by line or place; what is
// written reads as the same scene; files with fractions are rounded once and told so.
#include "host/scene/poly_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "host/scene/generate_scene.hpp"
#include "host/scene/poly_builder.hpp"
#include "host/scene/poly_check.hpp"
#include "host/scene/read_poly_json.hpp"

namespace sightline::scene {
namespace {

PolyImport read(std::string_view text, PolyFormat format, bool mend = false) {
  auto result = read_poly(text, "test", format, {mend});
  if (const auto* error = std::get_if<SceneError>(&result)) {
    ADD_FAILURE() << error->message();
    return {};
  }
  return std::get<PolyImport>(result);
}

std::string written(const PolyScene& scene, PolyFormat format) {
  const auto text = write_poly(scene, format);
  if (const auto* error = std::get_if<SceneError>(&text)) {
    ADD_FAILURE() << error->message();
    return {};
  }
  return std::get<std::string>(text);
}

std::string problems(const PolyScene& scene) {
  std::string text;
  for (const SceneError& error : check_poly_scene(scene)) text += error.message() + "\n";
  return text;
}

constexpr std::string_view tetrahedron_off =
    "OFF # a comment\n\n4 4 6\n0 0 0\n10 0 0 # another\r\n0 10 0\n0 0 10\n"
    "3 0 2 1 255 0 0\n3 0 1 3\n3 1 2 3 0.5 0.5 0.5 1\n3 2 0 3\n";
constexpr std::string_view tetrahedron_obj =
    "# a comment\nmtllib x.mtl\nv 0 0 0\nv 10 0 0 1.0\nv 0 10 0\nv 0 0 10\nvn 0 0 1\nvt 0 0\n"
    "f 1/1/1 3//1 2/1\nf -4 -3 -1\nusemtl red\nf 2 3 \\\n 4\ns off\nf 3 1 4\n";

TEST(ReadPoly, ATetrahedronIsTheSameInOffAndObj) {
  const PolyImport off = read(tetrahedron_off, PolyFormat::off);
  const PolyImport obj = read(tetrahedron_obj, PolyFormat::obj);
  EXPECT_EQ(off.scene, obj.scene);
  EXPECT_EQ(problems(off.scene), "");
  EXPECT_EQ(off.scene.vertices, (std::vector<PolyPoint>{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}}));
  ASSERT_EQ(off.scene.bodies.size(), 1U);
  EXPECT_FALSE(off.scene.bodies[0].sheet);
  EXPECT_EQ(off.scene.bodies[0].faces[1].outline, (std::vector<VertexIndex>{0, 1, 3}));
  EXPECT_FALSE(off.report.quantised);
  EXPECT_EQ(off.scene.step, 1.0);
}

TEST(ReadPoly, OffVariantsWithColoursAndNormals) {
  const auto triangle = [](const std::string& head, const std::string& more) {
    return read(head + "\n3 1\n0 0 0" + more + "\n1 0 0" + more + "\n0 1 0" + more + "\n3 0 1 2\n",
                PolyFormat::off)
        .scene;
  };
  const PolyScene plain = triangle("OFF", "");
  EXPECT_TRUE(plain.bodies.at(0).sheet);
  EXPECT_EQ(triangle("COFF", " 1 0 0 1"), plain);
  EXPECT_EQ(triangle("NOFF", " 0 0 1"), plain);
  EXPECT_EQ(triangle("STCNOFF", " 0 0 1 1 0 0 1 0 0"), plain);
}

TEST(ReadPoly, ObjectsComeBeforeGroups) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const PolyScene groups =
      read(vertices + "f 1 2 3\ng left wing\nf 1 2 4\ng b\nf 1 3 4\ng left wing\nf 2 3 4\n", PolyFormat::obj)
          .scene;
  ASSERT_EQ(groups.bodies.size(), 3U);
  EXPECT_EQ(groups.bodies[0].name, "");
  EXPECT_EQ(groups.bodies[1].name, "left wing");
  EXPECT_EQ(groups.bodies[1].faces.size(), 2U);
  const PolyScene objects =
      read(vertices + "o all\ng a\nf 1 3 2\ng b\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", PolyFormat::obj).scene;
  ASSERT_EQ(objects.bodies.size(), 1U);
  EXPECT_EQ(objects.bodies[0].name, "all");
  EXPECT_FALSE(objects.bodies[0].sheet);
}

TEST(ReadPoly, ModelsHaveTheCountsOfTheirTable) {
  struct Model {
    const char* name;
    std::size_t vertices, faces;
  };
  for (const Model& model :
       {Model{"bars", 451, 449}, Model{"grid", 82, 41}, Model{"objects", 388, 416},
        Model{"spring", 909, 1800}, Model{"squares", 192, 48}, Model{"tori", 512, 512}}) {
    std::ifstream file(std::string(SIGHTLINE_TEST_DATA "/models/") + model.name + ".off", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const PolyImport import = read(text, PolyFormat::off);
    std::size_t faces = 0;
    for (const PolyBody& body : import.scene.bodies) faces += body.faces.size();
    EXPECT_EQ(import.scene.vertices.size(), model.vertices) << model.name;
    EXPECT_EQ(faces, model.faces) << model.name;
    EXPECT_FALSE(import.report.quantised) << model.name;
    EXPECT_EQ(problems(import.scene), "") << model.name;
  }
}

TEST(WritePoly, WhatIsWrittenReadsAsTheSameScene) {
  for (const std::string_view family : generator_names()) {
    const auto scene = std::get<PolyScene>(generate_scene(family, 3, 5));
    EXPECT_EQ(read(written(scene, PolyFormat::json), PolyFormat::json).scene, scene) << family;
    if (family == "rooms" || family == "big_rooms") continue;  // holes
    PolyScene obj = read(written(scene, PolyFormat::obj), PolyFormat::obj).scene;
    EXPECT_EQ(obj.vertices, scene.vertices) << family;
    EXPECT_EQ(obj.bodies, scene.bodies) << family;
    // OFF has no bodies: what touches hangs together, what does not is apart.
    if (family == "touch" || family == "bricks" || family == "corridors") continue;
    PolyScene off = read(written(scene, PolyFormat::off), PolyFormat::off).scene;
    EXPECT_EQ(off.vertices, scene.vertices) << family;
    ASSERT_EQ(off.bodies.size(), scene.bodies.size()) << family;
    for (std::size_t b = 0; b < off.bodies.size(); ++b) EXPECT_EQ(off.bodies[b].faces, scene.bodies[b].faces);
  }
}

// A wall with a hatch as triangles: its area, and no edge that its outline and hole do not have is left
// alone.
TEST(WritePoly, FacesWithHolesBecomeTriangles) {
  const PolyScene scene = generate_rooms(3);
  const PolyScene off = read(written(scene, PolyFormat::off), PolyFormat::off).scene;
  EXPECT_EQ(problems(off), "");
  EXPECT_EQ(off.vertices, scene.vertices);
  const auto area = [](const PolyScene& s) {
    double sum = 0;
    const auto ring_area = [&](const std::vector<VertexIndex>& ring) {
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

TEST(WritePoly, AFaceOfTooManyVerticesWithAHoleIsNamed) {
  PolyScene scene;
  PolyFace face;
  const auto add = [&](std::vector<VertexIndex>& ring, std::int32_t x, std::int32_t y) {
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
  const auto* error = std::get_if<SceneError>(&result);
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(error->place, "body 0, face 0");
}

// Names that are the same, look like a comment or a line that goes on, or are those of unnamed bodies.
TEST(WritePoly, ObjKeepsBodiesApart) {
  PolyScene scene = generate_boxes(6);
  const char* names[] = {"", "a  b", " a b ", "#1", "ends in \\", "body 0"};
  for (std::size_t b = 0; b < 6; ++b) scene.bodies[b].name = names[b];
  const PolyScene again = read(written(scene, PolyFormat::obj), PolyFormat::obj).scene;
  ASSERT_EQ(again.bodies.size(), 6U);
  const char* written_names[] = {"body 0", "a b", "body 2", "_1", "ends in _", "body 5"};
  for (std::size_t b = 0; b < 6; ++b) {
    EXPECT_EQ(again.bodies[b].name, written_names[b]);
    EXPECT_EQ(again.bodies[b].faces, scene.bodies[b].faces);
  }
}

// A hollow cube: OFF does not say that its two surfaces are one body.
TEST(WritePoly, ACavitySurvivesOff) {
  PolyBuilder builder;
  builder.add_box("outer", {0, 0, 0}, {10, 10, 10});
  builder.add_box("inner", {2, 2, 2}, {8, 8, 8});
  PolyScene scene = builder.take();
  for (PolyFace face : scene.bodies[1].faces) {
    std::reverse(face.outline.begin(), face.outline.end());
    scene.bodies[0].faces.push_back(face);
  }
  scene.bodies.pop_back();
  for (const bool mend : {false, true}) {
    const PolyImport again = read(written(scene, PolyFormat::off), PolyFormat::off, mend);
    EXPECT_EQ(problems(again.scene), "");
    ASSERT_EQ(again.scene.bodies.size(), 1U);
    EXPECT_EQ(again.scene.bodies[0].faces, scene.bodies[0].faces);
    EXPECT_EQ(again.report.turned_bodies, 0U);
  }
}

TEST(Quantise, DecimalFractionsLoseNothing) {
  const PolyImport import =
      read("OFF\n4 1 0\n0.25 0 0\n1 0.001 0\n1 1 0\n-0.3 1 0\n4 0 1 2 3\n", PolyFormat::off);
  EXPECT_TRUE(import.report.quantised);
  EXPECT_EQ(import.report.step, 0.001);
  EXPECT_EQ(import.report.largest_shift, 0.0);
  EXPECT_EQ(import.report.split_faces, 0U);
  EXPECT_EQ(import.scene.vertices[0], (PolyPoint{250, 0, 0}));
  EXPECT_EQ(import.scene.vertices[3], (PolyPoint{-300, 1000, 0}));
  EXPECT_EQ(written(import.scene, PolyFormat::off),
            "OFF\n4 1 0\n0.25 0 0\n1 0.001 0\n1 1 0\n-0.3 1 0\n4 0 1 2 3\n");
}

// Only of some steps below 1 does a whole number make 1.
TEST(Quantise, AStepOfAnySizeIsMultiplied) {
  const std::string end = ",\"vertices\":[[0,0,0],[10,0,0],[0,-3,0]],\"bodies\":[{\"faces\":[[0,1,2]]}]}";
  const auto after_origin = [&](const std::string& step) {
    const std::string text =
        written(read("{\"step\":" + step + end, PolyFormat::json).scene, PolyFormat::off);
    return text.substr(16, text.find("3 0 1 2") - 16);
  };
  EXPECT_EQ(after_origin("0.75"), "7.5 0 0\n0 -2.25 0\n");
  EXPECT_EQ(after_origin("0.7"), "7 0 0\n0 -2.0999999999999996 0\n");
  EXPECT_EQ(after_origin("0.1"), "1 0 0\n0 -0.3 0\n");
}

TEST(Quantise, OtherFilesAreRoundedToAPowerOfTwo) {
  const PolyImport import = read("OFF\n3 1 0\n0 0 0\n3.14159265 0 0\n0 1e-9 2\n3 0 1 2\n", PolyFormat::off);
  EXPECT_EQ(import.report.step, std::ldexp(1.0, -14));
  EXPECT_EQ(import.scene.vertices[1], (PolyPoint{51472, 0, 0}));  // 3.14159265 * 16384 = 51471.85
  EXPECT_LE(import.report.largest_shift, std::ldexp(1.0, -15));
  EXPECT_GT(import.report.largest_shift, 0.0);
  const PolyImport large = read("OFF\n3 1 0\n0 0 0\n1e300 0 0\n0 1e300 0\n3 0 1 2\n", PolyFormat::off);
  EXPECT_EQ(problems(large.scene), "");
  const PolyImport integers = read("OFF\n3 1 0\n0 0 0\n262144 0 0\n0 262144 0\n3 0 1 2\n", PolyFormat::off);
  EXPECT_EQ(integers.report.step, 4.0);
  EXPECT_EQ(integers.report.largest_shift, 0.0);
}

TEST(Quantise, ASceneFarAwayIsMovedFirst) {
  const PolyImport import =
      read("OFF\n3 1 0\n1000000.125 5000000 0\n1000001.125 5000000 0\n1000000.125 5000001.5 0.1\n3 0 1 2\n",
           PolyFormat::off);
  EXPECT_EQ(problems(import.scene), "");
  EXPECT_LT(import.report.step, 0.01);
  EXPECT_LE(import.report.largest_shift, import.report.step / 2);
  EXPECT_NE(import.scene.origin, (PolyPoint{0, 0, 0}));
}

TEST(Quantise, FacesThatAreNoLongerPlanarBecomeTriangles) {
  const PolyImport import =
      read("OFF\n4 1 0\n0 0 0\n1.23456789 0 0\n1.23456789 1 0.1\n0 1 0\n4 0 1 2 3\n", PolyFormat::off);
  EXPECT_EQ(import.report.split_faces, 1U);
  EXPECT_GT(import.report.largest_deviation, 0.01);
  EXPECT_LT(import.report.largest_deviation, 0.1);
  EXPECT_EQ(import.scene.bodies[0].faces.size(), 2U);
  EXPECT_EQ(problems(import.scene), "");
}

TEST(Quantise, PointsThatFallTogetherBecomeOne) {
  const PolyImport import =
      read("OFF\n5 2 0\n0 0 0\n100000.7 0 0\n0 100000.7 0\n0 0 0.000001\n7 7 7\n3 0 1 2\n3 0 1 3\n",
           PolyFormat::off);
  EXPECT_EQ(import.report.merged_vertices, 1U);
  EXPECT_EQ(import.report.dropped_faces, 1U);
  // What was wrong with the file itself is not hidden.
  EXPECT_EQ(problems(import.scene), "vertex 3: is not used by any face\n");
}

TEST(Mend, MergesEqualVerticesDropsUnusedOnesAndTurnsBodies) {
  const std::string text =
      "OFF\n6 4 0\n0 0 0\n10 0 0\n0 10 0\n0 0 10\n10 0 0\n99 99 99\n"
      "3 1 2 0\n3 3 4 0\n3 3 2 1\n3 3 0 2\n";
  const PolyImport as_it_is = read(text, PolyFormat::off);
  EXPECT_EQ(problems(as_it_is.scene),
            "vertex 5: is not used by any face\nvertex 4: is the same point (10, 0, 0) as vertex 1\n");
  const PolyImport mended = read(text, PolyFormat::off, true);
  EXPECT_EQ(problems(mended.scene), "");
  EXPECT_EQ(mended.report.merged_vertices, 1U);
  EXPECT_EQ(mended.report.dropped_vertices, 1U);
  EXPECT_EQ(mended.report.turned_bodies, 1U);
  EXPECT_FALSE(mended.scene.bodies[0].sheet);
}

struct Damage {
  PolyFormat format;
  std::string text;
  std::string message;
};

TEST(ReadPoly, DamageIsNamedByLine) {
  const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n";
  const Damage damages[] = {
      {PolyFormat::off, "", "test: end of file: found no text, expected OFF"},
      {PolyFormat::off, "PLY\n", "test: line 1: found \"PLY\", expected OFF in the first line"},
      {PolyFormat::off, "4OFF\n",
       "test: line 1: found \"4OFF\", expected OFF, COFF, NOFF, CNOFF or STOFF: points of three dimensions"},
      {PolyFormat::off, "OFF BINARY\n", "test: line 1: found \"BINARY\", expected OFF as text"},
      {PolyFormat::off, "OFF\n3\n", "test: line 2: expected the numbers of vertices, faces and edges"},
      {PolyFormat::off, "OFF\n", "test: end of file: expected the numbers of vertices, faces and edges"},
      {PolyFormat::off, "OFF\n-3 1 0\n",
       "test: line 2: found \"-3\", expected a number of vertices or faces"},
      {PolyFormat::off, "OFF\n4000000000 1 0\n",
       "test: line 2: found \"4000000000\", expected a number of vertices or faces"},
      {PolyFormat::off, "OFF\n2000000000 1 0\n0 0 0\n",
       "test: end of file: found 1 vertices, expected 2000000000"},
      {PolyFormat::off, head + "0 x 0\n", "test: line 5: found \"x\", expected a number"},
      {PolyFormat::off, head + "0 nan 0\n", "test: line 5: found \"nan\", expected a number"},
      {PolyFormat::off, head + "0 1e999 0\n", "test: line 5: found \"1e999\", expected a number"},
      {PolyFormat::off, head + "0 1\n", "test: line 5: found 2 numbers, expected x, y and z"},
      {PolyFormat::off, head + "0 1 0\n", "test: end of file: found 0 faces, expected 1"},
      {PolyFormat::off, head + "0 1 0\n2 0 1\n",
       "test: line 6: found \"2\", expected how many vertices the face has, 3 or more"},
      {PolyFormat::off, head + "0 1 0\n4 0 1 2\n", "test: line 6: found 3 vertices, expected 4"},
      {PolyFormat::off, head + "0 1 0\n3 0 1 3\n", "test: line 6: found \"3\", expected a vertex below 3"},
      {PolyFormat::off, head + "0 1 0\n3 0 1 -1\n", "test: line 6: found \"-1\", expected a vertex below 3"},
      {PolyFormat::off, head + "0 1 0\n3 0 1 2\n3 0 1 2\n",
       "test: line 7: found \"3\", expected nothing after the last face"},
      {PolyFormat::off, std::string("O\x80\x01\n"),
       "test: line 1: found \"O??\", expected OFF in the first line"},
      {PolyFormat::obj, "", "test: end of file: found no vertices, expected lines \"v x y z\""},
      {PolyFormat::obj, "v 0 0\n", "test: line 1: found 2 numbers, expected x, y and z"},
      {PolyFormat::obj, "v 0 0 inf\n", "test: line 1: found \"inf\", expected a number"},
      {PolyFormat::obj, "v 0 0 0\nl 1 1\n",
       "test: line 2: found \"l\", expected faces only: what has no area can be drawn but cannot hide"},
      {PolyFormat::obj, "v 0 0 0\nf 1 1\n", "test: line 2: found 2 vertices, expected 3 or more"},
      {PolyFormat::obj, "v 0 0 0\nf 1 0 1\n",
       "test: line 2: found \"0\", expected a vertex 1..1 or the same from behind, -1..-1"},
      {PolyFormat::obj, "v 0 0 0\nf 1 -2 1\n",
       "test: line 2: found \"-2\", expected a vertex 1..1 or the same from behind, -1..-1"},
      {PolyFormat::obj, "v 0 0 0\nf 1 1/x 1\n",
       "test: line 2: found \"1/x\", expected a vertex 1..1 or the same from behind, -1..-1"},
      {PolyFormat::json, "{\"vertices\":[[0,0,0]]}", "test: expected a field \"bodies\", found none"},
      {PolyFormat::json, "[]", "test: expected an object, found an array of 0"},
      {PolyFormat::json, "{\"vertices\":[[0,0.5,0]],\"bodies\":[]}",
       "test: vertices[0][1]: expected an integer -262143..262143, found 0.5"},
      {PolyFormat::json, "{\"vertices\":[[0,0,262144]],\"bodies\":[]}",
       "test: vertices[0][2]: expected an integer -262143..262143, found 262144"},
      {PolyFormat::json, "{\"vertices\":[[0,0,0]],\"bodies\":[{\"faces\":[[0,0,1]]}]}",
       "test: bodies[0].faces[0][2]: expected an integer 0..0, found 1"},
      {PolyFormat::json, "{\"vertices\":[[0,0,0]],\"bodies\":[{\"faces\":[{\"outline\":[0,0]}]}]}",
       "test: bodies[0].faces[0].outline: expected an array of 3 or more, found an array of 2"},
      {PolyFormat::json, "{\"vertices\":[],\"bodies\":[{\"faces\":[],\"sheet\":1}]}",
       "test: bodies[0].sheet: expected true or false, found 1"},
      {PolyFormat::json, "{\"vertices\":[],\"bodies\":[],\"step\":0}",
       "test: step: expected a number above 0, found 0"},
      {PolyFormat::json, "{\"vertices\":[[0,0,9]],\"bodies\":[],\"step\":1e308}",
       "test: step: expected a step that leaves every coordinate finite, found 1e+308"},
      {PolyFormat::json, "{\"vertices\":[],\"bodies\":[],\"camera\":{\"eye\":[0,0,0]}}",
       "test: camera: expected a field \"forward\", found none"},
      {PolyFormat::json, "{\"vertices\":[],\"bodies\":[],\"name\":7}",
       "test: name: expected a string of up to 200 printable ASCII characters, found 7"},
  };
  for (const Damage& damage : damages) {
    const auto result = read_poly(damage.text, "test", damage.format);
    const auto* error = std::get_if<SceneError>(&result);
    ASSERT_NE(error, nullptr) << damage.text;
    EXPECT_EQ(error->message(), damage.message);
  }
}

TEST(ReadPoly, JsonWithoutACameraIsLookedAtFromOutside) {
  const PolyScene scene =
      read("{\"vertices\":[[0,0,0],[8,0,0],[0,8,0]],\"bodies\":[{\"faces\":[[0,1,2]]}]}", PolyFormat::json)
          .scene;
  EXPECT_TRUE(scene.bodies[0].sheet);
  EXPECT_TRUE(scene.camera.perspective);
  EXPECT_GT(scene.camera.eye[2], 8);
  EXPECT_EQ(problems(scene), "");
  EXPECT_TRUE(is_poly_json("{\"bodies\":[]}"));
  EXPECT_FALSE(is_poly_json("{\"cells\":[]}"));
  EXPECT_FALSE(is_poly_json("{\"bodies\":"));
}

TEST(PolyFormats, AreKnownByTheEndOfTheName) {
  EXPECT_EQ(poly_format_of("a/b.OFF"), PolyFormat::off);
  EXPECT_EQ(poly_format_of("b.obj"), PolyFormat::obj);
  EXPECT_EQ(poly_format_of("b.json"), PolyFormat::json);
  EXPECT_EQ(poly_format_of("off"), std::nullopt);
  EXPECT_EQ(poly_format_of("b.ply"), std::nullopt);
}

}  // namespace
}  // namespace sightline::scene
