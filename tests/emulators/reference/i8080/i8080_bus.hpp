// The processor's side of the 8080's bus while a program runs: 64K of RAM that never makes it wait, time, and the way
// to the ports.
//
// It lives in the locals of one run and touches the machine only on the slow paths, by value, so that a compiler can
// keep time and the deadline in registers; every verb is inlined into the run for the same reason.
#pragma once

#include "emulators/core/inline.hpp"
#include "emulators/core/tstates.hpp"
#include "emulators/i8080/bus.hpp"
#include "emulators/i8080/isa.hpp"
#include "emulators/i8080/state.hpp"
#include "tests/emulators/reference/i8080/observer.hpp"

namespace sightline::reference_8080 {
template <class Machine, class Ports, class Observer>
class I8080Bus {
 public:
  I8080Bus(Machine& machine, Observer& observer)
      : machine_(&machine), report_(observer), memory_(machine.memory_.data()), now_(machine.now_) {}
  I8080Bus(const I8080Bus&) = default;
  // From a bus of the same machine: takes over the time only, so that a compiler sees that the rest never changes in a
  // run and does not fetch it again for every instruction.
  SIGHTLINE_INLINE I8080Bus& operator=(const I8080Bus& other) {
    now_ = other.now_;
    deadline_ = other.deadline_;
    return *this;
  }

  SIGHTLINE_INLINE i8080::Byte fetch(i8080::Status cycle, i8080::Address address) {
    return take(i8080::CycleKind::fetch, cycle, address, core::TStates(4), false);
  }
  SIGHTLINE_INLINE i8080::Byte operand(i8080::Status cycle, i8080::Address address) {
    return take(i8080::CycleKind::read, cycle, address, core::TStates(3), true);
  }
  SIGHTLINE_INLINE i8080::Byte read(i8080::Status cycle, i8080::Address address) {
    return take(kind_of(cycle, i8080::CycleKind::read, i8080::CycleKind::stack_read), cycle, address,
                core::TStates(3), false);
  }
  SIGHTLINE_INLINE void write(i8080::Status cycle, i8080::Address address, i8080::Byte byte) {
    report(cycle, address, byte);
    wait(kind_of(cycle, i8080::CycleKind::write, i8080::CycleKind::stack_write), address);
    memory_[address] = byte;
    now_ += core::TStates(3);
  }
  SIGHTLINE_INLINE i8080::Byte in(i8080::Status cycle, i8080::Byte port) {
    const core::TStateInstant begun = now_;
    wait(i8080::CycleKind::input, i8080::joined(port, port));
    const i8080::Byte byte = machine_->input(port, now_ + third_t_state);
    report_at(begun, cycle, i8080::joined(port, port), byte);
    now_ += core::TStates(3);
    attention();
    return byte;
  }
  SIGHTLINE_INLINE void out(i8080::Status cycle, i8080::Byte port, i8080::Byte byte) {
    report(cycle, i8080::joined(port, port), byte);
    wait(i8080::CycleKind::output, i8080::joined(port, port));
    machine_->output(port, byte, now_ + third_t_state);
    now_ += core::TStates(3);
    attention();
  }
  SIGHTLINE_INLINE void internal(i8080::Byte, i8080::Byte) { now_ += core::TStates(3); }
  SIGHTLINE_INLINE void extend(int t_states) { now_ += core::TStates(t_states); }
  void halt(i8080::Status cycle, i8080::Address address) {
    report(cycle, address, 0);
    machine_->begin_halt(now_ + core::TStates(1));
    now_ += core::TStates(3);
  }

  void interrupt_enable(bool) {}
  void end_acknowledge() { machine_->acknowledging_ = false; }
  // Asked at the beginning of a cycle: INT in the T-state before it.
  bool acknowledging() { return machine_->still_acknowledging(now_); }
  SIGHTLINE_INLINE void attention() { deadline_ = core::TStateInstant::min(); }

  // A boundary is due when the deadline lies in the instruction that ended there, its last T-state included.
  [[nodiscard]] SIGHTLINE_INLINE bool due() const {
    return now_ > deadline_;
  }
  [[nodiscard]] core::TStateInstant now() const { return now_; }
  void set_now(core::TStateInstant now) { now_ = now; }
  void set_deadline(core::TStateInstant deadline) { deadline_ = deadline; }

 private:
  static constexpr core::TStates third_t_state{2};

  // Without MEMR the byte comes from the device whose interrupt is being acknowledged.
  SIGHTLINE_INLINE i8080::Byte take(i8080::CycleKind kind, i8080::Status cycle, i8080::Address address,
                                          core::TStates length, bool operand) {
    const core::TStateInstant begun = now_;
    wait(kind, address);
    const i8080::Byte byte = (cycle & i8080::status::memory_read) != 0
                                 ? memory_[address]
                                 : machine_->acknowledge(now_ + third_t_state);
    report_at(begun, cycle, address, byte, operand);
    now_ += length;
    return byte;
  }

  static constexpr i8080::CycleKind kind_of(i8080::Status cycle, i8080::CycleKind plain, i8080::CycleKind stack) {
    return (cycle & i8080::status::stack) != 0 ? stack : plain;
  }

  SIGHTLINE_INLINE void wait(i8080::CycleKind kind, i8080::Address address) {
    if constexpr (Ports::waits) {
      now_ += core::TStates(machine_->ports_.wait_states(kind, address, now_ + core::TStates(1)));
    }
  }
  SIGHTLINE_INLINE void report(i8080::Status cycle, i8080::Address address, i8080::Byte data) {
    report_at(now_, cycle, address, data);
  }
  SIGHTLINE_INLINE void report_at(core::TStateInstant begun, i8080::Status cycle, i8080::Address address,
                                        i8080::Byte data, bool operand = false) {
    // Every access of every opcode is compiled with it: an observer of instructions too is slow by itself.
    if constexpr (Observer::cycles && Observer::instructions) {
      if (machine_->report_out_of_line({begun, cycle, address, data, operand}, report_)) attention();
    } else if constexpr (Observer::cycles) {
      if (machine_->report_at_once({begun, cycle, address, data, operand}, report_))
        attention();
    }
  }

  Machine* machine_;
  [[no_unique_address]] Reporter<Observer> report_;
  i8080::Byte* memory_;
  core::TStateInstant now_;
  core::TStateInstant deadline_ = core::TStateInstant::min();  // the first boundary of a run is always looked at
};

}  // namespace sightline::reference_8080
