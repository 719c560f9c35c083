// The way of bus events to an observer, for those that run a processor: a value that is empty, and costs nothing, when the
// observer does not want them.
#pragma once

namespace sightline::core {

template <class Observer, bool wanted = Observer::cycles>
class Reporter {
 public:
  // The observer outlives the reporter.
  explicit constexpr Reporter(Observer& observer) : observer_(&observer) {}
  template <class Cycle>
  [[gnu::always_inline]] constexpr void operator()(const Cycle& cycle) const {
    observer_->cycle(cycle);
  }

 private:
  Observer* observer_;
};

template <class Observer>
class Reporter<Observer, false> {
 public:
  explicit constexpr Reporter(Observer&) {}
  template <class Cycle>
  constexpr void operator()(const Cycle&) const {}
};

}  // namespace sightline::core
