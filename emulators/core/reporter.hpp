// The way of bus events to an observer, for those that run a processor: a value that is empty, and costs nothing, when the
// observer does not want them.
//
// An observer that looks for few places among many has a filter: a small value, which the run keeps beside its registers,
// so that what is not looked for costs one test.
//   using Filter = ...;
//   Filter filter() const;
//     bool arrives(Address next) const      stop() is asked at these boundaries, and at the one after a cycle that was told
//     bool wants(const Cycle&) const        only these are told; where the observer wants cycles
//     bool asks_again() const               optional, PDP-7 only; true: stop() is asked at the next boundary, too. Asked after the devices have
//                                           been served, because a sink may have asked for a stop there
//
// An observer that looks at registers has a value of another kind, which the run keeps, too:
//   using Look = ...;
//   Look look() const;
//     bool asks(Address next, const View&) const               out of line: asked where a test of few host instructions behind
//                                           an instruction said so, which may be too often, and where something is due. The view has
//                                           the registers as the processor has them at work; its bus names it
// Which tests those are the machines say: i8080_looking.hpp, and of one that has marks the following.
// One that has marks, too, finds places by marks in the words of memory (of the PDP-7: pdp7/core_memory.hpp):
//   marked_places() const                 pairs of an address and its marks
//   in its Look: changes() const          what an instruction has to change to be followed by a question
//     marks() const                       all marks of these places
//     bool may_ask<changes>(const View&) const    after an instruction that may have changed what the set says (`change` of isa.hpp)
//     bool may_ask(const View&) const             after any instruction
//     void see(flags)                     before asks() outside the instructions: what gives the flags of all devices
//     bool looks_again(flags, broken_into)    the same, where devices have been attended to and may have broken into memory: it is to
//                                         be asked at the next boundary, too
//     void answered()                     stop() has been asked, and the run goes on
// stop() is asked where asks() says true, and finds the machine's registers and time up to date; told() says whether a cycle that
// was told is to end the run.
#pragma once

#include "inline.hpp"

namespace sightline::core {

template <class Observer>
concept Filtered = requires { typename Observer::Filter; };

template <class Observer>
concept Looks = requires { typename Observer::Look; };

template <class Observer>
concept Marks = Looks<Observer> && requires(const Observer& observer) { observer.marked_places(); };

template <class Observer, bool wanted = Observer::cycles>
class Reporter {
 public:
  static constexpr bool has_marks = Marks<Observer>;
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
  static constexpr bool has_marks = Marks<Observer>;
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
  static constexpr bool has_marks = Marks<Observer>;
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

template <class Observer>
  requires(Filtered<Observer> && !Looks<Observer>)
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

template <Looks Observer>
class Arrivals<Observer> {
 public:
  explicit constexpr Arrivals(const Observer& observer) : look_(observer.look()) {}
  [[nodiscard]] constexpr typename Observer::Look& look() { return look_; }
  [[nodiscard]] constexpr const typename Observer::Look& look() const { return look_; }

 private:
  typename Observer::Look look_;
};

}  // namespace sightline::core
