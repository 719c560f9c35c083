// The hard cases P1 to P22 of Plantinga, Seales and Dyer (1990) at the level of the algorithm: potential events of a few edges
// and
// vertices, and required properties of the structures of a turn. P18, a large model, is in model_turns_test.cpp. The report has
// pictures of the turning scenes (host/compare/hard_cases/manifest.json).
//
// A file has one edge or vertex per line: "edge x y z  x y z", "vertex x y z"; "#" begins a comment.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/potential_events.hpp"
#include "tests/host/scene/hard_case_files.hpp"

namespace sightline::algorithms::plantinga {
namespace {

struct EventLines {
  std::vector<Vector3> vertices;
  std::vector<Segment> edges;

  [[nodiscard]] bool are_three_edges() const { return vertices.empty() && edges.size() == 3; }
  // Every vertex with every edge; if there are only two edges, the ends of each with the other.
  [[nodiscard]] std::vector<std::pair<Vector3, Segment>> pairs() const {
    std::vector<std::pair<Vector3, Segment>> all;
    for (const Vector3& vertex : vertices)
      for (const Segment& edge : edges) all.emplace_back(vertex, edge);
    if (!vertices.empty() || edges.size() != 2) return all;
    for (const std::size_t i : {0U, 1U})
      for (const Vector3& end : {edges[i].from, edges[i].to}) all.emplace_back(end, edges[1 - i]);
    return all;
  }
};

EventLines lines_of(const std::string& file) {
  EventLines lines;
  std::istringstream text(scene::hard_case_text(file));
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    const auto point = [&words] {
      Vector3 p{};
      words >> p[0] >> p[1] >> p[2];
      return p;
    };
    if (kind == "vertex") {
      lines.vertices.push_back(point());
    } else if (kind == "edge") {
      const Vector3 from = point();
      lines.edges.push_back({from, point()});
    } else {
      EXPECT_EQ(kind, "#") << file;
    }
    EXPECT_TRUE(words) << file << ": " << line;
  }
  return lines;
}

QuadraticForm form_of(const EventLines& lines) {
  return meeting_form(crossing_of(lines.edges[0], lines.edges[1]),
                      crossing_of(lines.edges[0], lines.edges[2]));
}

// whole_lines: at all meetings of the lines of three edges, also outside the edges.
std::vector<Direction> events_of(const EventLines& lines, bool whole_lines) {
  std::vector<Direction> events;
  if (lines.are_three_edges())
    events = whole_lines ? roots_of(form_of(lines))
                         : three_edge_events({lines.edges[0], lines.edges[1], lines.edges[2]});
  for (const auto& [vertex, edge] : lines.pairs()) {
    const auto both = vertex_edge_events(vertex, edge);
    events.insert(events.end(), both.begin(), both.end());
  }
  sort_and_group(events);
  return events;
}

// --- The same formulas in doubles alone

using Real3 = std::array<double, 3>;

Real3 difference(const Vector3& a, const Vector3& b) {
  Real3 d{};
  for (std::size_t axis = 0; axis < 3; ++axis) d[axis] = static_cast<double>(a[axis] - b[axis]);
  return d;
}
std::array<double, 2> cross_xz(const Real3& a, const Real3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[0] * b[1] - a[1] * b[0]};
}

// As in Crossing: X and Z of each form.
struct NearCrossing {
  NearCrossing(const Segment& edge, const Segment& other)
      : n(cross_xz(difference(other.from, edge.from), difference(other.to, other.from))),
        d(cross_xz(difference(edge.to, edge.from), difference(other.to, other.from))),
        m(cross_xz(difference(other.from, edge.from), difference(edge.to, edge.from))) {}

  [[nodiscard]] bool meets_inside(double angle) const {
    const auto at = [angle](const std::array<double, 2>& form) {
      return form[0] * std::sin(angle) + form[1] * std::cos(angle);
    };
    const auto inside = [](double place) { return place > 0 && place < 1; };
    return inside(at(n) / at(d)) && inside(at(m) / at(d));
  }

  std::array<double, 2> n, d, m;
};

// A direction and its opposite are one line: its angle from 0 to pi.
double angle_of_line(double x, double z) {
  return x < 0 || (x == 0 && z < 0) ? std::atan2(-x, -z) : std::atan2(x, z);
}

