#include "host/explain/plantinga.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/turning_scene.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/explain/stage.hpp"

namespace sightline::explain {
namespace {

namespace pl = algorithms::plantinga;

constexpr std::size_t circle = 1;
constexpr std::size_t most_lesson_edges = 300;
constexpr std::size_t most_edges_shown = 40;
constexpr std::size_t most_events_shown = 250;

double degrees(double angle) { return angle * 180 / std::numbers::pi; }
Point on_circle(double angle, double radius = 1) { return {radius * std::sin(angle), -radius * std::cos(angle)}; }

enum class EventKind : std::uint8_t { face_edge_on, vertex_and_edge, three_edges };

class PlantingaTeller {
 public:
  PlantingaTeller(const pl::RotationModel& model, Steps& steps) : model_(model), maker_(model), steps_(steps) { count(); }

  void studied(pl::EdgeIndex edge, const pl::EdgeHistory& history, double angle) {
    candidates_ += history.candidates;
    changes_ += history.changes.size();
    ++edges_;
    count();
    for (const pl::EdgeChange& change : history.changes) found_.push_back(dot(Look::waiting, on_circle(change.direction.angle)));
    if (edges_ > most_edges_shown) return;
    std::vector<Mark> here;
    add_edge(here, Look::now, edge, angle);
    for (const pl::Occluder& occluder : model_.occluders_of(edge)) add_face(here, Look::other, occluder.face, angle);
    std::vector<Mark> there;
    for (const pl::EdgeChange& change : history.changes) there.push_back(line(Look::now, {on_circle(change.direction.angle, 0.85), on_circle(change.direction.angle, 1.05)}));
    steps_.add(fmt::format("Edge {}: {} faces may hide some of it in a turn. Between {} directions where its structure might change it was worked out from scratch; it does change at {} of "
                           "them.",
                           edge + 1, model_.occluders_of(edge).size(), history.candidates, history.changes.size()),
               "section 3", {{image, "edge", std::move(here)}, {circle, "edge", std::move(there)}, {circle, "found", found_}});
  }

  void count() {
    steps_.count("edges", model_.edges().size());
    steps_.count("edges studied", edges_);
    steps_.count("directions looked at", candidates_);
    steps_.count("changes kept", changes_);
    steps_.count("events", events_);
    steps_.count("events passed", passed_);
    steps_.count("pieces in the picture", pieces_);
  }

  [[nodiscard]] std::vector<Mark> wire(double angle) {
    std::vector<pl::ImageLine> lines;
    maker_.wire(angle, lines);
    return marks_of(lines, Look::faint);
  }
  [[nodiscard]] std::vector<Mark> picture(const pl::EdgeStructureGraph& graph, double angle) {
    std::vector<pl::ImageLine> lines;
    maker_.visible(graph, angle, lines);
    pieces_ = graph.piece_count();
    return marks_of(lines, Look::seen);
  }

  // Once round, from where the graph stands.
  void turn(const pl::EventList& list, pl::EdgeStructureGraph& graph) {
    events_ = list.events.size();
    count();
    std::vector<Mark> dots;
    for (const pl::Event& event : list.events) dots.push_back(dot(look_of(kind_of(list, event)), on_circle(event.direction.angle)));
    std::size_t of[3] = {};
    for (const pl::Event& event : list.events) ++of[static_cast<std::size_t>(kind_of(list, event))];
    steps_.add(fmt::format("The list of events of a full turn, in order of angle: {} where a face is seen edge-on, {} where a vertex meets an edge, {} where three edges meet. From now "
                           "on a view is made from the one before it.",
                           of[0], of[1], of[2]),
               "section 3", {{image, "edge", {}}, {circle, "edge", {}}, {circle, "found", {}}, {circle, "events", std::move(dots)}});
    for (std::size_t n = 0; n < list.events.size() && n < most_events_shown; ++n) {
      const std::size_t at = graph.passed() % list.events.size();
      const pl::Event& event = list.events[at];
      const double next = list.events[(at + 1) % list.events.size()].direction.angle;
      const double ahead = next > event.direction.angle ? next - event.direction.angle : next - event.direction.angle + 2 * std::numbers::pi;
      double angle = event.direction.angle + ahead / 2;
      if (angle > std::numbers::pi) angle -= 2 * std::numbers::pi;
      if (!graph.step_forward()) break;
      passed_ = n + 1;
      std::vector<Mark> changed;
      std::size_t removed = 0, added = 0;
      for (const pl::Change& change : list.changes_of(event)) {
        add_edge(changed, Look::now, change.edge, angle);
        removed += list.removed_by(change).size();
        added += list.added_by(change).size();
      }
      auto seen = picture(graph, angle);
      count();
      steps_.add(fmt::format("{:.2f} degrees: {}. Of {} edge{} {} piece{} replaced by {}.", degrees(event.direction.angle), what_of(kind_of(list, event), event), event.change_count,
                             event.change_count == 1 ? "" : "s", removed, removed == 1 ? " is" : "s are", added),
                 "section 4",
                 {{image, "wire", wire(angle)}, {image, "edge", std::move(changed)}, {image, "seen", std::move(seen)}, {circle, "sight", radius(angle)},
                  {circle, "event", {dot(Look::now, on_circle(event.direction.angle))}}});
    }
    if (list.events.size() > most_events_shown) steps_.add(fmt::format("And so on, over {} more events, until the turn is complete.", list.events.size() - most_events_shown), "section 4", {});
  }

