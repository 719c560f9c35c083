// An 8080 with 64K of RAM and the devices on its ports.
//
// Everything that is not an instruction happens at an instruction boundary, and a boundary costs one compare against
// the nearest instant at which anything may be due. Ports are touched with the T-state in which the real device would
// be; what they do in between they make up for then. INT is what the last T-state of an instruction finds.
//
// An interrupt's instruction, and whatever happens while HOLD is high or about to be, runs T-state by T-state
// (i8080_pins.hpp). Ports know beforehand when they ask for HOLD, so that nothing is paid while they do not.
//
// Left out: ROM, and memory banks.
// Source: i8080/cpu.hpp and pin_bus.hpp, which the tests hold this machine against.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "../core/inline.hpp"
#include "../core/reporter.hpp"
#include "../core/state_visitor.hpp"
#include "../core/runner.hpp"
#include "../core/tstates.hpp"
#include "../i8080/cpu.hpp"
#include "../i8080/state.hpp"
#include "i8080_bus.hpp"
#include "i8080_observer.hpp"
#include "i8080_pins.hpp"
#include "i8080_run.hpp"

namespace sightline::machines {

template <class Ports, class Observer = NoI8080Observer>
class I8080Machine {
 public:
  // Both must outlive the machine.
  I8080Machine(Ports& ports, Observer& observer) : ports_(ports), observer_(observer), memory_(new i8080::Byte[memory_size]{}) {}
  I8080Machine(const I8080Machine&) = delete;
  I8080Machine& operator=(const I8080Machine&) = delete;
  ~I8080Machine() { delete[] memory_; }

  // Registers, between runs.
  [[nodiscard]] i8080::State& registers() { return state_; }
  [[nodiscard]] const i8080::State& registers() const { return state_; }

  // Memory, without time: the door for loaders, dumps and tests.
  [[nodiscard]] i8080::Byte peek(i8080::Address address) const { return memory_[address]; }
  void deposit(i8080::Address address, i8080::Byte byte) { memory_[address] = byte; }
  [[nodiscard]] std::span<i8080::Byte> memory() { return {memory_, memory_size}; }
  [[nodiscard]] std::span<const i8080::Byte> memory() const { return {memory_, memory_size}; }

  [[nodiscard]] core::TStateInstant now() const { return now_; }
  // Since the machine was made; those a device supplied included.
  [[nodiscard]] std::uint64_t instructions() const { return instructions_; }
  // T-states in which the processor stood still because of HOLD, since the machine was made.
  [[nodiscard]] std::uint64_t held() const { return held_; }

  // All that a further run depends on besides the ports, as it is between two runs (../core/state_visitor.hpp).
  void visit_state(core::StateVisitor& visit) {
    visit.section("processor", state_);
    visit.section("time", [this](auto& fields) {
      fields("now", now_);
      fields("instructions", instructions_);
      fields("halt_sampled", halt_sampled_);
      bool after_halt = halt_ended_ == now_;
      fields("after_halt", after_halt);
      halt_ended_ = after_halt ? now_ : core::never_t;
    });
    // T-states in hand when the run stopped: an interrupt's instruction, or a HOLD.
    visit.section("pins", [this](auto& fields) {
      fields("acknowledging", pins_.acknowledged);
      fields("hold", pins_.hold);
      fields("hold_acknowledge", pins_.hold_acknowledge);
      fields("after_write", pins_.after_write);
      fields("passed_over", pins_.passed_over);
      fields("waking", pins_.waking);
      fields("held", held_);
      fields.require(!pins_.waking || state_.halted, "waking", "only in a halt");
    });
    visit.section("memory", [this](auto& fields) { fields.bytes("bytes", memory(), 0xFF); });
  }

  // The RESET pin; memory stays, and so do all registers but PC and INTE.
  void reset() {
    state_.pc = 0;
    static_cast<i8080::Control&>(state_) = {};
    pins_ = {};
    halt_ended_ = core::never_t;
  }

