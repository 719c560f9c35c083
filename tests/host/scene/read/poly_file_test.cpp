// OFF, OBJ and JSON: the contents are read; every kind of error is reported with line or position.
#include "host/scene/read/poly_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/poly_json.hpp"
#include "tests/host/scene/poly_support.hpp"

namespace sightline::scene {
namespace {

constexpr std::string_view tetrahedron_off =
    "OFF # a comment\n\n4 4 6\n0 0 0\n10 0 0 # another\r\n0 10 0\n0 0 10\n"
    "3 0 2 1 255 0 0\n3 0 1 3\n3 1 2 3 0.5 0.5 0.5 1\n3 2 0 3\n";
constexpr std::string_view tetrahedron_obj =
    "# a comment\nmtllib x.mtl\nv 0 0 0\nv 10 0 0 1.0\nv 0 10 0\nv 0 0 10\nvn 0 0 1\nvt 0 0\n"
    "f 1/1/1 3//1 2/1\nf -4 -3 -1\nusemtl red\nf 2 3 \\\n 4\ns off\nf 3 1 4\n";

struct Damage {
  PolyFormat format;
  std::string text;
  std::string message;
};

TEST(ReadPoly, ATetrahedronIsTheSameInOffAndObj) {
  const PolyImport off = read(tetrahedron_off, PolyFormat::off);
  const PolyImport obj = read(tetrahedron_obj, PolyFormat::obj);
  EXPECT_EQ(off.scene.vertices, obj.scene.vertices);
  EXPECT_EQ(off.scene.bodies, obj.scene.bodies);
  EXPECT_EQ(off.scene.surfaces, obj.scene.surfaces);
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
  EXPECT_EQ(triangle("NCOFF", " 255 0 0 255 0 0 1"), plain);  // MeshLab
}

TEST(ReadPoly, ObjectsComeBeforeGroups) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const PolyScene groups =
      read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nv 1 0 2\nv 0 1 2\nv 0 0 3\nv 0 0 4\nv 1 0 4\nv 0 1 4\n"
           "f 1 2 3\ng left wing\nf 4 5 6\ng b\nf 8 9 10\ng left wing\nf 5 4 7\n",
           PolyFormat::obj)
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

TEST(ReadPoly, GroupsOfOneSurfaceAndMaterialsAreBorders) {
  const auto import = read_poly(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng base\nf 1 3 2\ng sides\nf 1 2 4\nusemtl red\nf 2 3 4\nf 3 1 4\n", "test",
      PolyFormat::obj, {.mend = true});
  ASSERT_TRUE(import) << import.error().message();
  ASSERT_EQ(import->scene.bodies.size(), 1U);
  EXPECT_FALSE(import->scene.bodies[0].sheet);
  EXPECT_EQ(import->scene.material_of, (std::vector<std::uint32_t>{0, 1, 2, 2}));
}

TEST(ReadPoly, IgnoredPartsOfAnObjAreCounted) {
  const auto import = read_poly(
      "mtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\ns off\np 1 2\np 2 3\ncurv 0 1\nl 2\nf 1 2 3\nvt 0 0\n", "test",
      PolyFormat::obj);
  ASSERT_TRUE(import) << import.error().message();
  EXPECT_EQ(import->report.notes, (std::vector<std::string>{"1 statement \"curv\"", "1 statement \"l\"", "2 statements \"p\""}));
}

// A triangle; lines of three and of two vertices, one of them a side of it.
TEST(ReadPoly, PolylinesOfAnObjAreWires) {
  const std::string text = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 9\nl -1/1 2/7 1\nf 1 2 3\nv 1 1 5\nl 5 4\n";
  const std::vector<PolyWire> tidy{{0, 1}, {1, 3}, {3, 4}};
  for (const bool mend : {false, true}) {
    const PolyImport import = read(text, PolyFormat::obj, mend);
    EXPECT_EQ(import.scene.wires, tidy);
    EXPECT_EQ(import.scene.vertices.size(), 5U);
    EXPECT_EQ(import.report.notes, std::vector<std::string>{});
    EXPECT_EQ(problems(import.scene), "");
  }
}

TEST(ReadPoly, AFileOfLinesAloneIsAScene) {
  for (const bool mend : {false, true}) {
    const PolyImport import = read("v 0 0 0\nv 1.5 2 3\nv 4 5 6\nl 1 2 3\n", PolyFormat::obj, mend);
    EXPECT_EQ(import.scene.wires, (std::vector<PolyWire>{{0, 1}, {1, 2}}));
    EXPECT_TRUE(import.scene.bodies.empty());
    EXPECT_EQ(problems(import.scene), "");
  }
}

// Geomview's manual: the keyword may be missing, and only colours depend on the end of a line.
TEST(ReadPoly, OffIsAStreamOfNumbers) {
  const std::string vertices = "0 0 0\n10 0 0\n0 10 0\n0 0 10\n";
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const auto blanks = [](std::string text) {
    for (char& c : text) c = c == '\n' ? ' ' : c;
    return text;
  };
  const auto lines = [](std::string text) {
    for (char& c : text) c = c == ' ' ? '\n' : c;
    return text;
  };
  const PolyScene expected = read("OFF\n4 4 6\n" + vertices + faces, PolyFormat::off).scene;
  const std::string texts[] = {
      "OFF4 4 6\n" + vertices + faces,
      "OFF 4 4\n" + vertices + faces,
      "off\n4 4 6\n" + vertices + faces,
      "4 4 6\n" + vertices + faces,
      "OFF\n4\n4\n6\n" + vertices + faces,
      "OFF\n4 4\n6\n" + vertices + faces,
      "OFF\n4 4 6\n" + blanks(vertices) + "\n" + faces,
      "OFF\n4 4 6\n" + lines(vertices) + faces,
      "OFF\n4 4 6\n" + vertices + blanks(faces),
      "OFF\n4 4 6\n" + vertices + lines(faces),
      lines("OFF 4 4 6\n" + vertices + faces),
      blanks("OFF 4 4 6\n" + vertices + faces),
      "OFF # a\n4 4 # b\n6\n0 0 0 10 0 0#c\n0 10 0 0 0 10\n" + faces,
      "OFF\r4 4 6\r0 0 0\r10 0 0\r0 10 0\r0 0 10\r3 0 2 1\r3 0 1 3\r3 1 2 3\r3 2 0 3\r",
      "NOFF 4 4 6\n" + blanks("0 0 0 1 0 0\n10 0 0 0 1 0\n0 10 0 0 0 1\n0 0 10 1 0 0\n") + faces,
  };
  for (const std::string& text : texts) EXPECT_EQ(read(text, PolyFormat::off).scene, expected) << text;
  // Vertices on one line, and faces over several lines with their colours: one material each.
  const auto coloured = read_poly("OFF 4 4 6 " + blanks(vertices) + "3 0\n2 1 255 0 0\n3 0 1\n3\n3 1 2 3 255 0 0\n3 2 0 3 0.5 1 1 1\n", "test",
                                  PolyFormat::off, {.mend = true});
  ASSERT_TRUE(coloured) << coloured.error().message();
  EXPECT_EQ(coloured->scene.material_of, (std::vector<std::uint32_t>{0, 1, 0, 2}));
  EXPECT_TRUE(coloured->scene.materials_are_colours);
  // A missing coordinate is not a different layout.
  EXPECT_FALSE(read_poly("OFF\n4 4 6\n0 0 0\n10 0\n0 10 0\n0 0 10\n" + faces, "test", PolyFormat::off, {.mend = true}));
}

TEST(ReadPoly, VariantsOfObjAreRead) {
  PolyScene expected = read(tetrahedron_obj, PolyFormat::obj).scene;
  expected.material_of.clear();
  const std::string vertices = "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\n";
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  std::string old = vertices + faces;
  for (char& c : old) c = c == '\n' ? '\r' : c;
  for (const std::string& text :
       {faces + vertices, old, vertices + "f 1 3\\\n 2\nf 1 2 \\ # more\n 4\nf 2 3 4\nfo 3 1 4\n",
        "v 0 0 0 1\nv 10 0 0 0.5 0.5 0.5\nv 0 10 0 1 0 0 1\nv 0 0 10\n" + faces, vertices + "f 1// 3//1 2/1/\n" + faces.substr(8)})
    EXPECT_EQ(read(text, PolyFormat::obj).scene, expected) << text;
}

// In each format that can have them; --strict names the first one.
TEST(ReadPoly, DegenerateFacesAreOmittedAndCounted) {
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                          "element face 4\nproperty list uchar int vertex_index\nproperty uchar red\nend_header\n";
  const std::vector<std::string> expected{"1 face with a coordinate that is no finite number", "2 faces of fewer than three vertices"};
  const Damage texts[] = {
      {PolyFormat::obj, "v 0 nan 0\nv 0 0 0\nv 9 0 0\nv 0 9 0\nf 2 3\nf 1 2 3\nf\nf 2 3 4\n",
       "test: line 1: found \"nan\", expected a finite number"},
      {PolyFormat::off, "OFF\n4 4 0\n0 0 0\n9 0 0\n0 9 0\n0 0 -Infinity\n2 0 1 1 1 1\n3 0 1 3\n1 2\n3 0 1 2\n",
       "test: line 6: found \"-Infinity\", expected a finite number"},
      {PolyFormat::ply, ply + "0 0 0\n9 0 0\n0 9 0\n0 0 inf\n2 0 1 7\n3 0 1 3 8\n0 9\n3 0 1 2 8\n",
       "test: line 14: found \"inf\", expected a finite number"},
  };
  for (const Damage& damage : texts) {
    const auto mended = read_poly(damage.text, "test", damage.format, {.mend = true});
    ASSERT_TRUE(mended) << mended.error().message();
    EXPECT_EQ(mended->report.notes, expected) << damage.text;
    ASSERT_EQ(mended->scene.bodies.size(), 1U);
    EXPECT_EQ(mended->scene.bodies[0].faces.size(), 1U);
    EXPECT_EQ(mended->scene.vertices.size(), 3U);
    const auto strict = read_poly(damage.text, "test", damage.format);
    ASSERT_FALSE(strict);
    EXPECT_EQ(strict.error().message(), damage.message);
  }
  const auto none = read_poly("v 0 0 0\nv 1 1 1\nf 1 2\n", "test", PolyFormat::obj, {.mend = true});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message(), "test: line 3: found 2 vertices, expected 3 or more");
  const auto alone = read_poly("v 0 0 0\nv 1 0 0\nv 0 1 0\nv inf 0 0\nf 1 2 3\n", "test", PolyFormat::obj, {.mend = true});
  ASSERT_TRUE(alone) << alone.error().message();
  EXPECT_EQ(alone->report.notes, (std::vector<std::string>{"1 vertex with a coordinate that is no finite number"}));
}

