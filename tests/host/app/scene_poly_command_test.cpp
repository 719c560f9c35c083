// `sightline scene` with polyhedra: generate, convert, check, info; errors in files.
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::has;
using sightline::test::Ran;

class ScenePolyCommand : public sightline::test::CommandLine {};

TEST_F(ScenePolyCommand, GenerateConvertAndInfo) {
  EXPECT_EQ(sightline({"scene", "generate", "boxes", "10", "-o", "b.json"}).exit_code, 0);
  EXPECT_EQ(sightline({"scene", "generate", "boxes", "10"}).out, read("b.json"));
  EXPECT_EQ(sightline({"scene", "convert", "b.json", "-o", "b.off"}).exit_code, 0);
  EXPECT_EQ(sightline({"scene", "convert", "b.off", "-o", "b.obj"}).exit_code, 0);
  for (const char* file : {"b.json", "b.off", "b.obj"}) {
    const json info = json::parse(sightline({"scene", "info", "--json", file}).out);
    EXPECT_EQ(info.at("vertices"), 80) << file;
    EXPECT_EQ(info.at("edges"), 120) << file;
    EXPECT_EQ(info.at("faces"), 60) << file;
    EXPECT_EQ(info.at("bodies"), 10) << file;
    EXPECT_EQ(info.at("sheets"), 0) << file;
    EXPECT_TRUE(has(sightline({"scene", "check", file}).out, "a possible scene"));
  }
}

TEST_F(ScenePolyCommand, ABuiltInSceneAsPolyhedra) {
  EXPECT_EQ(sightline({"scene", "convert", "roberts", "-o", "r.obj"}).exit_code, 0);
  EXPECT_EQ(sightline({"scene", "check", "r.obj"}).exit_code, 0);
}

TEST_F(ScenePolyCommand, RoundingIsReported) {
  write("f.off", "OFF\n3 1 0\n0 0 0.123456789\n1 0 0\n0 1 0\n3 0 1 2\n");
  const Ran check = sightline({"scene", "check", "f.off"});
  EXPECT_EQ(check.exit_code, 0);
  EXPECT_TRUE(has(check.err, "rounded to a step of")) << check.err;
  write("f.off", "OFF\n3 1 0\n0 0 0.25\n1 0 0\n0 1 0\n3 0 1 2\n");
  const Ran exact = sightline({"scene", "check", "f.off"});
  EXPECT_EQ(exact.err, "") << "multiples of 0.01 are exact";
}

TEST_F(ScenePolyCommand, AFormatIsRecognisedByItsTextIfTheNameHasNoKnownEnding) {
  write("off.txt", "# a triangle\n\nOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write("obj.txt", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const char* file : {"off.txt", "obj.txt"}) {
    const Ran info = sightline({"scene", "info", file});
    EXPECT_EQ(info.exit_code, 0) << info.err;
    EXPECT_TRUE(has(info.out, "vertices       3")) << info.out;
    EXPECT_FALSE(has(info.out, "name"));
  }
  EXPECT_EQ(sightline({"draw", "exact", "-", "-o", "t.svg"}, read("obj.txt")).exit_code, 0);
  EXPECT_TRUE(exists("t.svg"));
  EXPECT_TRUE(has(sightline({"scene", "info", "-"}, "{").err, "standard input: line 1"));
  write("nothing.txt", "words\n");
  EXPECT_TRUE(has(sightline({"scene", "info", "nothing.txt"}).err, "nothing.txt: found no known format, expected STL"));
}

