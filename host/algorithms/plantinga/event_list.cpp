#include "host/algorithms/plantinga/event_list.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/algorithms/plantinga/history_search.hpp"
#include "host/base/result.hpp"

namespace sightline::algorithms::plantinga {
namespace {

// The next multiple of the tolerance, as a direction with integer parts.
Direction round_up(const Direction& direction, double tolerance) {
  const double angle = std::ceil(direction.angle / tolerance) * tolerance;
  if (!(angle < std::numbers::pi)) return rational_direction(0, -1);
  constexpr double scale = 0x1p50;
  return rational_direction(std::llround(scale * std::sin(angle)), std::llround(scale * std::cos(angle)));
}

void coarsen(EdgeHistory& history, double tolerance) {
  std::vector<EdgeChange> kept;
  for (EdgeChange& change : history.changes) {
    change.direction = round_up(change.direction, tolerance);
    if (!kept.empty() && kept.back().direction == change.direction) {
      kept.back().after = std::move(change.after);
    } else {
      kept.push_back(std::move(change));
    }
  }
  const EdgeStructure* now = &history.first;
  history.changes.clear();
  history.changes.reserve(kept.size());
  for (EdgeChange& change : kept) {
    if (change.after == *now) continue;
    history.changes.push_back(std::move(change));
    now = &history.changes.back().after;
  }
}

EventList merge_histories(const RotationModel& model, std::vector<EdgeHistory> histories, double tolerance) {
  EventList list;
  list.fingerprint = model.fingerprint();
  list.tolerance = tolerance;
  struct Place {
    EdgeIndex edge;
    std::uint32_t change;
  };
  std::vector<Place> order;
  for (EdgeIndex edge = 0; edge < histories.size(); ++edge) {
    for (std::uint32_t i = 0; i < histories[edge].changes.size(); ++i) order.push_back({edge, i});
  }
  const auto at = [&](const Place& p) -> const EdgeChange& { return histories[p.edge].changes[p.change]; };
  std::sort(order.begin(), order.end(), [&](const Place& p, const Place& q) {
    const int before = compare(at(p).direction, at(q).direction);
    return before != 0 ? before < 0 : p.edge < q.edge;
  });
  for (const Place& place : order) {
    const EdgeChange& change = at(place);
    if (list.events.empty() || !(list.events.back().direction == change.direction)) {
      list.events.push_back({change.direction, static_cast<std::uint32_t>(list.changes.size()), 0});
    }
    const EdgeHistory& history = histories[place.edge];
    append_change(list, place.edge,
                  place.change == 0 ? history.first : history.changes[place.change - 1].after, change.after);
  }
  list.first.reserve(histories.size());
  for (EdgeHistory& history : histories) list.first.push_back(std::move(history.first));
  return list;
}

}  // namespace

void append_change(EventList& list, EdgeIndex edge, const EdgeStructure& before, const EdgeStructure& after) {
  Change change{edge, static_cast<std::uint32_t>(list.pieces.size()), 0, 0};
  list.pieces.insert(list.pieces.end(), before.begin(), before.end());
  change.added = static_cast<std::uint32_t>(list.pieces.size());
  list.pieces.insert(list.pieces.end(), after.begin(), after.end());
  change.end = static_cast<std::uint32_t>(list.pieces.size());
  list.changes.push_back(change);
  ++list.events.back().change_count;
}

base::Result<EventList> build_event_list(const RotationModel& model, const BuildOptions& options) {
  const ConvexParts parts(model);
  HistorySearch<EdgeHistory> search(model.edges().size(), options,
                                    [&](EdgeIndex edge) { return history_of(model, parts, edge, options.trace); });
  if (auto stopped = search.run()) return std::move(*stopped);
  std::vector<EdgeHistory> histories = search.take();
  if (options.tolerance > 0) {
    for (EdgeHistory& history : histories) coarsen(history, options.tolerance);
  }
  return merge_histories(model, std::move(histories), options.tolerance);
}

}  // namespace sightline::algorithms::plantinga
