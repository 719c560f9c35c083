// What a caption names is numbered: in the image, in the plan or the chart, or in both. Also the position of labels on outlines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/explain/explain.hpp"
#include "host/explain/stage.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::explain {
namespace {

scene::LoadedScene scene_named(const std::string& name) {
  auto found = scene::named_scene(name);
  EXPECT_TRUE(found && *found) << name;
  return *scene::load_scene(std::move(**found));
}

Lesson lesson_of(const std::string& algorithm, const std::string& name) {
  const scene::LoadedScene source = scene_named(name);
  auto lesson = explain_scene(*find_explainer(algorithm), source, source.scene.camera);
  EXPECT_TRUE(lesson) << algorithm << ' ' << name;
  return std::move(*lesson);
}

// "cell 3", "portal 5", "face 7", "surface 12"; for an edge and a vertex only the number: as readers find them in a caption.
std::set<std::string> named_in(const std::string& caption) {
  static const std::regex thing(R"(\b(cell|portal|face|surface) (\d+))", std::regex::icase);
  static const std::regex things(R"(\b(face|surface|portal)s (\d+)(?: and |, )(\d+))", std::regex::icase);
  static const std::regex vertex(R"(\bvertex (\d+))", std::regex::icase);
  static const std::regex edge(R"(\bedge (\d+)-(\d+))", std::regex::icase);
  static const std::regex from_to(R"(\bedge from (\d+) to (\d+))", std::regex::icase);
  std::set<std::string> names;
  const auto each = [&](const std::regex& expression, auto take) {
    for (std::sregex_iterator at(caption.begin(), caption.end(), expression), end; at != end; ++at) take(*at);
  };
  const auto lower = [](std::string word) {
    word[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(word[0])));
    return word;
  };
  each(thing, [&](const std::smatch& m) { names.insert(lower(m[1]) + ' ' + m[2].str()); });
  each(things, [&](const std::smatch& m) {
    for (const std::size_t i : {2U, 3U}) names.insert(lower(m[1]) + ' ' + m[i].str());
  });
  each(vertex, [&](const std::smatch& m) { names.insert(m[1]); });
  each(edge, [&](const std::smatch& m) { names.insert({m[1].str(), m[2].str()}); });
  each(from_to, [&](const std::smatch& m) { names.insert({m[1].str(), m[2].str()}); });
  return names;
}

// The words on a sheet: "surface 3, cell 2" counts as two.
std::set<std::string> words_of(const std::map<std::string, std::vector<Mark>>& layers) {
  std::set<std::string> words;
  for (const auto& [name, marks] : layers) {
    for (const Mark& mark : marks) {
      if (mark.kind != Mark::Kind::text && mark.kind != Mark::Kind::label) continue;
      const std::size_t comma = mark.text.find(", ");
      words.insert(mark.text.substr(0, comma));
      if (comma != std::string::npos) words.insert(mark.text.substr(comma + 2));
    }
  }
  return words;
}

struct Case {
  const char* algorithm;
  std::vector<std::string> scenes;
  std::vector<std::size_t> sheets;  // on which everything named has its number
};

TEST(LessonNumbers, ExistForEverythingThatACaptionNames) {
  const std::vector<Case> cases{
      {"exact", {"boxes-2", "roberts"}, {0}},
      {"jones", {"house", "street4", "town-2"}, {1}},
      {"montani-re", {"boxes-3", "bricks-2", "town-2"}, {0}},
      {"willis", {"boxes-3", "bricks-2", "town-2"}, {0, 1}},
      {"plantinga", {"house", "triangles-3"}, {0, 1}},
  };
  for (const Case& each : cases) {
    for (const std::string& scene : each.scenes) {
      const Lesson lesson = lesson_of(each.algorithm, scene);
      std::vector<std::map<std::string, std::vector<Mark>>> state(lesson.sheets.size());
      std::size_t named = 0;
      for (const Step& step : lesson.steps) {
        for (const Layer& layer : step.changes) state[layer.sheet][layer.name] = layer.marks;
        const std::set<std::string> names = named_in(step.caption);
        for (const std::size_t sheet : each.sheets) {
          const std::set<std::string> words = words_of(state[sheet]);
          for (const std::string& name : names) {
            ++named;
            EXPECT_TRUE(words.count(name)) << each.algorithm << " of " << scene << ", sheet " << sheet << ": no " << name << " for: " << step.caption;
          }
        }
        for (std::size_t sheet = 0; sheet < state.size(); ++sheet) {
          const Sheet& box = lesson.sheets[sheet];
          for (const Mark& mark : state[sheet]["numbers"]) {
            for (std::size_t a = 0; a < 2; ++a)
              EXPECT_TRUE(mark.points[0][a] >= box.low[a] - 1e-9 && mark.points[0][a] <= box.high[a] + 1e-9)
                  << each.algorithm << " of " << scene << ": " << mark.text << " is off the sheet";
          }
          EXPECT_LE(state[sheet]["numbers"].size(), 64U) << each.algorithm << " of " << scene;
        }
      }
      EXPECT_GT(named, 10U) << each.algorithm << " of " << scene;
    }
  }
}