  // Runs from the state as it is until something stops it; what is due at the boundary where it stops is left to the
  // next run, so that a run in pieces is the same as a run in one.
  I8080StopReason run(const I8080Limits& limits) { return run(limits, observer_); }

  // The same, watched by another than the machine's own observer.
  template <class Watcher>
  [[gnu::noinline]] I8080StopReason run(const I8080Limits& limits, Watcher& watcher) {
    I8080Frame<I8080Machine, Watcher> frame(*this, watcher);
    const std::uint64_t begun = instructions_;
    std::uint64_t count = 0;
    const I8080StopReason reason = run_frame(frame, watcher, limits, count);
    publish(frame, begun + count);
    bring_ports_to(now_);
    return reason;
  }

 private:
  template <class, class>
  friend struct I8080Frame;
  template <class, class, class>
  friend class I8080Bus;

  template <class Watcher>
  I8080StopReason run_frame(I8080Frame<I8080Machine, Watcher>& frame, Watcher& watcher, const I8080Limits& limits,
                            std::uint64_t& count) {
    [[maybe_unused]] const std::uint64_t begun = instructions_;
    [[maybe_unused]] bool in_hold = false;  // where the run has to end: no boundary
    while (true) {
      if constexpr (Watcher::stops) {
        if (!state_.halted && !in_hold && frame.arrives(frame.registers.pc)) {
          if (core::reads_machine(watcher)) publish(frame, begun + count);
          if (watcher.stop(frame.now(), frame.registers.pc)) return I8080StopReason::observer;
        }
      }
      if (frame.due()) {
        if constexpr (core::Filtered<Watcher>) {
          if (!state_.halted && !in_hold && watcher.stop(frame.now(), frame.registers.pc)) return I8080StopReason::observer;
        }
        const std::int64_t most = instructions_of(limits, count);
        const Attention found = attend(frame.now(), limits, count, most);
        frame.look_around_after(found.now, found.deadline, most);
        if (found.stop) return found.reason;
        if (found.again) continue;
        if (found.by_pins) {
          in_hold = !state_.halted;
          if (step_by_pins(frame, watcher, limits.until)) {
            ++count;
            in_hold = false;
          }
          continue;
        }
      }
      const std::int64_t before = frame.allowance.instructions();
      go_on(frame, watcher);
      count += static_cast<std::uint64_t>(before - frame.allowance.instructions());
    }
  }

  // What the machine shows, as it is at a boundary.
  template <class Frame>
  void publish(const Frame& frame, std::uint64_t instructions) {
    static_cast<i8080::Registers&>(state_) = frame.registers;
    now_ = frame.now();
    instructions_ = instructions;
  }

  // Instructions of one allowance.
  static constexpr std::int64_t instructions_of(const I8080Limits& limits, std::uint64_t count) {
    const std::uint64_t left = count < limits.instructions ? limits.instructions - count : 1;
    return static_cast<std::int64_t>(
        std::min(left, static_cast<std::uint64_t>(core::Allowance<core::TState>::most)));
  }

  // Instructions up to the next boundary at which something is due, one at least; one, if the observer follows each.
  template <class Watcher>
  void go_on(I8080Frame<I8080Machine, Watcher>& frame, Watcher& watcher) {
    using Thread = I8080Thread<I8080Machine, Ports, Watcher>;
    if constexpr (Watcher::instructions) {
      const core::TStateInstant begun = frame.now();
      const i8080::State before = frame.state();
      const std::array<i8080::Byte, 3> bytes = bytes_at(before.pc);
      Thread(frame).step();
      watcher.instruction({begun, frame.now(), before.pc, bytes, false, before, frame.state()});
    } else if constexpr (core::follows_instructions<Watcher>) {
      Thread(frame).step();
    } else {
      core::Runner<Thread, Watcher>::run(frame);
    }
  }

