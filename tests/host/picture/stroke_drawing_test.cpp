// The SVG drawing: read back by a small independent parser it must be well-formed XML, cover exactly the lit points, and place
// them as
// on the tube.
#include "host/picture/stroke_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "host/picture/stroke_recorders.hpp"
#include "tests/host/picture/synthetic.hpp"

namespace sightline::picture {
namespace {

using Points = std::set<std::pair<int, int>>;

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string parent;
  std::string layer;  // inkscape:label of its group
};

// Elements of an XML text without entities in attributes, comments or CDATA; any error fails the test.
std::vector<Element> parse_xml(const std::string& text) {
  std::vector<Element> elements;
  std::vector<Element> open;
  std::size_t at = text.find("?>");
  while ((at = text.find('<', at)) != std::string::npos) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) {
      ADD_FAILURE() << "a tag without end";
      break;
    }
    std::string tag = text.substr(at + 1, end - at - 1);
    at = end;
    if (tag.front() == '/') {
      EXPECT_FALSE(open.empty());
      if (open.empty()) break;
      EXPECT_EQ(tag.substr(1), open.back().name);
      open.pop_back();
      continue;
    }
    const bool closed = tag.back() == '/';
    if (closed) tag.pop_back();
    Element element;
    std::size_t i = tag.find_first_of(" \n");
    element.name = tag.substr(0, i);
    if (!open.empty()) {
      element.parent = open.back().name;
      if (open.back().attributes.contains("inkscape:label"))
        element.layer = open.back().attributes["inkscape:label"];
    }
    while (i != std::string::npos && (i = tag.find_first_not_of(" \n", i)) != std::string::npos) {
      const std::size_t equals = tag.find("=\"", i);
      const std::size_t quote = equals == std::string::npos ? equals : tag.find('"', equals + 2);
      if (quote == std::string::npos) {
        ADD_FAILURE() << "an attribute without value in " << tag;
        break;
      }
      const bool is_new =
          element.attributes.emplace(tag.substr(i, equals - i), tag.substr(equals + 2, quote - equals - 2))
              .second;
      EXPECT_TRUE(is_new) << tag;
      i = quote + 1;
    }
    elements.push_back(element);
    if (!closed) open.push_back(element);
  }
  EXPECT_TRUE(open.empty());
  return elements;
}

// Lattice points on the polylines of each layer; positions must be within 0.1 um of a point's middle.
std::map<std::string, Points> covered_points(const std::string& svg) {
  std::map<std::string, Points> covered;
  for (const Element& element : parse_xml(svg)) {
    if (element.name != "polyline") continue;
    std::vector<std::pair<double, double>> corners;
    const char* next = element.attributes.at("points").c_str();
    while (*next != '\0') {
      char* rest = nullptr;
      const double across = std::strtod(next, &rest);
      EXPECT_EQ(*rest, ',');
      const double down = std::strtod(rest + 1, &rest);
      corners.emplace_back(across, down);
      next = *rest == ' ' ? rest + 1 : rest;
    }
    if (corners.size() == 2 && std::abs(corners[0].first - corners[1].first) < 0.1 &&
        corners[0].second == corners[1].second) {
      corners = {{(corners[0].first + corners[1].first) / 2, corners[0].second}};
    }
    std::vector<std::pair<int, int>> lattice;
    constexpr double pitch = 9.375 * 25.4 / 1024;
    for (const auto& [across, down] : corners) {
      const double x = across / pitch - 0.5;
      const double y = 1023 - (down / pitch - 0.5);
      EXPECT_NEAR(x * pitch, std::round(x) * pitch, 0.0001);
      EXPECT_NEAR(y * pitch, std::round(y) * pitch, 0.0001);
      lattice.emplace_back(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)));
    }
    Points& points = covered[element.layer];
    points.insert(lattice.front());
    for (std::size_t i = 1; i < lattice.size(); ++i) {
      const int dx = lattice[i].first - lattice[i - 1].first;
      const int dy = lattice[i].second - lattice[i - 1].second;
      EXPECT_TRUE(dx == 0 || dy == 0 || std::abs(dx) == std::abs(dy));
      const int steps = std::max(std::abs(dx), std::abs(dy));
      EXPECT_GT(steps, 0);
      for (int k = 1; k <= steps; ++k) {
        points.emplace(lattice[i - 1].first + dx / steps * k, lattice[i - 1].second + dy / steps * k);
      }
    }
  }
  return covered;
}

std::map<std::string, Points> lit_points(const std::vector<core::Stroke>& strokes) {
  std::map<std::string, Points> lit;
  for (const auto& stroke : strokes) {
    const std::string level = std::to_string(stroke.intensity);
    lit[level + " intensity " + level].emplace(stroke.x, stroke.y);
  }
  return lit;
}

