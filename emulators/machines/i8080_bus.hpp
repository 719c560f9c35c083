// The processor's side of the 8080's bus while a program runs: 64K of RAM that never makes it wait, time, and the way
// to the ports. For instructions from memory while nobody asks for HOLD; the rest is in i8080_pins.hpp.
//
// What changes with every cycle, the allowance of time, is a value in the hands of the processor; the rest is in the frame of
// the run. The machine is touched only on the slow paths, by value, so that a compiler can keep the allowance in a
// register; every verb is inlined into the instruction for the same reason.
#pragma once

#include <cstdint>

#include "../core/allowance.hpp"
#include "../core/inline.hpp"
#include "../core/reporter.hpp"
#include "../core/runner.hpp"
#include "../core/tstates.hpp"
#include "../i8080/bus.hpp"
#include "../i8080/cpu.hpp"
#include "../i8080/state.hpp"
#include "i8080_observer.hpp"

namespace sightline::machines {

// One run of a machine.
template <class Machine, class Observer>
struct I8080Frame {
  using Allowance = core::Allowance<core::TState>;

  I8080Frame(Machine& of, Observer& observer)
      : machine(&of),
        report(observer),
        arrives(observer),
        memory(of.memory_),
        registers(of.state_),
        control(&of.state_) {
    registers.f = i8080::as_flags(registers.f);
    look_around_after(of.now_, of.now_ - core::TStates(1), 1);
  }

  [[nodiscard]] core::TStateInstant now() const { return horizon - allowance.left(); }
  [[nodiscard]] i8080::State state() const { return {registers, *control}; }
  // A boundary is due when the deadline lies in the instruction that ended there, its last T-state included.
  [[nodiscard]] bool due() const { return allowance.over(); }
  void look_around_after(core::TStateInstant now, core::TStateInstant deadline, std::int64_t instructions) {
    horizon = deadline;
    allowance = Allowance(deadline - now, instructions);
  }

  Machine* machine;
  [[no_unique_address]] core::Reporter<Observer> report;
  [[no_unique_address]] core::Arrivals<Observer> arrives;
  i8080::Byte* memory;
  i8080::Registers registers;
  i8080::Control* control;
  core::TStateInstant horizon;  // the last instant that is not due
  Allowance allowance{core::TStates(0), 0};
};

template <class Machine, class Ports, class Observer>
class I8080Bus {
 public:
  using Frame = I8080Frame<Machine, Observer>;
  using Allowance = typename Frame::Allowance;

  SIGHTLINE_INLINE explicit I8080Bus(Frame& frame) : I8080Bus(frame, frame.memory, frame.allowance) {}
  SIGHTLINE_INLINE I8080Bus(Frame& frame, i8080::Byte* memory, Allowance allowance)
      : frame_(&frame), memory_(memory), allowance_(allowance) {}

  [[nodiscard]] i8080::Byte* memory() const { return memory_; }
  [[nodiscard]] Allowance allowance() const { return allowance_; }
  void count_instruction() { allowance_.count_instruction(); }
  void save() { frame_->allowance = allowance_; }

  // The opcode of the next instruction, before its cycle, and the cycle that takes it.
  [[nodiscard]] SIGHTLINE_INLINE i8080::Byte peek(i8080::Address address) const { return memory_[address]; }
  SIGHTLINE_INLINE void fetch_peeked(i8080::Status cycle, i8080::Address address, i8080::Byte opcode) {
    const core::TStateInstant begun = begin(i8080::CycleKind::fetch, address);
    report_at(begun, cycle, address, opcode);
    allowance_.pass(core::TStates(4));
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
    allowance_.pass(core::TStates(3));
  }
  i8080::Byte in(i8080::Status cycle, i8080::Byte port) {
    const core::TStateInstant begun = begin(i8080::CycleKind::input, i8080::joined(port, port));
    const i8080::Byte byte = frame_->machine->input(port, now() + third_t_state);
    report_at(begun, cycle, i8080::joined(port, port), byte);
    allowance_.pass(core::TStates(3));
    if (frame_->machine->ports_want_look()) attention();
    return byte;
  }
  void out(i8080::Status cycle, i8080::Byte port, i8080::Byte byte) {
    report(cycle, i8080::joined(port, port), byte);
    wait(i8080::CycleKind::output, i8080::joined(port, port));
    frame_->machine->output(port, byte, now() + third_t_state);
    allowance_.pass(core::TStates(3));
    if (frame_->machine->ports_want_look()) attention();
  }
  SIGHTLINE_INLINE void internal(i8080::Byte, i8080::Byte) { allowance_.pass(core::TStates(3)); }
  SIGHTLINE_INLINE void extend(int t_states) { allowance_.pass(core::TStates(t_states)); }
  void halt(i8080::Status cycle, i8080::Address address) {
    report(cycle, address, 0);
    frame_->machine->begin_halt(now() + core::TStates(1));
    allowance_.pass(core::TStates(3));
  }

  void interrupt_enable(bool) {}
  // Only the instruction of a device asks.
  void end_acknowledge() {}
  bool acknowledging() { return false; }
  SIGHTLINE_INLINE void attention() {
    frame_->horizon = now() - core::TStates(1);
    allowance_.end();
  }