TEST_F(ScenePolyCommand, ErrorsAreNamedAndNothingIsWritten) {
  write("twisted.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 1\n0 1 0\n4 0 1 2 3\n");
  const Ran check = sightline({"scene", "check", "twisted.off"});
  EXPECT_EQ(check.exit_code, 4);
  EXPECT_TRUE(has(check.err, "twisted.off: body 0, face 0: vertex 3")) << check.err;
  EXPECT_EQ(sightline({"scene", "convert", "twisted.off", "--strict", "-o", "out.json"}).exit_code, 4);
  EXPECT_FALSE(exists("out.json"));
  write("empty.off", "");
  EXPECT_EQ(sightline({"scene", "info", "empty.off"}).exit_code, 4);
  EXPECT_EQ(sightline({"scene", "check", "missing.off"}).exit_code, 5);
  EXPECT_EQ(sightline({"scene", "check", "."}).exit_code, 5);
  EXPECT_EQ(sightline({"scene", "generate", "castles", "1"}).exit_code, 2);
  EXPECT_EQ(sightline({"scene", "generate", "rooms", "1000"}).exit_code, 2);
  const std::vector<sightline::test::Arguments> no_numbers{
      {"scene", "generate", "boxes", "-1"},
      {"scene", "generate", "boxes", "3", "--seed", "-1"},
      {"scene", "generate", "boxes", "3", "--seed", "18446744073709551616"},
      {"sweep", "boxes-2", "--views", "1", "--seed", "-7"}};
  for (const auto& arguments : no_numbers) {
    const Ran ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 2) << arguments.back();
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(has(ran.err, "found \"" + arguments.back() +
                                 "\", expected a whole number from 0 to 18446744073709551615"))
        << ran.err;
  }
  EXPECT_EQ(sightline({"scene", "generate", "rooms", "2", "-o", "x.step"}).exit_code, 2);
  EXPECT_EQ(sightline({"scene", "generate", "rooms", "2", "-o", "no/x.json"}).exit_code, 5);
}

