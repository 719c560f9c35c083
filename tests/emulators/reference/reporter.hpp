// The way of bus events to an observer, for those that run a processor: a value that is empty, and costs nothing, when the
// observer does not want them.
//
// An observer that looks for few places among many has a filter: a small value, which the run keeps beside its registers,
// so that what is not looked for costs one test.
//   using Filter = ...;
//   Filter filter() const;
//     bool arrives(Address next) const      stop() is asked at these boundaries, and at the one after a cycle that was told
//     bool wants(const Cycle&) const        which cycles are told; cycles that a device takes must be refused, because stop() is not asked after them
//     bool asks_again() const               optional, PDP-7 only; true: stop() is asked at the next boundary, too. Asked after the devices have
//                                           been served, because a sink may have asked for a stop there
// One that is asked at every boundary has none.
#pragma once

#include "emulators/core/inline.hpp"

namespace sightline::reference {

template <class Observer>
concept Filtered = requires { typename Observer::Filter; };

// An observer that is asked or told after every instruction: a run executes one at a time.
template <class Observer>
inline constexpr bool follows_instructions = Observer::instructions || (Observer::stops && !Filtered<Observer>);

template <class Observer, bool wanted = Observer::cycles>
class Reporter {
 public:
  // The observer outlives the reporter.
  explicit constexpr Reporter(Observer& observer) : observer_(&observer) {}
  // True: stop() is to be asked at the next boundary.
  template <class Cycle>
  SIGHTLINE_INLINE constexpr bool operator()(const Cycle& cycle) const {
    observer_->cycle(cycle);
    return false;
  }

 private:
  Observer* observer_;
};

template <Filtered Observer>
class Reporter<Observer, true> {
 public:
  explicit constexpr Reporter(Observer& observer) : observer_(&observer), filter_(observer.filter()) {}
  template <class Cycle>
  SIGHTLINE_INLINE constexpr bool operator()(const Cycle& cycle) const {
    if (!filter_.wants(cycle)) [[likely]]
      return false;
    observer_->cycle(cycle);
    return true;
  }

 private:
  Observer* observer_;
  typename Observer::Filter filter_;
};

template <class Observer>
class Reporter<Observer, false> {
 public:
  explicit constexpr Reporter(Observer&) {}
  template <class Cycle>
  constexpr bool operator()(const Cycle&) const {
    return false;
  }
};

// Whether the observer is to be asked at a boundary that has nothing else to it.
template <class Observer>
class Arrivals {
 public:
  explicit constexpr Arrivals(const Observer&) {}
  template <class Address>
  constexpr bool operator()(Address) const {
    return Observer::stops;
  }
};

template <Filtered Observer>
class Arrivals<Observer> {
 public:
  explicit constexpr Arrivals(const Observer& observer) : filter_(observer.filter()) {}
  template <class Address>
  SIGHTLINE_INLINE constexpr bool operator()(Address next) const {
    return filter_.arrives(next);
  }
  [[nodiscard]] SIGHTLINE_INLINE constexpr bool asks_again() const {
    if constexpr (requires { filter_.asks_again(); }) return filter_.asks_again();
    else return false;
  }

 private:
  typename Observer::Filter filter_;
};

// Whether stop() is to find the machine's registers, time and counts as they are at its boundary.
template <class Observer>
[[nodiscard]] constexpr bool reads_machine(const Observer& observer) {
  if constexpr (requires { observer.reads_machine(); }) return observer.reads_machine();
  else return false;
}

}  // namespace sightline::reference
