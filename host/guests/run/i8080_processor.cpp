// See i8080_processor.hpp.
#include "host/guests/run/i8080_processor.hpp"

#include "emulators/core/inline.hpp"
#include "host/guests/run/i8080_observers.hpp"

namespace sightline::guests::run {

namespace {

// Ends a run before the instruction at a place, but not where the run begins.
struct Arrival {
  static constexpr bool instructions = false;
  static constexpr bool cycles = false;
  static constexpr bool stops = true;
  struct Filter {
    i8080::Address place;
    [[nodiscard]] SIGHTLINE_INLINE bool arrives(i8080::Address next) const { return next == place; }
  };

  i8080::Address place;
  core::TStateInstant begun;

  [[nodiscard]] Filter filter() const { return {place}; }
  [[nodiscard]] bool stop(core::TStateInstant now, i8080::Address next) const { return next == place && now != begun; }
};

}  // namespace

machines::I8080StopReason I8080Processor::run(const machines::I8080Limits& limits) { return I8080Machine::run(limits); }
machines::I8080StopReason I8080Processor::run(const machines::I8080Limits& limits, I8080Watcher& watcher) {
  return I8080Machine::run(limits, watcher);
}
machines::I8080StopReason I8080Processor::run(const machines::I8080Limits& limits, I8080Reporter& reporter) {
  return I8080Machine::run(limits, reporter);
}

machines::I8080StopReason I8080Processor::run_to(i8080::Address place, const machines::I8080Limits& limits) {
  Arrival arrival{place, now()};
  return I8080Machine::run(limits, arrival);
}

}  // namespace sightline::guests::run