std::vector<double> roots_in_doubles(const NearCrossing& second, const NearCrossing& third) {
  const double xx = second.n[0] * third.d[0] - third.n[0] * second.d[0];
  const double xz = second.n[0] * third.d[1] + second.n[1] * third.d[0] - third.n[0] * second.d[1] -
                    third.n[1] * second.d[0];
  const double zz = second.n[1] * third.d[1] - third.n[1] * second.d[1];
  const double discriminant = xz * xz - 4 * xx * zz;
  if (!(discriminant > 0)) return {};
  const double q = -(xz + std::copysign(std::sqrt(discriminant), xz)) / 2;
  return {angle_of_line(q, xx), angle_of_line(zz, q)};
}

std::size_t event_count_in_doubles(const EventLines& lines, bool whole_lines) {
  std::vector<double> angles;
  if (lines.are_three_edges()) {
    const NearCrossing second(lines.edges[0], lines.edges[1]);
    const NearCrossing third(lines.edges[0], lines.edges[2]);
    for (const double angle : roots_in_doubles(second, third))
      if (whole_lines || (second.meets_inside(angle) && third.meets_inside(angle))) angles.push_back(angle);
  }
  for (const auto& [vertex, edge] : lines.pairs()) {
    const Real3 along = difference(edge.to, edge.from);
    const Real3 from = difference(vertex, edge.from);
    const auto m = cross_xz(from, along);
    if (from[1] / along[1] >= 0 && from[1] / along[1] <= 1 && (m[0] != 0 || m[1] != 0))
      angles.push_back(angle_of_line(m[1], -m[0]));
  }
  std::sort(angles.begin(), angles.end());
  return 2 * static_cast<std::size_t>(std::unique(angles.begin(), angles.end()) - angles.begin());
}

// --- P1 to P14, P17, P19

using XZ = std::array<std::int64_t, 2>;  // X : Z, the sine to the cosine of theta

struct Expected {
  std::size_t directions = 0;
  std::vector<XZ> there = {};
  std::optional<std::array<std::int64_t, 3>> form = std::nullopt;  // of three edges, but for its sign
  std::vector<double> tangents = {};
  bool whole_lines = false;
};

// Compares directions including their opposites; doubles must give the same number.
void expect_events(const std::string& file, const Expected& expected) {
  SCOPED_TRACE(file);
  const EventLines lines = lines_of(file);
  const auto events = events_of(lines, expected.whole_lines);
  EXPECT_EQ(events.size(), expected.directions);
  EXPECT_EQ(event_count_in_doubles(lines, expected.whole_lines), events.size());
  for (const XZ& d : expected.there)
    EXPECT_NE(std::find(events.begin(), events.end(), rational_direction(d[0], d[1])), events.end())
        << d[0] << ':' << d[1];
  for (const double tangent : expected.tangents)
    EXPECT_TRUE(std::any_of(events.begin(), events.end(), [&](const Direction& event) {
      return std::abs(std::tan(event.angle) - tangent) < 1e-9;
    })) << tangent;
  if (!expected.form) return;
  const auto [xx, xz, zz] = *expected.form;
  const QuadraticForm form = form_of(lines);
  EXPECT_TRUE((form == QuadraticForm{xx, xz, zz} || form == QuadraticForm{-xx, -xz, -zz}));
}

