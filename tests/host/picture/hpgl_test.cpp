// Pen paths on paper: an independent interpreter of HP-GL must draw every step of the paths at its position on the paper; so must
// the
// image and the SVG drawing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/picture/pen_drawing.hpp"
#include "host/picture/pen_path.hpp"

namespace sightline::picture {
namespace {

using Points = std::set<std::pair<int, int>>;

// A walk of steps in the eight directions over paper of 256 by 256 steps.
std::vector<PenPath> random_paths(std::uint32_t seed, Points& walked) {
  std::mt19937 random(seed);
  const auto up_to = [&](int n) { return static_cast<int>(random() % static_cast<std::uint32_t>(n)); };
  std::vector<PenPath> paths;
  for (int n = 0; n < 20; ++n) {
    PenPoint at{up_to(256), up_to(256)};
    PenPath path{{at}};
    walked.emplace(at.x, at.y);
    for (int run = up_to(200); run > 0; --run) {
      const int dx = up_to(3) - 1;
      const int dy = up_to(3) - 1;
      for (int step = up_to(9); step > 0; --step) {
        at = {std::clamp(at.x + dx, 0, 255), std::clamp(at.y + dy, 0, 255)};
        extend(path, at);
        walked.emplace(at.x, at.y);
      }
    }
    paths.push_back(path);
  }
  return paths;
}

struct Plotted {
  std::vector<std::vector<std::pair<long, long>>> lines;  // in plotter units
  std::size_t longest_instruction = 0;
};

// Reads IN, SP, PU and PD with absolute coordinates, as a plotter does; anything else fails the test.
Plotted plot(const std::string& text) {
  Plotted plotted;
  std::pair<long, long> pen{0, 0};
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = text.find(';', at);
    if (end == std::string::npos || text.compare(end, 2, ";\n") != 0) {
      ADD_FAILURE() << "no instruction a line at byte " << at;
      break;
    }
    const std::string instruction = text.substr(at, end - at);
    at = end + 2;
    plotted.longest_instruction = std::max(plotted.longest_instruction, instruction.size());
    const std::string code = instruction.substr(0, 2);
    if (code == "IN" || code == "SP") continue;
    if (code == "PU") plotted.lines.emplace_back();
    EXPECT_TRUE(code == "PU" || code == "PD") << instruction;
    const char* digits = instruction.c_str() + 2;
    while (*digits != '\0') {
      char* after = nullptr;
      const long x = std::strtol(digits, &after, 10);
      EXPECT_EQ(*after, ',');
      const long y = std::strtol(after + 1, &after, 10);
      digits = *after == ',' ? after + 1 : after;
      pen = {x, y};
      if (code == "PD") plotted.lines.back().push_back(pen);
      if (code == "PU") plotted.lines.back() = {pen};
    }
  }
  return plotted;
}

TEST(Hpgl, ComputedByHand) {
  const std::vector<PenPath> paths{{{{0, 0}, {3, 0}, {3, 2}}}, {{{10, 10}}}};
  EXPECT_EQ(hpgl(paths, minigraf_paper), "IN;\nSP1;\nPU0,0;\nPD15,0,15,10;\nPU50,50;\nPD;\nPU;\nSP0;\n");
  // 3 * 10.16 = 30.48, 2 * 10.16 = 20.32, 10 * 10.16 = 101.6
  EXPECT_EQ(hpgl(paths, calcomp_paper), "IN;\nSP1;\nPU0,0;\nPD30,0,30,20;\nPU102,102;\nPD;\nPU;\nSP0;\n");
  EXPECT_EQ(hpgl({}, calcomp_paper), "IN;\nSP1;\nPU;\nSP0;\n");
}

TEST(Hpgl, RoundingErrorsDoNotAccumulate) {
  for (int x = 0; x < 256; ++x) {
    const std::vector<PenPath> paths{{{{x, 0}, {x, 255}}}};
    const Plotted plotted = plot(hpgl(paths, calcomp_paper));
    EXPECT_LE(std::abs(plotted.lines.front().front().first * 25 - x * 254L), 12);
    EXPECT_EQ(plotted.lines.front().back().second, 2591) << "255 steps of 10.16 units";
  }
}

TEST(Hpgl, DrawsExactlyThePaths) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Points walked;
    const auto paths = random_paths(seed, walked);
    const Plotted plotted = plot(hpgl(paths, minigraf_paper));
    ASSERT_EQ(plotted.lines.size(), paths.size() + 1) << "and the last PU";
    EXPECT_LE(plotted.longest_instruction, 2 + 64 * 10);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      std::vector<std::pair<long, long>> expected;
      for (const PenPoint& corner : paths[i].corners) expected.emplace_back(corner.x * 5, corner.y * 5);
      EXPECT_EQ(plotted.lines[i], expected);
    }
  }
}

TEST(PenPaths, StraightRunsKeepTheirEnds) {
  PenPath path{{{5, 5}}};
  for (const PenPoint point : {PenPoint{6, 5}, {7, 5}, {7, 5}, {8, 6}, {9, 7}, {9, 6}, {9, 7}})
    extend(path, point);
  EXPECT_EQ(path, (PenPath{{{5, 5}, {7, 5}, {9, 7}, {9, 6}, {9, 7}}}));
}

TEST(PenImages, BlackensEveryPointOnceScaled) {
  Points walked;
  const auto paths = random_paths(7, walked);
  for (const int scale : {1, 3}) {
    const Image image = pen_image(paths, calcomp_paper, scale);
    ASSERT_EQ(image.width, 256 * scale);
    ASSERT_EQ(image.height, 256 * scale);
    for (int row = 0; row < image.height; ++row) {
      for (int column = 0; column < image.width; ++column) {
        const bool black = image.pixels[image.index(column, row)] == 0;
        ASSERT_EQ(black, walked.contains({column / scale, 255 - row / scale})) << column << ' ' << row;
      }
    }
  }
}

TEST(PenImages, PointsOffThePaperAreOmitted) {
  const std::vector<PenPath> paths{{{{-3, 4}, {2, 4}}}, {{{256, 256}}}};
  const Image image = pen_image(paths, calcomp_paper, 1);
  EXPECT_EQ(std::count(image.pixels.begin(), image.pixels.end(), 0), 3);
}

TEST(PenSvg, InMillimetresFromTheLowerLeft) {
  const std::vector<PenPath> paths{{{{0, 0}, {100, 0}, {100, 255}}}, {{{1, 1}}}};
  const std::string text = pen_svg(paths, calcomp_paper, "a < b");
  // 255 steps of 0.254 mm are 64.77 mm; with margins 84.77.
  EXPECT_NE(text.find("width=\"84.770mm\" height=\"84.770mm\" viewBox=\"0 0 84.770 84.770\""),
            std::string::npos);
  EXPECT_NE(text.find("<polyline points=\"10.000,74.770 35.400,74.770 35.400,10.000\"/>"), std::string::npos)
      << text;
  EXPECT_NE(text.find("<polyline points=\"10.244,74.516 10.264,74.516\"/>"), std::string::npos) << text;
  EXPECT_NE(text.find("inkscape:label=\"1 pen\""), std::string::npos);
  EXPECT_NE(text.find("<title>a &lt; b</title>"), std::string::npos);
  EXPECT_NE(pen_svg({}, minigraf_paper, "").find("width=\"51.875mm\""), std::string::npos);
}

}  // namespace
}  // namespace sightline::picture
