#include "host/explain/plantinga.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/trace.hpp"
#include "host/algorithms/plantinga/turning_scene.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/explain/other_turns.hpp"
#include "host/explain/stage.hpp"
#include "host/explain/turn_stage.hpp"

namespace sightline::explain {
namespace {

using pl::EventKind;

constexpr std::size_t circle = 1;
constexpr std::size_t most_lesson_edges = 300;
constexpr std::size_t most_hidden_shown = 4;        // edges of the initial picture with a step each: wholly hidden,
constexpr std::size_t most_parts_shown = 8;         // and partly hidden
constexpr std::size_t most_edges_in_detail = 4;     // edges studied direction by direction
constexpr std::size_t most_directions_shown = 10;   // directions per such edge,
constexpr std::size_t most_equal_shown = 4;         // of them at which nothing changes
constexpr std::size_t most_summaries = 16;          // summaries of all other edges
constexpr std::size_t most_events_with_views = 80;  // events with one step for the event and one for the view after it
constexpr std::size_t most_events_shown = 200;

std::string count_text(std::uint64_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

// The three groups of events that the circle distinguishes.
enum class Group : std::uint8_t { edge_on, vertex_and_edge, three_edges };
Group group_of(EventKind kind) {
  switch (kind) {
    case EventKind::vertex_in_front:
    case EventKind::vertex_behind:
    case EventKind::passage: return Group::vertex_and_edge;
    case EventKind::three_edges: return Group::three_edges;
    case EventKind::own_face:
    case EventKind::face_edge_on:
    case EventKind::edge_pair:
    case EventKind::own_plane:
    case EventKind::in_line: break;
  }
  return Group::edge_on;
}
Look look_of(Group group) {
  switch (group) {
    case Group::edge_on: return Look::mask;
    case Group::vertex_and_edge: return Look::plain;
    case Group::three_edges: return Look::other;
  }
  return Look::plain;
}

// The vertices and faces that a caption names: "vertex 3", "edge 4-5" (two vertices), "face 7", "faces 7, 8".
struct MentionedParts {
  std::set<std::uint32_t> vertices;
  std::set<std::uint32_t> faces;  // from 0
};
MentionedParts find_mentioned(std::string_view caption) {
  MentionedParts named;
  std::size_t at = 0;
  const auto number = [&]() -> std::optional<std::uint32_t> {
    std::uint32_t value = 0;
    const std::size_t begin = at;
    while (at < caption.size() && caption[at] >= '0' && caption[at] <= '9') value = value * 10 + static_cast<std::uint32_t>(caption[at++] - '0');
    return at == begin ? std::nullopt : std::optional(value);
  };
  const auto passes = [&](std::string_view word) {
    if (caption.substr(at, word.size()) != word) return false;
    at += word.size();
    return true;
  };
  while (at < caption.size()) {
    if (passes("dge ")) {  // matches "Edge" at the beginning of a sentence, too
      const auto from = number();
      if (!from || !passes("-")) continue;
      named.vertices.insert(*from);
      if (const auto to = number()) named.vertices.insert(*to);
    } else if (passes("vertex ")) {
      if (const auto vertex = number()) named.vertices.insert(*vertex);
    } else if (passes("face ") || passes("faces ")) {
      do {
        if (const auto face = number()) named.faces.insert(*face - 1);
      } while (passes(", ") && at < caption.size() && caption[at] >= '0' && caption[at] <= '9');
    } else {
      ++at;
    }
  }
  return named;
}

class PlantingaRecorder final : public pl::Trace {
 public:
  PlantingaRecorder(const pl::RotationModel& model, TurnStage& stage, double angle, Steps& steps)
      : model_(model), stage_(stage), steps_(steps), angle_(angle), causes_(model.edges().size()) {
    summary_size_ = std::max<std::size_t>(1, (model.edges().size() + most_summaries - 1) / most_summaries);
    count();
  }

  void count() {
    steps_.count("edges", model_.edges().size());
    steps_.count("pieces seen", pieces_);
    steps_.count("edges studied", studied_);
    steps_.count("potential events", potential_);
    steps_.count("dropped by the filter", dropped_);
    steps_.count("directions compared", compared_);
    steps_.count("changes kept", changes_);
    steps_.count("events", events_);
    steps_.count("events passed", passed_);
  }

  // The initial picture: hidden-line removal from scratch.

  void scratch_begins(pl::EdgeIndex, std::span<const pl::Occluder> occluders) override {
    occluder_count_ = occluders.size();
    covering_.clear();
  }

  void scratch_covers(pl::EdgeIndex, pl::FaceIndex face, double, double) override { covering_.insert(face); }

  void scratch_ends(pl::EdgeIndex edge, bool compared, const pl::EdgeStructure& left) override {
    if (!compared) {
      ++turned_away_;
      return;
    }
    stage_.place(angle_);
    pieces_ += left.size();
    for (const pl::Piece& piece : left) stage_.add_piece(initial_, Look::seen, edge, piece, angle_);
    std::size_t& shown = left.empty() ? hidden_shown_ : parts_shown_;
    if (is_whole(edge, left) || shown == (left.empty() ? most_hidden_shown : most_parts_shown)) return;
    ++shown;
    count();
    std::vector<Mark> faces;
    std::string names;
    for (const pl::FaceIndex face : covering_) {
      stage_.add_face(faces, Look::other, face, angle_);
      names += fmt::format("{}{}", names.empty() ? "" : ", ", face + 1);
    }
    std::vector<Mark> marks;
    stage_.add_edge(marks, Look::hidden, edge, angle_);
    for (const pl::Piece& piece : left) stage_.add_piece(marks, Look::now, edge, piece, angle_);
    add_step(angle_, fmt::format(
                   "{} is compared with the {} that may hide some of it from some direction. From here face{} {} cover{} some of "
                   "it; what is covered on both sides of its line in the image is hidden. {}",
                   name_of(edge, true), count_text(occluder_count_, "face"), covering_.size() == 1 ? "" : "s", names,
                   covering_.size() == 1 ? "s" : "", what_is_left(left)),
               "section 4", {{image, "face", std::move(faces)}, {image, "edge", std::move(marks)}, {image, "seen", initial_}});
  }

  void initial_picture(const picture::LinePicture& drawn) {
    pieces_ = drawn.pieces.size();
    count();
    add_step(angle_,
        fmt::format("The initial picture, made by hidden-line removal from scratch: {}.{} Of "
                    "each piece the graph stores what it ends in: a vertex, or a T-junction and the edge that hides the rest.",
                    count_text(pieces_, "visible piece"),
                    turned_away_ == 0 ? ""
                                      : fmt::format(" {} left out: all faces at {} look away.",
                                                    turned_away_ == 1 ? "One edge is" : fmt::format("{} edges are", turned_away_),
                                                    turned_away_ == 1 ? "it" : "them")),
        "section 4", {{image, "face", {}}, {image, "edge", {}}, {image, "seen", stage_.seen(drawn, angle_)}});
  }

  // The preprocessing phase.

  void study_begins(pl::EdgeIndex, std::span<const pl::Occluder> occluders) override {
    occluders_.assign(occluders.begin(), occluders.end());
    comparisons_.clear();
    dropped_here_ = 0;
  }

  void potential(const pl::PotentialEvent& event) override {
    ++potential_;
    causes_[event.edge].push_back(event);
  }

  void dropped(EventKind, pl::EdgeIndex) override {
    ++dropped_;
    ++dropped_here_;
  }

  void compared(pl::EdgeIndex, const pl::Direction& direction, const pl::EdgeStructure& before,
                const pl::EdgeStructure& after) override {
    comparisons_.push_back({direction, before, after});
  }

  void study_ends(pl::EdgeIndex edge, const pl::EdgeHistory& history) override {
    if (worth_detail(edge, history)) {
      end_summary();
      add_details(edge, history);
      return;
    }
    add_study(history);
    summary_.push_back(edge);
    summary_directions_ += history.candidates;
    summary_changes_ += history.changes.size();
    if (summary_.size() == summary_size_) end_summary();
  }

  // Adds one step for the edges that had none.
  void end_summary() {
    if (summary_.empty()) return;
    std::vector<Mark> edges;
    std::vector<Mark> plan;
    for (const pl::EdgeIndex edge : summary_) {
      stage_.add_edge(edges, Look::now, edge, angle_);
      stage_.add_edge_to_plan(plan, Look::now, edge);
    }
    count();
    const std::string which = summary_.size() == 1 ? name_of(summary_.front(), true) : fmt::format("{} edges", summary_.size());
    add_step(angle_, fmt::format("{} {} studied{}: {} compared, {} kept.", which, summary_.size() == 1 ? "is" : "are",
                           detailed_ == 0 ? "" : " in the same way", count_text(summary_directions_, "direction"),
                           count_text(summary_changes_, "change")),
               "section 3",
               {{image, "wire", stage_.wire(angle_)},
                {image, "face", {}},
                {image, "cause", {}},
                {image, "seen", {}},
                {image, "edge", std::move(edges)},
                {circle, "cause", std::move(plan)},
                {circle, "candidates", {}},
                {circle, "found", found_},
                {circle, "sight", stage_.radius(angle_)}});
    summary_.clear();
    summary_directions_ = summary_changes_ = 0;
  }

  // The on-line phase: a full turn from the graph's current direction.
  void turn(const pl::EventList& list, pl::EdgeStructureGraph& graph) {
    events_ = list.events.size();
    count();
    std::vector<Mark> dots;
    std::array<std::size_t, 3> of{};
    for (const pl::Event& event : list.events) {
      const Group group = group_of(causes_of(list, event));
      ++of[static_cast<std::size_t>(group)];
      dots.push_back(dot(look_of(group), stage_.on_circle(event.direction.angle)));
    }
    add_step(angle_,
        fmt::format(
            "The event list of a full turn, sorted by angle: at {} a face or a plane of two edges is edge-on (the paper "
            "leaves these out), at {} a vertex and an edge meet in the image (EV), at {} three edges meet (EEE). From now on no "
            "edge is compared with a face.",
            count_text(of[0], "event"), of[1], of[2]),
        "section 4",
        {{image, "wire", stage_.wire(angle_)},
         {image, "face", {}},
         {image, "cause", {}},
         {image, "edge", {}},
         {image, "seen", view_of(graph, angle_)},
         {circle, "cause", {}},
         {circle, "candidates", {}},
         {circle, "found", {}},
         {circle, "events", std::move(dots)},
         {circle, "legend", legend(of)},
         {circle, "sight", stage_.radius(angle_)}});
    const bool with_views = list.events.size() <= most_events_with_views;
    for (std::size_t n = 0; n < list.events.size() && n < most_events_shown; ++n) {
      const std::size_t at = graph.passed() % list.events.size();
      add_event(list, list.events[at], graph);
      if (!graph.step_forward()) return;
      if (with_views) add_view(list, at, graph);
    }
    if (list.events.size() > most_events_shown)
      add_step(angle_,
          fmt::format("The turn goes on in the same way over {}.", count_text(list.events.size() - most_events_shown, "more event")),
          "section 4", {{image, "cause", {}}, {circle, "cause", {}}});
  }

  void finish(const picture::LinePicture& drawn) {
    pieces_ = drawn.pieces.size();
    passed_ = events_;
    count();
    add_step(angle_,
        events_ == 0
            ? "Nothing changes in a whole turn: the picture from every direction has the same structure."
            : "The turn is complete, and the picture is the initial one again. Each step touched only the edges that change, "
              "however large the scene is.",
        "section 4",
        {{image, "wire", stage_.wire(angle_)},
         {image, "cause", {}},
         {image, "edge", {}},
         {image, "seen", stage_.seen(drawn, angle_)},
         {circle, "cause", {}},
         {circle, "sight", stage_.radius(angle_)}});
  }

 private:
  // Adds a step whose image is seen from `angle`, with the numbers of the vertices and faces that the caption names.
  void add_step(double angle, std::string caption, std::string section, std::vector<Layer> changes) {
    const MentionedParts named = find_mentioned(caption);
    Layer in_image{image, "numbers", {}};
    Layer in_plan{circle, "numbers", {}};
    for (const std::uint32_t face : named.faces) stage_.add_face_number(in_image.marks, in_plan.marks, face, angle);
    for (const std::uint32_t vertex : named.vertices) stage_.add_vertex_number(in_image.marks, in_plan.marks, vertex, angle);
    changes.push_back(std::move(in_image));
    changes.push_back(std::move(in_plan));
    steps_.add(std::move(caption), std::move(section), std::move(changes));
  }

  struct Comparison {
    pl::Direction direction;
    pl::EdgeStructure before;
    pl::EdgeStructure after;
  };

  // Whether an edge is shown in detail: one of the first whose structure changes for a reason not yet explained, or stays the same
  // at some directions.
  [[nodiscard]] bool worth_detail(pl::EdgeIndex edge, const pl::EdgeHistory& history) const {
    if (detailed_ == most_edges_in_detail || history.changes.empty() || history.changes.size() == comparisons_.size())
      return false;
    if (detailed_ == 0) return true;
    return std::any_of(history.changes.begin(), history.changes.end(), [&](const pl::EdgeChange& change) {
      return explained_kinds_.count(first_cause(edge, change.direction).kind) == 0;
    });
  }

  void add_study(const pl::EdgeHistory& history) {
    ++studied_;
    compared_ += history.candidates;
    changes_ += history.changes.size();
    for (const pl::EdgeChange& change : history.changes) found_.push_back(dot(Look::waiting, stage_.on_circle(change.direction.angle)));
  }

  void add_details(pl::EdgeIndex edge, const pl::EdgeHistory& history) {
    ++detailed_;
    std::vector<Mark> edge_marks;
    std::vector<Mark> faces;
    std::vector<Mark> plan;
    stage_.add_edge(edge_marks, Look::now, edge, angle_);
    for (const pl::Occluder& occluder : occluders_) {
      stage_.add_face(faces, Look::other, occluder.face, angle_);
      for (const pl::Corner& corner : model_.corners(occluder.face)) stage_.add_edge_to_plan(plan, Look::other, corner.side);
    }
    stage_.add_edge_to_plan(plan, Look::now, edge);
    std::vector<Mark> candidates;
    for (const Comparison& each : comparisons_)
      candidates.push_back(line(Look::now, {stage_.on_circle(each.direction.angle, 0.92), stage_.on_circle(each.direction.angle, 1.04)}));
    count();
    add_step(angle_,
        fmt::format(
            "{}: {} may hide some of it in a turn, as some of it is behind their planes. Its potential events are at {}.{} The "
            "structure of the edge is made from scratch between each two of them.",
            name_of(edge, true), count_text(occluders_.size(), "face"), count_text(comparisons_.size(), "direction"),
            dropped_here_ == 0 ? ""
                               : fmt::format(" Others, {} of them, are dropped at once: another face surely hides the point, or "
                                             "the nearer edge bounds nothing there.",
                                             dropped_here_)),
        "section 3",
        {{image, "wire", stage_.wire(angle_)},
         {image, "face", std::move(faces)},
         {image, "cause", {}},
         {image, "seen", {}},
         {image, "edge", std::move(edge_marks)},
         {circle, "cause", std::move(plan)},
         {circle, "candidates", std::move(candidates)},
         {circle, "found", found_},
         {circle, "sight", stage_.radius(angle_)}});
    std::size_t shown = 0;
    const std::uint64_t compared_before = compared_;
    const std::uint64_t changes_before = changes_;
    std::size_t equal = 0;
    for (const Comparison& each : comparisons_) {
      if (shown == most_directions_shown) break;
      if (each.before == each.after && ++equal > most_equal_shown) continue;
      add_comparison(edge, each);
      ++shown;
    }
    compared_ = compared_before;
    changes_ = changes_before;
    add_study(history);
    count();
    std::vector<Mark> marks;
    stage_.add_edge(marks, Look::now, edge, angle_);
    add_step(angle_, fmt::format("{}The list keeps {} of {} for {}.",
                           shown < comparisons_.size() ? "The other directions are compared in the same way. " : "",
                           history.changes.size(), count_text(comparisons_.size(), "direction"), name_of(edge, false)),
               "section 3",
               {{image, "wire", stage_.wire(angle_)},
                {image, "face", {}},
                {image, "cause", {}},
                {image, "seen", {}},
                {image, "edge", std::move(marks)},
                {circle, "cause", {}},
                {circle, "candidates", {}},
                {circle, "found", found_},
                {circle, "sight", stage_.radius(angle_)}});
  }

  void add_comparison(pl::EdgeIndex edge, const Comparison& each) {
    const double angle = each.direction.angle;
    const pl::PotentialEvent cause = first_cause(edge, each.direction);
    const bool changed = !(each.before == each.after);
    if (changed) explained_kinds_.insert(cause.kind);
    ++compared_;
    changes_ += changed ? 1 : 0;
    count();
    std::vector<Mark> marks;
    stage_.place(angle);
    stage_.add_edge(marks, Look::hidden, edge, angle);
    for (const pl::Piece& piece : each.after) stage_.add_piece(marks, Look::now, edge, piece, angle);
    std::vector<Mark> in_image;
    std::vector<Mark> in_plan;
    stage_.add_cause(in_image, in_plan, cause, angle);
    add_step(angle, fmt::format("{:.2f} degrees: {}. {} just before: {}; just after: {}. {}", degrees(angle), what_of(cause),
                           name_of(edge, true), structure_in_words(each.before), structure_in_words(each.after),
                           changed ? "They differ: it is an event." : "They are equal: it is no event of this edge."),
               "section 3",
               {{image, "wire", stage_.wire(angle)},
                {image, "face", {}},
                {image, "cause", std::move(in_image)},
                {image, "edge", std::move(marks)},
                {circle, "cause", std::move(in_plan)},
                {circle, "sight", stage_.radius(angle)}});
  }

  void add_event(const pl::EventList& list, const pl::Event& event, const pl::EdgeStructureGraph& graph) {
    const double angle = event.direction.angle;
    ++passed_;
    stage_.place(angle);
    std::set<pl::EdgeIndex> edges;
    std::vector<Mark> changed;
    std::size_t removed = 0;
    std::size_t added = 0;
    for (const pl::Change& change : list.changes_of(event)) {
      edges.insert(change.edge);
      for (const pl::Piece& piece : list.removed_by(change)) stage_.add_piece(changed, Look::hidden, change.edge, piece, angle);
      for (const pl::Piece& piece : list.added_by(change)) stage_.add_piece(changed, Look::now, change.edge, piece, angle);
      removed += list.removed_by(change).size();
      added += list.added_by(change).size();
    }
    std::vector<Mark> seen;
    for (const pl::LivePiece& live : graph.pieces())
      if (live.edge != pl::no_edge && edges.count(live.edge) == 0) stage_.add_piece(seen, Look::seen, live.edge, live.piece, angle);
    pieces_ = graph.piece_count() - removed + added;
    count();
    const std::vector<pl::PotentialEvent> causes = causes_of(list, event);
    std::vector<Mark> in_image;
    std::vector<Mark> in_plan;
    std::string what;
    for (std::size_t i = 0; i < causes.size() && i < 2; ++i) {
      stage_.add_cause(in_image, in_plan, causes[i], angle);
      what += fmt::format("{}{}", i == 0 ? "" : ", and ", what_of(causes[i]));
    }
    if (causes.size() > 2) what += fmt::format(", and {} more in the same direction", causes.size() - 2);
    add_step(angle, fmt::format("Event {} of {} at {:.2f} degrees: {}. {} change{}: {} removed from the graph and {} added.", passed_,
                           events_, degrees(angle), what, count_text(edges.size(), "edge"), edges.size() == 1 ? "s" : "",
                           removed == 1 ? "1 piece is" : fmt::format("{} pieces are", removed), added),
               "section 4",
               {{image, "wire", stage_.wire(angle)},
                {image, "cause", std::move(in_image)},
                {image, "edge", std::move(changed)},
                {image, "seen", std::move(seen)},
                {circle, "cause", std::move(in_plan)},
                {circle, "sight", stage_.radius(angle)}});
  }

  void add_view(const pl::EventList& list, std::size_t at, const pl::EdgeStructureGraph& graph) {
    const double here = list.events[at].direction.angle;
    const double next = list.events[(at + 1) % list.events.size()].direction.angle;
    const double ahead = next > here ? next - here : next - here + 2 * std::numbers::pi;
    double angle = here + ahead / 2;
    if (angle > std::numbers::pi) angle -= 2 * std::numbers::pi;
    add_step(angle,
        fmt::format(
            "The structure stays the same up to {:.2f} degrees. A frame between, here at {:.2f}, draws the {} of the graph; only "
            "the vertices and the T-junctions are placed again.",
            degrees(next), degrees(angle), count_text(graph.piece_count(), "piece")),
        "section 4",
        {{image, "wire", stage_.wire(angle)},
         {image, "cause", {}},
         {image, "edge", {}},
         {image, "seen", view_of(graph, angle)},
         {circle, "cause", {}},
         {circle, "sight", stage_.radius(angle)}});
  }

  // The potential events of an edge at a direction, faces first.
  [[nodiscard]] std::vector<pl::PotentialEvent> causes_at(pl::EdgeIndex edge, const pl::Direction& direction) const {
    std::vector<pl::PotentialEvent> found;
    for (const pl::PotentialEvent& event : causes_[edge])
      if (event.direction == direction) found.push_back(event);
    std::stable_sort(found.begin(), found.end(),
                     [](const pl::PotentialEvent& a, const pl::PotentialEvent& b) { return a.kind < b.kind; });
    return found;
  }
  [[nodiscard]] pl::PotentialEvent first_cause(pl::EdgeIndex edge, const pl::Direction& direction) const {
    const auto found = causes_at(edge, direction);
    return found.empty() ? pl::PotentialEvent{EventKind::own_plane, edge, edge, 0, direction} : found.front();
  }
  // One cause for each edge that changes, without duplicates.
  [[nodiscard]] std::vector<pl::PotentialEvent> causes_of(const pl::EventList& list, const pl::Event& event) const {
    std::vector<pl::PotentialEvent> causes;
    std::set<std::string> said;
    for (const pl::Change& change : list.changes_of(event)) {
      const pl::PotentialEvent cause = first_cause(change.edge, event.direction);
      if (said.insert(what_of(cause)).second) causes.push_back(cause);
    }
    std::stable_sort(causes.begin(), causes.end(),
                     [](const pl::PotentialEvent& a, const pl::PotentialEvent& b) { return a.kind < b.kind; });
    return causes;
  }
  static Group group_of(const std::vector<pl::PotentialEvent>& causes) {
    return causes.empty() ? Group::edge_on : explain::group_of(causes.front().kind);
  }

  [[nodiscard]] std::string what_of(const pl::PotentialEvent& cause) const {
    switch (cause.kind) {
      case EventKind::own_face: return fmt::format("face {} is seen edge-on", cause.first + 1);
      case EventKind::face_edge_on:
        return fmt::format("face {}, which is in front of {}, is seen edge-on", cause.first + 1, name_of(cause.edge, false));
      case EventKind::vertex_in_front:
        return fmt::format("vertex {} passes in front of {} (EV)", cause.first, name_of(cause.edge, false));
      case EventKind::vertex_behind:
        return fmt::format("vertex {} passes behind {} (EV)", cause.first, name_of(cause.second, false));
      case EventKind::three_edges:
        return fmt::format("{} and {} cross in front of {} (EEE)", name_of(cause.first, false), name_of(cause.second, false),
                           name_of(cause.edge, false));
      case EventKind::edge_pair:
        return fmt::format("the plane of {} and {} is seen edge-on", name_of(cause.first, false), name_of(cause.second, false));
      case EventKind::own_plane:
        return fmt::format("the plane of {} and {} is seen edge-on", name_of(cause.edge, false), name_of(cause.first, false));
      case EventKind::in_line:
        return fmt::format("{} and {} are on one line of the image", name_of(cause.edge, false), name_of(cause.first, false));
      case EventKind::passage:
        return fmt::format("the point where {} passes through face {} is behind {}", name_of(cause.edge, false), cause.first + 1,
                           name_of(cause.second, false));
    }
    return {};
  }

  // The legend of the groups that have events.
  static std::vector<Mark> legend(const std::array<std::size_t, 3>& events) {
    constexpr std::array<std::string_view, 3> words{"plane edge-on", "EV: vertex, edge", "EEE: three edges"};
    std::vector<Mark> marks;
    for (std::size_t group = 0; group < words.size(); ++group)
      if (events[group] != 0)
        marks.push_back(text(look_of(static_cast<Group>(group)), {-1.24, 1.2 - 0.13 * static_cast<double>(marks.size())}, std::string(words[group])));
    return marks;
  }

  [[nodiscard]] std::string name_of(pl::EdgeIndex edge, bool begins) const {
    return fmt::format("{}dge {}-{}", begins ? 'E' : 'e', model_.edges()[edge].from, model_.edges()[edge].to);
  }
  [[nodiscard]] std::string end_of(const pl::End& end) const {
    switch (end.kind()) {
      case pl::EndKind::vertex:
      case pl::EndKind::contact: return fmt::format("vertex {}", end.index());
      case pl::EndKind::junction: return name_of(end.index(), false);
      case pl::EndKind::passage: break;
    }
    return fmt::format("face {}", end.index() + 1);
  }
  // The ends of the pieces: "from vertex 3 to edge 4-5".
  [[nodiscard]] std::string structure_in_words(const pl::EdgeStructure& structure) const {
    if (structure.empty()) return "nothing is visible";
    if (structure.size() > 2) return count_text(structure.size(), "piece");
    std::string words;
    for (const pl::Piece& piece : structure)
      words += fmt::format("{}from {} to {}", words.empty() ? "" : " and ", end_of(piece.low), end_of(piece.high));
    return words;
  }
  [[nodiscard]] bool is_whole(pl::EdgeIndex edge, const pl::EdgeStructure& structure) const {
    const picture::LineEdge& ends = model_.edges()[edge];
    return structure.size() == 1 && structure[0].low == pl::End::of(pl::EndKind::vertex, ends.from) &&
           structure[0].high == pl::End::of(pl::EndKind::vertex, ends.to);
  }
  [[nodiscard]] std::string what_is_left(const pl::EdgeStructure& left) const {
    if (left.empty()) return "Nothing of it is visible.";
    std::set<pl::EdgeIndex> junctions;
    for (const pl::Piece& piece : left)
      for (const pl::End end : {piece.low, piece.high})
        if (end.kind() == pl::EndKind::junction) junctions.insert(end.index());
    std::string names;
    for (const pl::EdgeIndex edge : junctions) names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(edge, false));
    const std::string ends =
        names.empty() ? ""
                      : fmt::format(", cut off in {} with {}", junctions.size() == 1 ? "a T-junction" : "T-junctions", names);
    return fmt::format("{} of it {} left{}.", count_text(left.size(), "piece"), left.size() == 1 ? "is" : "are", ends);
  }

  // The view of the graph; counts its pieces.
  [[nodiscard]] std::vector<Mark> view_of(const pl::EdgeStructureGraph& graph, double angle) {
    pieces_ = graph.piece_count();
    count();
    return stage_.view(graph, angle);
  }

  const pl::RotationModel& model_;
  TurnStage& stage_;
  Steps& steps_;
  const double angle_;  // of the camera's direction
  std::vector<std::vector<pl::PotentialEvent>> causes_;

  // For the initial picture.
  std::size_t occluder_count_ = 0;
  std::set<pl::FaceIndex> covering_;
  std::vector<Mark> initial_;
  std::size_t turned_away_ = 0;
  std::size_t hidden_shown_ = 0;
  std::size_t parts_shown_ = 0;
  // For the edge being studied.
  std::vector<pl::Occluder> occluders_;
  std::vector<Comparison> comparisons_;
  std::size_t dropped_here_ = 0;
  // For all edges.
  std::vector<Mark> found_;
  std::set<EventKind> explained_kinds_;
  std::size_t detailed_ = 0;
  std::vector<pl::EdgeIndex> summary_;
  std::size_t summary_size_ = 1;
  std::size_t summary_directions_ = 0;
  std::size_t summary_changes_ = 0;
  std::uint64_t pieces_ = 0, studied_ = 0, potential_ = 0, dropped_ = 0, compared_ = 0, changes_ = 0, events_ = 0, passed_ = 0;
};

}  // namespace

base::Result<Lesson> explain_plantinga(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                       const scene::CellComplex*) {
  if (const auto reason = pl::why_not(scene)) return base::Error{"", "plantinga", *reason};
  const pl::RotationModel model(scene);
  if (model.edges().size() > most_lesson_edges)
    return base::Error{"", "plantinga", fmt::format("the scene has {} edges, too many to follow", model.edges().size()),
                       fmt::format("at most {}", most_lesson_edges)};
  Lesson lesson{"plantinga", "Plantinga, Seales and Dyer 1990: the events of a turn", scene.name, {}, {}};
  TurnStage stage(model, camera);
  lesson.sheets = {stage.image_sheet(), {"The circle of directions and the scene, from above", {-1.25, -1.25}, {1.25, 1.25}}};
  const auto exact = pl::sight_of(camera);
  pl::Sight sight = exact ? *exact : pl::Sight{-std::int64_t{camera.forward[0]}, -std::int64_t{camera.forward[2]}};
  if (sight.x == 0 && sight.z == 0) sight.z = 1;
  const double angle = std::atan2(static_cast<double>(sight.x), static_cast<double>(sight.z));
  Steps steps(lesson);
  PlantingaRecorder recorder(model, stage, angle, steps);
  std::vector<Point> ring;
  for (int i = 0; i <= 180; ++i) ring.push_back(stage.on_circle(i * std::numbers::pi / 90));
  steps.add(fmt::format(
                "The scene turns about a vertical axis and is seen in parallel projection.{} The structure of the picture, which "
                "pieces of which edges are visible and what each ends in, changes at certain directions only: at events.",
                exact ? "" : " The algorithm turns nothing else, so the camera is replaced by its horizontal direction."),
            "section 2",
            {{image, "wire", stage.wire(angle)},
             {circle, "ring", {line(Look::faint, std::move(ring))}},
             {circle, "plan", stage.plan()},
             {circle, "sight", stage.radius(angle)}});
  const picture::LinePicture picture = pl::visible_edges(model, sight, recorder);
  recorder.initial_picture(picture);
  pl::BuildOptions options;
  options.trace = &recorder;
  auto list = pl::build_event_list(model, options);
  if (!list) return std::move(list.error());
  recorder.end_summary();
  pl::EdgeStructureGraph graph(*list);
  static_cast<void>(graph.turn_to(angle));
  recorder.turn(*list, graph);
  recorder.finish(picture);
  add_other_turns(model, stage, circle, steps);
  return lesson;
}

}  // namespace sightline::explain