// In the image an entered cell has its number in its mask, and a portal in front of the eye has its own number.
TEST(LessonNumbers, OfJonesAreInTheImage) {
  for (const std::string scene : {"house", "street4"}) {
    const Lesson lesson = lesson_of("jones", scene);
    std::map<std::string, std::vector<Mark>> layers;
    std::size_t entered = 0, portals = 0;
    for (const Step& step : lesson.steps) {
      for (const Layer& layer : step.changes)
        if (layer.sheet == 0) layers[layer.name] = layer.marks;
      const auto names = named_in(step.caption);
      const auto words = words_of(layers);
      if (step.caption.find(" is entered. ") != std::string::npos && !layers["mask"].empty()) {
        ++entered;
        EXPECT_TRUE(words.count(*names.begin())) << step.caption;
      }
      if (step.caption.find(" waits with it") != std::string::npos && layers["portal"].size() == 2) {
        ++portals;
        for (const std::string& name : names) EXPECT_TRUE(words.count(name)) << name << ": " << step.caption;
      }
    }
    EXPECT_GT(entered, 2U) << scene;
    EXPECT_GT(portals, 2U) << scene;
  }
}

TEST(LessonNumbers, DoNotChangeTheirPlaceInThePlan) {
  const Lesson lesson = lesson_of("jones", "street4");
  std::map<std::string, Point> places;
  std::size_t seen = 0;
  for (const Step& step : lesson.steps) {
    for (const Layer& layer : step.changes) {
      if (layer.sheet != 1) continue;
      for (const Mark& mark : layer.marks) {
        if (mark.kind != Mark::Kind::label || mark.text.starts_with("portal")) continue;
        const std::string number = mark.text.starts_with("cell ") ? mark.text.substr(5) : mark.text;
        const auto [known, fresh] = places.try_emplace(number, mark.points[0]);
        EXPECT_EQ(known->second, mark.points[0]) << number;
        ++seen;
      }
    }
  }
  EXPECT_EQ(places.size(), 26U);
  EXPECT_GT(seen, 300U);
}

// A point is inside an outline if a ray to the right, tilted so that it meets no corner, crosses it an odd number of times.
bool within(const std::vector<Point>& outline, const Point& p) {
  bool inside = false;
  const double slope = 0.0123456789;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto above = [&](const Point& q) { return q[1] - p[1] - slope * (q[0] - p[0]); };
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    if ((above(a) > 0) == (above(b) > 0)) continue;
    const double t = above(a) / (above(a) - above(b));
    if (a[0] + t * (b[0] - a[0]) > p[0]) inside = !inside;
  }
  return inside;
}

TEST(LabelPoint, IsWithinTheOutline) {
  const std::vector<Point> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(label_point(square), (Point{2, 2}));
  EXPECT_EQ(label_point(square, 0.75), (Point{2, 3}));
  // Its centroid is outside.
  const std::vector<Point> horseshoe{{0, 0}, {6, 0}, {6, 5}, {4, 5}, {4, 1}, {1, 1}, {1, 5}, {0, 5}};
  EXPECT_EQ(label_point(horseshoe), (Point{5, 2.5})) << "the broader leg";
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.2, 1);
  for (int n = 0; n < 200; ++n) {
    std::vector<Point> star;
    for (int i = 0; i < 9; ++i) {
      const double r = radius(random);
      star.push_back({r * std::cos(i * 0.698 + 0.1), r * std::sin(i * 0.698 + 0.1)});
    }
    for (const double height : {0.3, 0.5, 0.92}) EXPECT_TRUE(within(star, label_point(star, height))) << n;
  }
}

TEST(LabelPoint, OfAnOutlineWithoutAnAreaIsOnIt) {
  EXPECT_EQ(label_point({{1, 3}, {5, 3}, {5, 3}, {1, 3}}), (Point{3, 3}));
  EXPECT_EQ(label_point({{2, 1}, {2, 5}, {2, 5}, {2, 1}}), (Point{2, 3}));
  EXPECT_EQ(label_point({{2, 1}}), (Point{2, 1}));
}

// The length of a line within the field of 90 degrees.
double length_within(const Point& from, const Point& to) {
  double low = 0, high = 1;
  for (std::size_t a = 0; a < 2; ++a) {
    const double d = to[a] - from[a];
    for (const double side : {-1.0, 1.0}) {
      const double reach = 1 - side * from[a];  // side * (from + t d) <= 1
      if (side * d > 0) high = std::min(high, reach / (side * d));
      if (side * d < 0) low = std::max(low, reach / (side * d));
      if (d == 0 && reach < 0) return 0;
    }
  }
  return high > low ? (high - low) * std::hypot(to[0] - from[0], to[1] - from[1]) : 0;
}

// If the eye is in a cell the lesson draws exactly the real lines that the oracle of cells sees: the corners of the room are
// among
// them, the joints of solids are not.
TEST(LessonOfJones, ShowsTheRealLines) {
  namespace oracle = algorithms::oracle;
  for (const std::string name : {"house", "street4", "corridor8"}) {
    const scene::LoadedScene source = scene_named(name);
    const scene::PolyCamera& camera = source.scene.camera;
    const Lesson lesson = lesson_of("jones", name);
    double shown = 0;
    for (const Layer& layer : lesson.steps.back().changes)
      if (layer.sheet == 0 && layer.name == "seen")
        for (const Mark& mark : layer.marks) shown += length_within(mark.points[0], mark.points[1]);
    oracle::Window window;
    window.scale = 4096;
    window.centre = {4096, 4096};
    window.points = {geometry::Span{0, 8192}, geometry::Span{0, 8192}};
    window.near = 1;
    const auto lines = oracle::visible_lines(*source.cells, camera.eye, window);
    ASSERT_TRUE(lines) << name;
    double expected = 0;
    for (const auto& line : oracle::on_screen(*lines, camera.eye, window)) expected += std::hypot(line.x1 - line.x0, line.y1 - line.y0) / 4096;
    EXPECT_GT(expected, 3) << name;
    EXPECT_NEAR(shown, expected, 0.005 * expected) << name;
  }
}

}  // namespace
}  // namespace sightline::explain