  [[nodiscard]] SIGHTLINE_INLINE bool due() const { return allowance_.over(); }
  [[nodiscard]] SIGHTLINE_INLINE core::TStateInstant now() const { return frame_->horizon - allowance_.left(); }

 private:
  static constexpr core::TStates third_t_state{2};

  SIGHTLINE_INLINE i8080::Byte take(i8080::CycleKind kind, i8080::Status cycle, i8080::Address address,
                                          core::TStates length, bool operand) {
    const core::TStateInstant begun = begin(kind, address);
    const i8080::Byte byte = memory_[address];
    report_at(begun, cycle, address, byte, operand);
    allowance_.pass(length);
    return byte;
  }
  // When a cycle begins; its wait states are over.
  SIGHTLINE_INLINE core::TStateInstant begin(i8080::CycleKind kind, i8080::Address address) {
    core::TStateInstant begun{};
    if constexpr (Observer::cycles) begun = now();
    wait(kind, address);
    return begun;
  }

  static constexpr i8080::CycleKind kind_of(i8080::Status cycle, i8080::CycleKind plain, i8080::CycleKind stack) {
    return (cycle & i8080::status::stack) != 0 ? stack : plain;
  }

  SIGHTLINE_INLINE void wait(i8080::CycleKind kind, i8080::Address address) {
    if constexpr (Ports::waits) {
      allowance_.pass(
          core::TStates(frame_->machine->ports_.wait_states(kind, address, now() + core::TStates(1))));
    }
  }
  SIGHTLINE_INLINE void report(i8080::Status cycle, i8080::Address address, i8080::Byte data) {
    if constexpr (Observer::cycles) report_at(now(), cycle, address, data);
  }
  SIGHTLINE_INLINE void report_at(core::TStateInstant begun, i8080::Status cycle, i8080::Address address,
                                        i8080::Byte data, bool operand = false) {
    // Every access of every opcode is compiled with it: an observer of instructions too is slow by itself.
    if constexpr (Observer::cycles && Observer::instructions) {
      if (frame_->machine->report_out_of_line({begun, cycle, address, data, operand}, frame_->report)) attention();
    } else if constexpr (Observer::cycles) {
      if (frame_->machine->report_at_once({begun, cycle, address, data, operand}, frame_->report)) attention();
    }
  }

  Frame* frame_;
  i8080::Byte* memory_;
  Allowance allowance_;
};

// The processor on it, as threads.hpp runs it.
template <class Machine, class Ports, class Observer>
class I8080Thread {
 public:
  using Bus = I8080Bus<Machine, Ports, Observer>;
  using Frame = typename Bus::Frame;
  using Execution = i8080::Execution<Bus>;
  static constexpr unsigned codes = Execution::codes;
  static constexpr bool has_spare_word = false;

  SIGHTLINE_INLINE explicit I8080Thread(Frame& frame)
      : frame_(&frame), execution_(Bus(frame), frame.registers, *frame.control) {}

  SIGHTLINE_INLINE static I8080Thread resume(Frame& frame, const core::HostWords& words) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): it was made by host_words()
    auto* const memory = reinterpret_cast<i8080::Byte*>(static_cast<std::uintptr_t>(words.a));
    const Bus bus(frame, memory, typename Bus::Allowance(words.b));
    return I8080Thread(frame, Execution(bus, frame.registers, *frame.control, words.c, static_cast<std::uint32_t>(words.d), words.e));
  }
  [[nodiscard]] SIGHTLINE_INLINE core::HostWords host_words() const {
    return {reinterpret_cast<std::uintptr_t>(execution_.bus().memory()), execution_.bus().allowance().host_word(),
            execution_.a(), execution_.hl(), execution_.pc()};
  }

  [[nodiscard]] SIGHTLINE_INLINE unsigned code() const {
    return execution_.bus().peek(static_cast<i8080::Address>(execution_.pc()));
  }
  template <unsigned code>
  static constexpr bool leaves_memory = Execution::template is_rare<code>;
  template <unsigned code>
  [[nodiscard]] SIGHTLINE_INLINE bool is_rare() const {
    return leaves_memory<code>;
  }
  template <unsigned code>
  SIGHTLINE_INLINE void execute() {
    execution_.bus().count_instruction();
    if constexpr (!leaves_memory<code>) execution_.template step_as<code>();
  }
  void execute_any() {
    execution_.bus().count_instruction();
    execution_.step_rare(static_cast<i8080::Byte>(code()));
  }
  [[nodiscard]] SIGHTLINE_INLINE bool leaves() const {
    if constexpr (Observer::stops) {
      if (frame_->arrives(static_cast<i8080::Address>(execution_.pc()))) [[unlikely]] return true;
    }
    return execution_.bus().due();
  }
  SIGHTLINE_INLINE void leave() { execution_.save(); }

  // One instruction, whatever its opcode.
  void step() {
    execution_.bus().count_instruction();
    execution_.step();
    leave();
  }

 private:
  SIGHTLINE_INLINE I8080Thread(Frame& frame, const Execution& execution)
      : frame_(&frame), execution_(execution) {}

  Frame* frame_;
  Execution execution_;
};

}  // namespace sightline::machines
