// `sightline draw`: files of every kind, and usage errors.
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::has;

class DrawCommand : public sightline::test::CommandLine {
 protected:
  void expect_usage_error(const sightline::test::Arguments& arguments, std::string_view what) {
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 2) << what;
    EXPECT_TRUE(has(ran.err, what)) << ran.err;
    EXPECT_TRUE(files().empty());
  }
  // The same if files exist: they must be unchanged.
  void expect_usage_error_beside(const sightline::test::Arguments& arguments, std::string_view what) {
    const auto before = files();
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 2) << what;
    EXPECT_TRUE(has(ran.err, what)) << ran.err;
    EXPECT_EQ(files(), before);
  }
  // Left, top, right and bottom of all lines of an SVG, in mm: "M x y", then relative coordinates; a signed one needs no blank.
  static std::array<double, 4> box_of(const std::string& svg) {
    std::array<double, 4> box{1e9, 1e9, -1e9, -1e9};
    for (std::size_t at = svg.find(" d=\"M"); at != std::string::npos; at = svg.find(" d=\"M", at + 1)) {
      const std::string text = svg.substr(at + 5, svg.find('"', at + 5) - at - 5);
      const char* next = text.c_str();
      double x = 0;
      double y = 0;
      while (*next != 0) {
        char* end = nullptr;
        x += std::strtod(next, &end);
        y += std::strtod(end, &end);
        box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x), std::max(box[3], y)};
        next = *end == 'l' ? end + 1 : end;
      }
    }
    return box;
  }
};

TEST_F(DrawCommand, SkalaAsSvg) {
  ASSERT_EQ(sightline({"draw", "skala", "sinc", "--size", "120x80", "-o", "s.svg"}).exit_code, 0);
  const std::string svg = read("s.svg");
  EXPECT_TRUE(has(svg, "width=\"120.000mm\" height=\"80.000mm\" viewBox=\"0 0 120.000 80.000\""));
  EXPECT_TRUE(has(svg, "inkscape:label=\"1 lines along x\""));
  EXPECT_TRUE(has(svg, "inkscape:label=\"2 rims\""));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  ASSERT_EQ(sightline({"draw", "skala", "sinc", "--size", "120x80", "-o", "t.svg"}).exit_code, 0);
  EXPECT_EQ(svg, read("t.svg"));
}

TEST_F(DrawCommand, SkalaAsHpgl) {
  ASSERT_EQ(sightline({"draw", "skala", "peaks", "--picture", "contours", "--levels", "3", "-o", "s.plt"})
                .exit_code,
            0);
  const std::string text = read("s.plt");
  EXPECT_TRUE(text.starts_with("IN;\nSP1;\nPU"));
  EXPECT_TRUE(has(text, "SP5;\n"));  // rims, silhouette, three contours
  EXPECT_FALSE(has(text, "SP6;\n"));
  EXPECT_TRUE(text.ends_with("PU;\nSP0;\n"));
}

TEST_F(DrawCommand, SkalaAsImageOfAnySize) {
  ASSERT_EQ(sightline({"draw", "skala", "--function", "x*z", "--picture", "surface", "--pixels", "90x70",
                       "-o", "s.png"})
                .exit_code,
            0);
  const auto png = sightline::picture::read_png(path("s.png").string());
  ASSERT_TRUE(png);
  EXPECT_EQ(png->image.width, 90);
  EXPECT_EQ(png->image.height, 70);
  EXPECT_EQ(png->image.pixels.front(), 255);
  const auto middle = png->image.pixels[png->image.index(45, 35)];
  EXPECT_TRUE(middle > 40 && middle < 250) << int{middle};
}

TEST_F(DrawCommand, AGridFileWithAHole) {
  write("h.csv", "1,2,3\n2,nan,4\n2,4,9\n");
  const auto guessed = sightline({"draw", "skala", "h.csv", "--along", "both", "-o", "h.svg"});
  EXPECT_EQ(guessed.exit_code, 0);
  EXPECT_EQ(guessed.err, "sightline: h.csv: read as a matrix of 3 rows and 3 columns\n");
  EXPECT_EQ(sightline({"draw", "skala", "h.csv", "--layout", "matrix", "-o", "h.svg"}).err, "");
  EXPECT_EQ(sightline({"draw", "skala", "peaks", "-o", "h.svg"}).err, "");
  write("bad.csv", "1,2\n3\n");
  const auto ran = sightline({"draw", "skala", "bad.csv", "-o", "bad.svg"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "bad.csv:2")) << ran.err;
  EXPECT_FALSE(exists("bad.svg"));
}