  // One instruction, T-state by T-state; false: it has come to no end of a halt or a HOLD before `until`.
  template <class Watcher>
  bool step_by_pins(I8080Frame<I8080Machine, Watcher>& frame, Watcher& watcher, core::TStateInstant until) {
    using Frame = I8080Frame<I8080Machine, Watcher>;
    I8080Tell tell{&frame};
    if constexpr (Watcher::cycles) {
      tell.cycle = [](void* to, const I8080Cycle& cycle) { static_cast<Frame*>(to)->report(cycle); };
    }
    if constexpr (requires(const I8080HoldPins& pins) { watcher.hold(pins); }) {
      tell.to_holds = &watcher;
      tell.hold = [](void* to, const I8080HoldPins& pins) { static_cast<Watcher*>(to)->hold(pins); };
    }
    [[maybe_unused]] const i8080::State before = frame.state();
    [[maybe_unused]] const std::array<i8080::Byte, 3> bytes = bytes_at(before.pc);
    const I8080PinStep step = step_on_pins(frame.registers, frame.now(), until, tell);
    frame.look_around_after(step.now, at_once(step.now), 1);
    if constexpr (Watcher::instructions) {
      if (step.executed)
        watcher.instruction({step.begun, step.now, before.pc, step.acknowledged ? supplied_.bytes : bytes, step.acknowledged,
                             before, frame.state()});
    }
    return step.executed;
  }

  struct Attention {
    core::TStateInstant now;
    core::TStateInstant deadline;
    I8080StopReason reason = I8080StopReason::observer;
    bool stop = false;
    bool by_pins = false;  // the next instruction, or what is to come before it, runs T-state by T-state
    bool again = false;    // a halt has ended: the boundary is another
  };

  // A boundary at which something may be due. In and out by value: see run().
  [[gnu::noinline]] Attention attend(core::TStateInstant now, const I8080Limits& limits, std::uint64_t count,
                                     std::int64_t most) {
    if (ports_.stopped()) return stopping(now, I8080StopReason::ports);
    if (count >= limits.instructions) return stopping(now, I8080StopReason::instruction_limit);
    if (now >= limits.until) return stopping(now, I8080StopReason::time_limit);
    if (state_.halted) return wait_in_halt(now, limits.until);
    bring_ports_to(now);
    if (pins_under_way() || hold_is_near(now)) return by_pins(now);
    // INT is not looked at after EI, nor before the first instruction, where no T-state could have seen it.
    const bool looks = !state_.deferred && now > core::at_t_state(0);
    if (looks && state_.interrupts_on && ports_.interrupt()) return by_pins(now);
    Attention found{now, at_once(now)};
    if (looks) found.deadline = next_deadline(now, limits.until, most);
    state_.deferred = false;
    return found;
  }

  static Attention by_pins(core::TStateInstant now) { return {now, at_once(now), {}, false, true, false}; }
  static Attention stopping(core::TStateInstant now, I8080StopReason reason) {
    return {now, at_once(now), reason, true, false, false};
  }
  // The deadline that makes the next boundary due.
  static constexpr core::TStateInstant at_once(core::TStateInstant now) { return now - core::TStates(1); }

  // The last instant that must be over before the next look. An instruction lasts at least 4 T-states, so `most` of them
  // cannot end earlier than 4 * most from now: that bounds their number without a count to compare.
  [[nodiscard]] core::TStateInstant next_deadline(core::TStateInstant now, core::TStateInstant until,
                                                  std::int64_t most) const {
    constexpr core::TStates last{1};
    core::TStateInstant deadline = std::min(ports_.deadline(), now + core::TStates(4) * most - last);
    if constexpr (HoldingPorts<Ports>) deadline = std::min(deadline, ports_.next_hold(now) - longest_instruction);
    return until != core::never_t ? std::min(deadline, until - last) : deadline;
  }