  [[nodiscard]] static std::vector<Mark> radius(double angle) {
    return {line(Look::now, {{0, 0}, on_circle(angle)}), text(Look::now, on_circle(angle, 1.12), fmt::format("{:.1f}", degrees(angle)))};
  }

 private:
  static std::vector<Mark> marks_of(const std::vector<pl::ImageLine>& lines, Look look) {
    std::vector<Mark> marks;
    for (const pl::ImageLine& each : lines) marks.push_back(line(look, {{each.u0, each.v0}, {each.u1, each.v1}}));
    return marks;
  }
  static Point in_image(const pl::Vector3& p, double angle) {
    return {static_cast<double>(p[0]) * std::cos(angle) - static_cast<double>(p[2]) * std::sin(angle), static_cast<double>(p[1])};
  }
  void add_edge(std::vector<Mark>& marks, Look look, pl::EdgeIndex edge, double angle) const {
    const pl::Segment segment = model_.segment(edge);
    marks.push_back(line(look, {in_image(segment.from, angle), in_image(segment.to, angle)}));
  }
  void add_face(std::vector<Mark>& marks, Look look, pl::FaceIndex face, double angle) const {
    std::vector<Point> outline;
    for (const pl::Corner& corner : model_.corners(face)) outline.push_back(in_image(model_.vertices()[corner.vertex], angle));
    marks.push_back(area(look, std::move(outline)));
  }
  static Look look_of(EventKind kind) {
    switch (kind) {
      case EventKind::face_edge_on: return Look::mask;
      case EventKind::vertex_and_edge: return Look::plain;
      case EventKind::three_edges: return Look::other;
    }
    return Look::plain;
  }
  [[nodiscard]] bool edge_on(pl::FaceIndex face, const pl::Direction& direction) const {
    return !model_.faces()[face].horizontal && pl::sign_at(direction, pl::form_of(model_.faces()[face].normal)) == 0;
  }
  // The list says what changes, not why: a face is edge-on or not, and of the others those that exchange junctions alone are of
  // three edges.
  [[nodiscard]] EventKind kind_of(const pl::EventList& list, const pl::Event& event) const {
    for (pl::FaceIndex face = 0; face < model_.faces().size(); ++face)
      if (edge_on(face, event.direction)) return EventKind::face_edge_on;
    for (const pl::Change& change : list.changes_of(event)) {
      const auto removed = list.removed_by(change);
      const auto added = list.added_by(change);
      if (removed.size() != added.size()) return event.direction.rational ? EventKind::vertex_and_edge : EventKind::three_edges;
      for (std::size_t i = 0; i < removed.size(); ++i) {
        for (const auto& [a, b] : {std::pair(removed[i].low, added[i].low), {removed[i].high, added[i].high}}) {
          if (!(a == b) && (a.kind() != pl::EndKind::junction || b.kind() != pl::EndKind::junction)) return EventKind::vertex_and_edge;
        }
      }
    }
    return event.direction.rational ? EventKind::vertex_and_edge : EventKind::three_edges;
  }
  [[nodiscard]] std::string what_of(EventKind kind, const pl::Event& event) const {
    switch (kind) {
      case EventKind::face_edge_on: {
        std::string faces;
        int found = 0;
        for (pl::FaceIndex face = 0; face < model_.faces().size() && found < 4; ++face) {
          if (!edge_on(face, event.direction)) continue;
          faces += fmt::format("{}{}", found == 0 ? "" : ", ", face + 1);
          ++found;
        }
        return fmt::format("face{} {} seen edge-on", found == 1 ? "" : "s", faces + (found == 1 ? " is" : " are"));
      }
      case EventKind::vertex_and_edge: return "a vertex and an edge meet in the image (EV)";
      case EventKind::three_edges: return "three edges meet in a point of the image (EEE)";
    }
    return {};
  }

