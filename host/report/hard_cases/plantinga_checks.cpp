#include "host/report/hard_cases/plantinga_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/table_1.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::plantinga;
using native::EdgeIndex;
using native::EndKind;

constexpr std::string_view lost_step = "a step of the list does not fit";

// Every end there ever is, with its edge, until one is not as it should be.
template <class Good>
bool all_ends(const TurnedScene& turned, Good good) {
  const auto all = [&](EdgeIndex edge, std::span<const native::Piece> pieces) {
    return std::all_of(pieces.begin(), pieces.end(), [&](const native::Piece& piece) {
      return good(edge, piece.low) && good(edge, piece.high);
    });
  };
  for (EdgeIndex edge = 0; edge < turned.list.first.size(); ++edge)
    if (!all(edge, turned.list.first[edge])) return false;
  return std::all_of(
      turned.list.changes.begin(), turned.list.changes.end(),
      [&](const native::Change& change) { return all(change.edge, turned.list.added_by(change)); });
}

// The height of a level edge.
std::optional<std::int64_t> level_of(const native::RotationModel& model, EdgeIndex edge) {
  const native::Segment segment = model.segment(edge);
  if (segment.from[1] != segment.to[1]) return std::nullopt;
  return segment.from[1];
}

// (X : Z) to (X : -Z).
native::Direction mirrored(const native::Direction& direction) {
  if (direction.rational) return native::rational_direction(direction.form.xx, -direction.form.zz);
  const native::QuadraticForm form{direction.form.xx, -direction.form.xz, direction.form.zz};
  const auto roots = native::roots_of(form);
  const auto from_mirror = [&](const native::Direction& root) {
    return std::abs(std::remainder(root.angle - (std::numbers::pi - direction.angle), 2 * std::numbers::pi));
  };
  return *std::min_element(roots.begin(), roots.end(),
                           [&](const auto& a, const auto& b) { return from_mirror(a) < from_mirror(b); });
}

TurnFault scratch_fault(const TurnedScene& turned, const native::EdgeStructureGraph& graph,
                        std::size_t after) {
  const auto& events = turned.list.events;
  const auto& a = events[after].direction;
  const auto& b = events[(after + 1) % events.size()].direction;
  for (EdgeIndex edge = 0; edge < turned.model.edges().size(); ++edge) {
    if (graph.structure_of(edge) !=
        native::structure_between(turned.model, edge, turned.model.occluders_of(edge), a, b))
      return fmt::format("edge {} after event {} is not as from scratch", edge, after);
  }
  return std::nullopt;
}

TurnFault not_as_at_first(const TurnedScene& turned, const native::EdgeStructureGraph& graph) {
  for (EdgeIndex edge = 0; edge < turned.list.first.size(); ++edge)
    if (graph.structure_of(edge) != turned.list.first[edge])
      return fmt::format("edge {} is not as it was at first", edge);
  return std::nullopt;
}

}  // namespace

TurnFault turn_fault(const TurnedScene& turned) {
  native::EdgeStructureGraph graph(turned.list);
  for (std::size_t i = 0; i < turned.list.events.size(); ++i) {
    if (!graph.step_forward()) return std::string(lost_step);
    if (auto fault = scratch_fault(turned, graph, i)) return fault;
  }
  if (auto fault = not_as_at_first(turned, graph)) return fault;
  for (std::size_t i = 0; i < turned.list.events.size(); ++i)
    if (!graph.step_backward()) return std::string(lost_step);
  return not_as_at_first(turned, graph);
}

TurnFault level_edges_never_cross(const TurnedScene& turned) {
  const bool good = all_ends(turned, [&](EdgeIndex edge, const native::End& end) {
    if (end.kind() != EndKind::junction) return true;
    const auto level = level_of(turned.model, edge);
    return !level || level_of(turned.model, end.index()) != level;
  });
  if (good) return std::nullopt;
  return "a level edge ends on one of the same height";
}