TEST_F(ScenePolyCommand, MendRepairs) {
  write("double.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n3 0 1 2\n");
  EXPECT_EQ(sightline({"scene", "convert", "double.off", "--strict", "-o", "d.off"}).exit_code, 4);
  const Ran mended = sightline({"scene", "convert", "double.off", "-o", "d.off"});
  EXPECT_EQ(mended.exit_code, 0) << mended.err;
  EXPECT_EQ(read("d.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
}

// Each file is a box of 10 x 6 x 4 units: tests/data/meshes/README.md.
TEST_F(ScenePolyCommand, ABoxWrittenInManyWays) {
  struct Box {
    const char* file;
    int faces, edges, sheets;
    const char* said;
  };
  for (const Box& box : {Box{"stl-bom.stl", 12, 18, 0, ""}, Box{"off-bom.off", 6, 12, 0, ""}, Box{"obj-bom.obj", 6, 12, 0, ""},
                         Box{"stl-trailing-bytes.stl", 12, 18, 0, "37 bytes after the last triangle passed over"},
                         Box{"off-glued.off", 6, 12, 0, ""}, Box{"ply-tristrips.ply", 12, 18, 0, ""},
                         Box{"stl-nan-vertex.stl", 11, 18, 1, "1 face with a coordinate that is no finite number passed over"},
                         Box{"obj-two-vertex-face.obj", 6, 12, 0, "1 face of fewer than three vertices passed over"}}) {
    const std::string file = std::string(SIGHTLINE_TEST_DATA "/meshes/") + box.file;
    const Ran ran = sightline({"scene", "info", "--json", file});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(sightline({"scene", "info", file}).err, *box.said == '\0' ? "" : std::string("sightline: warning: mended: ") + box.said + "\n");
    const json info = json::parse(ran.out);
    EXPECT_EQ(info.at("bounds"), json::parse("[[0,0,0],[10,6,4]]")) << box.file;
    EXPECT_EQ(info.at("vertices"), 8) << box.file;
    EXPECT_EQ(info.at("faces"), box.faces) << box.file;
    EXPECT_EQ(info.at("edges"), box.edges) << box.file;
    EXPECT_EQ(info.at("sheets"), box.sheets) << box.file;
    EXPECT_EQ(info.at("surfaces"), 6) << box.file;
  }
}

const std::string drawing_data = std::string(SIGHTLINE_TEST_DATA) + "/drawing/";

// A cube with a vertex of one side on the edge of another face: nine edges are visible, each 10 sqrt(2/3) long.
TEST_F(ScenePolyCommand, AVertexOnAnEdgeOfAnotherFace) {
  const std::string cube = drawing_data + "t-vertex-cube.obj";
  const Ran info = sightline({"scene", "info", cube});
  EXPECT_TRUE(has(info.out, "1 solid, 0 sheets")) << info.out;
  EXPECT_TRUE(has(info.out, "6 planes")) << info.out;
  EXPECT_EQ(info.err, "sightline: warning: mended: 1 edge divided at vertices of other faces\n");
  EXPECT_TRUE(has(sightline({"scene", "check", cube}).err, "1 edge divided at vertices of other faces"));
  const Ran drawn = sightline({"draw", "exact", cube, "--view", "iso", "--json", "-o", "c.svg"});
  EXPECT_TRUE(has(drawn.out, "\"visible_length\": 73.4846922")) << drawn.out;
  EXPECT_FALSE(has(drawn.out, "\"boundary\"")) << drawn.out;
}

TEST_F(ScenePolyCommand, FarFromTheOriginIsDrawnAsNearIt) {
  for (const char* view : {"iso", "front", "trimetric"}) {
    for (const char* name : {"near", "far-from"}) {
      const Ran ran = sightline({"draw", "exact", drawing_data + name + "-origin.obj", "--vertical", "z", "--view", view, "-o",
                                 std::string(name) + ".plt"});
      ASSERT_EQ(ran.exit_code, 0) << ran.err;
    }
    EXPECT_EQ(read("near.plt"), read("far-from.plt")) << view;
  }
  // Points are those of the file, to the last decimal.
  const std::string far = drawing_data + "far-from-origin.obj";
  EXPECT_TRUE(has(sightline({"scene", "info", far}).out,
                  "x 500123416..500123496  y 5412345638..5412345718  z 310250..310320"));
  const Ran eye = sightline({"draw", "exact", far, "--vertical", "z", "--eye", "500123456,5412345478.123,310400", "--json", "-o", "e.svg"});
  ASSERT_EQ(eye.exit_code, 0) << eye.err;
  EXPECT_TRUE(has(eye.out, "500123456.0,\n      5412345478.123,\n      310400.0")) << eye.out;
  const Ran inside = sightline({"draw", "exact", far, "--eye", "500123456,5412345678,310280", "-o", "e.svg"});
  EXPECT_TRUE(has(inside.err, "the eye 500123456,5412345678,310280 is inside this solid")) << inside.err;
}

TEST_F(ScenePolyCommand, TheErrorForAnOpenPartNamesTheDistanceThatClosesIt) {
  write("gap.off", "OFF\n7 4 0\n0 0 0\n10 0 0\n0 10 0\n0 0 10\n0.03 0 0\n10 0 0.02\n0 0.01 10\n3 0 2 1\n3 4 5 6\n3 1 2 3\n3 0 3 2\n");
  const Ran ran = sightline({"scene", "info", "gap.off"});
  EXPECT_TRUE(has(ran.err, "sightline: warning: 2 parts are open; --weld 0.05 closes them\n")) << ran.err;
  EXPECT_TRUE(has(sightline({"scene", "info", "gap.off", "--weld", "0.05"}).out, "1 solid, 0 sheets"));
}

// A pipe can be read once.
TEST_F(ScenePolyCommand, SceneFromAPipe) {
  const std::string polyhedra = sightline({"scene", "generate", "boxes", "2"}).out;
  ASSERT_EQ(mkfifo(path("p").c_str(), 0600), 0);
  for (const char* action : {"check", "info", "convert"}) {
    std::thread writer([&] { std::ofstream(path("p"), std::ios::binary) << polyhedra; });
    const Ran ran = sightline({"scene", action, "p"});
    writer.join();
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
  }
}

}  // namespace