  const pl::RotationModel& model_;
  pl::FrameMaker maker_;
  Steps& steps_;
  std::vector<Mark> found_;
  std::uint64_t edges_ = 0, candidates_ = 0, changes_ = 0, events_ = 0, passed_ = 0, pieces_ = 0;
};

}  // namespace

base::Result<Lesson> explain_plantinga(const scene::PolyScene& scene, const scene::PolyCamera& camera, const scene::CellComplex*) {
  if (const auto reason = pl::why_not(scene)) return base::Error{"", "plantinga", *reason};
  const pl::RotationModel model(scene);
  if (model.edges().size() > most_lesson_edges)
    return base::Error{"", "plantinga", fmt::format("the scene has {} edges, too many to follow", model.edges().size()), "at most 300"};
  Lesson lesson{"plantinga", "Plantinga, Seales and Dyer 1990: the events of a turn", scene.name, {}, {}};
  double reach = 1;
  double low = 0, high = 0;
  bool first = true;
  for (const auto& v : scene.vertices) {
    reach = std::max(reach, std::sqrt(double(v[0]) * v[0] + double(v[2]) * v[2]));
    low = first ? v[1] : std::min(low, double(v[1]));
    high = first ? v[1] : std::max(high, double(v[1]));
    first = false;
  }
  const double margin = 0.04 * std::max(2 * reach, high - low);
  lesson.sheets = {{"The image, in parallel projection", {-reach - margin, low - margin}, {reach + margin, high + margin}},
                   {"The circle of directions from above, the viewer outside", {-1.2, -1.2}, {1.25, 1.2}}};
  Steps steps(lesson);
  PlantingaTeller teller(model, steps);
  const auto exact = pl::sight_of(camera);
  pl::Sight sight = exact ? *exact : pl::Sight{-std::int64_t{camera.forward[0]}, -std::int64_t{camera.forward[2]}};
  if (sight.x == 0 && sight.z == 0) sight.z = 1;
  const double angle = std::atan2(static_cast<double>(sight.x), static_cast<double>(sight.z));
  std::vector<Mark> ring;
  std::vector<Point> points;
  for (int i = 0; i <= 180; ++i) points.push_back(on_circle(i * std::numbers::pi / 90));
  ring.push_back(line(Look::faint, std::move(points)));
  steps.add(fmt::format("The scene turns about its vertical axis and is seen in parallel projection.{} As it turns, the structure of the picture, which pieces of which edges are seen and "
                        "what each ends in, changes at certain directions only: at visual events.",
                        exact ? "" : " The camera is replaced by its direction on the ground."),
            "section 2", {{image, "wire", teller.wire(angle)}, {circle, "ring", std::move(ring)}, {circle, "sight", PlantingaTeller::radius(angle)}});
  pl::BuildOptions options;
  options.threads = 1;
  options.studied = [&](pl::EdgeIndex edge, const pl::EdgeHistory& history) { teller.studied(edge, history, angle); };
  auto list = pl::build_event_list(model, options);
  if (!list) return std::move(list.error());
  pl::EdgeStructureGraph graph(*list);
  static_cast<void>(graph.turn_to(angle));
  teller.turn(*list, graph);
  static_cast<void>(graph.turn_to(angle));
  std::vector<Mark> seen = teller.picture(graph, angle);
  teller.count();
  steps.add(list->events.empty() ? "Nothing changes in a whole turn: every view has the same structure."
                                 : "The turn is complete. Each step touched only the edges that change, however large the scene is.",
            "section 4", {{image, "edge", {}}, {image, "wire", teller.wire(angle)}, {image, "seen", std::move(seen)}, {circle, "event", {}}, {circle, "sight", PlantingaTeller::radius(angle)}});
  return lesson;
}

}  // namespace sightline::explain