TurnFault four_faces_edge_on(const TurnedScene& turned) {
  const std::vector<native::Direction> expected{
      native::rational_direction(-3, -4), native::rational_direction(-4, 3), native::rational_direction(3, 4),
      native::rational_direction(4, -3)};
  if (turned.list.events.size() != expected.size())
    return fmt::format("{} events, not {}", turned.list.events.size(), expected.size());
  for (const native::Event& event : turned.list.events) {
    if (std::find(expected.begin(), expected.end(), event.direction) == expected.end())
      return fmt::format("an event at {:.9f} rad", event.direction.angle);
  }
  return std::nullopt;
}

TurnFault level_sheet_hides_nothing(const TurnedScene& turned) {
  const auto& sheet = turned.scene.bodies.back().faces.front().outline;
  const auto of_sheet = [&](EdgeIndex edge) {
    const auto& ends = turned.model.edges()[edge];
    return std::find(sheet.begin(), sheet.end(), ends.from) != sheet.end() &&
           std::find(sheet.begin(), sheet.end(), ends.to) != sheet.end();
  };
  const bool good = all_ends(turned, [&](EdgeIndex, const native::End& end) {
    return end.kind() != EndKind::junction || !of_sheet(end.index());
  });
  if (good) return std::nullopt;
  return "an edge ends on the sheet";
}

TurnFault mirrored_events(const TurnedScene& turned) {
  const auto& events = turned.list.events;
  std::size_t alone = 0;
  for (const native::Event& event : events) {
    const auto changes = turned.list.changes_of(event);
    if (std::all_of(changes.begin(), changes.end(), [&](const native::Change& change) {
          return turned.list.added_by(change).size() == turned.list.removed_by(change).size();
        }))
      continue;
    const native::Direction wanted = mirrored(event.direction);
    const auto found = std::lower_bound(
        events.begin(), events.end(), wanted,
        [](const native::Event& e, const native::Direction& d) { return native::less(e.direction, d); });
    if (found == events.end() || !(found->direction == wanted)) ++alone;
  }
  if (alone == 0) return std::nullopt;
  return fmt::format("{} of {} groups have no mirror image", alone, events.size());
}

TurnFault large_steps(const TurnedScene& turned) {
  native::EdgeStructureGraph graph(turned.list);
  const auto look = [&](double degrees) -> TurnFault {
    if (!graph.turn_to(degrees * std::numbers::pi / 180)) return std::string(lost_step);
    const std::size_t count = turned.list.events.size();
    return scratch_fault(turned, graph, (graph.passed() + count - 1) % count);
  };
  for (int i = -6; i <= 6; ++i)
    if (auto fault = look(30 * i + 0.001)) return fault;
  for (int i = 6; i >= -6; --i)
    if (auto fault = look(30 * i + 0.002)) return fault;
  return look(0.003);
}

TurnFault fronts_always_seen(const TurnedScene& turned) {
  const auto front = std::max_element(turned.model.vertices().begin(), turned.model.vertices().end(),
                                      [](const auto& a, const auto& b) { return a[2] < b[2]; });
  native::EdgeStructureGraph graph(turned.list);
  const auto& events = turned.list.events;
  for (std::size_t i = 0; i + 1 < events.size(); ++i) {
    if (!graph.step_forward()) return std::string(lost_step);
    if (std::abs(events[i].direction.angle + events[i + 1].direction.angle) > std::numbers::pi) continue;
    for (EdgeIndex edge = 0; edge < turned.model.edges().size(); ++edge) {
      const native::Segment segment = turned.model.segment(edge);
      if (segment.from[2] != (*front)[2] || segment.to[2] != (*front)[2]) continue;
      const auto pieces = graph.structure_of(edge);
      if (pieces.size() != 1 || pieces[0].low.kind() != EndKind::vertex ||
          pieces[0].high.kind() != EndKind::vertex)
        return fmt::format("edge {} is not seen whole after event {}", edge, i);
    }
  }
  return std::nullopt;
}

TurnFault only_grid_disagrees() {
  std::string wrong;
  for (const native::Table1Row& row : native::printed_table_1()) {
    const double average = static_cast<double>(row.events) / static_cast<double>(row.edges);
    if (std::abs(average - row.events_per_edge) > 0.0501) wrong += std::string(row.model) + " ";
  }
  if (wrong == "Grid ") return std::nullopt;
  return fmt::format("rows that disagree: {}", wrong);
}

}  // namespace sightline::harness::report
