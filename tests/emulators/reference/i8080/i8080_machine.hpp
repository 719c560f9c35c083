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

#include "emulators/core/inline.hpp"
#include "emulators/core/state_visitor.hpp"
#include "emulators/core/tstates.hpp"
#include "tests/emulators/reference/i8080/cpu.hpp"
#include "emulators/i8080/state.hpp"
#include "tests/emulators/reference/i8080/i8080_bus.hpp"
#include "tests/emulators/reference/i8080/observer.hpp"

namespace sightline::reference_8080 {
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
      fields("acknowledging", acknowledging_);
    });
    visit.section("memory", [this](auto& fields) { fields.bytes("bytes", std::span<i8080::Byte>(memory_), 0xFF); });
  }

  // The RESET pin; memory stays, and so do all registers but PC and INTE.
  void reset() {
    using Bus = I8080Bus<I8080Machine, Ports, Observer>;
    reference_8080::Cpu<Bus> cpu(Bus(*this, observer_), state_, state_);
    cpu.reset();
    static_cast<i8080::Registers&>(state_) = cpu.registers();
    halt_ended_ = core::never_t;
  }

  // Runs from the state as it is until something stops it; what is due at the boundary where it stops is left to the
  // next run, so that a run in pieces is the same as a run in one. Registers, time and the processor's side of the bus
  // are locals of this function: that, and nothing else, is what makes it fast.
  I8080StopReason run(const I8080Limits& limits) { return run(limits, observer_); }

  // The same, watched by another than the machine's own observer.
  template <class Watcher>
  [[gnu::noinline]] I8080StopReason run(const I8080Limits& limits, Watcher& watcher) {
    using Bus = I8080Bus<I8080Machine, Ports, Watcher>;
    reference_8080::Cpu<Bus> cpu(Bus(*this, watcher), state_, state_);
    [[maybe_unused]] const Arrivals<Watcher> arrives(watcher);
    std::uint64_t count = 0;
    I8080StopReason reason = I8080StopReason::observer;
    while (true) {
      if constexpr (Watcher::stops) {
        if (arrives(cpu.pc())) [[unlikely]] {
          if (!state_.halted && watcher.stop(cpu.bus().now(), cpu.pc())) break;
        }
      }
      if (cpu.bus().due()) [[unlikely]] {
        if constexpr (Filtered<Watcher>) {
          if (!state_.halted && watcher.stop(cpu.bus().now(), cpu.pc())) break;
        }
        const Attention found = attend(cpu.bus().now(), limits, count);
        cpu.bus().set_now(found.now);
        cpu.bus().set_deadline(found.deadline);
        if (found.stop) {
          reason = found.reason;
          break;
        }
        if (found.again) continue;
        if (found.interrupt) {
          ++count;
          acknowledge_one(cpu, watcher);
          continue;
        }
      }
      ++count;
      step(cpu, watcher);
    }
    instructions_ += count;
    static_cast<i8080::Registers&>(state_) = cpu.registers();
    now_ = cpu.bus().now();
    still_acknowledging(now_);  // first: the next run cannot follow INT through what has passed
    bring_ports_to(now_);
    return reason;
  }

 private:
  template <class, class, class>
  friend class I8080Bus;

  template <class Cpu, class Watcher>
  SIGHTLINE_INLINE void step(Cpu& cpu, Watcher& watcher) {
    if constexpr (Watcher::instructions) {
      const core::TStateInstant begun = cpu.bus().now();
      const i8080::State before = cpu.state();
      const auto at = [&](unsigned i) { return memory_[static_cast<i8080::Address>(before.pc + i)]; };
      const std::array<i8080::Byte, 3> bytes{at(0), at(1), at(2)};
      cpu.step();
      watcher.instruction({begun, cpu.bus().now(), before.pc, bytes, false, before, cpu.state()});
    } else {
      cpu.step();
    }
  }

  // The instruction a device supplies.
  template <class Cpu, class Watcher>
  SIGHTLINE_INLINE void acknowledge_one(Cpu& cpu, Watcher& watcher) {
    acknowledging_ = true;
    supplied_ = {};
    supplied_count_ = 0;
    if constexpr (Watcher::instructions) {
      const core::TStateInstant begun = cpu.bus().now();
      const i8080::State before = cpu.state();
      cpu.acknowledge();
      watcher.instruction({begun, cpu.bus().now(), before.pc, supplied_, true, before, cpu.state()});
    } else {
      cpu.acknowledge();
    }
    cpu.bus().attention();
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
  [[gnu::noinline]] Attention attend(core::TStateInstant now, const I8080Limits& limits, std::uint64_t count) {
    if (ports_.stopped()) return stopping(now, I8080StopReason::ports);
    if (count >= limits.instructions) return stopping(now, I8080StopReason::instruction_limit);
    if (now >= limits.until) return stopping(now, I8080StopReason::time_limit);
    if (state_.halted) return wait_in_halt(now, limits.until);
    Attention found{now, core::TStateInstant::min()};
    found.interrupt = still_acknowledging(now);  // first: it follows INT through what has passed
    bring_ports_to(now);
    // INT is not looked at after EI, nor before the first instruction, where no T-state could have seen it.
    const bool looks = !state_.deferred && now > core::at_t_state(0);
    if (looks && state_.interrupts_on && ports_.interrupt()) found.interrupt = true;
    if (looks) found.deadline = next_deadline(now, limits, limits.instructions - count);
    state_.deferred = false;
    return found;
  }

  static Attention stopping(core::TStateInstant now, I8080StopReason reason) {
    return {now, core::TStateInstant::min(), reason, true, false, false};
  }

  // The last instant that must be over before the next look. An instruction lasts at least 4 T-states, so `left` more
  // of them cannot end earlier than 4 * left from now: that bounds their number without a count to compare.
  [[nodiscard]] core::TStateInstant next_deadline(core::TStateInstant now, const I8080Limits& limits,
                                                  std::uint64_t left) const {
    constexpr std::uint64_t uncounted = std::uint64_t{1} << 60;
    constexpr core::TStates last{1};
    core::TStateInstant deadline = ports_.deadline();
    if (limits.until != core::never_t) deadline = std::min(deadline, limits.until - last);
    if (left < uncounted) {
      deadline = std::min(deadline, now + core::TStates(4) * static_cast<std::int64_t>(left) - last);
    }
    return deadline;
  }

  // HLT waits from T2 of its halt cycle on. The T-state t that finds INT high is followed by two more; T1 of the next
  // instruction is t + 3, a boundary like any other: whether INT is still high decides what is fetched there.
  Attention wait_in_halt(core::TStateInstant now, core::TStateInstant until) {
    core::TStateInstant t = halt_sampled_;
    // A HLT that a device has supplied, and INT has stayed high.
    if (waking_) {
      waking_ = false;
      state_.halted = false;
      halt_ended_ = std::max(now, t + core::TStates(3));
      return {halt_ended_, core::TStateInstant::min(), {}, false, false, true};
    }
    while (state_.interrupts_on) {
      ports_.advance(t);
      if (ports_.interrupt()) {
        state_.halted = false;
        halt_ended_ = std::max(now, t + core::TStates(3));
        return {halt_ended_, core::TStateInstant::min(), {}, false, false, true};
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
    waking_ = still_acknowledging(second_t_state + core::TStates(1));
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

  [[gnu::noinline]] i8080::Byte input(i8080::Byte port, core::TStateInstant at) {
    still_acknowledging(at);
    return ports_.in(port, at);
  }
  [[gnu::noinline]] void output(i8080::Byte port, i8080::Byte byte, core::TStateInstant at) {
    still_acknowledging(at);
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
  SIGHTLINE_INLINE bool report_at_once(I8080Cycle cycle, Report report) {
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
  bool waking_ = false;  // the latch ends a halt that has begun
  std::array<i8080::Byte, 3> supplied_{};  // by the device, since the last acknowledge began
  std::size_t supplied_count_ = 0;
};

}  // namespace sightline::reference_8080