// Blocks of points that are no grid: an upright strip and its like, as gnuplot's parametric surfaces.
TEST_F(DrawCommand, ANetOfCurves) {
  write("net.dat", "0 0 0\n1 0 0\n\n0 0 1\n1 0 1\n\n0 1 1\n1 1 1\n");
  const auto ran = sightline({"draw", "skala", "net.dat", "--rotate", "0", "--json", "-o", "net.svg"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.err, "sightline: net.dat: read as a net of 3 curves of 2 points\n");
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json["x_range"], (std::vector<double>{0, 1}));
  EXPECT_EQ(json["height_range"], (std::vector<double>{0, 1}));
  EXPECT_EQ(json["counts"]["lines"], 2) << "the border, a closed line, and the curve in the middle, where the surface bends";
  expect_usage_error_beside({"draw", "skala", "net.dat", "--picture", "contours", "-o", "t.svg"}, "net.dat is a net of curves");
  expect_usage_error_beside({"draw", "skala", "net.dat", "--axes", "-o", "t.svg"}, "net.dat is a net of curves");
  const auto other = sightline({"skala", "lines", "net.dat", "-o", "p"});
  EXPECT_EQ(other.exit_code, 4);
  EXPECT_TRUE(has(other.err, "draw it by: sightline draw skala net.dat")) << other.err;
}

TEST_F(DrawCommand, HolesThinningAndTriangles) {
  write("g.asc", "ncols 4\nnrows 3\nxllcenter 10\nyllcenter 20\ncellsize 5\n1 2 3 4\n5 6 7 8\n9 10 11 12\n");
  const auto thin = sightline({"draw", "skala", "g.asc", "--thin", "2", "--nodata", "-7", "--json", "-o", "g.svg"});
  ASSERT_EQ(thin.exit_code, 0) << thin.err;
  EXPECT_EQ(thin.err, "sightline: g.asc: every 2nd point of 4 x 3 is taken, a grid of 2 x 2\n");
  EXPECT_EQ(nlohmann::json::parse(thin.out)["x_range"], (std::vector<double>{10, 20}));
  write("s.xyz", "0 0 1\n4 1 2\n1 5 3\n3 4 2\n2 2 5\n");
  const auto scattered = sightline({"draw", "skala", "s.xyz", "-o", "s.svg"});
  EXPECT_EQ(scattered.exit_code, 4);
  EXPECT_TRUE(has(scattered.err, "use --triangulate")) << scattered.err;
  const auto triangles = sightline({"draw", "skala", "s.xyz", "--triangulate", "--points", "9", "--slices", "7", "--json", "-o", "s.svg"});
  ASSERT_EQ(triangles.exit_code, 0) << triangles.err;
  EXPECT_EQ(nlohmann::json::parse(triangles.out)["points"], 9);
  EXPECT_EQ(nlohmann::json::parse(triangles.out)["y_range"], (std::vector<double>{0, 5}));
  expect_usage_error_beside({"draw", "skala", "s.xyz", "--points", "9", "-o", "t.svg"}, "without --triangulate");
  expect_usage_error_beside({"draw", "skala", "peaks", "--thin", "2", "-o", "t.svg"}, "--thin: found without a grid file");
  expect_usage_error_beside({"draw", "skala", "peaks", "--nodata", "2", "-o", "t.svg"}, "--nodata: found without a grid file");
  expect_usage_error_beside({"draw", "skala", "peaks", "--triangulate", "-o", "t.svg"}, "--triangulate: found without a file of points");
  expect_usage_error_beside({"draw", "skala", "s.xyz", "--triangulate", "--layout", "matrix", "-o", "t.svg"}, "--triangulate: found with --layout matrix");
  EXPECT_TRUE(has(sightline({"draw", "skala", "g.asc", "--triangulate", "-o", "t.svg"}).err, "leave out --layout, --xyz and --triangulate"));
}

