// An 8080 with 64K of RAM and the devices on its ports.
//
// Everything that is not an instruction happens at an instruction boundary, and a boundary costs one compare against
// the nearest instant at which anything may be due. Ports are touched with the T-state in which the real device would
// be; what they do in between they make up for then. INT is what the last T-state of an instruction finds.
//
// Left out: HOLD, which no board of this machine asks for (i8080/pin_bus.hpp has it), ROM, and memory banks.
// Source: i8080/cpu.hpp and pin_bus.hpp, which the tests hold this machine against.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../core/reporter.hpp"
#include "../core/tstates.hpp"
#include "../i8080/cpu.hpp"
#include "../i8080/state.hpp"
#include "i8080_bus.hpp"
#include "i8080_observer.hpp"
#include "i8080_run.hpp"

namespace sightline::machines {

template <class Ports, class Observer = NoI8080Observer>
class I8080Machine {
 public:
  // Both must outlive the machine.
  I8080Machine(Ports& ports, Observer& observer) : ports_(ports), observer_(observer), memory_(65536) {}
  I8080Machine(const I8080Machine&) = delete;
  I8080Machine& operator=(const I8080Machine&) = delete;

  // Registers, between runs.
  [[nodiscard]] i8080::State& registers() { return state_; }
  [[nodiscard]] const i8080::State& registers() const { return state_; }

  // Memory, without time: the door for loaders, dumps and tests.
  [[nodiscard]] i8080::Byte peek(i8080::Address address) const { return memory_[address]; }
  void deposit(i8080::Address address, i8080::Byte byte) { memory_[address] = byte; }
  [[nodiscard]] std::span<i8080::Byte> memory() { return memory_; }
  [[nodiscard]] std::span<const i8080::Byte> memory() const { return memory_; }

  [[nodiscard]] core::TStateInstant now() const { return now_; }
  // Since the machine was made; those a device supplied included.
  [[nodiscard]] std::uint64_t instructions() const { return instructions_; }

  // All that a further run depends on besides the ports, as it is between two runs (../core/visit_state.hpp).
  template <class Visitor>
  void visit_state(Visitor& visit) {
    visit.section("processor", state_);
    visit.section("time", [this](auto& fields) {
      fields("now", now_);
      fields("instructions", instructions_);
      fields("halt_sampled", halt_sampled_);
      bool after_halt = halt_ended_ == now_;
      fields("after_halt", after_halt);
      halt_ended_ = after_halt ? now_ : core::never_t;
      fields("acknowledging", acknowledging_);
    });
    visit.section("memory", [this](auto& fields) { fields.bytes("bytes", std::span<i8080::Byte>(memory_), 0xFF); });
  }

  // The RESET pin; memory stays, and so do all registers but PC and INTE.
  void reset() {
    state_.pc = 0;
    static_cast<i8080::Control&>(state_) = {};
    acknowledging_ = false;
    halt_ended_ = core::never_t;
  }

  // Runs from the state as it is until something stops it; what is due at the boundary where it stops is left to the
  // next run, so that a run in pieces is the same as a run in one.
  I8080StopReason run(const I8080Limits& limits) { return run(limits, observer_); }

  // The same, watched by another than the machine's own observer.
  template <class Watcher>
  [[gnu::noinline]] I8080StopReason run(const I8080Limits& limits, Watcher& watcher) {
    I8080Frame<I8080Machine, Watcher> frame(*this, watcher);
    std::uint64_t count = 0;
    const I8080StopReason reason = run_frame(frame, watcher, limits, count);
    instructions_ += count;
    static_cast<i8080::Registers&>(state_) = frame.registers;
    now_ = frame.now();
    still_acknowledging(now_);  // first: the next run cannot follow INT through what has passed
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
    while (true) {
      if constexpr (Watcher::stops) {
        if (frame.arrives(frame.registers.pc)) {
          if (!state_.halted && watcher.stop(frame.now(), frame.registers.pc)) return I8080StopReason::observer;
        }
      }
      if (frame.due()) {
        if constexpr (core::Filtered<Watcher>) {
          if (!state_.halted && watcher.stop(frame.now(), frame.registers.pc)) return I8080StopReason::observer;
        }
        const std::int64_t most = instructions_of(limits, count);
        const Attention found = attend(frame.now(), limits, count, most);
        frame.look_around_after(found.now, found.deadline, most);
        if (found.stop) return found.reason;
        if (found.again) continue;
        if (found.interrupt) {
          ++count;
          acknowledge_one(frame, watcher);
          continue;
        }
      }
      const std::int64_t before = frame.allowance.instructions();
      go_on(frame, watcher);
      count += static_cast<std::uint64_t>(before - frame.allowance.instructions());
    }
  }

  // Instructions of one allowance.
  static constexpr std::int64_t instructions_of(const I8080Limits& limits, std::uint64_t count) {
    const std::uint64_t left = count < limits.instructions ? limits.instructions - count : 1;
    return static_cast<std::int64_t>(
        std::min(left, static_cast<std::uint64_t>(core::Allowance<core::TState>::most)));
  }

