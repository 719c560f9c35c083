// The parts of an 8080 machine: registers, memory, time, ports, and three engines that execute its instructions. Each
// engine is an instance of ../i8080/cpu.hpp on a different bus:
//
//   i8080_fast.cpp    unobserved runs
//   i8080_plain.cpp   observed runs, memory that makes the processor wait, and hosts without the fast engine
//   i8080_pins.cpp    T-state by T-state: around a HOLD, and the instruction that an interrupting device supplies
//
// At the boundaries between instructions i8080.cpp chooses the engine. A boundary is served only when the deadline has
// passed: before that only instructions execute.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "../core/allowance.hpp"
#include "../core/stroke.hpp"
#include "../core/tstates.hpp"
#include "../i8080/bus.hpp"
#include "../i8080/pin_bus.hpp"
#include "../i8080/state.hpp"
#include "i8080.hpp"
#include "i8080_ports.hpp"

namespace sightline::i8080 {

struct MachineParts {
  explicit MachineParts(const Options& chosen) : options(chosen), ports(chosen.strict) { clear_above_memory(); }

  // The fast engine addresses most of these by one small offset: they come first.
  State state;
  core::TStateInstant deadline{};  // a boundary later than this is served
  core::Allowance<core::TState> allowance{core::TStates(0), 0};  // of the fast engine
  core::TStateInstant now{};
  std::uint64_t instructions = 0;
  core::TStateInstant halt_sampled{};              // the next T-state in which a halted processor samples INT
  core::TStateInstant halt_ended = core::never_t;  // T1 of the fetch after the last halt
  PinLatches pins;                                 // all false between instructions, except around an acknowledge or a HOLD
  std::uint64_t held = 0;
  Options options;
  Ports ports;
  core::StrokeBuffer strokes;
  UndefinedOpcodes undefined;
  std::array<Byte, 0x10000> memory{};  // FF above the RAM

  static constexpr core::TStates one{1};
  static constexpr core::TStates longest_instruction{18};  // XTHL, without wait states

  [[nodiscard]] bool ends_early() const { return options.memory < memory.size(); }
  void store(Address address, Byte byte) {
    if (address < options.memory) memory[address] = byte;
  }
  void clear_above_memory() {
    if (ends_early()) std::fill(memory.begin() + options.memory, memory.end(), Byte{0xFF});
  }
  void count_undefined(Byte opcode, Address address);

  // The next boundary must be served.
  void serve_next_boundary() { deadline = now - one; }

  [[nodiscard]] bool pins_under_way() const {
    return pins.acknowledged || pins.hold || pins.hold_acknowledge || pins.passed_over || pins.waking;
  }
  // HOLD was high in the last T-state, or may be within the next instruction, whose length is unbounded if it has to wait.
  [[nodiscard]] bool hold_is_near(core::TStateInstant at) const {
    const core::TStateInstant next = ports.next_hold(at - one);
    return next != core::never_t && (ports.has_wait_states() || next < at + longest_instruction);
  }
  // As of the last T-state.
  [[nodiscard]] bool halt_may_end(const PinLatches& latches) const {
    return latches.waking || latches.acknowledged ||
           (state.interrupts_on && (ports.interrupt() || ports.deadline() != core::never_t));
  }
  [[nodiscard]] std::array<Byte, 3> bytes_at(Address address) const {
    const auto at = [&](unsigned i) { return memory[static_cast<Address>(address + i)]; };
    return {at(0), at(1), at(2)};
  }
};

// The events that the observer of a run wants.
class Watch {
 public:
  Watch() = default;  // no observer
  explicit Watch(Observer& observer)
      : observer_(&observer),
        marks_(observer.marks),
        port_marks_(observer.marks != nullptr ? observer.port_marks : nullptr),
        all_cycles_(observer.marks == nullptr),
        every_boundary_(observer.marks == nullptr || observer.every_boundary),
        instructions_(observer.instructions),
        expects_stop_(true) {}

  // Cycles that read bytes of instructions, and halt cycles, are wanted only if this is true.
  [[nodiscard]] bool wants_all_cycles() const { return all_cycles_; }
  [[nodiscard]] bool wants(Address address, std::uint8_t marks) const {
    return marks_ != nullptr ? (marks_[address] & marks) != 0 : all_cycles_;
  }
  [[nodiscard]] bool wants_port(std::uint8_t port, std::uint8_t marks) const {
    return port_marks_ != nullptr ? (port_marks_[port] & marks) != 0 : all_cycles_;
  }
  [[nodiscard]] bool wants_instructions() const { return instructions_; }
  [[nodiscard]] bool is_observed() const { return observer_ != nullptr; }
  // stop() must be called before the instruction at `next`.
  [[nodiscard]] bool wants_boundary(Address next) const {
    return every_boundary_ || expects_stop_ || (marks_ != nullptr && (marks_[next] & mark::stop) != 0);
  }

  void report(const BusCycle& cycle) {
    expects_stop_ = true;
    observer_->cycle(cycle);
  }
  void report(const HoldPins& pins) { observer_->hold(pins); }
  void report(const InstructionRecord& record) { observer_->instruction(record); }
  [[nodiscard]] bool stop(core::TStateInstant now, Address next) {
    expects_stop_ = false;
    return observer_->stop(now, next);
  }

 private:
  Observer* observer_ = nullptr;
  const std::uint8_t* marks_ = nullptr;
  const std::uint8_t* port_marks_ = nullptr;
  bool all_cycles_ = false;
  bool every_boundary_ = false;
  bool instructions_ = false;
  bool expects_stop_ = false;  // at the next boundary: the run begins, or a cycle has been reported
};

// Each executes at least one instruction from memory, until a boundary must be served, and counts instructions and time.

// At most `most` instructions, 1 to Allowance::most; the deadline must allow that many.
void run_fast(MachineParts& machine, std::int64_t most);
// Until a boundary must be served or Observer::stop() must be called.
void run_plainly(MachineParts& machine, Watch& watch);
// One instruction, or the rest of a halt or a HOLD, at most up to `until`. True: an instruction was executed. On entry
// devices are in the state of the last T-state; on return the next boundary must be served.
bool step_by_pins(MachineParts& machine, Watch& watch, core::TStateInstant until);

}  // namespace sightline::i8080