  // HLT waits from T2 of its halt cycle on. The T-state t that finds INT high is followed by two more; T1 of the next
  // instruction is t + 3, a boundary like any other: whether INT is still high decides what is fetched there. HOLD is sampled
  // from t + 1 on, and is low before t + 2.
  Attention wait_in_halt(core::TStateInstant now, core::TStateInstant until) {
    core::TStateInstant t = halt_sampled_;
    if (pins_under_way() || (t + core::TStates(1) == now && hold_is_near(now)))
      return halt_may_end(pins_) ? by_pins(now) : stopping(now, I8080StopReason::halt);
    const core::TStateInstant hold = next_hold(now);
    while (state_.interrupts_on) {
      ports_.advance(t);
      if (hold != core::never_t && t + core::TStates(2) >= hold) {
        pins_.acknowledged = pins_.waking = ports_.interrupt();
        bring_ports_to(hold);
        return by_pins(hold);
      }
      if (ports_.interrupt()) {
        state_.halted = false;
        halt_ended_ = std::max(now, t + core::TStates(3));
        return {halt_ended_, at_once(halt_ended_), {}, false, false, true};
      }
      halt_sampled_ = t + core::TStates(1);
      if (ports_.stopped()) return stopping(std::max(now, halt_sampled_), I8080StopReason::ports);
      const core::TStateInstant next = ports_.deadline();
      if (next == core::never_t) break;
      t = std::max(hold != core::never_t ? std::min(next, hold - core::TStates(2)) : next, halt_sampled_);
      if (t >= until) {
        halt_sampled_ = until;
        return stopping(std::max(now, until), I8080StopReason::time_limit);
      }
    }
    return stopping(now, I8080StopReason::halt);
  }

  void begin_halt(core::TStateInstant second_t_state) {
    halt_sampled_ = second_t_state;
  }

  // Everything before `now` has happened.
  void bring_ports_to(core::TStateInstant now) {
    if (now > core::at_t_state(0)) ports_.advance(now - core::TStates(1));
  }

  // --- T-state by T-state ---

  static constexpr core::TStates longest_instruction{18};  // XTHL, without wait states

  [[nodiscard]] bool pins_under_way() const {
    return pins_.acknowledged || pins_.hold || pins_.hold_acknowledge || pins_.passed_over || pins_.waking;
  }
  [[nodiscard]] core::TStateInstant next_hold([[maybe_unused]] core::TStateInstant t) const {
    if constexpr (HoldingPorts<Ports>) return ports_.next_hold(t);
    return core::never_t;
  }
  // As of the T-state before.
  [[nodiscard]] bool halt_may_end(const i8080::PinLatches& pins) const {
    return pins.waking || pins.acknowledged ||
           (state_.interrupts_on && (ports_.interrupt() || ports_.deadline() != core::never_t));
  }
  // HOLD was high in the T-state before, or may be within the next instruction, which is of any length where it has to wait.
  [[nodiscard]] bool hold_is_near(core::TStateInstant now) const {
    const core::TStateInstant next = next_hold(now - core::TStates(1));
    return next != core::never_t && (Ports::waits || next < now + longest_instruction);
  }