TEST(PlantingaHardCases, P1DoubleRootsAreNoEvents) {
  expect_events("P1.txt", {.form = {{-88, 0, 0}}});
  expect_events("P1b.txt", {.form = {{-256, -128, -16}}});
  expect_events("P1c.txt", {.form = {{-196, 56, -4}}});
}
TEST(PlantingaHardCases, P1EdgesOnOneLineOfTheImage) {
  expect_events("P1d.txt", {.form = {{-81, 108, -36}}});
  expect_events("P1d-2.txt", {});
}
TEST(PlantingaHardCases, P2NearlyDoubleRoots) {
  expect_events("P2-apart.txt", {.directions = 4});
  expect_events("P2-none.txt", {});
  expect_events("P2b-apart.txt", {.directions = 4});
  expect_events("P2b-none.txt", {});
  const auto apart = events_of(lines_of("P2-apart.txt"), false);
  EXPECT_NEAR(apart[2].angle - apart[1].angle, 1.5e-3, 5e-5);
}
TEST(PlantingaHardCases, P3TwoIrrationalRoots) {
  expect_events("P3.txt",
                {.directions = 4, .form = {{129, 111, 18}}, .tangents = {-0.643692555, -0.216772561}});
}
TEST(PlantingaHardCases, P4ARootAt90Degrees) {
  expect_events("P4.txt", {.directions = 4,
                           .there = {{1, 0}, {-1, 0}, {-2, 3}, {2, -3}},
                           .form = {{0, -72, -48}},
                           .whole_lines = true});
}
TEST(PlantingaHardCases, P5AVertexAt90Degrees) {
  expect_events("P5.txt", {.directions = 2, .there = {{1, 0}, {-1, 0}}});
}
TEST(PlantingaHardCases, P6TwoEventsNearerThanATrillionth) {
  expect_events("P6.txt", {.directions = 4, .there = {{832040, 1346269}, {1346269, 2178309}}});
}
TEST(PlantingaHardCases, P7TwoVerticesOnOneLineOfSight) {
  expect_events("P7.txt", {.directions = 2, .there = {{1, 2}, {-1, -2}}});
}
TEST(PlantingaHardCases, P8AVertexThatSlidesAlongALevelEdge) {
  expect_events("P8.txt", {});
}
TEST(PlantingaHardCases, P10VerticalEdgesCoincideAsAWhole) {
  expect_events("P10.txt", {.directions = 2, .there = {{1, 2}, {-1, -2}}});
}
TEST(PlantingaHardCases, P11AVertexOnTheAxis) {
  expect_events("P11.txt", {.directions = 2, .there = {{3, 4}, {-3, -4}}});
}
TEST(PlantingaHardCases, P12AnEdgeOnTheAxis) {
  expect_events("P12.txt", {.directions = 2, .there = {{3, 4}, {-3, -4}}});
}
TEST(PlantingaHardCases, P13FormsThatVanish) {
  expect_events("P13.txt", {.form = {{0, 0, 0}}});
  expect_events("P13-parallel.txt", {.form = {{0, 0, 0}}});
}
TEST(PlantingaHardCases, P13AFaceThatTurnsOver) {
  expect_events("P13-face.txt", {.whole_lines = true});
}
TEST(PlantingaHardCases, P14AConstantForm) {
  expect_events("P14.txt", {.form = {{0, 0, -700}}, .whole_lines = true});
}
TEST(PlantingaHardCases, P17AMeetingAtAnEndIsOfTheVertex) {
  const EventLines lines = lines_of("P17.txt");
  for (const Direction& end : {rational_direction(0, 1), rational_direction(0, -1)}) {
    const auto events = events_of(lines, false);
    EXPECT_EQ(std::find(events.begin(), events.end(), end), events.end());
    const auto roots = events_of(lines, true);
    EXPECT_NE(std::find(roots.begin(), roots.end(), end), roots.end());
  }
  expect_events("P17-vertex.txt", {.directions = 2, .there = {{0, 1}, {0, -1}}});
}
TEST(PlantingaHardCases, P19AnEventAtPi) {
  expect_events("P19.txt", {.directions = 2, .there = {{0, 1}, {0, -1}}});
}

// --- Turning scenes

struct Turned {
  explicit Turned(scene::PolyScene of) : scene(std::move(of)), model(scene), list(*build_event_list(model)) {}

  // Visits every end of a piece that ever occurs, with its edge.
  template <class Visit>
  void for_ends(Visit visit) const {
    const auto all = [&](EdgeIndex edge, std::span<const Piece> pieces) {
      for (const Piece& piece : pieces) {
        visit(edge, piece.low);
        visit(edge, piece.high);
      }
    };
    for (EdgeIndex edge = 0; edge < list.first.size(); ++edge) all(edge, list.first[edge]);
    for (const Change& change : list.changes) all(change.edge, list.added_by(change));
  }
  [[nodiscard]] bool as_from_scratch(const EdgeStructureGraph& graph) const {
    const std::size_t count = list.events.size();
    const Direction& before = list.events[(graph.passed() + count - 1) % count].direction;
    const Direction& after = list.events[graph.passed() % count].direction;
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge)
      if (graph.structure_of(edge) != structure_between(model, edge, model.occluders_of(edge), before, after))
        return false;
    return true;
  }

  scene::PolyScene scene;
  RotationModel model;
  EventList list;
};