  // Instructions up to the next boundary at which something is due, one at least; one, if each has to be told.
  template <class Watcher>
  void go_on(I8080Frame<I8080Machine, Watcher>& frame, Watcher& watcher) {
    using Thread = I8080Thread<I8080Machine, Ports, Watcher>;
    if constexpr (Watcher::instructions) {
      const core::TStateInstant begun = frame.now();
      const i8080::State before = frame.state();
      const auto at = [&](unsigned i) { return memory_[static_cast<i8080::Address>(before.pc + i)]; };
      const std::array<i8080::Byte, 3> bytes{at(0), at(1), at(2)};
      Thread(frame).step();
      watcher.instruction({begun, frame.now(), before.pc, bytes, false, before, frame.state()});
    } else {
      core::Runner<Thread, Watcher>::run(frame);
    }
  }

  // The instruction a device supplies.
  template <class Watcher>
  void acknowledge_one(I8080Frame<I8080Machine, Watcher>& frame, Watcher& watcher) {
    using Thread = I8080Thread<I8080Machine, Ports, Watcher>;
    acknowledging_ = true;
    supplied_ = {};
    supplied_count_ = 0;
    if constexpr (Watcher::instructions) {
      const core::TStateInstant begun = frame.now();
      const i8080::State before = frame.state();
      Thread(frame).acknowledge();
      watcher.instruction({begun, frame.now(), before.pc, supplied_, true, before, frame.state()});
    } else {
      Thread(frame).acknowledge();
    }
  }

  struct Attention {
    core::TStateInstant now;
    core::TStateInstant deadline;
    I8080StopReason reason = I8080StopReason::observer;
    bool stop = false;
    bool interrupt = false;
    bool again = false;  // a halt has ended: the boundary is another
  };

  // A boundary at which something may be due. In and out by value: see run().
  [[gnu::noinline]] Attention attend(core::TStateInstant now, const I8080Limits& limits, std::uint64_t count,
                                     std::int64_t most) {
    if (ports_.stopped()) return stopping(now, I8080StopReason::ports);
    if (count >= limits.instructions) return stopping(now, I8080StopReason::instruction_limit);
    if (now >= limits.until) return stopping(now, I8080StopReason::time_limit);
    if (state_.halted) return wait_in_halt(now, limits.until);
    Attention found{now, at_once(now)};
    found.interrupt = still_acknowledging(now);  // first: it follows INT through what has passed
    bring_ports_to(now);
    // INT is not looked at after EI, nor before the first instruction, where no T-state could have seen it.
    const bool looks = !state_.deferred && now > core::at_t_state(0);
    if (looks && state_.interrupts_on && ports_.interrupt()) found.interrupt = true;
    if (looks) found.deadline = next_deadline(now, limits.until, most);
    state_.deferred = false;
    return found;
  }

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
    const core::TStateInstant deadline = std::min(ports_.deadline(), now + core::TStates(4) * most - last);
    return until != core::never_t ? std::min(deadline, until - last) : deadline;
  }

  // HLT waits from T2 of its halt cycle on. The T-state t that finds INT high is followed by two more; T1 of the next
  // instruction is t + 3, a boundary like any other: whether INT is still high decides what is fetched there.
  Attention wait_in_halt(core::TStateInstant now, core::TStateInstant until) {
    core::TStateInstant t = halt_sampled_;
    while (state_.interrupts_on) {
      ports_.advance(t);
      if (ports_.interrupt()) {
        state_.halted = false;
        halt_ended_ = std::max(now, t + core::TStates(3));
        return {halt_ended_, at_once(halt_ended_), {}, false, false, true};
      }
      halt_sampled_ = t + core::TStates(1);
      if (ports_.stopped()) return stopping(std::max(now, halt_sampled_), I8080StopReason::ports);
      const core::TStateInstant next = ports_.deadline();
      if (next == core::never_t) break;
      t = std::max(next, halt_sampled_);
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

  // The acknowledge latch: INT has not dropped since the acknowledge, as of the T-state before `now`.
  [[gnu::noinline]] bool still_acknowledging(core::TStateInstant now) {
    core::TStateInstant before{};
    while (acknowledging_ && ports_.interrupt() && ports_.deadline() < now && ports_.deadline() > before) {
      before = ports_.deadline();
      ports_.advance(before);
    }
    if (acknowledging_) acknowledging_ = ports_.interrupt();
    if (acknowledging_) bring_ports_to(now);
    return acknowledging_;
  }

  [[gnu::noinline]] i8080::Byte input(i8080::Byte port, core::TStateInstant at) { return ports_.in(port, at); }
  [[gnu::noinline]] void output(i8080::Byte port, i8080::Byte byte, core::TStateInstant at) {
    ports_.out(port, byte, at);
  }
  [[gnu::noinline]] i8080::Byte acknowledge(core::TStateInstant at) {
    still_acknowledging(at);
    const i8080::Byte byte = ports_.acknowledge(at);
    if (supplied_count_ < supplied_.size()) supplied_[supplied_count_++] = byte;
    return byte;
  }

  // The fetch that ends a halt still says HLTA.
  template <bool ends_of_halts = true, class Report>
  [[gnu::always_inline]] bool report_at_once(I8080Cycle cycle, Report report) {
    if constexpr (ends_of_halts) {
      if (cycle.time == halt_ended_) cycle.status |= i8080::status::halt;
    }
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
  std::vector<i8080::Byte> memory_;
  core::TStateInstant halt_sampled_{};  // the next T-state in which a halted processor looks at INT
  core::TStateInstant halt_ended_ = core::never_t;  // T1 of the fetch after the last halt
  bool acknowledging_ = false;
  std::array<i8080::Byte, 3> supplied_{};  // by the device, since the last acknowledge began
  std::size_t supplied_count_ = 0;
};

}  // namespace sightline::machines
