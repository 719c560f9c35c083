// HP-GL of drawings, read back by an independent interpreter: the lines are at their positions on the paper, and no point is
// beyond the
// limits of the plotter.
#include "host/picture/plotter.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace sightline::picture {
namespace {

struct Drawn {
  int pen = 0;
  std::vector<std::pair<long, long>> points;  // units
};

// IN, SP, VS, PU, PD, PA, PR as a plotter reads them; anything else fails the test.
std::vector<Drawn> draw(const std::string& text) {
  std::vector<Drawn> lines;
  std::pair<long, long> at{0, 0};
  bool relative = false;
  bool down = false;
  int pen = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find(';', begin);
    EXPECT_NE(end, std::string::npos);
    if (end == std::string::npos) break;
    const std::string instruction = text.substr(begin, end - begin);
    begin = text[end + 1] == '\n' ? end + 2 : end + 1;
    const std::string code = instruction.substr(0, 2);
    if (code == "SP") pen = std::atoi(instruction.c_str() + 2);
    if (code == "IN" || code == "SP" || code == "VS") continue;
    if (code == "PA" || code == "PR") {
      relative = code == "PR";
    } else {
      EXPECT_TRUE(code == "PU" || code == "PD") << instruction;
      down = code == "PD";
    }
    if (code == "PD") lines.push_back({pen, {at}});
    const char* digits = instruction.c_str() + 2;
    while (*digits != '\0') {
      char* after = nullptr;
      const long x = std::strtol(digits, &after, 10);
      EXPECT_EQ(*after, ',') << instruction;
      const long y = std::strtol(after + 1, &after, 10);
      digits = *after == ',' ? after + 1 : after;
      at = relative ? std::pair(at.first + x, at.second + y) : std::pair(x, y);
      if (down) lines.back().points.push_back(at);
    }
  }
  return lines;
}

// Lines that fill the sheet to its margin.
VectorDrawing drawing_for(const Paper& paper, std::uint32_t layers) {
  std::mt19937 random(3);
  VectorDrawing drawing;
  drawing.width = paper.width - 2 * paper.margin;
  drawing.height = paper.height - 2 * paper.margin;
  for (std::uint32_t layer = 0; layer < layers; ++layer) {
    drawing.layers.push_back({"layer", {0, 0, 0}});
    for (int i = 0; i < 3; ++i) {
      drawing.lines.push_back({layer, static_cast<std::uint32_t>(drawing.points.size()), 90});
      for (int p = 0; p < 90; ++p)
        drawing.points.push_back({static_cast<float>(drawing.width) * static_cast<float>(random() % 101) / 100,
                                  static_cast<float>(drawing.height) * static_cast<float>(random() % 101) / 100});
    }
  }
  return drawing;
}

TEST(Plotters, LinesAreAtTheirPositionOnThePaper) {
  const Paper paper{120, 80, 10, 0.2};
  const VectorDrawing drawing = drawing_for(paper, 2);
  for (const bool relative : {false, true}) {
    const std::vector<Drawn> lines = draw(hpgl_of(drawing, paper, {.pens = {4, 2}, .relative = relative}));
    std::vector<std::pair<long, long>> all;
    for (const Drawn& line : lines)
      for (std::size_t i = 0; i < line.points.size(); ++i)
        if (all.empty() || all.back() != line.points[i]) all.push_back(line.points[i]);
    EXPECT_EQ(lines.front().pen, 4);
    EXPECT_EQ(lines.back().pen, 2);
    std::vector<std::pair<long, long>> expected;
    for (const DrawingPoint& p : drawing.points) {
      const std::pair<long, long> at{std::lround((10 + double{p.x}) * 40), std::lround((10 + double{p.y}) * 40)};
      if (expected.empty() || expected.back() != at) expected.push_back(at);
    }
    EXPECT_EQ(all, expected) << relative;
  }
}

TEST(Plotters, NoPointIsBeyondTheLimits) {
  struct Sheet {
    double width, height;
    long most_x, most_y;
  };
  // The plotting areas of the 7475A's manual.
  for (const Sheet& sheet : {Sheet{297, 210, 11040, 7721}, Sheet{210, 297, 11040, 7721}, Sheet{420, 297, 16158, 11040}}) {
    Paper paper{sheet.width, sheet.height, 0, 0.2};
    const Plotter& plotter = *find_plotter("hp7475a");
    const auto margin = least_margin(plotter, paper);
    ASSERT_TRUE(margin);
    paper.margin = *margin;
    long farthest_x = 0;
    long farthest_y = 0;
    for (const Drawn& line : draw(hpgl_of(drawing_for(paper, 8), paper, {.plotter = &plotter}))) {
      EXPECT_GE(line.pen, 1);
      EXPECT_LE(line.pen, 6);
      for (const auto& [x, y] : line.points) {
        EXPECT_GE(x, 0);
        EXPECT_GE(y, 0);
        EXPECT_LE(x, sheet.most_x);
        EXPECT_LE(y, sheet.most_y);
        farthest_x = std::max(farthest_x, x);
        farthest_y = std::max(farthest_y, y);
      }
    }
    // The whole area is used: one of the two limits is reached.
    EXPECT_TRUE(farthest_x >= sheet.most_x - 1 || farthest_y >= sheet.most_y - 1);
  }
  EXPECT_FALSE(least_margin(*find_plotter("hp7475a"), {200, 200, 10, 0.2}));
}