// Between every two events of a turn, and backwards.
TEST(PlantingaHardCases, TurnsAreAsFromScratch) {
  for (const char* file : {"P9.json", "P15.json", "P16.json", "P20.json", "P21.json"}) {
    const Turned turned(scene::hard_case_scene(file));
    EdgeStructureGraph graph(turned.list);
    const std::size_t count = turned.list.events.size();
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(graph.step_forward()) << file;
      ASSERT_TRUE(turned.as_from_scratch(graph)) << file << " after event " << i;
    }
    for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(graph.step_backward()) << file;
    for (EdgeIndex edge = 0; edge < turned.list.first.size(); ++edge)
      EXPECT_EQ(graph.structure_of(edge), turned.list.first[edge]) << file;
  }
}

TEST(PlantingaHardCases, P9LevelEdgesOfOneHeightNeverCross) {
  const Turned turned(scene::hard_case_scene("P9.json"));
  const auto level = [&](EdgeIndex edge) -> std::optional<std::int64_t> {
    const Segment segment = turned.model.segment(edge);
    if (segment.from[1] != segment.to[1]) return std::nullopt;
    return segment.from[1];
  };
  turned.for_ends([&](EdgeIndex edge, const End& end) {
    if (end.kind() == EndKind::junction && level(edge)) {
      EXPECT_NE(level(edge), level(end.index()));
    }
  });
}

TEST(PlantingaHardCases, P15AFaceTurnsOverInOneGroup) {
  const Turned turned(scene::hard_case_scene("P15.json"));
  std::vector<Direction> directions;
  for (const Event& event : turned.list.events) directions.push_back(event.direction);
  std::vector<Direction> expected{rational_direction(-3, -4), rational_direction(-4, 3),
                                  rational_direction(3, 4), rational_direction(4, -3)};
  sort_and_group(expected);
  EXPECT_EQ(directions, expected);
}

TEST(PlantingaHardCases, P16ALevelSheetHidesNothing) {
  const Turned turned(scene::hard_case_scene("P16.json"));
  const auto& sheet = turned.scene.bodies.back().faces.front().outline;
  const auto on_sheet = [&](scene::VertexIndex v) {
    return std::find(sheet.begin(), sheet.end(), v) != sheet.end();
  };
  turned.for_ends([&](EdgeIndex, const End& end) {
    if (end.kind() != EndKind::junction) return;
    const auto& edge = turned.model.edges()[end.index()];
    EXPECT_FALSE(on_sheet(edge.from) && on_sheet(edge.to));
  });
}

// Frames 30 degrees apart, forwards and backwards, and half a turn at once.
TEST(PlantingaHardCases, P20LargeSteps) {
  const Turned turned(scene::hard_case_scene("P20.json"));
  EdgeStructureGraph graph(turned.list);
  const auto expect_at = [&](double degrees) {
    ASSERT_TRUE(graph.turn_to(degrees * std::numbers::pi / 180));
    EXPECT_TRUE(turned.as_from_scratch(graph)) << degrees;
  };
  for (int i = -6; i <= 6; ++i) expect_at(30 * i + 0.001);
  for (int i = 6; i >= -6; --i) expect_at(30 * i + 0.002);
  expect_at(0.003);
}

// Seen from in front of the common plane, the front faces are always completely visible.
TEST(PlantingaHardCases, P21FrontsInOnePlaneHideNothingOfEachOther) {
  const Turned turned(scene::hard_case_scene("P21.json"));
  std::int64_t front = turned.model.vertices()[0][2];
  for (const Vector3& vertex : turned.model.vertices()) front = std::max(front, vertex[2]);
  EdgeStructureGraph graph(turned.list);
  const auto& events = turned.list.events;
  for (std::size_t i = 0; i + 1 < events.size(); ++i) {
    ASSERT_TRUE(graph.step_forward());
    if (std::abs(events[i].direction.angle + events[i + 1].direction.angle) > std::numbers::pi) continue;
    for (EdgeIndex edge = 0; edge < turned.model.edges().size(); ++edge) {
      const Segment segment = turned.model.segment(edge);
      if (segment.from[2] != front || segment.to[2] != front) continue;
      const auto pieces = graph.structure_of(edge);
      ASSERT_EQ(pieces.size(), 1U) << "edge " << edge << " after event " << i;
      EXPECT_EQ(pieces[0].low.kind(), EndKind::vertex);
      EXPECT_EQ(pieces[0].high.kind(), EndKind::vertex);
    }
  }
}

}  // namespace
}  // namespace sightline::algorithms::plantinga