std::vector<core::Stroke> strokes_at(const std::vector<std::array<int, 3>>& points) {
  std::vector<core::Stroke> strokes;
  for (const auto& [x, y, intensity] : points) {
    core::Stroke stroke;
    stroke.x = static_cast<std::uint16_t>(x);
    stroke.y = static_cast<std::uint16_t>(y);
    stroke.intensity = static_cast<std::uint8_t>(intensity);
    strokes.push_back(stroke);
  }
  return strokes;
}

TEST(JoinStrokes, RunsKeepOnlyTheirEnds) {
  const auto lines =
      join_strokes(strokes_at({{5, 5, 7}, {6, 5, 7}, {7, 5, 7}, {8, 6, 7}, {9, 7, 7}, {9, 7, 7}, {9, 6, 7}}));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].corners, (std::vector<LatticePoint>{{5, 5}, {7, 5}, {9, 7}, {9, 6}}));
}

TEST(JoinStrokes, TurningBackKeepsTheTurningPoint) {
  const auto lines = join_strokes(strokes_at({{5, 5, 7}, {6, 5, 7}, {7, 5, 7}, {6, 5, 7}, {5, 5, 7}}));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].corners, (std::vector<LatticePoint>{{5, 5}, {7, 5}, {5, 5}}));
}

TEST(JoinStrokes, GapsAndIntensitiesSeparateLines) {
  // Two points apart is a dark gap (scale 1); points at opposite edges of the screen are not adjacent.
  const auto lines = join_strokes(strokes_at({{0, 5, 7}, {2, 5, 7}, {3, 5, 6}, {1023, 5, 6}, {0, 5, 6}}));
  ASSERT_EQ(lines.size(), 5U);
  for (const auto& line : lines) EXPECT_EQ(line.corners.size(), 1U);
}

TEST(Svg, CornersOfTheScreenInMillimetres) {
  const std::string svg = svg_drawing(strokes_at({{0, 0, 7}, {1, 0, 7}, {1023, 1023, 7}}), "corners");
  // Half a point is 238.125 / 2048 = 0.11627 mm.
  EXPECT_NE(svg.find("points=\"0.1163,238.0087 0.3488,238.0087\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("points=\"237.9987,0.1163 238.0187,0.1163\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("width=\"238.125mm\" height=\"238.125mm\" viewBox=\"0 0 238.125 238.125\""),
            std::string::npos);
}

TEST(Svg, LayersOnlyForIntensitiesInUseAndTitleEscaped) {
  const std::string svg = svg_drawing(strokes_at({{3, 3, 7}, {9, 9, 0}}), "a<b> & \"c\"\x01");
  EXPECT_NE(svg.find("<title>a&lt;b&gt; &amp; &quot;c&quot;?</title>"), std::string::npos);
  int layers = 0;
  for (const auto& element : parse_xml(svg)) {
    if (element.name != "g") continue;
    ++layers;
    EXPECT_EQ(element.attributes.at("inkscape:groupmode"), "layer");
    EXPECT_EQ(element.attributes.at("stroke-linecap"), "round");
    EXPECT_EQ(element.attributes.at("inkscape:label"), layers == 1 ? "0 intensity 0" : "7 intensity 7");
  }
  EXPECT_EQ(layers, 2);
  EXPECT_EQ(parse_xml(svg_drawing({}, "")).size(), 2U) << "svg and title";
}

TEST(Svg, CoversACubeExactly) {
  auto strokes = tests::cube_pass(0, 7);
  const auto dim = tests::cube_pass(0, 2);
  strokes.insert(strokes.end(), dim.begin() + 100, dim.begin() + 900);
  const std::string svg = svg_drawing(strokes, "cube");
  EXPECT_EQ(covered_points(svg), lit_points(strokes));
  EXPECT_LT(svg.size(), 40'000U) << "straight runs are joined";
}

TEST(Svg, CoversRandomWalksExactly) {
  std::mt19937 random(1971);
  for (int walk = 0; walk < 50; ++walk) {
    std::vector<std::array<int, 3>> points;
    int x = 500;
    int y = 500;
    int intensity = 7;
    for (int i = 0; i < 300; ++i) {
      const int reach = random() % 8 == 0 ? 2 : 1;
      x += static_cast<int>(random() % 3 - 1U) * reach;
      y += static_cast<int>(random() % 3 - 1U) * reach;
      if (random() % 40 == 0) intensity = static_cast<int>(random() % 8);
      points.push_back({x, y, intensity});
    }
    const auto strokes = strokes_at(points);
    ASSERT_EQ(covered_points(svg_drawing(strokes, "walk")), lit_points(strokes)) << walk;
  }
}

}  // namespace
}  // namespace sightline::picture
