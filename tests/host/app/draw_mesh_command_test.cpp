// `sightline draw` of meshes and of bodies that pass through each other: layers, hatching, units, step files.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "host/picture/png.hpp"
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
  // Checks the exit code and the empty errors of a call that must succeed.
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

// In an isometric view it is visible before x = -2 and after x = 10 (tests/host/algorithms/exact/wires_test.cpp): the same parts
// of the
// 20 units from the left border of the drawing, at 10 mm, to the right one, at 190.
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

TEST_F(DrawMesh, LinesWithoutFacesAreOmittedByTheOtherMethods) {
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
TEST_F(DrawMesh, BordersBetweenColoursAreDrawnOnRequest) {
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
  // A material in OBJ belongs to a part, and its border is drawn.
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
  // For all kinds of scenes, with all edges, too.
  expect_ok({"draw", "exact", "house", "--layers", "body", "--all-edges", "-o", "h.svg"});
}

// Layers are not identified by names of bodies: bodies may share a name, or be named like the layer of hidden lines.
TEST_F(DrawMesh, BodiesWithOneNameHaveSeparateLayers) {
  std::string text(box_and_bar);
  for (const std::string_view name : {"\"name\":\"box\"", "\"name\":\"bar\""}) text.replace(text.find(name), name.size(), "\"name\":\"hidden\"");
  write("two.json", text);
  expect_ok({"draw", "exact", "two.json", "--layers", "body", "--hidden", "-o", "b.svg"});
  const std::string svg = read("b.svg");
  for (const char* layer : {"\"1 hidden\"\n     fill=\"none\" stroke=\"#000000\"", "\"2 hidden\"\n     fill=\"none\" stroke=\"#c80000\"",
                            "\"3 hidden\"\n     fill=\"none\" stroke=\"#969696\""})
    EXPECT_TRUE(has(svg, layer)) << layer << svg;
}

TEST_F(DrawMesh, TheListOfStrokesChangesNoDrawing) {
  write("cube.obj",
        "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 0 0 9\nv 9 0 9\nv 9 9 9\nv 0 9 9\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  for (const char* scene : {"cube.obj", "boxes-2"}) {
    for (const char* edges : {"feature", "all"}) {
      expect_ok({"draw", "exact", scene, "--edges", edges, "--hidden", "-o", "without.plt"});
      expect_ok({"draw", "exact", scene, "--edges", edges, "--hidden", "--strokes", "s.jsonl", "-o", "with.plt"});
      EXPECT_EQ(read("with.plt"), read("without.plt")) << scene << ' ' << edges;
      EXPECT_TRUE(has(read("s.jsonl"), "\"kind\":\"silhouette\"")) << scene << ' ' << edges;
    }
  }
  for (const char* option : {"--strokes=s.jsonl", "--min-length=1"})
    EXPECT_TRUE(has(sightline({"draw", "montani-re", "cube.obj", "--fill", option, "-o", "f.svg"}).err, " excludes --")) << option;
}

// A cube of 180 mm on the paper, from the front, with a line every 10 mm: the first and the last of 19 would lie on its edges.
TEST_F(DrawMesh, HatchingOnAnEdgeIsOmitted) {
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

TEST_F(DrawMesh, HatchingHasSeparateLayers) {
  write("two.json", box_and_bar);
  expect_ok({"draw", "exact", "two.json", "-o", "plain.svg"});
  const auto ran = sightline({"draw", "exact", "two.json", "--hatch", "30,2", "--light", "1,3,0.5", "--json", "-o", "h.svg"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "\"hatching\"")) << ran.out;
  const std::string svg = read("h.svg");
  EXPECT_TRUE(has(svg, "inkscape:label=\"3 hatching\""));
  // The edges are those of the drawing without hatching.
  const std::string plain = read("plain.svg");
  const std::size_t begin = plain.find("<g id=\"layer-1\"");
  const std::size_t end = plain.find("</svg>");
  EXPECT_TRUE(has(svg, plain.substr(begin, end - begin)));
  expect_ok({"draw", "oracle", "two.json", "--hatch", "30,2", "--light", "1,3,0.5", "-o", "o.svg"});
  EXPECT_EQ(svg, read("o.svg"));
}

TEST_F(DrawMesh, ImpossibleHatching) {
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

// The host sends the step file to a program on the emulated machine, which passes it to the emulated plotter.
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
      // The paper of 200 mm is in the middle of a carriage of 279.4 mm.
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

// A box of 10 x 6 x 4, seen from the front as 10 x 6.
constexpr std::string_view box = "v 0 0 0\nv 10 0 0\nv 10 6 0\nv 0 6 0\nv 0 0 4\nv 10 0 4\nv 10 6 4\nv 0 6 4\n"
                                 "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

// The bounds of a step file's drawing, in steps: codes 0 to 7 are the directions clockwise from +y, 8 and 9 lift and lower the
// pen.
std::array<long, 4> bounds_of_steps(const std::string& file) {
  std::array<long, 4> bounds{1 << 20, 1 << 20, -1, -1};
  long x = 0;
  long y = 0;
  bool down = false;
  for (const char c : file) {
    const auto code = static_cast<unsigned char>(c);
    constexpr std::array<int, 8> across{0, 1, 1, 1, 0, -1, -1, -1};
    if (code < 8) {
      x += across[code];
      y += across[(code + 2) % 8];
    } else if (code < 0xFF) {
      down = code == 9;
    }
    if (down) bounds = {std::min(bounds[0], x), std::min(bounds[1], y), std::max(bounds[2], x), std::max(bounds[3], y)};
  }
  return bounds;
}

// At 2:1 it is 20 x 12 mm, in the middle of the paper: 800 x 480 units of HP-GL around its middle.
TEST_F(DrawMesh, AScaleIsTheSameOnEveryDevice) {
  write("box.obj", box);
  const auto drawn = [&](std::vector<std::string> more, const std::string& file) {
    std::vector<std::string> all{"draw", "exact", "box.obj", "--view", "front", "--scale", "2:1", "-o", file};
    all.insert(all.end(), more.begin(), more.end());
    expect_ok(all);
    return read(file);
  };
  const auto whole = [](long left, long low, long right, long high) {
    return "PU" + std::to_string(left) + "," + std::to_string(low) + ";\nPD" + std::to_string(left) + "," + std::to_string(high) + "," +
           std::to_string(right) + "," + std::to_string(high) + "," + std::to_string(right) + "," + std::to_string(low) + "," +
           std::to_string(left) + "," + std::to_string(low) + ";";
  };
  // 297 x 210 mm are 11880 x 8400 units; the limits of the plotters on it 11040 x 7721.
  EXPECT_TRUE(has(drawn({"--size", "A4", "--landscape"}, "a.plt"), whole(5540, 3960, 6340, 4440)));
  for (const char* device : {"hp7475a", "hp7550a"})
    EXPECT_TRUE(has(drawn({"--device", device}, "a.plt"), whole(5120, 3621, 5920, 4101))) << device;
  // On A3 16158 x 11040.
  EXPECT_TRUE(has(drawn({"--device", "hp7475a", "--size", "A3", "--landscape"}, "a.plt"), whole(7679, 5280, 8479, 5760)));
  // A4 upright lies on its side.
  EXPECT_TRUE(has(drawn({"--device", "hp7475a", "--size", "A4"}, "a.plt"), "PD5280,3461,5280,4261,5760,4261,5760,3461"));
  EXPECT_TRUE(has(drawn({}, "a.svg"), "M90 106l0-12 20 0 0 12-20 0"));
  EXPECT_TRUE(has(drawn({"--margin", "60"}, "a.pdf"), "110.000 106.000 l"));
  EXPECT_TRUE(has(drawn({}, "a.dxf"), " 10\n110.000\n 20\n106.000\n"));
  // 279.4 mm are 1100 steps of 0.254 mm: 550 -+ 39.4 and -+ 23.6.
  EXPECT_EQ(bounds_of_steps(drawn({"--device", "calcomp"}, "a.steps")), (std::array<long, 4>{511, 526, 589, 574}));
  EXPECT_EQ(sightline({"draw", "exact", "box.obj", "--view", "front", "--scale", "2:1", "-o", "a.png"}).exit_code, 2);
  // Ten pixels per millimetre: 200 x 120 pixels around the middle of 2970 x 2100, with lines two pixels wide.
  drawn({"--size", "A4", "--landscape", "--dpi", "254"}, "a.png");
  const auto png = sightline::picture::read_png(path("a.png").string());
  ASSERT_TRUE(png);
  ASSERT_EQ(png->image.width, 2970);
  ASSERT_EQ(png->image.height, 2100);
  const auto ink = [&png](int column, int row) { return 255 - png->image.pixels[png->image.index(column, row)]; };
  for (const int column : {1385, 1585}) {
    EXPECT_GT(ink(column - 1, 1050), 200);
    EXPECT_EQ(ink(column - 1, 1050), ink(column, 1050));
    EXPECT_EQ(ink(column - 3, 1050) + ink(column + 2, 1050), 0);
  }
  for (const int row : {990, 1110}) {
    EXPECT_GT(ink(1485, row - 1), 200);
    EXPECT_EQ(ink(1485, row - 1), ink(1485, row));
  }
}

TEST_F(DrawMesh, AScaleCountsTheUnitOfTheFile) {
  write("box.obj", box);
  const auto width = [&](const char* unit, const char* scale) {
    expect_ok({"draw", "exact", "box.obj", "--view", "front", "--unit", unit, "--scale", scale, "--size", "A3", "--landscape", "--layers", "none",
               "-o", "a.plt"});
    std::istringstream text(read("a.plt"));
    std::string line;
    long low = 1 << 20;
    long high = 0;
    while (std::getline(text, line)) {
      if (!line.starts_with("PD")) continue;
      std::istringstream numbers(line.substr(2));
      long x = 0;
      long y = 0;
      char comma = 0;
      while (numbers >> x >> comma >> y) {
        low = std::min(low, x);
        high = std::max(high, x);
        numbers >> comma;
      }
    }
    return high - low;
  };
  EXPECT_EQ(width("inch", "1:1"), 10'160);   // 254 mm
  EXPECT_EQ(width("m", "1:50"), 8'000);      // 200 mm
  EXPECT_EQ(width("cm", "1:2.5"), 1'600);    // 40 mm
  EXPECT_EQ(width("ft", "1:10"), 12'192);    // 304.8 mm
  EXPECT_EQ(width("cm", "2:1"), 8'000);
  // Coordinates of a file with fractions are in steps of 0.1.
  write("half.obj", "v 0.5 0.5 0\nv 20.5 0.5 0\nv 20.5 40.5 0\nf 1 2 3\n");
  expect_ok({"draw", "exact", "half.obj", "--view", "front", "--scale", "1:1", "-o", "half.svg"});
  EXPECT_TRUE(has(read("half.svg"), "M90 120l20 0 0-40-20 40")) << read("half.svg");
}

TEST_F(DrawMesh, AScaleThatDoesNotFitNamesThePaper) {
  write("box.obj", box);
  const auto refused = [&](std::vector<std::string> more, std::string_view expected) {
    std::vector<std::string> all{"draw", "exact", "box.obj", "--view", "front"};
    all.insert(all.end(), more.begin(), more.end());
    const auto ran = sightline(all);
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_TRUE(has(ran.err, expected)) << ran.err;
  };
  refused({"--scale", "30:1", "-o", "x.svg"},
          "found a drawing of 300.0x180.0 mm on paper with room for 180.0x180.0, expected a paper of at least 320x200 mm with its margins, "
          "such as --size A3 --landscape");
  // The plotter can draw on 276 x 193.025 mm of A4: 27.6:1 fits exactly, with any margin.
  refused({"--scale", "27.7:1", "--device", "hp7475a", "-o", "x.plt"}, "such as --size A3 --landscape");
  refused({"--scale", "50:1", "--device", "hp7475a", "-o", "x.plt"}, "expected a smaller scale");
  refused({"--scale", "27.6:1", "--device", "hp7475a", "--margin", "12", "-o", "x.plt"}, "room for 273.0x186.0");
  refused({"--scale", "2:1", "--field", "20", "-o", "x.svg"}, "--scale");
  refused({"--scale", "2", "-o", "x.svg"}, "expected N:M");
  refused({"--scale", "0:1", "-o", "x.svg"}, "expected N:M");
  refused({"--scale", "2:1", "--perspective", "-o", "x.svg"}, "which has no scale");
  // 170 mm from the front, 17 (10 cos 22.5 + 4 sin 22.5) = 183.1 mm in the next view; neither file is written.
  refused({"--scale", "17:1", "--turntable", "16", "-o", "x.svg"}, "found a drawing of 183.1x102.0 mm");
  EXPECT_TRUE(files() == std::vector<std::string>{"box.obj"});
  expect_ok({"draw", "exact", "box.obj", "--view", "front", "--scale", "27.6:1", "--device", "hp7475a", "-o", "a.plt"});
  EXPECT_TRUE(has(read("a.plt"), "PU0,549;\nPD0,7173,11040,7173,11040,549,0,549;")) << read("a.plt");
}

// 10 x 6 x 4 units, 100 x 60 x 40 mm.
TEST_F(DrawMesh, SeveralViewsShareASheet) {
  write("box.obj", box);
  expect_ok({"draw", "exact", "box.obj", "--views", "front,top,right", "--scale", "10:1", "--size", "A4", "--landscape", "-o", "a.svg"});
  // 150 x 110 mm with the gaps, in the middle of 297 x 210: the view from the front at 73.5 .. 173.5 and 100 .. 160 from the top.
  for (const char* part : {"M73.5 100l100 0 0 60-100 0 0-60", "M173.5 90l-100 0 0-40 100 0 0 40", "M183.5 100l40 0 0 60-40 0 0-60"}) EXPECT_TRUE(has(read("a.svg"), part)) << part << read("a.svg");
  expect_ok({"draw", "exact", "box.obj", "--views", "front,top,right", "--first-angle", "--scale", "10:1", "--size", "A4", "--landscape", "-o", "b.svg"});
  // From the front at 123.5 .. 223.5 and 50 .. 110, from above below that, from the right to the left.
  for (const char* part : {"M123.5 110l0-60 100 0 0 60-100 0", "M123.5 120l100 0 0 40-100 0 0-40", "M113.5 110l-40 0 0-60 40 0 0 60"}) EXPECT_TRUE(has(read("b.svg"), part)) << part << read("b.svg");
  const auto refused = [&](std::vector<std::string> more, std::string_view expected) {
    std::vector<std::string> all{"draw", "exact", "box.obj", "-o", "x.svg"};
    all.insert(all.end(), more.begin(), more.end());
    const auto ran = sightline(all);
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_TRUE(has(ran.err, expected)) << ran.err;
  };
  refused({"--views", "front,above"}, "--views: above not in {front,back,");
  refused({"--views", "front,front"}, "found front twice");
  refused({"--views", "front,top", "--view", "iso"}, "--view");
  refused({"--views", "front,top", "--turntable", "3"}, "--turntable");
  refused({"--views", "front,top", "--section", "x=1"}, "--section");
  refused({"--first-angle"}, "--views");
  refused({"--views", "front,right", "--scale", "20:1"}, "found a drawing of 290.0x120.0 mm");
}

TEST_F(DrawMesh, ASectionTakesAwayWhatIsBeforeThePlane) {
  write("box.obj", box);
  // From the right the box is 4 x 6 units: 180 mm are 6 units, and the cut fills the rectangle of 120 x 180 mm.
  expect_ok({"draw", "exact", "box.obj", "--view", "right", "--section", "x=2.5", "--strokes", "a.jsonl", "-o", "a.svg"});
  std::istringstream strokes(read("a.jsonl"));
  int hatched = 0;
  for (std::string text; std::getline(strokes, text);) {
    const auto stroke = nlohmann::json::parse(text);
    if (stroke["layer"] != "section") continue;
    ++hatched;
    for (const char* end : {"from", "to"}) {
      EXPECT_GE(stroke[end][0], 40 - 1e-6);
      EXPECT_LE(stroke[end][0], 160 + 1e-6);
    }
  }
  EXPECT_NEAR(hatched, (120 + 180) / std::sqrt(2.0) / 2, 2) << "lines 2 mm apart across the diagonal";
  const auto edge_on = sightline({"draw", "exact", "box.obj", "--view", "top", "--section", "x=2.5", "-o", "b.svg"});
  EXPECT_EQ(edge_on.exit_code, 2);
  EXPECT_TRUE(has(edge_on.err, "which this view sees edge on")) << edge_on.err;
  for (const char* wrong : {"x", "w=1", "x=", "x=a", "x=nan", "x=1e999"}) {
    const auto ran = sightline({"draw", "exact", "box.obj", "--section", wrong, "-o", "b.svg"});
    EXPECT_EQ(ran.exit_code, 2) << wrong << ran.err;
    EXPECT_TRUE(has(ran.err, "expected an axis and a place in the unit of the file, such as x=12.5")) << ran.err;
  }
  const auto nothing = sightline({"draw", "exact", "box.obj", "--view", "front", "--section", "z=-100", "-o", "b.svg"});
  EXPECT_EQ(nothing.exit_code, 4) << nothing.err;
  EXPECT_TRUE(has(nothing.err, "nothing behind the planes of the section")) << nothing.err;
}

// A side of 20 x 40 units of the file, of which 60 are across the paper's 180 mm; its coordinates are multiples of 0.1.
TEST_F(DrawMesh, TheFieldIsInTheUnitOfTheFile) {
  write("half.obj", "v 0.5 0.5 0.5\nv 20.5 0.5 0.5\nv 20.5 40.5 0.5\nv 0.5 40.5 0.5\nv 0.5 0.5 10.5\nv 20.5 0.5 10.5\nv 20.5 40.5 10.5\n"
                    "v 0.5 40.5 10.5\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  expect_ok({"draw", "exact", "half.obj", "--view", "front", "--field", "60", "-o", "a.svg"});
  EXPECT_TRUE(has(read("a.svg"), "M70 160l0-120 60 0 0 120-60 0")) << read("a.svg");
  expect_ok({"draw", "montani-re", "half.obj", "--view", "front", "--field", "60", "--fill", "-o", "f.svg"});
  for (const char* place : {"70.000,160.000", "130.000,40.000"}) EXPECT_TRUE(has(read("f.svg"), place)) << read("f.svg");
  write("box.obj", box);
  const auto refused = sightline({"draw", "exact", "box.obj", "--view", "front", "--field", "190", "--size", "A4", "--device", "hp7475a", "-o", "x.plt"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(has(refused.err, "hp7475a needs 10.5, expected --margin 10.5 as well; --field 189 then")) << refused.err;
  // 189 units on 189 mm: 10 mm are 400 units of HP-GL.
  expect_ok({"draw", "exact", "box.obj", "--view", "front", "--field", "189", "--margin", "10.5", "--size", "A4", "--device", "hp7475a", "-o", "a.plt"});
  EXPECT_TRUE(has(read("a.plt"), "PD5400,3661,5400,4061,5640,4061,5640,3661;")) << read("a.plt");
}

// 60 mm of paper with 20 units on the 40 mm inside its margins, at ten pixels per millimetre.
TEST_F(DrawMesh, AFilledSheetHasItsMarginsAndItsScale) {
  write("box.obj", box);
  expect_ok({"draw", "montani-re", "box.obj", "--view", "front", "--field", "20", "--fill", "--size", "60x60", "--dpi", "254", "-o", "f.png"});
  const auto png = sightline::picture::read_png(path("f.png").string());
  ASSERT_TRUE(png);
  const auto& image = png->image;
  ASSERT_EQ(image.width, 600);
  const auto colour = [&image](int column, int row) {
    const auto at = image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(column, row));
    return std::vector<int>(at, at + 3);
  };
  const std::vector<int> white{255, 255, 255};
  EXPECT_EQ(colour(99, 300), white);
  EXPECT_EQ(colour(300, 500), white);
  const std::vector<int> sky = colour(100, 100);
  EXPECT_NE(sky, white);
  EXPECT_EQ(colour(499, 499), sky);
  for (const auto& [outside, inside] : std::vector<std::pair<std::array<int, 2>, std::array<int, 2>>>{
           {{199, 300}, {200, 300}}, {{400, 300}, {399, 300}}, {{300, 239}, {300, 240}}, {{300, 360}, {300, 359}}}) {
    EXPECT_EQ(colour(outside[0], outside[1]), sky);
    EXPECT_NE(colour(inside[0], inside[1]), sky);
  }
}

TEST_F(DrawMesh, TheDefaultUpDirectionChangesNothing) {
  write("box.obj", box);
  for (const char* view : {"iso", "dimetric", "trimetric", "NW", "front"}) {
    expect_ok({"draw", "exact", "box.obj", "--view", view, "-o", "a.svg"});
    expect_ok({"draw", "exact", "box.obj", "--view", view, "--up", "0,1,0", "-o", "b.svg"});
    EXPECT_EQ(read("a.svg"), read("b.svg")) << view;
  }
  expect_ok({"draw", "exact", "box.obj", "--vertical", "-z", "--view", "iso", "-o", "a.svg"});
  expect_ok({"draw", "exact", "box.obj", "--vertical", "-z", "--view", "iso", "--up", "0,0,-1", "-o", "b.svg"});
  EXPECT_EQ(read("a.svg"), read("b.svg"));
}

TEST_F(DrawMesh, AnotherUpDirectionKeepsTheViewingDirection) {
  write("box.obj", box);
  for (const char* view : {"iso", "dimetric", "trimetric", "NW"}) {
    const auto forward = [&](std::vector<std::string> more) {
      std::vector<std::string> all{"draw", "exact", "box.obj", "--view", view, "--json", "-o", "a.svg"};
      all.insert(all.end(), more.begin(), more.end());
      const std::string out = sightline(all).out;
      const std::size_t begin = out.find("\"forward\"");
      return out.substr(begin, out.find(']', begin) - begin);
    };
    EXPECT_FALSE(forward({}).empty());
    EXPECT_EQ(forward({}), forward({"--up", "0,0,1"})) << view;
    EXPECT_EQ(forward({}), forward({"--up", "1,2,3"})) << view;
  }
}

TEST_F(DrawMesh, EachLayerHasAPenAndSharingIsReported) {
  write("box.obj", box);
  const auto drawn = [&](std::vector<std::string> more, const std::string& file) {
    std::vector<std::string> all{"draw", "exact", "box.obj", "--view", "iso", "--hidden", "-o", file};
    all.insert(all.end(), more.begin(), more.end());
    const auto ran = sightline(all);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return ran.err;
  };
  EXPECT_EQ(drawn({}, "a.svg"), "");
  for (const char* label : {"\"1 silhouette\"", "\"2 crease\"", "\"3 hidden\""}) EXPECT_TRUE(has(read("a.svg"), label)) << label;
  EXPECT_EQ(drawn({}, "a.dxf"), "");
  EXPECT_TRUE(has(read("a.dxf"), "3-HIDDEN\n"));
  EXPECT_EQ(drawn({}, "a.pdf"), "");
  EXPECT_TRUE(has(read("a.pdf"), "/OC /L2 BDC"));
  EXPECT_FALSE(has(read("a.pdf"), "/OC /L3 BDC"));
  EXPECT_EQ(drawn({"--device", "hp7475a"}, "a.plt"), "");
  for (const char* pen : {"SP1;", "SP2;", "SP3;"}) EXPECT_TRUE(has(read("a.plt"), pen)) << pen;
  EXPECT_FALSE(has(read("a.plt"), "SP4;"));
  EXPECT_EQ(drawn({"--pens", "6,4,2"}, "a.plt"), "");
  const std::string text = read("a.plt");
  EXPECT_LT(text.find("SP6;"), text.find("SP4;"));
  EXPECT_LT(text.find("SP4;"), text.find("SP2;"));
  EXPECT_TRUE(has(drawn({"--pens", "1,3"}, "a.plt"), "a.plt: 3 layers for the 2 pens of --pens: crease and hidden share pen 3\n"));
  EXPECT_TRUE(has(drawn({"--pens", "1,3", "--hatch", "30,2"}, "a.plt"),
                  "a.plt: 5 layers for the 2 pens of --pens: crease, hatching, cross-hatching and hidden share pen 3\n"));
  EXPECT_TRUE(has(sightline({"draw", "exact", "box.obj", "--view", "iso", "--hidden", "--pens", "1,3", "--json", "-o", "a.plt"}).out, "\"pens\": 2,"));
  EXPECT_TRUE(has(drawn({"--pens", "1,2,3,4"}, "a.plt"), "a.plt: 3 layers for the 4 pens of --pens: pen 4 draws nothing\n"));
  EXPECT_TRUE(has(drawn({}, "a.steps"), "a.steps: 2 layers for the one pen of calcomp: visible and hidden share it\n"));
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

// A sheet of 231,200 triangles takes more than a minute, which needs an explicit option.
TEST_F(DrawMesh, MinutesOfWorkNeedAnOption) {
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
  EXPECT_TRUE(has(ran.err, "--go-on draws it anyway")) << ran.err;
  EXPECT_FALSE(exists("x.svg"));
}

TEST_F(DrawMesh, TheUnitOfAFile) {
  write("a.off", "OFF\n4 4 0\n0 0 0\n1.25 0 0\n0 1.25 0\n0 0 1.25\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  EXPECT_FALSE(has(sightline({"scene", "info", "a.off"}).out, "unit"));
  const auto ran = sightline({"scene", "info", "a.off", "--unit", "mm"});
  EXPECT_TRUE(has(ran.out, "unit           mm")) << ran.out;
  // Nothing is rounded. Of the other file's three numbers the largest, 12345.678, is farthest from a multiple of an eighth:
  // 0.053.
  EXPECT_EQ(ran.err, "");
  write("rounded.off", "OFF\n4 4 0\n0 0 0\n1.25 0 0\n0 1.25 0\n0 0 12345.678\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const auto rounded = sightline({"scene", "info", "rounded.off", "--unit", "mm"});
  EXPECT_TRUE(has(rounded.err, "rounded to a step of 0.125 mm, by at most 0.053 mm")) << rounded.err;
  EXPECT_TRUE(has(sightline({"scene", "info", "a.off", "--unit", "inch", "--json"}).out, "\"unit\": \"inch\""));
  EXPECT_TRUE(has(sightline({"draw", "exact", "boxes-3", "--unit", "mm", "-o", "b.svg"}).err, "--unit: boxes-3 is no mesh"));
  EXPECT_EQ(sightline({"scene", "info", "a.off", "--unit", "furlong"}).exit_code, 2);
  EXPECT_TRUE(has(sightline({"scene", "convert", "a.off", "-o", "a.gltf"}).err, "expected a name that ends in"));
}

}  // namespace
