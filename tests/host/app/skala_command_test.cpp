// `sightline skala`: pictures, figures, and errors.
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::has;
using sightline::test::Ran;

class SkalaCommand : public sightline::test::CommandLine {
 protected:
  json report(Arguments arguments) {
    arguments.insert(arguments.begin(), "skala");
    arguments.push_back("--json");
    const Ran ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return ran.exit_code == 0 ? json::parse(ran.out) : json{};
  }
  void expect_failure(const Arguments& arguments, int exit_code, std::string_view message) {
    Arguments all{"skala"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ran ran = sightline(all);
    EXPECT_EQ(ran.exit_code, exit_code) << message << '\n' << ran.out << ran.err;
    EXPECT_TRUE(has(ran.err, message)) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_FALSE(exists("out")) << "nothing may be written";
  }
  [[nodiscard]] sightline::picture::Image image(const std::string& name) const {
    const auto file = sightline::picture::read_png(path(name).string());
    EXPECT_TRUE(file) << name;
    return file ? file->image : sightline::picture::Image{};
  }
};

TEST_F(SkalaCommand, WritesAPictureAndReportsTheCost) {
  const Ran ran = sightline({"skala", "lines", "sinc", "-o", "pictures"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* line :
       {"60 slices of 33 points, rotated 30, elevation 30", "8080 at 3 MHz, EF9365 board, parallel link",
        "T-states", "s at 3 MHz (the paper: about 2 s)", "per cent", "(the paper: about 15)", "points walked",
        "points lit", "picture          pictures/sinc.png"}) {
    EXPECT_TRUE(has(ran.out, line)) << line << '\n' << ran.out;
  }
  EXPECT_FALSE(has(ran.out, "pen lifts"));
  EXPECT_FALSE(has(ran.out, "unanswered"));
  const auto picture = image("pictures/sinc.png");
  EXPECT_EQ(picture.width, 768);
  EXPECT_EQ(picture.channels, 3);
}

// The paper's figures are for drawings on a raster display without hidden parts: "all mentioned algorithms", conclusion.
TEST_F(SkalaCommand, ThePapersFiguresAreForRastersWithoutHiddenParts) {
  for (const char* picture : {"lines", "surface", "contours"})
    EXPECT_TRUE(has(sightline({"skala", picture, "sinc", "--slices", "20"}).out, "(the paper: about 2 s)")) << picture;
  const std::vector<Arguments> others{{"skala", "lines", "sinc", "--no-visibility"},
                                      {"skala", "lines", "sinc", "--device", "minigraf"}};
  for (const Arguments& other : others) {
    const Ran ran = sightline(other);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_FALSE(has(ran.out, "the paper")) << ran.out;
  }
}

TEST_F(SkalaCommand, JsonFields) {
  const json r = report({"lines", "rogers", "--slices", "20", "--points", "17"});
  EXPECT_EQ(r.at("schema"), "sightline/skala/1");
  EXPECT_EQ(r.at("function"), "rogers");
  EXPECT_EQ(r.at("slices"), 20);
  EXPECT_EQ(r.at("points"), 17);
  EXPECT_EQ(r.at("status"), "complete");
  EXPECT_EQ(r.at("machine").at("clock_hz"), 3'000'000);
  EXPECT_NEAR(r.at("seconds").get<double>(), r.at("t_states").get<double>() / 3e6, 1e-9);
  EXPECT_GT(r.at("total_t_states").get<std::int64_t>(), r.at("t_states").get<std::int64_t>());
  EXPECT_GT(r.at("points_walked").get<int>(), r.at("points_lit").get<int>());
  EXPECT_TRUE(r.at("visibility_cost_per_cent").is_number());
  EXPECT_FALSE(r.contains("plotter"));
  for (const json& file : r.at("pictures")) EXPECT_TRUE(exists(file.get<std::string>()));
}

TEST_F(SkalaCommand, SubdividesCells) {
  const json coarse = report({"contours", "peaks", "--slices", "9", "--points", "11", "-o", "coarse"});
  const json fine = report({"contours", "peaks", "--slices", "9", "--points", "11", "--subdivide", "3", "--check", "-o", "fine"});
  EXPECT_EQ(fine.at("slices"), 25);
  EXPECT_EQ(fine.at("points"), 31);
  // Nine times the cells, each with the lines of its borders and contours.
  EXPECT_GT(fine.at("command_bytes").get<int>(), 3 * coarse.at("command_bytes").get<int>());
  EXPECT_GT(fine.at("t_states").get<std::int64_t>(), coarse.at("t_states").get<std::int64_t>());
  // Lines have as many slices as before, of more points; a net of lines has more of both.
  const std::vector<std::pair<std::vector<std::string>, std::pair<int, int>>> lines{
      {{}, {9, 31}}, {{"--rotate", "90"}, {25, 11}}, {{"--along", "z"}, {25, 11}}, {{"--both"}, {25, 31}}};
  for (const auto& [more, size] : lines) {
    std::vector<std::string> words{"lines", "peaks", "--slices", "9", "--points", "11", "--subdivide", "3", "-o", "lines"};
    words.insert(words.end(), more.begin(), more.end());
    const json drawn = report(words);
    EXPECT_EQ(drawn.at("slices"), size.first) << drawn;
    EXPECT_EQ(drawn.at("points"), size.second) << drawn;
  }
  expect_failure({"contours", "peaks", "--subdivide", "1"}, 2, "--subdivide");
  expect_failure({"contours", "peaks", "--slices", "33", "--points", "33", "--subdivide", "40"}, 4, "at most 1024 by 1024");
}

TEST_F(SkalaCommand, CountsTheDotsThatTheTemporaryMasksSave) {
  const json r = report({"lines", "sinc", "--direct-masks", "--check"});
  EXPECT_EQ(r.at("direct_masks"), true);
  EXPECT_GT(r.at("wrong_dots").at("missing").get<int>(), 100);
  EXPECT_EQ(r.at("wrong_dots").at("extra"), 0);
  EXPECT_TRUE(exists("out/sinc-direct.png"));
  const Ran ran = sightline({"skala", "surface", "sinc", "--direct-masks"});
  EXPECT_TRUE(has(ran.out, "wrong dots       ")) << ran.out;
}

TEST_F(SkalaCommand, TheSameBytesEveryTime) {
  const Ran first = sightline({"skala", "surface", "peaks", "--json"});
  const std::string picture = read("out/peaks.png");
  EXPECT_EQ(sightline({"skala", "surface", "peaks", "--json"}).out, first.out);
  EXPECT_EQ(read("out/peaks.png"), picture);
}

TEST_F(SkalaCommand, SurfacesAreGreyUnlessAskedOtherwise) {
  report({"surface", "saddle", "--scale", "1", "-o", "grey"});
  report({"surface", "saddle", "--scale", "2", "--palette", "colour", "-o", "colour"});
  EXPECT_EQ(image("grey/saddle.png").channels, 1);
  EXPECT_EQ(image("grey/saddle.png").width, 256);
  EXPECT_EQ(image("colour/saddle.png").channels, 3);
  EXPECT_EQ(image("colour/saddle.png").width, 512);
}

TEST_F(SkalaCommand, WithoutVisibilityMoreIsDrawn) {
  const json with = report({"lines", "peaks", "-o", "with"});
  const json without = report({"lines", "peaks", "--no-visibility", "-o", "without"});
  EXPECT_GT(without.at("points_lit").get<int>(), with.at("points_lit").get<int>());
  EXPECT_EQ(without.at("points_walked"), with.at("points_walked"));
  EXPECT_TRUE(without.at("visibility_cost_per_cent").is_null());
  EXPECT_NEAR(with.at("visibility_cost_per_cent").get<double>(),
              100 * (with.at("t_states").get<double>() / without.at("t_states").get<double>() - 1), 1e-6);
}

TEST_F(SkalaCommand, PlottersWriteDrawings) {
  for (const char* device : {"calcomp", "minigraf"}) {
    const json r = report({"lines", "franke", "--slices", "12", "--device", device, "-o", device});
    EXPECT_GT(r.at("plotter").at("seconds").get<double>(), 5.0);
    EXPECT_GT(r.at("plotter").at("pen_lifts").get<int>(), 0);
    ASSERT_EQ(r.at("pictures").size(), 3U);
    EXPECT_EQ(image(std::string(device) + "/franke.png").channels, 1);
    EXPECT_TRUE(has(read(std::string(device) + "/franke.svg"), "<polyline"));
    EXPECT_TRUE(read(std::string(device) + "/franke.hpgl").starts_with("IN;\nSP1;\nPU"));
  }
  EXPECT_NE(read("calcomp/franke.hpgl"), read("minigraf/franke.hpgl")) << "their steps differ";
  EXPECT_TRUE(has(sightline({"skala", "lines", "franke", "--device", "calcomp"}).out, "pen lifts"));
}

// A set of files is all or nothing.
TEST_F(SkalaCommand, IfOneFileCannotBeWrittenNoneIs) {
  std::filesystem::create_directories(path("p/franke.hpgl"));
  const Ran ran = sightline({"skala", "lines", "franke", "--slices", "5", "--device", "calcomp", "-o", "p"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_TRUE(has(ran.err, "p/franke.hpgl")) << ran.err;
  EXPECT_EQ(ran.out, "");
  for (const char* name : {"p/franke.png", "p/franke.svg", "p/franke.png.partial", "p/franke.svg.partial"})
    EXPECT_FALSE(exists(name)) << name;
}

// The program always looks for the board once.
TEST_F(SkalaCommand, TheSearchForABoardIsNotReported) {
  for (const char* device : {"alt256", "calcomp", "minigraf"}) {
    const Ran ran = sightline({"skala", "lines", "sinc", "--slices", "3", "--device", device});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_FALSE(has(ran.out, "unanswered")) << ran.out;
  }
}

TEST_F(SkalaCommand, BothFamiliesAffectLinesOnly) {
  for (const char* picture : {"surface", "contours"}) {
    report({picture, "peaks", "--slices", "9", "--points", "9", "-o", "one"});
    report({picture, "peaks", "--slices", "9", "--points", "9", "--both", "-o", "both"});
    EXPECT_EQ(read("one/peaks.png"), read("both/peaks.png")) << picture;
  }
  expect_failure({"surface", "sinc", "--both", "--along", "x"}, 2, "--both");
}

TEST_F(SkalaCommand, BoardsAndLinksMakeTheSamePicture) {
  report({"lines", "step", "-o", "a"});
  report({"lines", "step", "--device", "alt256", "-o", "b"});
  const json slow = report({"lines", "step", "--link", "serial", "-o", "c"});
  EXPECT_EQ(image("a/step.png"), image("b/step.png"));
  EXPECT_EQ(image("a/step.png"), image("c/step.png"));
  EXPECT_GT(slow.at("total_t_states").get<std::int64_t>(),
            slow.at("command_bytes").get<std::int64_t>() * 3000);
}

TEST_F(SkalaCommand, FamiliesLevelsNetAndZoomChangeThePicture) {
  const auto lit = [this](Arguments arguments) {
    return report(std::move(arguments)).at("points_lit").get<int>();
  };
  const int x = lit({"lines", "sinc", "--along", "x", "--slices", "20", "--points", "20"});
  const int z = lit({"lines", "sinc", "--along", "z", "--slices", "20", "--points", "20"});
  EXPECT_GT(lit({"lines", "sinc", "--both", "--slices", "20", "--points", "20"}), std::max(x, z));
  EXPECT_GT(lit({"contours", "sinc", "--levels", "20"}), lit({"contours", "sinc", "--levels", "3"}));
  EXPECT_GT(lit({"contours", "sinc", "--net"}), lit({"contours", "sinc"}));
  EXPECT_NE(lit({"lines", "sinc", "--zoom", "2"}), lit({"lines", "sinc"}));
}

TEST_F(SkalaCommand, ExpressionsAndGridFiles) {
  const json expression =
      report({"lines", "--function", "x*x - z*z", "--domain", "-1:1", "--slices", "9", "-o", "e"});
  EXPECT_EQ(expression.at("function"), "x*x - z*z");
  EXPECT_TRUE(exists("e/function.png"));
  write("hill top.csv", "0,0,0\n0,1,0\n0,nan,0\n");
  const json grid = report({"contours", "hill top.csv", "-o", "g"});
  EXPECT_EQ(grid.at("slices"), 3);
  EXPECT_TRUE(exists("g/hill_top.png"));
}

TEST_F(SkalaCommand, LayoutsOfGridFiles) {
  write("columns.xyz", "0 0 1 9\n1 0 2 9\n0 5 4 9\n1 5 5 9\n");
  const Ran guessed = sightline({"skala", "lines", "columns.xyz", "--json", "-o", "g"});
  EXPECT_EQ(guessed.err, "sightline: columns.xyz: read as x y z in columns, a grid of 2 x 2, column 4 left out\n");
  EXPECT_EQ(json::parse(guessed.out).at("slices"), 2);
  EXPECT_EQ(report({"lines", "columns.xyz", "--layout", "matrix", "-o", "m"}).at("points"), 4);
  EXPECT_EQ(sightline({"skala", "lines", "columns.xyz", "--layout", "points", "-o", "p"}).err, "");
}

TEST_F(SkalaCommand, BadInputIsNamedAndNothingIsWritten) {
  write("scatter.xyz", "0.1 3.2 1\n2.5 0.3 2\n1.7 1.9 4\n0.4 2.2 3\n");
  expect_failure({"lines", "scatter.xyz"}, 4, "scatter.xyz: found 4 scattered points");
  write("row.csv", "1,2,3\n");
  write("word.csv", "1,2\n3,four\n");
  write("hole.csv", "1,2\n3,?\n");
  expect_failure({"lines", "row.csv"}, 4, "row.csv");
  expect_failure({"lines", "word.csv"}, 4, "word.csv:2:3");
  expect_failure({"surface", "hole.csv"}, 4, "hole.csv:2");
  expect_failure({"lines", "no_such_function"}, 5, "no function of that name, expected a grid file or one of sinc, rogers");
  expect_failure({"lines", "--function", "sin(x"}, 2, "sin(x");
  expect_failure({"lines", "--function", "sqrt(-1-x*x)"}, 2, "--function");
  expect_failure({"lines", "--function", "x", "--domain", "3:1"}, 2, "--domain");
  expect_failure({"lines", "sinc", "--domain", "0:1"}, 2, "--domain");
  expect_failure({"lines"}, 2, "no function to draw");
  expect_failure({"lines", "sinc", "--function", "x"}, 2, "two functions");
  expect_failure({"lines", "word.csv", "--slices", "9"}, 2, "its own size");
}

TEST_F(SkalaCommand, OptionsOutOfRange) {
  expect_failure({"lines", "sinc", "--slices", "1"}, 2, "--slices");
  expect_failure({"lines", "sinc", "--points", "2000"}, 2, "--points");
  expect_failure({"lines", "sinc", "--elevate", "91"}, 2, "--elevate");
  expect_failure({"lines", "sinc", "--rotate", "nan"}, 2, "--rotate");
  expect_failure({"lines", "sinc", "--device", "teletype"}, 2, "--device");
  expect_failure({"lines", "sinc", "--both", "--along", "x"}, 2, "--both");
  expect_failure({"lines", "sinc", "--levels", "3"}, 2, "--levels");
  expect_failure({"contours", "sinc", "--levels", "0"}, 2, "--levels");
  expect_failure({"surface", "sinc", "--clock", "1"}, 2, "--clock");
  expect_failure({"spheres"}, 2, "lines, surface, contours");
}

// The program's own delay loops time the Minigraf's steps; a faster processor shortens them.
TEST_F(SkalaCommand, AClockThatThePlotterProgramDoesNotExpect) {
  expect_failure({"lines", "sinc", "--slices", "5", "--device", "minigraf", "--clock", "6000000"}, 3,
                 "made for a clock of 3 MHz");
  expect_failure({"lines", "sinc", "--slices", "5", "--link", "serial", "--clock", "100000"}, 3,
                 "serial link; its timing is made for a clock of 3 MHz");
}

// A folder's name need not be UTF-8, but JSON must be.
TEST_F(SkalaCommand, HelpTeaches) {
  const Ran ran = sightline({"skala", "--help"});
  EXPECT_EQ(ran.exit_code, 0);
  for (const char* text :
       {"lines", "surface", "contours", "sightline skala lines sinc", "--function", "Exit codes"})
    EXPECT_TRUE(has(ran.out, text)) << text;
}

}  // namespace