  // The rest of a halt or a HOLD, and the instruction after a HOLD. What bring_ports_to(now) does has been done.
  [[gnu::noinline]] I8080PinStep step_on_pins(i8080::Registers& registers, core::TStateInstant now, core::TStateInstant until,
                                              I8080Tell tell) {
    i8080::PinLatches latches = pins_;
    latches.interrupt = now > core::at_t_state(0) && ports_.interrupt();
    latches.woken = !state_.halted && halt_ended_ == now;
    latches.halted = state_.halted || latches.woken;
    supplied_ = {};
    I8080Board<Ports> board(ports_, memory_, supplied_, now, latches.hold_acknowledge, tell);
    I8080PinBus<Ports> bus(board, state_.interrupts_on, latches);
    I8080PinStep step;
    if (state_.halted) wait_on_pins(board, bus, until);
    else if (hold_on_pins(board, bus, until)) step = execute_on_pins(board, bus, registers);
    step.now = board.now();
    if (state_.halted) halt_sampled_ = step.now - core::TStates(1);
    held_ += static_cast<std::uint64_t>(board.held());
    pins_ = bus.latches();
    pins_.acknowledged = pins_.acknowledged && pins_.interrupt;
    pins_.after_write = pins_.after_write && pins_.hold;
    pins_.interrupt = pins_.halted = pins_.woken = false;  // see above
    return step;
  }
  void wait_on_pins(I8080Board<Ports>& board, I8080PinBus<Ports>& bus, core::TStateInstant until) {
    do {
      if (bus.wait_in_halt()) {
        state_.halted = false;
        halt_ended_ = board.now();
        return;
      }
      if (ports_.stopped() || board.now() >= until || !halt_may_end(bus.latches())) return;
    } while (bus.latches().waking || bus.latches().hold || bus.latches().hold_acknowledge || hold_is_near(board.now()));
  }
  // False: HOLD lasts until `until` at least.
  bool hold_on_pins(I8080Board<Ports>& board, I8080PinBus<Ports>& bus, core::TStateInstant until) {
    while (bus.wait_in_hold()) {
      if (board.now() >= until) return false;
      if (bus.latches().hold) board.pass_held(until);
      if (board.now() >= until) return false;
    }
    return true;
  }
  I8080PinStep execute_on_pins(I8080Board<Ports>& board, I8080PinBus<Ports>& bus, i8080::Registers& registers) {
    I8080PinStep step{{}, board.now(), true, false};
    i8080::Execution<I8080PinBus<Ports>&> execution(bus, registers, state_);
    const bool interrupt = bus.interrupt();
    const bool open = state_.interrupts_on && !state_.deferred;
    state_.deferred = false;
    step.acknowledged = (interrupt && open) || bus.acknowledging();
    if (step.acknowledged) execution.acknowledge();
    else execution.step();
    execution.save();
    return step;
  }

  [[nodiscard]] std::array<i8080::Byte, 3> bytes_at(i8080::Address address) const {
    const auto at = [&](unsigned i) { return memory_[static_cast<i8080::Address>(address + i)]; };
    return {at(0), at(1), at(2)};
  }

  [[gnu::noinline]] i8080::Byte input(i8080::Byte port, core::TStateInstant at) { return ports_.in(port, at); }
  [[gnu::noinline]] void output(i8080::Byte port, i8080::Byte byte, core::TStateInstant at) {
    ports_.out(port, byte, at);
  }
  [[nodiscard]] bool ports_want_look() const {
    if constexpr (requires { ports_.wants_look(); }) return ports_.wants_look();
    else return true;
  }

  // The fetch that ends a halt still says HLTA.
  template <class Report>
  SIGHTLINE_INLINE bool report_at_once(I8080Cycle cycle, Report report) {
    if (cycle.time == halt_ended_) cycle.status |= i8080::status::halt;
    return report(cycle);
  }
  template <class Report>
  [[gnu::noinline]] bool report_out_of_line(I8080Cycle cycle, Report report) {
    return report_at_once(cycle, report);
  }

  Ports& ports_;
  Observer& observer_;
  i8080::State state_;
  core::TStateInstant now_{};
  std::uint64_t instructions_ = 0;
  static constexpr std::size_t memory_size = 0x10000;
  i8080::Byte* const memory_;  // owned; <memory> would make each reader of this header read half of the library
  core::TStateInstant halt_sampled_{};  // the next T-state in which a halted processor looks at INT
  core::TStateInstant halt_ended_ = core::never_t;  // T1 of the fetch after the last halt
  i8080::PinLatches pins_;  // all false between instructions at which nothing is in hand
  SuppliedBytes supplied_;
  std::uint64_t held_ = 0;
};

}  // namespace sightline::machines