// Proportions are those of the box unless it is stretched; the output states which.
TEST_F(DrawCommand, ProportionsOfASurface) {
  const auto drawn = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"draw", "skala", "--function", "x+y", "--x-range", "0:4", "--y-range", "0:1", "--elevate", "90", "--rotate", "0",
                                       "--points", "5", "--slices", "5", "--size", "120x60", "--json", "-o", "s.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    return std::pair{json["aspect"], box_of(read("s.svg"))};
  };
  // From above, on 100 by 40 mm of paper: the box is a square, four times as long as deep, or as the paper.
  const auto [free, square] = drawn({});
  EXPECT_EQ(free["name"], "free");
  EXPECT_EQ(free["stretched"], false);
  EXPECT_NEAR(square[2] - square[0], 40, 0.01);
  EXPECT_NEAR(square[3] - square[1], 40, 0.01);
  const auto [equal, flat] = drawn({"--aspect", "equal-xy"});
  EXPECT_EQ(equal["box"][1], 0.25);
  EXPECT_NEAR(flat[2] - flat[0], 100, 0.01);
  EXPECT_NEAR(flat[3] - flat[1], 25, 0.01);
  const auto [sides, own] = drawn({"--aspect", "1:2:1"});
  EXPECT_NEAR(own[2] - own[0], 20, 0.01);
  EXPECT_NEAR(own[3] - own[1], 40, 0.01);
  const auto [stretched, page] = drawn({"--stretch"});
  EXPECT_EQ(stretched["stretched"], true);
  EXPECT_NEAR(page[2] - page[0], 100, 0.01);
  EXPECT_NEAR(page[3] - page[1], 40, 0.01);
  expect_usage_error_beside({"draw", "skala", "sinc", "-o", "t.svg", "--aspect", "wide"}, "free, equal-xy, equal, or three sides");
  expect_usage_error_beside({"draw", "skala", "sinc", "-o", "t.svg", "--aspect", "1:2"}, "--aspect");
}

