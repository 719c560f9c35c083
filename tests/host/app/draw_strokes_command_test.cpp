// `sightline draw` checked at the level of pen strokes: every outer edge is in the file, each stretch of paper is drawn once, no
// dash
// overlaps a line, and --strokes lists what is drawn. Expectations are computed by hand from the meshes in tests/data/drawing.
#include <cmath>
#include <sstream>
#include <tuple>

#include <nlohmann/json.hpp>

#include "tests/host/app/command_line.hpp"
#include "tests/support/read_drawing.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::tests::DrawnSegment;

const std::string drawing_data = SIGHTLINE_TEST_DATA "/drawing/";

class DrawStrokes : public sightline::test::CommandLine {
 protected:
  // Draws into `file`, and returns the strokes.
  std::vector<json> strokes(const std::string& mesh, const Arguments& options, const std::string& file = "a.svg") {
    Arguments words{"draw", "exact", drawing_data + mesh, "--strokes", "s.jsonl", "-o", file};
    words.insert(words.end(), options.begin(), options.end());
    const auto ran = sightline(words);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    std::vector<json> rows;
    std::istringstream text(read("s.jsonl"));
    for (std::string row; std::getline(text, row);) rows.push_back(json::parse(row));
    return rows;
  }
};

DrawnSegment segment_of(const json& stroke) {
  return {stroke.at("from").at(0), stroke.at("from").at(1), stroke.at("to").at(0), stroke.at("to").at(1)};
}

std::vector<DrawnSegment> segments_of(const std::vector<json>& strokes) {
  std::vector<DrawnSegment> segments;
  for (const json& stroke : strokes) segments.push_back(segment_of(stroke));
  return segments;
}

// The length of one line that overlaps another, in mm.
double overlap(const DrawnSegment& a, const DrawnSegment& b) {
  const double length = std::hypot(a[2] - a[0], a[3] - a[1]);
  const double across = (a[2] - a[0]) / length;
  const double up = (a[3] - a[1]) / length;
  std::array<double, 2> along{};
  for (const std::size_t end : {0U, 2U}) {
    const double x = b[end] - a[0];
    const double y = b[end + 1] - a[1];
    if (std::abs(y * across - x * up) > 1e-5) return 0;
    along[end / 2] = x * across + y * up;
  }
  return std::min(length, std::max(along[0], along[1])) - std::max(0.0, std::min(along[0], along[1]));
}

void expect_each_stretch_once(const std::vector<json>& strokes) {
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const DrawnSegment a = segment_of(strokes[i]);
    EXPECT_GT(std::hypot(a[2] - a[0], a[3] - a[1]), 1e-5) << strokes[i];
    for (std::size_t k = 0; k < i; ++k) EXPECT_LT(overlap(a, segment_of(strokes[k])), 1e-5) << strokes[i] << strokes[k];
  }
}

// Of a box seen from a corner nine edges are visible, three of them inside the outline.
TEST_F(DrawStrokes, NoOuterEdgeIsLostInAnyFormat) {
  using Case = std::tuple<std::string, Arguments>;
  for (const auto& [mesh, view] : {Case{"outer-edge-whole-numbers.obj", {"--view", "dimetric"}},
                                   Case{"outer-edge-house.obj", {"--vertical", "z", "--orthographic", "-1,2,-1"}}}) {
    for (const Arguments& paper : {Arguments{}, Arguments{"--size", "A4"}, Arguments{"--size", "A3", "--landscape", "--margin", "17.3"},
                                   Arguments{"--size", "100x73", "--margin", "3"}}) {
      for (const std::string file : {"a.svg", "a.plt", "a.dxf", "a.pdf"}) {
        Arguments options = view;
        options.insert(options.end(), paper.begin(), paper.end());
        const std::vector<json> rows = strokes(mesh, options, file);
        ASSERT_EQ(rows.size(), 9U) << mesh << ' ' << file;
        std::map<std::string, int> kinds;
        for (const json& row : rows) ++kinds[row.at("kind").get<std::string>()];
        EXPECT_EQ(kinds, (std::map<std::string, int>{{"crease", 3}, {"silhouette", 6}}));
        const std::string text = read(file);
        sightline::tests::DrawnLines lines;
        double tolerance = 0.008;  // pen_order joins ends within 0.005 mm; files have micrometres
        if (file == "a.svg") {
          const std::size_t height = text.find("height=\"") + 8;
          lines = sightline::tests::lines_of_svg(text, std::atof(text.c_str() + height));
        } else if (file == "a.plt") {
          lines = sightline::tests::lines_of_hpgl(text);
          for (auto& line : lines)
            for (auto& [x, y] : line) x *= 0.025, y *= 0.025;
          tolerance += 0.018;
        } else {
          lines = file == "a.dxf" ? sightline::tests::lines_of_dxf(text) : sightline::tests::lines_of_pdf(text);
        }
        const auto found = sightline::tests::segments_of(lines);
        for (const DrawnSegment& stroke : segments_of(rows))
          EXPECT_LE(sightline::tests::distance_from(found, stroke), tolerance) << mesh << ' ' << file;
        for (const DrawnSegment& line : found)
          EXPECT_LE(sightline::tests::distance_from(segments_of(rows), line), tolerance) << mesh << ' ' << file;
      }
    }
  }
}

