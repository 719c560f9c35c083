// The smallest bus on which a PDP-7 processor runs: an array of words, a count of cycles, and devices whose answers the test
// sets.
#pragma once

#include <array>
#include <cstdint>

#include "emulators/pdp7/bus.hpp"
#include "emulators/pdp7/cpu.hpp"
#include "emulators/pdp7/timing.hpp"

namespace sightline::tests {

struct ArrayMachine {
  std::array<core::Word18, 8192> core{};
  core::Word18 switches;
  pdp7::IotReply reply;
  int cycles = 0;
  core::Duration asynchronous{};
  int unanswered = 0;
};

class ArrayBus {
 public:
  explicit ArrayBus(ArrayMachine& machine) : machine_(&machine) {}

  core::Word18 fetch(pdp7::Address a) { return read(a); }
  void interrupt(core::Word18 word) { write(0, word); }
  core::Word18 read(pdp7::Address a) {
    ++machine_->cycles;
    return machine_->core.at(a);
  }
  void write(pdp7::Address a, core::Word18 word) {
    ++machine_->cycles;
    machine_->core.at(a) = word;
  }
  core::Word18 modify(pdp7::Address a) {
    ++machine_->cycles;
    return machine_->core.at(a) = machine_->core.at(a) + core::Word18(1);
  }
  pdp7::IotReply iot(std::uint32_t, core::Word18 ac) {
    pdp7::IotReply reply = machine_->reply;
    reply.ac = reply.ac | ac;
    return reply;
  }
  void idle(core::Duration duration) { machine_->asynchronous += duration; }
  core::Word18 switches() { return machine_->switches; }
  void unanswered(std::uint32_t, pdp7::Address) { ++machine_->unanswered; }
  void attention() {}

 private:
  ArrayMachine* machine_;
};

static_assert(pdp7::Bus<ArrayBus>);

// Runs `instructions` from `state` and returns the state after them.
inline pdp7::State run_on_array(ArrayMachine& machine, const pdp7::State& state, int instructions = 1,
                                const pdp7::Model& model = {}) {
  const pdp7::Timing timing;
  pdp7::Cpu<ArrayBus> cpu(ArrayBus(machine), model, timing, state);
  for (int i = 0; i < instructions; ++i) cpu.step();
  return cpu.state();
}

}  // namespace sightline::tests