// Round heights by default; layers by kind, with descriptive names.
TEST_F(DrawCommand, AFigureInLayers) {
  const auto ran = sightline({"draw", "skala", "peaks", "--picture", "contours", "--labels", "--floor", "--axes", "--title", "Three hills", "--colours",
                              "heights", "--size", "A4", "--json", "-o", "f.svg"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(nlohmann::json::parse(ran.out)["levels"], (std::vector<double>{-6, -4, -2, 0, 2, 4, 6, 8}));
  const std::string svg = read("f.svg");
  for (const char* layer : {" rims\"", " silhouette\"", " contour -6\"", " contour 8\"", " floor 0\"", " axes\"", " text\""}) EXPECT_TRUE(has(svg, layer)) << layer;
  const auto by_step = sightline({"draw", "skala", "peaks", "--picture", "contours", "--contour-step", "2.5", "--json", "-o", "g.plt"});
  EXPECT_EQ(nlohmann::json::parse(by_step.out)["levels"], (std::vector<double>{-5, -2.5, 0, 2.5, 5, 7.5}));
  expect_usage_error_beside({"draw", "skala", "peaks", "--picture", "contours", "--contour-step", "0.01", "-o", "t.svg"}, "more than 255");
  expect_usage_error_beside({"draw", "skala", "peaks", "--labels", "-o", "t.svg"}, "--picture contours or --floor");
  expect_usage_error_beside({"draw", "skala", "peaks", "--axes", "--axis-names", "a,b", "-o", "t.svg"}, "expected three");
  expect_usage_error_beside({"draw", "skala", "peaks", "--x-range", "3:1", "-o", "t.svg"}, "--x-range");
  expect_usage_error_beside({"draw", "skala", "spike", "--x-range", "1:3", "-o", "t.svg"}, "--x-range");
  expect_usage_error_beside({"draw", "skala", "peaks", "--xyz", "a,b,c", "-o", "t.svg"}, "without a grid file");
  expect_usage_error_beside({"draw", "skala", "peaks", "--layout", "table", "-o", "t.svg"}, "--layout: found without a grid file");
  expect_usage_error_beside({"draw", "skala", "t.csv", "--layout", "table", "--xyz", "1,2,3", "-o", "t.svg"}, "--xyz: found with --layout table");
}

// At most eight layers for eight pens: rims, silhouette, contours, floor, axes and text are separate.
TEST_F(DrawCommand, AFigureForAPlotter) {
  ASSERT_EQ(sightline({"draw", "skala", "peaks", "--picture", "contours", "--labels", "--floor", "--axes", "--size", "A4", "--device", "hp7550a", "-o", "f.plt"}).exit_code, 0);
  const std::string text = read("f.plt");
  EXPECT_FALSE(has(text, "SP7;"));
  for (const char* pen : {"SP1;", "SP2;", "SP3;", "SP4;", "SP5;", "SP6;"}) {
    const std::size_t at = text.find(pen);
    ASSERT_NE(at, std::string::npos) << pen;
    EXPECT_EQ(text.find(pen, at + 1), std::string::npos) << pen;
  }
  ASSERT_EQ(sightline({"draw", "skala", "peaks", "--axes", "--title", "Peaks", "--size", "A4", "-o", "f.dxf"}).exit_code, 0);
  EXPECT_TRUE(has(read("f.dxf"), "-AXES\n"));
  EXPECT_TRUE(has(read("f.dxf"), "-TEXT\n"));
}

// Surfaces that hide each other have a common domain and a common scale of heights.
TEST_F(DrawCommand, SeveralSurfaces) {
  write("low.csv", "x,y,height\n0,0,1\n0,1,1\n1,0,1\n1,1,1\n");
  write("high.csv", "place,0,1\n0,2,2\n1,2,\n");
  const auto ran = sightline({"draw", "skala", "low.csv", "high.csv", "--json", "--axes", "-o", "two.svg"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(nlohmann::json::parse(ran.out)["height_range"], (std::vector<double>{1, 2}));
  EXPECT_EQ(nlohmann::json::parse(ran.out)["scene"], "low.csv, high.csv");
  EXPECT_TRUE(has(read("two.svg"), "lines along x, surface 2"));
  write("wide.csv", "1,2,3\n4,5,6\n");
  const auto other = sightline({"draw", "skala", "low.csv", "wide.csv", "-o", "t.svg"});
  EXPECT_EQ(other.exit_code, 4);
  EXPECT_TRUE(has(other.err, "wide.csv: found 2 slices of 3 points over other places than those of low.csv")) << other.err;
}

TEST_F(DrawCommand, ASceneByEveryAlgorithm) {
  for (const char* algorithm : {"exact", "oracle"}) {
    const std::string file = std::string(algorithm) + ".svg";
    const auto ran = sightline({"draw", algorithm, "boxes-5", "--json", "-o", file});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(has(ran.out, "\"schema\": \"sightline/draw/1\"")) << ran.out;
    EXPECT_TRUE(has(ran.out, "\"edges\": 60,")) << ran.out;
  }
  EXPECT_EQ(read("exact.svg"), read("oracle.svg"));
  EXPECT_TRUE(has(read("exact.svg"), "inkscape:label=\"1 visible\""));
  EXPECT_FALSE(has(read("exact.svg"), "hidden"));
}

TEST_F(DrawCommand, HiddenLinesHaveASeparateLayerAndPen) {
  ASSERT_EQ(sightline({"draw", "exact", "house", "--hidden", "-o", "h.svg"}).exit_code, 0);
  EXPECT_TRUE(has(read("h.svg"), "inkscape:label=\"2 hidden\""));
  ASSERT_EQ(sightline({"draw", "exact", "house", "--hidden", "-o", "h.plt"}).exit_code, 0);
  EXPECT_TRUE(has(read("h.plt"), "SP2;"));
}

TEST_F(DrawCommand, SeamsAreDrawnOnRequest) {
  ASSERT_EQ(sightline({"draw", "exact", "touch-2", "-o", "t.svg"}).exit_code, 0);
  ASSERT_EQ(sightline({"draw", "exact", "touch-2", "--all-edges", "-o", "all.svg"}).exit_code, 0);
  EXPECT_LT(read("t.svg").size(), read("all.svg").size());
}

TEST_F(DrawCommand, EquivalentCameras) {
  ASSERT_EQ(
      sightline({"draw", "exact", "boxes-5", "--eye", "9000,9000,9000", "--look-at", "0,0,0", "-o", "a.svg"})
          .exit_code,
      0);
  ASSERT_EQ(sightline({"draw", "exact", "boxes-5", "--eye", "9000,9000,9000", "--forward", "-1,-1,-1",
                       "--right", "-1,1,0", "--up", "-1,-1,2", "-o", "b.svg"})
                .exit_code,
            0);
  EXPECT_EQ(read("a.svg"), read("b.svg"));
  const auto top =
      sightline({"draw", "exact", "boxes-5", "--orthographic", "0,0,-1", "--json", "-o", "c.svg"});
  ASSERT_EQ(top.exit_code, 0) << top.err;
  EXPECT_TRUE(has(top.out, "\"perspective\": false")) << top.out;
}

TEST_F(DrawCommand, AnEyeInsideASolidIsNamed) {
  write("cube.off",
        "OFF\n8 6 0\n0 0 0\n9 0 0\n9 9 0\n0 9 0\n0 0 9\n9 0 9\n9 9 9\n0 9 9\n"
        "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  ASSERT_EQ(sightline({"draw", "exact", "cube.off", "-o", "cube.svg"}).exit_code, 0);
  const auto inside = sightline({"draw", "exact", "cube.off", "--eye", "4,4,4", "-o", "i.svg"});
  EXPECT_EQ(inside.exit_code, 4);
  EXPECT_TRUE(has(inside.err, "cube.off: body 0")) << inside.err;
  EXPECT_TRUE(has(inside.err, "inside this solid")) << inside.err;
  const auto on = sightline({"draw", "exact", "cube.off", "--eye", "9,4,4", "-o", "i.svg"});
  EXPECT_EQ(on.exit_code, 4);
  EXPECT_TRUE(has(on.err, "on this face")) << on.err;
  EXPECT_FALSE(exists("i.svg"));
}

TEST_F(DrawCommand, WrongCameras) {
  const auto expect = [&](sightline::test::Arguments options, std::string_view what) {
    sightline::test::Arguments all{"draw", "exact", "boxes-2", "-o", "s.svg"};
    all.insert(all.end(), options.begin(), options.end());
    expect_usage_error(all, what);
  };
  expect({"--eye", "1,2"}, "--eye");
  expect({"--eye", "1,2,262144"}, "between -262143,-262143,-262143 and 262143,262143,262143");
  expect({"--eye", "1,2,3", "--look-at", "1,2,3"}, "the eye itself");
  expect({"--orthographic", "0,0,0"}, "a direction");
  expect({"--orthographic", "0,0,1", "--eye", "1,2,3"}, "one of them");
  expect({"--forward", "0,0,1"}, "together");
  expect({"--forward", "0,0,1", "--right", "1,0,1", "--up", "0,1,0"}, "right angles");
  expect({"--field", "180"}, "--field");
  expect({"--field", "nan"}, "--field");
  expect({"--vertical", "up"}, "--vertical");
}

TEST_F(DrawCommand, WrongUsage) {
  expect_usage_error({"draw"}, "exact");
  expect_usage_error({"draw"}, "skala");
  expect_usage_error({"draw", "exact", "-o", "s.svg"}, "SCENE");
  expect_usage_error({"draw", "exact", "boxes-0", "-o", "s.svg"}, "size");
  expect_usage_error({"draw", "skala", "sinc"}, "--output");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.gif"}, ".svg, .png, .plt");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--size", "12"}, "WIDTHxHEIGHT");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--size", "12x12"}, "--margin");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--margin", "nan"}, "--margin");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--pen", "nan"}, "--pen");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.png", "--pixels", "9000x10"}, "1 to 8192");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--rotate", "nan"}, "--rotate");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.plt", "--picture", "surface"}, "plotter");
  expect_usage_error({"draw", "skala", "-o", "s.svg"}, "no function");
}

