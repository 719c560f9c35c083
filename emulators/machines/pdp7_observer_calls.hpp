// Decides by the marks which calls the observer of a run gets. Without an observer nothing is marked.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "../core/inline.hpp"
#include "../pdp7/bus.hpp"
#include "../pdp7/state.hpp"
#include "pdp7.hpp"

namespace sightline::pdp7 {

class ObserverCalls {
 public:
  explicit ObserverCalls(Observer* observer)
      : observer_(observer),
        marks_(observer == nullptr ? no_marks.data() : observer->marks == nullptr ? all_accesses.data() : observer->marks),
        all_(observer != nullptr && observer->marks == nullptr),
        every_boundary_(all_ || (observer != nullptr && observer->every_boundary)),
        next_boundary_(observer != nullptr) {}

  [[nodiscard]] Observer* observer() const { return observer_; }

  // An access to core; `mark`: the mark that reports it.
  SIGHTLINE_INLINE void access(std::uint8_t mark, const Cycle& cycle) {
    if ((marks_[cycle.address & address_mask] & mark) != 0) [[unlikely]] report(cycle);
  }
  // The program interrupt or an IOT.
  void event(const Cycle& cycle) {
    if (observer_ != nullptr) report(cycle);
  }
  void idle(const Cycle& cycle) {
    if (all_) report(cycle);
  }

  // Whether stop() is to be called at a boundary.
  [[nodiscard]] SIGHTLINE_INLINE bool wants_stop(Address next) const { return next_boundary_ || (marks_[next] & mark::stop) != 0; }
  // Calls stop() at that boundary. True: the run ends there.
  [[nodiscard]] bool stop(core::Instant now, Address next) {
    next_boundary_ = every_boundary_;
    return observer_->stop(now, next);
  }

 private:
  using Marks = std::array<std::uint8_t, std::size_t{address_mask} + 1>;
  static constexpr Marks no_marks{};
  static constexpr Marks all_accesses = [] {
    Marks marks{};
    for (std::uint8_t& each : marks) each = mark::fetched | mark::read | mark::written;
    return marks;
  }();

  void report(const Cycle& cycle) {
    next_boundary_ = true;
    observer_->cycle(cycle);
  }

  Observer* observer_;
  const std::uint8_t* marks_;
  bool all_;             // every cycle is reported
  bool every_boundary_;  // stop() is called at every boundary
  bool next_boundary_;   // at the next one
};

}  // namespace sightline::pdp7
