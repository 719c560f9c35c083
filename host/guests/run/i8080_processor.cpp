// See i8080_processor.hpp.
#include "host/guests/run/i8080_processor.hpp"

#include <cstddef>

#include "host/guests/run/i8080_observers.hpp"
#include "host/guests/run/probe.hpp"

namespace sightline::guests::run {

machines::I8080StopReason I8080Processor::run(const machines::I8080Limits& limits) { return I8080Machine::run(limits); }
machines::I8080StopReason I8080Processor::run(const machines::I8080Limits& limits, I8080Watcher& watcher) {
  return I8080Machine::run(limits, watcher);
}
machines::I8080StopReason I8080Processor::run(const machines::I8080Limits& limits, I8080Reporter& reporter) {
  return I8080Machine::run(limits, reporter);
}

machines::I8080StopReason I8080Processor::run_to(i8080::Address place, const machines::I8080Limits& limits) {
  Probe probe(std::size_t{0x10000}, std::size_t{0x100});
  probe.mark(place, Probe::executed);
  I8080Watcher watcher(probe);
  watcher.begin(now());
  return run(limits, watcher);
}

}  // namespace sightline::guests::run