// An option that does not apply to this picture is reported.
TEST_F(DrawCommand, OptionsOfOtherPictures) {
  expect_usage_error({"draw", "exact", "boxes-2", "-o", "s.svg", "--pixels", "90x70"},
                     "--pixels: found without");
  expect_usage_error({"draw", "exact", "boxes-2", "-o", "s.png", "--size", "90x70", "--pixels", "9x9"},
                     "--pixels: found with --size");
  const auto fast = sightline({"draw", "exact", "boxes-2", "-o", "s.plt", "--device", "hp7475a", "--speed", "60"});
  EXPECT_TRUE(has(fast.err, "warning: --speed: found 60 cm/s, which hp7475a does not reach: the file says 38.1")) << fast.err;
  EXPECT_TRUE(has(read("s.plt"), "VS38.1;")) << fast.err;
  std::filesystem::remove(path("s.plt"));
  expect_usage_error({"draw", "exact", "boxes-2", "-o", "s.svg", "--device", "hp7475a"}, "--device: found without");
  expect_usage_error({"draw", "exact", "boxes-2", "-o", "s.plt", "--device", "hp7475a", "--size", "200x200"}, "expected A4, A3, Letter, Tabloid");
  expect_usage_error(
      {"draw", "exact", "boxes-2", "-o", "s.plt", "--device", "hp7475a", "--size", "A4", "--margin", "5"},
      "--margin: found 5 mm");
  expect_usage_error(
      {"draw", "exact", "boxes-2", "-o", "s.plt", "--device", "hp7475a", "--size", "A4", "--pens", "1,7"},
      "expected 1 to 6");
  expect_usage_error({"draw", "exact", "boxes-2", "-o", "-", "--json"}, "--output: found - with --json");
  expect_usage_error({"draw", "exact", "boxes-2", "-o", "s.png", "--margin", "5"}, "--margin: found without");
  expect_usage_error({"draw", "exact", "boxes-2", "-o", "s.plt", "--pen", "1"}, "--pen: found without");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--levels", "5"}, "--picture contours");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--net", "--picture", "lines"},
                     "--net: found");
}

