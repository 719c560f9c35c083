// `sightline draw exact` and `draw oracle` of a scene of cells. From inside: the lines that the oracle of cells finds visible,
// read
// back from the drawing. From outside: the solids and walls, and one line that says so.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "tests/host/app/command_line.hpp"
#include "tests/host/scene/scene_support.hpp"
#include "tests/support/read_drawing.hpp"

namespace {

namespace oracle = sightline::algorithms::oracle;
using sightline::scene::CellScene;
using sightline::test::has;
using sightline::tests::DrawnSegment;

class DrawCells : public sightline::test::CommandLine {
 protected:
  std::vector<DrawnSegment> drawn(const std::string& file) {
    return sightline::tests::segments_of(sightline::tests::lines_of_svg(read(file), 200));
  }
};

constexpr const char* left_out = "the outer box is left out: ";

// A field of view of 90 degrees on 180 mm of paper, as in the drawing.
std::vector<DrawnSegment> visible(const CellScene& scene, const sightline::geometry::Point& eye) {
  oracle::Window window;
  window.points = {sightline::geometry::Span{0, 1024}, sightline::geometry::Span{0, 1024}};
  window.near = 1;
  std::vector<DrawnSegment> segments;
  const auto mm = [](double point) { return 10 + point * 180 / 1024; };
  for (const oracle::ScreenSegment& s : oracle::on_screen(*oracle::visible_lines(scene, eye, window), eye, window))
    segments.push_back({mm(s.x0), mm(s.y0), mm(s.x1), mm(s.y1)});
  return segments;
}

// The largest distance of a point of `lines`, sampled every millimetre, from all of `others`.
double farthest(const std::vector<DrawnSegment>& lines, const std::vector<DrawnSegment>& others) {
  double greatest = 0;
  for (const auto& [x0, y0, x1, y1] : lines) {
    const double steps = std::ceil(std::hypot(x1 - x0, y1 - y0)) + 1;
    for (double step = 0; step <= steps; ++step) {
      const double t = step / steps;
      double nearest = std::numeric_limits<double>::infinity();
      for (const DrawnSegment& other : others)
        nearest = std::min(nearest, sightline::tests::distance_to(other, x0 + (x1 - x0) * t, y0 + (y1 - y0) * t));
      greatest = std::max(greatest, nearest);
    }
  }
  return greatest;
}

TEST_F(DrawCells, FromInsideAreTheVisibleLinesOfTheirMatter) {
  struct Case {
    const char* scene;
    std::vector<std::string> options;
    sightline::geometry::Point eye;
  };
  std::vector<Case> cases;
  for (const char* const name : {"house", "roberts", "street4", "corridor8"})
    cases.push_back({name, {}, sightline::scene::builtin_scene(name).default_view});
  // Behind the partition, away from its other side.
  cases.push_back({"house", {"--eye", "100,100,420"}, {100, 100, 420}});
  for (const Case& each : cases) {
    const auto truth = visible(sightline::scene::builtin_scene(each.scene), each.eye);
    ASSERT_GT(truth.size(), 5U) << each.scene;
    for (const char* const method : {"exact", "oracle"}) {
      sightline::test::Arguments words{"draw", method, each.scene, "-o", "d.svg"};
      words.insert(words.end(), each.options.begin(), each.options.end());
      const auto ran = sightline(words);
      ASSERT_EQ(ran.exit_code, 0) << ran.err;
      EXPECT_EQ(ran.err, "") << each.scene;
      const auto lines = drawn("d.svg");
      EXPECT_LT(farthest(lines, truth), 0.01) << method << ' ' << each.scene << ", extra";
      EXPECT_LT(farthest(truth, lines), 0.01) << method << ' ' << each.scene << ", missing";
    }
  }
}

TEST_F(DrawCells, FromOutsideShowSolidsAndWallsWithAMessage) {
  struct Case {
    std::vector<std::string> options;
    const char* reason;
  };
  for (const Case& each : {Case{{"--eye", "300,100,-500"}, "the eye is outside all cells"},
                           Case{{"--orthographic", "1,-1,2"}, "parallel projection looks at the scene from outside"},
                           Case{{"--all-edges"}, "--edges, --crease and --all-edges choose among the edges of solids and walls"}}) {
    sightline::test::Arguments words{"draw", "exact", "house", "-o", "d.svg"};
    words.insert(words.end(), each.options.begin(), each.options.end());
    const auto ran = sightline(words);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.err, std::string("sightline: warning: house: ") + left_out + each.reason + "\n");
    // Jones's native method always draws the edges of solids and walls, without a message.
    words[1] = "jones";
    words[4] = "j.svg";
    const auto jones = sightline(words);
    ASSERT_EQ(jones.exit_code, 0) << jones.err;
    EXPECT_EQ(jones.err, "");
    EXPECT_EQ(read("d.svg"), read("j.svg"));
  }
}

TEST_F(DrawCells, ViewsOfATurnAreAllFromInsideOrAllWithoutTheBox) {
  const auto outside = sightline({"draw", "exact", "house", "--turntable", "4", "-o", "t.svg"});
  ASSERT_EQ(outside.exit_code, 0) << outside.err;
  EXPECT_TRUE(has(outside.err, left_out));
  // Around x = 300, z = 575: two cells, on both sides of a wall.
  const auto inside =
      sightline({"draw", "exact", "house", "--eye", "400,100,575", "--look-at", "500,100,575", "--turntable", "4", "-o", "u.svg"});
  ASSERT_EQ(inside.exit_code, 0) << inside.err;
  EXPECT_EQ(inside.err, "");
  EXPECT_NE(read("u-1.svg"), read("u-2.svg"));
}

TEST_F(DrawCells, FromInsideHaveHiddenLinesBodiesAndStrokes) {
  const auto ran = sightline({"draw", "exact", "house", "--hidden", "--layers", "body", "--strokes", "-", "-o", "d.svg"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "\"kind\":\"wire\",\"layer\":\"walls\",\"hidden\":false")) << ran.out;
  EXPECT_TRUE(has(ran.out, "\"kind\":\"wire\",\"layer\":\"wires\",\"hidden\":false")) << ran.out;
  EXPECT_TRUE(has(ran.out, "\"kind\":\"wire\",\"layer\":\"hidden\",\"hidden\":true")) << ran.out;
}

}  // namespace
