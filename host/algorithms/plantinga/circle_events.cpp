#include "host/algorithms/plantinga/circle_events.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "host/algorithms/plantinga/circle_candidates.hpp"
#include "host/algorithms/plantinga/circle_structure.hpp"
#include "host/algorithms/plantinga/history_search.hpp"

namespace sightline::algorithms::plantinga {
namespace {

struct CircleChange {
  Enclosure within;
  EdgeStructure after;
};
struct CircleHistory {
  EdgeStructure first;  // before the first change, and again after the last
  std::vector<CircleChange> changes;
};

CircleHistory history_of(const RotationModel& model, const ConvexParts& parts, const EyeCircle& circle, EdgeIndex edge) {
  const std::vector<Occluder> occluders = model.occluders_from_anywhere(edge);
  const std::vector<Enclosure> candidates = candidates_of(model, parts, circle, edge, occluders);
  const auto structure_after = [&](std::size_t i) {
    const bool last = i + 1 == candidates.size();
    const double next = last ? candidates.front().low + 2 * half_turn : candidates[i + 1].low;
    return structure_at(model, circle, edge, occluders, place_at(circle, (candidates[i].high + next) / 2));
  };
  CircleHistory history;
  // Without candidates, any angle is right.
  history.first = candidates.empty() ? structure_at(model, circle, edge, occluders, place_at(circle, 1))
                                     : structure_after(candidates.size() - 1);
  const EdgeStructure* now = &history.first;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    EdgeStructure after = i + 1 == candidates.size() ? history.first : structure_after(i);
    if (after == *now) continue;
    history.changes.push_back({candidates[i], std::move(after)});
    now = &history.changes.back().after;
  }
  return history;
}

// The upper end of an enclosure as a direction that can be kept in a list.
Direction upper_end(const Enclosure& enclosure) {
  constexpr double scale = 0x1p50;
  const double angle = std::min(enclosure.high, half_turn);
  if (!(angle < half_turn)) return rational_direction(0, -1);
  return rational_direction(std::llround(scale * std::sin(angle)), std::llround(scale * std::cos(angle)));
}

CircleEvents merge_histories(const RotationModel& model, std::vector<CircleHistory> histories) {
  CircleEvents events;
  events.list.fingerprint = model.fingerprint();
  for (const CircleHistory& history : histories) {
    for (const CircleChange& change : history.changes) events.enclosures.push_back(change.within);
  }
  sort_and_join(events.enclosures, 4 * place_error);
  struct Place {
    std::size_t event;
    EdgeIndex edge;
    std::uint32_t change;
  };
  std::vector<Place> order;
  for (EdgeIndex edge = 0; edge < histories.size(); ++edge) {
    CircleHistory& history = histories[edge];
    // A change that was joined through pi with the last event: it is the last one.
    while (!history.changes.empty() && history.changes.front().within.low < events.enclosures.front().low) {
      history.first = history.changes.front().after;
      history.changes.push_back(history.changes.front());
      history.changes.erase(history.changes.begin());
    }
    for (std::uint32_t i = 0; i < history.changes.size(); ++i) {
      const double low = history.changes[i].within.low;
      const auto after = std::upper_bound(events.enclosures.begin(), events.enclosures.end(), low,
                                          [](double angle, const Enclosure& event) { return angle < event.low; });
      const bool joined = after == events.enclosures.begin();
      order.push_back({static_cast<std::size_t>((joined ? events.enclosures.end() : after) - events.enclosures.begin()) - 1, edge, i});
    }
  }
  std::stable_sort(order.begin(), order.end(), [](const Place& a, const Place& b) { return a.event < b.event; });
  std::vector<EdgeStructure> now;
  for (const CircleHistory& history : histories) now.push_back(history.first);
  std::size_t done = 0;
  for (std::size_t event = 0; event < events.enclosures.size(); ++event) {
    events.list.events.push_back({upper_end(events.enclosures[event]), static_cast<std::uint32_t>(events.list.changes.size()), 0});
    while (done < order.size() && order[done].event == event) {
      const EdgeIndex edge = order[done].edge;
      while (done + 1 < order.size() && order[done + 1].event == event && order[done + 1].edge == edge) ++done;
      const EdgeStructure& after = histories[edge].changes[order[done].change].after;
      if (after != now[edge]) append_change(events.list, edge, now[edge], after);
      now[edge] = after;
      ++done;
    }
  }
  for (CircleHistory& history : histories) events.list.first.push_back(std::move(history.first));
  return events;
}

}  // namespace

std::optional<std::size_t> CircleEvents::passed_at(double angle) const {
  const auto within = [](const Enclosure& enclosure, double at) {
    return at >= enclosure.low - place_error && at <= enclosure.high + place_error;
  };
  const auto after = std::upper_bound(enclosures.begin(), enclosures.end(), angle,
                                      [](double at, const Enclosure& event) { return at < event.low; });
  if (after != enclosures.end() && within(*after, angle)) return std::nullopt;
  if (after != enclosures.begin() && within(*std::prev(after), angle)) return std::nullopt;
  if (!enclosures.empty() && within(enclosures.back(), angle + 2 * half_turn)) return std::nullopt;
  if (!enclosures.empty() && within(enclosures.front(), angle - 2 * half_turn)) return std::nullopt;
  return static_cast<std::size_t>(after - enclosures.begin());
}

base::Result<CircleEvents> build_circle_events(const RotationModel& model, const EyeCircle& circle, const BuildOptions& options) {
  const ConvexParts parts(model);
  HistorySearch<CircleHistory> search(model.edges().size(), options,
                                      [&](EdgeIndex edge) { return history_of(model, parts, circle, edge); });
  if (auto stopped = search.run()) return std::move(*stopped);
  return merge_histories(model, search.take());
}

}  // namespace sightline::algorithms::plantinga
