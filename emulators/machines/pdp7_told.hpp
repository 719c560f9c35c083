// What of a run an observer is told, by the marks of addresses. Without an observer nothing is marked.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "../core/inline.hpp"
#include "../pdp7/bus.hpp"
#include "../pdp7/state.hpp"
#include "pdp7.hpp"

namespace sightline::pdp7 {

class Told {
 public:
  explicit Told(Observer* observer)
      : observer_(observer),
        marks_(observer == nullptr ? no_marks.data() : observer->marks == nullptr ? all_accesses.data() : observer->marks),
        all_(observer != nullptr && observer->marks == nullptr),
        asks_always_(all_ || (observer != nullptr && observer->every_boundary)),
        asks_(observer != nullptr) {}

  [[nodiscard]] Observer* observer() const { return observer_; }

  // An access to core; `mark`: one that an address must have for it.
  SIGHTLINE_INLINE void access(std::uint8_t mark, const Cycle& cycle) {
    if ((marks_[cycle.address & address_mask] & mark) != 0) [[unlikely]] tell(cycle);
  }
  // The program interrupt or an IOT.
  void event(const Cycle& cycle) {
    if (observer_ != nullptr) tell(cycle);
  }
  void idle(const Cycle& cycle) {
    if (all_) tell(cycle);
  }

  // Whether stop() is to be asked at a boundary.
  [[nodiscard]] SIGHTLINE_INLINE bool asks(Address next) const { return asks_ || (marks_[next] & mark::stop) != 0; }
  // At that boundary. True: the run ends there.
  [[nodiscard]] bool stops(core::Instant now, Address next) {
    asks_ = asks_always_;
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

  void tell(const Cycle& cycle) {
    asks_ = true;
    observer_->cycle(cycle);
  }

  Observer* observer_;
  const std::uint8_t* marks_;
  bool all_;          // every cycle is told
  bool asks_always_;  // at every boundary
  bool asks_;         // at the next one
};

}  // namespace sightline::pdp7
