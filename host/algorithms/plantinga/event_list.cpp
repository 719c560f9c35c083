#include "host/algorithms/plantinga/event_list.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/base/result.hpp"
#include "host/base/threads.hpp"

namespace sightline::algorithms::plantinga {
namespace {

// Finds the histories of the edges on several threads. The result does not depend on the distribution of edges among
// threads.
class HistorySearch {
 public:
  HistorySearch(const RotationModel& model, const BuildOptions& options)
      : model_(model), options_(options), parts_(model), histories_(model.edges().size()) {}

  // Returns an error if a limit was reached.
  std::optional<base::Error> run() {
    const unsigned threads = options_.threads != 0 ? options_.threads : base::available_threads();
    base::run_on_threads(options_.trace != nullptr ? 1 : threads, [this] { work(); });
    return stopped_;
  }

  [[nodiscard]] std::vector<EdgeHistory> take() { return std::move(histories_); }

 private:
  void work() {
    for (;;) {
      const std::size_t edge = next_.fetch_add(1);
      if (edge >= histories_.size() || given_up_) return;
      EdgeHistory history = history_of(model_, parts_, static_cast<EdgeIndex>(edge), options_.trace);
      std::uint64_t pieces = history.first.size();
      for (const EdgeChange& change : history.changes) pieces += 2 * change.after.size();
      const base::Lock lock(mutex_);
      changes_ += history.changes.size();
      pieces_ += pieces;
      histories_[edge] = std::move(history);
      ++done_;
      if (options_.progress) options_.progress(done_, histories_.size());
      if (changes_ > options_.most_changes) give_up("changes", options_.most_changes);
      if (pieces_ > options_.most_pieces) give_up("pieces", options_.most_pieces);
    }
  }

  void give_up(const std::string& what, std::uint64_t limit) {
    given_up_ = true;
    if (stopped_) return;
    stopped_ = base::bad_input("more than " + std::to_string(limit) + " " + what + " of edges: stopped after " +
                          std::to_string(done_) + " of " + std::to_string(histories_.size()) +
                          " edges with " + std::to_string(changes_) + " changes");
  }

  const RotationModel& model_;
  const BuildOptions& options_;
  const ConvexParts parts_;
  std::vector<EdgeHistory> histories_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> given_up_ = false;
  base::Mutex mutex_;
  std::size_t done_ = 0;
  std::uint64_t changes_ = 0;
  std::uint64_t pieces_ = 0;
  std::optional<base::Error> stopped_;
};

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
  HistorySearch search(model, options);
  if (auto stopped = search.run()) return std::move(*stopped);
  std::vector<EdgeHistory> histories = search.take();
  if (options.tolerance > 0) {
    for (EdgeHistory& history : histories) coarsen(history, options.tolerance);
  }
  return merge_histories(model, std::move(histories), options.tolerance);
}

}  // namespace sightline::algorithms::plantinga