// From the manuals: A4 has 11040 by 7721 units of 0.025 mm.
TEST(Plotters, PlottingAreas) {
  const Plotter& plotter = *find_plotter("hp7475a");
  const auto lying = plotting_area(plotter, {297, 210, 0, 0.2});
  ASSERT_TRUE(lying);
  EXPECT_DOUBLE_EQ((*lying)[0], 276);
  EXPECT_DOUBLE_EQ((*lying)[1], 193.025);
  const auto upright = plotting_area(plotter, {210, 297, 0, 0.2});
  ASSERT_TRUE(upright);
  EXPECT_DOUBLE_EQ((*upright)[0], 193.025);
  EXPECT_DOUBLE_EQ((*upright)[1], 276);
  EXPECT_FALSE(plotting_area(plotter, {297, 297, 0, 0.2}));
  const auto drum = plotting_area(*find_plotter("calcomp"), {1000, 300, 0, 0.2});
  ASSERT_TRUE(drum);
  EXPECT_DOUBLE_EQ((*drum)[0], 1000);
  EXPECT_DOUBLE_EQ((*drum)[1], 279.4);
}

TEST(Plotters, DefaultPaper) {
  for (const char* name : {"hp7475a", "hp7550a"}) EXPECT_EQ(find_plotter(name)->papers.front().paper, "A4");
  EXPECT_DOUBLE_EQ(find_plotter("calcomp")->papers.front().width, 279.4);
  EXPECT_DOUBLE_EQ(find_plotter("calcomp")->papers.front().height, 279.4);
}

// One millimetre is 40 units on both axes; the margins do not change the scale.
TEST(Plotters, AMillimetreIsFortyUnitsOnEveryPaper) {
  for (const char* name : {"hp7475a", "hp7550a"}) {
    for (const PlotterPaperLimits& sheet : find_plotter(name)->papers) {
      for (const bool upright : {false, true}) {
        const Paper paper{upright ? sheet.height : sheet.width, upright ? sheet.width : sheet.height, 0, 0.2};
        VectorDrawing drawing;
        drawing.width = paper.width;
        drawing.height = paper.height;
        drawing.layers = {{"visible", {}}};
        drawing.points = {{50, 60}, {150, 60}, {150, 160}};
        drawing.lines = {{0, 0, 3}};
        const auto lines = draw(hpgl_of(drawing, paper, {.plotter = find_plotter(name)}));
        ASSERT_EQ(lines.size(), 1U);
        const auto& [a, b, c] = std::array{lines[0].points[0], lines[0].points[1], lines[0].points[2]};
        EXPECT_EQ(std::abs(b.first - a.first) + std::abs(b.second - a.second), 4000) << name << ' ' << sheet.paper;
        EXPECT_EQ(std::abs(c.first - b.first) + std::abs(c.second - b.second), 4000) << name << ' ' << sheet.paper;
      }
    }
  }
}

TEST(Plotters, APointIsWrittenOnce) {
  VectorDrawing drawing;
  drawing.width = drawing.height = 100;
  drawing.layers = {{"visible", {}}};
  // The second and the fourth are less than half a unit from the points before them; the second line is omitted, the third is a
  // dot.
  drawing.points = {{1, 1}, {1.01F, 1}, {2, 1}, {2, 1.01F}, {2, 3}, {5, 5}, {5, 5.001F}};
  drawing.lines = {{0, 0, 5}, {0, 5, 2}, {0, 5, 1}};
  const Paper paper{100, 100, 0, 0.2};
  EXPECT_EQ(hpgl_of(drawing, paper), "IN;\nSP1;\nPU40,40;\nPD80,40,80,120;\nPU200,200;\nPD;\nPU;\nSP0;\n");
  EXPECT_EQ(hpgl_of(drawing, paper, {.relative = true}),
            "IN;\nSP1;\nPU;PA40,40;\nPD;PR40,0,0,80;\nPU;PA200,200;\nPD;\nPU;PA;\nSP0;\n");
}

TEST(Plotters, EachLayerHasItsPen) {
  const HpglOptions six{.plotter = find_plotter("hp7475a")};
  EXPECT_EQ(pen_of_layer(0, six), 1);
  EXPECT_EQ(pen_of_layer(5, six), 6);
  EXPECT_EQ(pen_of_layer(7, six), 6);
  EXPECT_EQ(pen_of_layer(7, {}), 8);
  const HpglOptions named{.pens = {4, 2}};
  EXPECT_EQ(pen_of_layer(0, named), 4);
  EXPECT_EQ(pen_of_layer(1, named), 2);
  EXPECT_EQ(pen_of_layer(2, named), 2);
}

TEST(Plotters, UprightPaperLiesOnItsSide) {
  const Paper paper{210, 297, 20, 0.2};
  VectorDrawing drawing;
  drawing.width = 170;
  drawing.height = 257;
  drawing.layers = {{"visible", {0, 0, 0}}};
  drawing.points = {{0, 0}, {170, 0}};  // the lower edge of the drawing
  drawing.lines = {{0, 0, 2}};
  const auto lines = draw(hpgl_of(drawing, paper, {.plotter = find_plotter("hp7475a")}));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].points[0].first, lines[0].points[1].first);   // along the plotter's y axis
  EXPECT_EQ(lines[0].points[1].second - lines[0].points[0].second, 170 * 40);
  EXPECT_GT(lines[0].points[0].first, 11040 / 2);  // far from its top
}

}  // namespace
}  // namespace sightline::picture