TEST_F(DrawCommand, EndingsInCapitals) {
  ASSERT_EQ(sightline({"draw", "exact", "boxes-2", "-o", "a.SVG"}).exit_code, 0);
  ASSERT_EQ(sightline({"draw", "exact", "boxes-2", "-o", "b.svg"}).exit_code, 0);
  EXPECT_EQ(read("a.SVG"), read("b.svg"));
}

TEST_F(DrawCommand, AnEmptyDrawingIsWarnedAbout) {
  const auto away = sightline({"draw", "exact", "boxes-2", "--eye", "-9000,0,0", "--look-at", "-9900,0,0",
                               "--field", "20", "-o", "a.svg"});
  EXPECT_EQ(away.exit_code, 0);
  EXPECT_TRUE(has(away.err, "a.svg: the drawing is empty, nothing is in view")) << away.err;
  EXPECT_EQ(sightline({"draw", "exact", "boxes-2", "-o", "b.svg"}).err, "");
}

// Interrupted during long work: no new files remain, and existing files are unchanged.
TEST_F(DrawCommand, CtrlCLeavesEverythingAsItWas) {
  const int nameless = open(path(".").c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (nameless < 0) GTEST_SKIP() << "this file system has no files without a name";
  close(nameless);
  write("old.svg", "as it was");
  for (const char* file : {"old.svg", "new.svg"}) {
    const auto stopped =
        sightline({"draw", "oracle", "boxes-20000", "-o", file}, "", std::chrono::milliseconds(700));
    EXPECT_EQ(stopped.exit_code, 1000 + SIGINT) << stopped.err;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"old.svg"}));
  EXPECT_EQ(read("old.svg"), "as it was");

  ASSERT_EQ(sightline({"draw", "exact", "boxes-2", "-o", "old.svg"}).exit_code, 0);
  EXPECT_TRUE(read("old.svg").ends_with("</svg>\n"));
  write("plain", "");
  EXPECT_EQ(std::filesystem::status(path("old.svg")).permissions(),
            std::filesystem::status(path("plain")).permissions());
}

TEST_F(DrawCommand, AFileThatCannotBeWritten) {
  EXPECT_EQ(sightline({"draw", "skala", "sinc", "-o", "nowhere/s.svg"}).exit_code, 5);
  EXPECT_EQ(sightline({"draw", "skala", "missing.csv", "-o", "s.svg"}).exit_code, 5);
  // Reported before the work: this oracle would take hours.
  EXPECT_EQ(sightline({"draw", "oracle", "boxes-20000", "-o", "nowhere/s.svg"}).exit_code, 5);
}

}  // namespace
