// The histories of all edges in a full turn, for lists of events.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/base/result.hpp"
#include "host/base/threads.hpp"

namespace sightline::algorithms::plantinga {

// Finds the histories of the edges on several threads. The result does not depend on the distribution of edges among
// threads.
template <class History>
class HistorySearch {
 public:
  using Find = std::function<History(EdgeIndex)>;
  HistorySearch(std::size_t edges, const BuildOptions& options, Find find)
      : options_(options), find_(std::move(find)), histories_(edges) {}

  // Returns an error if a limit was reached.
  std::optional<base::Error> run() {
    const unsigned threads = options_.threads != 0 ? options_.threads : base::available_threads();
    base::run_on_threads(options_.trace != nullptr ? 1 : threads, [this] { work(); });
    return stopped_;
  }

  [[nodiscard]] std::vector<History> take() { return std::move(histories_); }

 private:
  void work() {
    for (;;) {
      const std::size_t edge = next_.fetch_add(1);
      if (edge >= histories_.size() || given_up_) return;
      History history = find_(static_cast<EdgeIndex>(edge));
      std::uint64_t pieces = history.first.size();
      for (const auto& change : history.changes) pieces += 2 * change.after.size();
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

  const BuildOptions& options_;
  const Find find_;
  std::vector<History> histories_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> given_up_ = false;
  base::Mutex mutex_;
  std::size_t done_ = 0;
  std::uint64_t changes_ = 0;
  std::uint64_t pieces_ = 0;
  std::optional<base::Error> stopped_;
};

}  // namespace sightline::algorithms::plantinga