// The colours of the remaining faces are kept.
TEST(ReadPoly, MaterialsOfTheRemainingFaces) {
  const auto import = read_poly("OFF\n5 5 0\n0 0 0\n10 0 0\n0 10 0\n0 0 10\nnan 0 0\n3 0 1 4 9\n3 0 2 1 8\n3 0 1 3 7\n3 1 2 3 8\n3 2 0 3 6\n",
                                "test", PolyFormat::off, {.mend = true});
  ASSERT_TRUE(import) << import.error().message();
  EXPECT_EQ(import->scene.material_of, (std::vector<std::uint32_t>{1, 2, 1, 3}));
  const auto text = write_poly(import->scene, PolyFormat::json);
  ASSERT_TRUE(text);
  const auto again = read_poly(*text, "test", PolyFormat::json);
  ASSERT_TRUE(again) << again.error().message();
  PolyScene expected = import->scene;
  EXPECT_EQ(expected.face_in_file, (std::vector<std::uint32_t>{1, 2, 3, 4}));
  EXPECT_EQ(expected.vertex_in_file, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  expected.face_in_file = expected.vertex_in_file = {};  // the text numbers them alike
  EXPECT_EQ(again->scene, expected);
}

TEST(ReadPoly, ModelsHaveTheCountsOfTheirTable) {
  struct Model {
    const char* name;
    std::size_t vertices, edges, faces;
  };
  for (const Model& model : {Model{"squares", 192, 192, 48}, Model{"grid", 82, 105, 41}, Model{"objects", 388, 800, 416},
                             Model{"bars", 451, 880, 449}, Model{"tori", 512, 1024, 512}, Model{"spring", 909, 2709, 1800}}) {
    const auto text = builtin_scene_text(model.name);
    ASSERT_TRUE(text) << model.name;
    const PolyImport import = read(*text, PolyFormat::off);
    std::size_t faces = 0;
    std::set<std::pair<VertexIndex, VertexIndex>> edges;
    for (const PolyBody& body : import.scene.bodies) {
      faces += body.faces.size();
      for (const PolyFace& face : body.faces) {
        for (std::size_t i = 0; i < face.outline.size(); ++i)
          edges.insert(std::minmax(face.outline[i], face.outline[(i + 1) % face.outline.size()]));
      }
    }
    EXPECT_EQ(import.scene.vertices.size(), model.vertices) << model.name;
    EXPECT_EQ(faces, model.faces) << model.name;
    EXPECT_EQ(edges.size(), model.edges) << model.name;
    EXPECT_FALSE(import.report.quantised) << model.name;
    EXPECT_EQ(problems(import.scene), "") << model.name;
  }
}

TEST(ReadPoly, ErrorsAreReportedByLine) {
  const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n";
  const Damage damages[] = {
      {PolyFormat::off, "", "test: end of file: found no text, expected OFF"},
      {PolyFormat::off, "PLY\n", "test: line 1: found \"PLY\", expected OFF in the first line"},
      {PolyFormat::off, "4OFF\n",
       "test: line 1: found \"4OFF\", expected OFF, COFF, NOFF, CNOFF or STOFF: points of three dimensions"},
      {PolyFormat::off, "OFF BINARY\n", "test: line 1: found \"BINARY\", expected OFF as text"},
      {PolyFormat::off, "OFF\n3\n", "test: end of file: expected the numbers of vertices, faces and edges"},
      {PolyFormat::off, "OFF\n", "test: end of file: expected the numbers of vertices, faces and edges"},
      {PolyFormat::off, "OFF\n-3 1 0\n",
       "test: line 2: found \"-3\", expected a number of vertices or faces"},
      {PolyFormat::off, "OFF\n4000000000 1 0\n",
       "test: line 2: found \"4000000000\", expected a number of vertices or faces"},
      {PolyFormat::off, "OFF\n2000000000 1 0\n0 0 0\n",
       "test: end of file: found 1 vertices, expected 2000000000"},
      {PolyFormat::off, head + "0 x 0\n", "test: line 5: found \"x\", expected a number"},
      {PolyFormat::off, head + "0 nan 0\n3 0 1 2\n", "test: line 5: found \"nan\", expected a finite number"},
      {PolyFormat::off, head + "0 1e999 0\n3 0 1 2\n", "test: line 5: found \"1e999\", expected a finite number"},
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
      {PolyFormat::obj, "v 0 0 inf\n", "test: line 1: found \"inf\", expected a finite number"},
      {PolyFormat::obj, "v 0 0 0\nf 1 1\n", "test: line 2: found 2 vertices, expected 3 or more"},
      {PolyFormat::obj, "v 0 0 0\nf 1 3/1 2\nv 1 1 1\n",
       "test: line 2: found \"3/1\", expected a vertex 1..2 or the same from behind, -2..-1"},
      {PolyFormat::obj, "v 0 0 0\nf 1 0 1\n",
       "test: line 2: found \"0\", expected a vertex 1..1 or the same from behind, -1..-1"},
      {PolyFormat::obj, "v 0 0 0\nf 1 -2 1\n",
       "test: line 2: found \"-2\", expected a vertex 1..1 or the same from behind, -1..-1"},
      {PolyFormat::obj, "v 0 0 0\nf 1 1/x 1\n",
       "test: line 2: found \"1/x\", expected a vertex 1..1 or the same from behind, -1..-1"},
      {PolyFormat::json, "{\"vertices\":[[0,0,0]]}", "test: expected a field \"bodies\", found none"},
      {PolyFormat::obj, "v 0 0 0\nl 1 2\n",
       "test: line 2: found \"2\", expected a vertex 1..1 or the same from behind, -1..-1"},
      {PolyFormat::obj, "v 0 0 0\nl 1 1/x 1\n",
       "test: line 2: found \"1/x\", expected a vertex 1..1 or the same from behind, -1..-1"},
      {PolyFormat::json, R"({"vertices":[[0,0,0]],"bodies":[],"wires":[[0,1]]})",
       "test: wires[0][1]: expected an integer 0..0, found 1"},
      {PolyFormat::json, R"({"vertices":[[0,0,0]],"bodies":[],"wires":[[0]]})",
       "test: wires[0]: expected an array of 2, found an array of 1"},
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
    ASSERT_FALSE(result) << damage.text;
    EXPECT_EQ(result.error().message(), damage.message);
  }
}

TEST(ReadPoly, JsonWithoutACameraIsSeenFromOutside) {
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
  EXPECT_EQ(poly_format_of("b.Ply"), PolyFormat::ply);
  EXPECT_EQ(poly_format_of("b.stl"), PolyFormat::stl);
  EXPECT_EQ(poly_format_of("b.step"), std::nullopt);
}

}  // namespace
}  // namespace sightline::scene
