// `sightline draw` of meshes and of bodies that pass through each other: layers, hatching, units, step files.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "tests/host/app/command_line.hpp"
#include "tests/support/effort.hpp"

namespace {

using sightline::test::has;

// A box, and a bar through it.
constexpr std::string_view box_and_bar = R"({"name":"two","step":1,"vertices":[
[0,0,0],[10,0,0],[0,10,0],[10,10,0],[0,0,10],[10,0,10],[0,10,10],[10,10,10],
[3,4,-5],[7,4,-5],[3,7,-5],[7,7,-5],[3,4,15],[7,4,15],[3,7,15],[7,7,15]],
"bodies":[{"name":"box","faces":[[0,2,3,1],[4,5,7,6],[0,1,5,4],[2,6,7,3],[0,4,6,2],[1,3,7,5]]},
{"name":"bar","faces":[[8,10,11,9],[12,13,15,14],[8,9,13,12],[10,14,15,11],[8,12,14,10],[9,11,15,13]]}],
"camera":{"perspective":false,"eye":[40,35,50],"forward":[-4,-3,-5],"right":[5,0,-4],"up":[-12,41,-15]}})";

class DrawMesh : public sightline::test::CommandLine {
 protected:
  // The line of the exit code and the errors of a call that must work.
  void expect_ok(const sightline::test::Arguments& arguments) {
    const auto ran = sightline(arguments);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
  }
};