// Two cubes of 10, the second moved by 5 to the right and to the front: together 15 wide and 10 high, 12 mm per unit.
TEST_F(DrawStrokes, LinesThatCoincideInAViewAlongAnAxis) {
  const std::vector<json> rows = strokes("twice-aligned-view.obj", {"--view", "front"});
  std::set<std::array<double, 4>> lines;
  for (const DrawnSegment& line : segments_of(rows)) lines.insert(line);
  EXPECT_EQ(lines, (std::set<std::array<double, 4>>{
                       {10, 40, 190, 40}, {10, 160, 190, 160}, {10, 40, 10, 160}, {70, 40, 70, 160}, {190, 40, 190, 160}}));
  EXPECT_EQ(rows.size(), 5U);
  // The top is an edge of each cube.
  for (const json& row : rows)
    if (row.at("from") == json({10, 160}) && row.at("to") == json({190, 160})) {
      EXPECT_EQ(row.at("edges").size(), 2U) << row;
      EXPECT_EQ(row.at("faces").size(), 4U) << row;
    }
}

TEST_F(DrawStrokes, BricksAreDrawnOnce) {
  for (const char* view : {"iso", "front", "top", "right", "dimetric"}) {
    const std::vector<json> visible = strokes("twice-bricks.obj", {"--view", view});
    expect_each_stretch_once(visible);
    const std::vector<json> all = strokes("twice-bricks.obj", {"--view", view, "--hidden"});
    expect_each_stretch_once(all);
    // From the front and the right each hidden line is covered by a visible one.
    const std::string name = view;
    EXPECT_EQ(all.size() > visible.size(), name != "front" && name != "right") << view;
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const json& row) { return !row.at("hidden").get<bool>(); }),
              static_cast<std::ptrdiff_t>(visible.size()));
  }
}

// From the top all hidden lines of a cube are under its outline, and four edges are points.
TEST_F(DrawStrokes, ACubeFromTheTopHasNoHiddenLines) {
  const std::vector<json> rows = strokes("cube.obj", {"--view", "top", "--hidden"});
  EXPECT_EQ(rows.size(), 4U);
  for (const json& row : rows) EXPECT_FALSE(row.at("hidden").get<bool>());
  EXPECT_EQ(read("a.svg").find("hidden"), std::string::npos);
}

// 20 x 40 units, 60 of them across the shorter side of the 180 mm inside the margins.
TEST_F(DrawStrokes, FieldCountsUnitsOfTheFile) {
  std::set<std::array<double, 4>> lines;
  for (const DrawnSegment& line : segments_of(strokes("field-in-steps.obj", {"--view", "front", "--field", "60"}))) lines.insert(line);
  EXPECT_EQ(lines, (std::set<std::array<double, 4>>{{70, 40, 130, 40}, {70, 160, 130, 160}, {70, 40, 70, 160}, {130, 40, 130, 160}}));
}

// A closed line with a side of 0.5 mm, and a separate tick of 0.4 mm.
TEST_F(DrawStrokes, ShortLinesAreOmittedUnlessTheyCloseAGap) {
  write("l.obj", "v 0 0 0\nv 100 0 0\nv 100 50 0\nv 99.6 50.3 0\nv 0 50 0\nv 20 20 0\nv 20.4 20 0\nl 1 2 3 4 5 1\nl 6 7\n");
  const auto count = [&](const Arguments& more) {
    Arguments words{"draw", "exact", "l.obj", "--view", "front", "--scale", "1:1", "--strokes", "s.jsonl", "-o", "l.svg"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(sightline(words).exit_code, 0);
    const std::string text = read("s.jsonl");
    return std::count(text.begin(), text.end(), '\n');
  };
  const auto whole = count({});
  EXPECT_EQ(whole, 6);
  EXPECT_EQ(count({"--min-length", "0.3"}), whole);
  EXPECT_EQ(count({"--min-length", "0.5"}), whole - 1) << "the tick of 0.4 mm";
  EXPECT_EQ(count({"--min-length", "290"}), whole - 1) << "all sides together have 300.1";
  EXPECT_EQ(count({"--min-length", "320"}), 0) << "the closed line, too";
  EXPECT_EQ(sightline({"draw", "exact", "l.obj", "--min-length", "1", "-o", "l.png"}).exit_code, 2);
}

TEST_F(DrawStrokes, StrokesAreWrittenToAFileOrStandardOutput) {
  const std::string cube = drawing_data + "cube.obj";
  const auto piped = sightline({"draw", "exact", cube, "--view", "iso", "--strokes", "-", "-o", "c.svg"});
  EXPECT_EQ(piped.exit_code, 0);
  EXPECT_EQ(std::count(piped.out.begin(), piped.out.end(), '\n'), 9);
  EXPECT_EQ(sightline({"draw", "exact", cube, "--strokes", "-", "--json", "-o", "c.svg"}).exit_code, 2);
  EXPECT_EQ(sightline({"draw", "exact", cube, "--strokes", "-", "-o", "-"}).exit_code, 2);
  EXPECT_EQ(sightline({"draw", "exact", cube, "--strokes", "c.svg", "-o", "c.svg"}).exit_code, 2);
  const auto image = sightline({"draw", "exact", cube, "--strokes", "s.jsonl", "-o", "c.png"});
  EXPECT_EQ(image.exit_code, 2);
  EXPECT_NE(image.err.find("--strokes: found without --size, or a name that does not end in .png"), std::string::npos) << image.err;
  EXPECT_EQ(sightline({"draw", "exact", cube, "--turntable", "12", "--strokes", "t.jsonl", "-o", "t.svg"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("t-01.jsonl")));
  EXPECT_TRUE(std::filesystem::exists(path("t-12.jsonl")));
  // Also for a scene without kinds.
  const auto boxes = sightline({"draw", "exact", "boxes-3", "--strokes", "-", "-o", "r.svg"});
  EXPECT_EQ(boxes.exit_code, 0);
  EXPECT_NE(boxes.out.find("\"kind\":\"silhouette\",\"layer\":\"visible\""), std::string::npos);
}

}  // namespace