TEST_F(DrawMesh, BodiesThatPassThroughEachOtherInJson) {
  write("two.json", box_and_bar);
  for (const char* method : {"exact", "oracle"}) {
    const auto ran = sightline({"draw", method, "two.json", "--json", "-o", std::string(method) + ".svg"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    EXPECT_TRUE(has(ran.out, "\"intersection\": 8")) << ran.out;
  }
  EXPECT_EQ(read("exact.svg"), read("oracle.svg"));
  EXPECT_TRUE(has(read("exact.svg"), "inkscape:label=\"1 visible\""));
  EXPECT_TRUE(has(read("exact.svg"), "inkscape:label=\"2 intersection\""));
  const auto turn = sightline({"spin", "two.json", "--step", "90", "-o", "t.apng"});
  EXPECT_EQ(turn.exit_code, 0) << turn.err;
  EXPECT_TRUE(has(turn.out, "4 frames")) << turn.out;
  const auto other = sightline({"draw", "jones", "two.json", "-o", "j.svg"});
  EXPECT_TRUE(has(other.err, "bodies pass through each other, the first at faces")) << other.err;
}

// A box, and a line through it.
constexpr std::string_view box_and_line =
    "v 0 0 0\nv 10 0 0\nv 10 6 0\nv 0 6 0\nv 0 0 4\nv 10 0 4\nv 10 6 4\nv 0 6 4\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\n"
    "f 3 4 8 7\nf 4 1 5 8\nv -5 3 2\nv 15 3 2\nl 9 10\n";

// In an isometric view it is seen before x = -2 and after x = 10 (tests/host/algorithms/exact/wires_test.cpp): so many parts
// of the 20 units from the left border of the drawing, at 10 mm, to the right one, at 190.
TEST_F(DrawMesh, LinesWithoutFacesAreHiddenByFaces) {
  write("f.obj", box_and_line);
  for (const char* method : {"exact", "oracle"}) {
    const auto ran = sightline({"draw", method, "f.obj", "--view", "iso", "--json", "-o", std::string(method) + ".svg"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    EXPECT_TRUE(has(ran.out, "\"wire\": 1")) << ran.out;
    const std::string svg = read(std::string(method) + ".svg");
    const std::string layer = svg.substr(std::min(svg.find(" wire\""), svg.size()));
    EXPECT_TRUE(has(layer, "M145 ")) << svg;        // 10 + 180 * 15 / 20
    EXPECT_TRUE(has(layer, "M37 ")) << svg;         // 10 + 180 * 3 / 20
    EXPECT_TRUE(has(layer, "l45 25.981\"")) << svg;  // the slope of an isometric axis is tan 30 degrees
    EXPECT_TRUE(has(layer, "l-27-15.589\"")) << svg;
  }
  expect_ok({"draw", "exact", "f.obj", "--layers", "body", "-o", "b.svg"});
  EXPECT_TRUE(has(read("b.svg"), " wires\""));
  expect_ok({"draw", "exact", "f.obj", "--edges", "crease", "-o", "c.svg"});
  EXPECT_FALSE(has(read("c.svg"), " wire\""));
}

TEST_F(DrawMesh, LinesWithoutFacesAreLeftOutByTheOtherMethods) {
  write("f.obj", box_and_line);
  const std::string warning = "sightline: warning: f.obj: 1 line without faces left out; `sightline draw exact` draws it\n";
  for (const char* method : {"jones", "montani-re", "plantinga"}) {
    const auto ran = sightline({"draw", method, "f.obj", "--orthographic", "1,0,1", "-o", std::string(method) + ".svg"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.err, warning);
    EXPECT_FALSE(has(read(std::string(method) + ".svg"), " wire")) << method;
  }
  const auto turn = sightline({"spin", "f.obj", "--step", "90", "-o", "t.apng"});
  EXPECT_EQ(turn.exit_code, 0);
  EXPECT_EQ(turn.err, warning);
  const auto compared = sightline({"compare", "f.obj"});
  EXPECT_EQ(compared.exit_code, 0) << compared.out;
  EXPECT_TRUE(has(compared.err, warning)) << compared.err;
  const auto off = sightline({"scene", "convert", "f.obj", "-o", "f.off"});
  EXPECT_EQ(off.exit_code, 4);
  EXPECT_TRUE(has(off.err, "f.obj: has 1 line without faces, for which this format has no place")) << off.err;
}

TEST_F(DrawMesh, AFileOfLinesAlone) {
  write("l.obj", "v 0 0 0\nv 3 0 0\nv 3 4.5 0\nl 1 2 3\n");
  for (const std::string_view option : {"--json", "--strict", "--hidden", "--all-edges"})
    EXPECT_EQ(sightline({"draw", "exact", "l.obj", std::string(option), "-o", "l.svg"}).exit_code, 0) << option;
  expect_ok({"draw", "exact", "l.obj", "--view", "front", "-o", "l.svg"});
  EXPECT_TRUE(has(read("l.svg"), "<path d=\"M40 190l120 0 0-180\"/>")) << read("l.svg");  // 4.5 units are 180 mm
  const auto info = sightline({"scene", "info", "l.obj"});
  EXPECT_TRUE(has(info.out, "2 without faces")) << info.out;
  const auto jones = sightline({"draw", "jones", "l.obj", "-o", "j.svg"});
  EXPECT_EQ(jones.exit_code, 4);
  EXPECT_TRUE(has(jones.err, "l.obj: found only 2 lines without faces, expected a scene with faces; `sightline draw exact` draws them"))
      << jones.err;
}

// No two faces of the sphere bend by 30 degrees, and its silhouette from (1, 1, 1) has 40 of 792 edges.
TEST_F(DrawMesh, ColoursOfFacesAreBordersWhereAskedFor) {
  const std::string sphere = SIGHTLINE_TEST_DATA "/meshes/ply-face-colours.ply";
  const auto edges_of = [&](const std::string& file, const sightline::test::Arguments& more) {
    sightline::test::Arguments words{"draw", "exact", file, "--view", "iso", "--json", "-o", "s.svg"};
    words.insert(words.end(), more.begin(), more.end());
    const std::string out = sightline(words).out;
    const std::size_t at = out.find("\"edges\": ");
    return at == std::string::npos ? -1 : std::atoi(out.c_str() + at + 9);
  };
  EXPECT_EQ(edges_of(sphere, {}), 40);
  EXPECT_EQ(edges_of(sphere, {"--edges", "feature"}), 40);
  EXPECT_EQ(edges_of(sphere, {"--edges", "silhouette"}), 40);
  EXPECT_EQ(edges_of(sphere, {"--edges", "silhouette,border"}), 792);
  EXPECT_EQ(edges_of(sphere, {"--edges", "all"}), 792);
  expect_ok({"scene", "convert", sphere, "-o", "s.json"});
  EXPECT_EQ(edges_of("s.json", {}), 40);
  EXPECT_EQ(edges_of("s.json", {"--edges", "silhouette,border"}), 792);
  // A material of OBJ is a part's, and its border is drawn.
  write("m.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n");
  EXPECT_EQ(edges_of("m.obj", {}), 5);
}

TEST_F(DrawMesh, ALayerForEachBody) {
  write("two.json", box_and_bar);
  expect_ok({"draw", "exact", "two.json", "--layers", "body", "-o", "b.svg"});
  const std::string svg = read("b.svg");
  EXPECT_TRUE(has(svg, "inkscape:label=\"1 box\"\n     fill=\"none\" stroke=\"#000000\"")) << svg;
  EXPECT_TRUE(has(svg, "inkscape:label=\"2 bar\"\n     fill=\"none\" stroke=\"#c80000\"")) << svg;
  expect_ok({"draw", "exact", "two.json", "--layers", "body", "-o", "b.dxf"});
  EXPECT_TRUE(has(read("b.dxf"), "1-BOX"));
  EXPECT_TRUE(has(read("b.dxf"), "2-BAR"));
  expect_ok({"draw", "exact", "two.json", "--layers", "body", "-o", "b.plt"});
  EXPECT_TRUE(has(read("b.plt"), "SP1;"));
  EXPECT_TRUE(has(read("b.plt"), "SP2;"));
  // All kinds of scenes, with all edges, too.
  expect_ok({"draw", "exact", "house", "--layers", "body", "--all-edges", "-o", "h.svg"});
}

// A cube of 180 mm on the paper, from the front, with a line every 10 mm: the first and the last of 19 would lie on its edges.
TEST_F(DrawMesh, HatchingThatLiesOnAnEdgeIsLeftOut) {
  write("cube.obj",
        "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 0 0 9\nv 9 0 9\nv 9 9 9\nv 0 9 9\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  for (const char* angle : {"0,10", "90,10"}) {
    const auto ran = sightline({"draw", "exact", "cube.obj", "--view", "front", "--hatch", angle, "--light", "1,0,0", "--strokes", "s.jsonl", "-o", "h.svg"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    std::map<std::string, int> kinds;
    std::istringstream rows(read("s.jsonl"));
    for (std::string row; std::getline(rows, row);) ++kinds[row.substr(row.find("\"kind\":\"") + 8, 6)];
    EXPECT_EQ(kinds, (std::map<std::string, int>{{"silhou", 4}, {"hatchi", 17}, {"cross-", 8}})) << angle;
  }
}

TEST_F(DrawMesh, HatchingIsLayersOfItsOwn) {
  write("two.json", box_and_bar);
  expect_ok({"draw", "exact", "two.json", "-o", "plain.svg"});
  const auto ran = sightline({"draw", "exact", "two.json", "--hatch", "30,2", "--light", "1,3,0.5", "--json", "-o", "h.svg"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "\"hatching\"")) << ran.out;
  const std::string svg = read("h.svg");
  EXPECT_TRUE(has(svg, "inkscape:label=\"3 hatching\""));
  // The edges are those of the drawing without it.
  const std::string plain = read("plain.svg");
  const std::size_t begin = plain.find("<g id=\"layer-1\"");
  const std::size_t end = plain.find("</svg>");
  EXPECT_TRUE(has(svg, plain.substr(begin, end - begin)));
  expect_ok({"draw", "oracle", "two.json", "--hatch", "30,2", "--light", "1,3,0.5", "-o", "o.svg"});
  EXPECT_EQ(svg, read("o.svg"));
}

TEST_F(DrawMesh, HatchingThatCannotBe) {
  for (const auto& [hatch, light, what] : std::vector<std::array<std::string, 3>>{{"45", "1,1,1", "ANGLE,SPACING"},
                                                                                  {"45,0", "1,1,1", "a spacing from"},
                                                                                  {"nan,1", "1,1,1", "ANGLE,SPACING"},
                                                                                  {"45,1,2", "1,1,1", "ANGLE,SPACING"},
                                                                                  {"45,1", "1,1", "--light"},
                                                                                  {"45,1", "0,0,0", "expected a direction"}}) {
    const auto ran = sightline({"draw", "exact", "boxes-3", "--hatch", hatch, "--light", light, "-o", "x.svg"});
    EXPECT_EQ(ran.exit_code, 2) << hatch;
    EXPECT_TRUE(has(ran.err, what)) << ran.err;
  }
  EXPECT_NE(sightline({"draw", "jones", "boxes-3", "--hatch", "45,1", "-o", "x.svg"}).exit_code, 0);
}

// The step file, sent by the host to a program on the emulated machine, which gives it to the emulated plotter.
TEST_F(DrawMesh, AStepFileIsDrawnByTheEmulatedCalComp) {
  write("two.json", box_and_bar);
  const std::string player = std::string(SIGHTLINE_SOURCE_DIR) + "/host/examples/boards/player.asm";
  expect_ok({"asm", "i8080", player, "-o", "player.hex", "--format", "hex"});
  const auto drawn = sightline({"draw", "exact", "two.json", "--json", "-o", "two.steps"});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  const auto ran = sightline({"run", "i8080", "player.hex", "--plotter", "calcomp", "--parallel", "two.steps",
                              "--strokes", "back.txt"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_FALSE(has(ran.out, "off carriage"));
  // The same lines in HP-GL, whose units are a fortieth of a millimetre.
  expect_ok({"draw", "exact", "two.json", "-o", "two.plt"});
  std::set<std::pair<long, long>> steps;
  std::istringstream strokes(read("back.txt"));
  std::string line;
  while (std::getline(strokes, line)) {
    std::istringstream fields(line);
    long time = 0;
    long x = 0;
    long y = 0;
    fields >> time >> x >> y;
    steps.emplace(x, y);
  }
  EXPECT_GT(steps.size(), 1000U);
  std::istringstream plot(read("two.plt"));
  int corners = 0;
  std::string instruction;
  while (std::getline(plot, instruction, ';')) {
    const std::size_t letter = instruction.find("P");
    if (letter == std::string::npos || (instruction[letter + 1] != 'U' && instruction[letter + 1] != 'D')) continue;
    std::istringstream numbers(instruction.substr(letter + 2));
    double x = 0;
    double y = 0;
    char comma = 0;
    while (numbers >> x >> comma >> y) {
      numbers >> comma;
      // The paper of 200 mm lies in the middle of a carriage of 279.4 mm.
      const long column = std::lround(x / 40 / 0.254);
      const long row = std::lround((y / 40 + 39.7) / 0.254);
      bool near = false;
      for (long i = -1; i <= 1; ++i)
        for (long k = -1; k <= 1; ++k) near = near || steps.contains({column + i, row + k});
      EXPECT_TRUE(near) << x << ' ' << y;
      ++corners;
    }
  }
  EXPECT_GT(corners, 20);
}

TEST_F(DrawMesh, LimitsOfTheCalComp) {
  EXPECT_TRUE(has(sightline({"draw", "exact", "boxes-3", "--device", "calcomp", "-o", "x.plt"}).err, ".steps for the CalComp"));
  EXPECT_TRUE(has(sightline({"draw", "exact", "boxes-3", "--device", "hp7475a", "-o", "x.steps"}).err, "which is for calcomp"));
  EXPECT_TRUE(
      has(sightline({"draw", "exact", "boxes-3", "--size", "A4", "--margin", "5", "-o", "x.steps"}).err,
          "expected 8.8 or more"));
  EXPECT_TRUE(has(sightline({"draw", "exact", "boxes-3", "--speed", "10", "-o", "x.steps"}).err, "--speed"));
  expect_ok({"draw", "exact", "boxes-3", "--size", "A4", "-o", "x.steps"});
  expect_ok({"draw", "skala", "sinc", "--device", "calcomp", "--format", "steps", "-o", "y.bin"});
}

// A sheet of 231,200 triangles: a minute and more, for which one has to ask.
TEST_F(DrawMesh, WhatTakesMinutesIsRefused) {
  NEEDS_OPTIMISED_CODE();
  std::string bytes(80, ' ');
  const auto put = [&bytes](const auto& number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); };
  constexpr int side = 340;
  put(static_cast<unsigned>(2 * side * side));
  for (int i = 0; i < 2 * side * side; ++i) {
    const auto x = static_cast<float>(i / 2 % side);
    const auto y = static_cast<float>(i / 2 / side);
    const bool upper = i % 2 != 0;
    for (const float c : {0.0F, 0.0F, 1.0F, x, y, 0.0F, x + 1, upper ? y + 1 : y, 0.0F, upper ? x : x + 1, y + 1, 0.0F}) put(c);
    bytes += std::string(2, '\0');
  }
  write("sheet.stl", bytes);
  const auto ran = sightline({"draw", "oracle", "sheet.stl", "-o", "x.svg"});
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(has(ran.err, "oracle is quadratic here, and takes about 2 minutes for 231200 faces")) << ran.err;
  EXPECT_TRUE(has(ran.err, "--go-on draws it all the same")) << ran.err;
  EXPECT_FALSE(exists("x.svg"));
}

TEST_F(DrawMesh, TheUnitOfAFile) {
  write("a.off", "OFF\n4 4 0\n0 0 0\n1.25 0 0\n0 1.25 0\n0 0 1.25\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  EXPECT_FALSE(has(sightline({"scene", "info", "a.off"}).out, "unit"));
  const auto ran = sightline({"scene", "info", "a.off", "--unit", "mm"});
  EXPECT_TRUE(has(ran.out, "unit           mm")) << ran.out;
  EXPECT_TRUE(has(ran.err, "steps of 0.01 mm")) << ran.err;
  EXPECT_TRUE(has(sightline({"scene", "info", "a.off", "--unit", "inch", "--json"}).out, "\"unit\": \"inch\""));
  EXPECT_TRUE(has(sightline({"draw", "exact", "boxes-3", "--unit", "mm", "-o", "b.svg"}).err, "--unit: boxes-3 is no mesh"));
  EXPECT_EQ(sightline({"scene", "info", "a.off", "--unit", "furlong"}).exit_code, 2);
  EXPECT_TRUE(has(sightline({"scene", "convert", "a.off", "-o", "a.gltf"}).err, "expected a name that ends in"));
}

}  // namespace
