// A PDP-7 with its core memory, its devices and, when one is attached, a display that fetches its words by
// data break.
//
// Everything that is not an instruction happens at an instruction boundary, in this order: data breaks of the disk,
// of the display, a clock tick, the program interrupt. A boundary costs one compare against the nearest instant at which any of
// them may be due; what the display, the clock or a device does in between is made up for when it is touched.
// A data break is granted at the first boundary at or after the request and takes one cycle; its word is
// at the display at the end of it.
//
// Left out: the single-step keys, data breaks while the processor is halted, and the devices that
// no scene uses (drum, magnetic tape, line printer).
// Sources: PDP-4 manual page 16 (breaks "only at the completion of the current instruction"), and timing.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "emulators/core/inline.hpp"
#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"
#include "emulators/pdp7/console.hpp"
#include "emulators/pdp7/core_memory.hpp"
#include "tests/emulators/reference/pdp7/cpu.hpp"
#include "emulators/pdp7/timing.hpp"
#include "emulators/machines/pdp7.hpp"
#include "tests/emulators/reference/pdp7/display_iots.hpp"
#include "tests/emulators/reference/pdp7/peripherals.hpp"
#include "tests/emulators/reference/reporter.hpp"
#include "tests/emulators/reference/pdp7/pdp7_bus.hpp"

namespace sightline::reference {
using pdp7::Counts;
using pdp7::InstructionRecord;
using pdp7::Limits;
using pdp7::StopReason;
using pdp7::Unanswered;

// How the machine is put together.
struct Configuration {
  std::uint32_t core_words = 8192;
  pdp7::Model model{};
  Devices devices{};
  pdp7::Timing timing{};
};

template <class Display, class Observer>
class BasicPdp7 {
 public:
  BasicPdp7(const Configuration& configuration, Observer& observer)
      : configuration_(completed(configuration)),
        core_(configuration.core_words),
        devices_(configuration.devices, configuration_.timing,
                 configuration_.model.extend ? pdp7::address_mask : pdp7::in_bank_mask),
        observer_(observer) {}
  BasicPdp7(const BasicPdp7&) = delete;
  BasicPdp7& operator=(const BasicPdp7&) = delete;

  // Plugs the display in; the arguments go to its constructor.
  template <class... Arguments>
  Display& attach_display(Arguments&&... arguments) {
    return display_.emplace(std::forward<Arguments>(arguments)...);
  }
  [[nodiscard]] Display* display() { return display_ ? &*display_ : nullptr; }
  [[nodiscard]] const Display* display() const { return display_ ? &*display_ : nullptr; }

  // Registers, between runs.
  [[nodiscard]] pdp7::State& registers() { return state_; }
  [[nodiscard]] const pdp7::State& registers() const { return state_; }

  // Core, without time: the door for loaders, dumps and tests.
  [[nodiscard]] core::Word18 peek(pdp7::Address address) const { return core_.read(address); }
  void deposit(pdp7::Address address, core::Word18 word) { core_.write(address, word); }
  [[nodiscard]] std::span<const core::Word18> core() const { return {core_.data(), core_.size()}; }
  void randomise_core(std::uint64_t seed) { core_.randomise(seed); }

  [[nodiscard]] pdp7::Console& console() { return console_; }
  [[nodiscard]] Peripherals& devices() { return devices_; }
  [[nodiscard]] const Peripherals& devices() const { return devices_; }
  [[nodiscard]] const Configuration& configuration() const { return configuration_; }
  [[nodiscard]] core::Instant now() const { return now_; }

  [[nodiscard]] Counts counts() const {
    Counts counts = counts_;
    counts.machine_cycles =
        static_cast<std::uint64_t>((now_.time_since_epoch() - asynchronous_) / pdp7::machine_cycle);
    return counts;
  }

  // One entry for every instruction word that nothing obeyed, in the order of first appearance.
  [[nodiscard]] const std::vector<Unanswered>& unanswered() const { return unanswered_; }

  // The START key: clears all flags, leaves core, AC, L, MQ and SC alone, and makes the next fetch at
  // `address`.
  void start(pdp7::Address address) {
    devices_.clear(now_);
    if (display_) display_->power_clear(now_);
    using Bus = Pdp7Bus<BasicPdp7, Observer>;
    reference::Cpu<Bus> cpu(Bus(*this, observer_), configuration_.model, configuration_.timing, state_);
    cpu.start(address);
    state_ = cpu.state();
  }

  // Runs from the state as it is (the CONTINUE key) until something stops it; what is due at the boundary
  // where it stops is left to the next run, but the display has drawn everything up to that instant.
  // Registers, time and the processor's side of the bus are locals of this function: that, and nothing else,
  // is what makes it fast; inlined, it would share the host's registers with its caller.
  StopReason run(const Limits& limits) { return run(limits, observer_); }

  // The same, watched by another than the machine's own observer.
  template <class Watcher>
  [[gnu::noinline]] StopReason run(const Limits& limits, Watcher& watcher) {
    using Bus = Pdp7Bus<BasicPdp7, Watcher>;
    reference::Cpu<Bus> cpu(Bus(*this, watcher), configuration_.model, configuration_.timing, state_);
    [[maybe_unused]] const Arrivals<Watcher> arrives(watcher);
    forget_deadlines();
    std::uint64_t left = limits.instructions;
    StopReason reason = StopReason::instruction_limit;
    for (;;) {
      if constexpr (Watcher::stops) {
        if (arrives(cpu.pc())) [[unlikely]] {
          if (left != 0 && watcher.stop(cpu.bus().now(), cpu.pc())) {
            reason = StopReason::observer;
            break;
          }
        }
      }
      if (cpu.bus().due()) [[unlikely]] {
        if (left == 0) break;
        if constexpr (Filtered<Watcher>) {
          if (watcher.stop(cpu.bus().now(), cpu.pc())) {
            reason = StopReason::observer;
            break;
          }
        }
        if (cpu.bus().now() >= limits.until) {
          reason = StopReason::time_limit;
          break;
        }
        if (attend(cpu, limits.until, left)) continue;
      }
      --left;
      const pdp7::Outcome outcome = step(cpu, watcher);
      if (outcome != pdp7::Outcome::completed) [[unlikely]] {
        reason = reason_of(outcome);
        break;
      }
    }
    counts_.instructions += limits.instructions - left;
    state_ = cpu.state();
    now_ = cpu.bus().now();
    if (display_) display_->advance(now_);
    return reason;
  }

 private:
  template <class, class>
  friend class Pdp7Bus;

  static Configuration completed(Configuration configuration) {
    if (configuration.core_words > 8192) configuration.model.extend = true;
    return configuration;
  }

  static constexpr StopReason reason_of(pdp7::Outcome outcome) {
    switch (outcome) {
      case pdp7::Outcome::halted: return StopReason::halt;
      case pdp7::Outcome::xct_chain: return StopReason::xct_chain;
      default: return StopReason::unanswered;
    }
  }

  template <class Cpu, class Watcher>
  SIGHTLINE_INLINE pdp7::Outcome step(Cpu& cpu, Watcher& watcher) {
    if constexpr (Watcher::instructions) {
      const core::Instant begun = cpu.bus().now();
      const pdp7::State before = cpu.state();
      const core::Word18 word = core_.read(before.pc);
      const pdp7::Outcome outcome = cpu.step();
      watcher.instruction(InstructionRecord{begun, cpu.bus().now(), before.pc, word, before, cpu.state()});
      return outcome;
    } else {
      return cpu.step();
    }
  }

  // A boundary at which something may be due. True when the program interrupt was taken: its cycle ends at a
  // boundary of its own.
  template <class Cpu>
  SIGHTLINE_INLINE bool attend(Cpu& cpu, core::Instant until, std::uint64_t left) {
    auto& bus = cpu.bus();
    const bool deferred = cpu.interrupts_deferred();
    const Attention found = look_around(bus.now(), cpu.interrupts_open(), until, left, bus.reporter());
    cpu.end_interrupt_delay();
    bus.set_now(found.now);
    bus.set_deadline(deferred ? core::Instant::min() : found.deadline);
    if (found.interrupt) cpu.interrupt();
    return found.interrupt;
  }

  struct Attention {
    core::Instant now;
    core::Instant deadline;
    bool interrupt;
  };

  // Gives the devices the cycles they ask for. In and out by value: see run().
  template <class Report>
  [[gnu::noinline]] Attention look_around(core::Instant now, bool interrupts_open, core::Instant until,
                                          std::uint64_t left, Report report) {
    bool asked = false;
    const auto tell = [&report, &asked](const pdp7::Cycle& cycle) { asked = report(cycle) || asked; };
    while (disk_break(now, tell) || display_break(now, tell) || clock_tick(now, tell)) {
    }
    if (now >= devices_due_) {
      devices_.advance(now);
      devices_due_ = devices_.deadline();
    }
    const bool interrupt =
        interrupts_open && (devices_.interrupt_request() || (display_ && display_->interrupt_request()));
    const core::Instant event = asked ? now : std::min(display_due_, devices_due_);
    return {now, std::min(event, std::min(until, shortest_end(now, left))), interrupt};
  }

  // No run of `left` instructions ends before this: each takes a cycle at least. So the instructions need to
  // be counted, but the limit to be looked at only with the other deadlines.
  static constexpr core::Instant shortest_end(core::Instant now, std::uint64_t left) {
    constexpr std::uint64_t many = std::uint64_t{1} << 32;
    return now + pdp7::machine_cycle * static_cast<std::int64_t>(std::min(left, many));
  }

  // One data break of the disk, which waits least: it comes before the display's.
  template <class Report>
  bool disk_break(core::Instant& now, Report report) {
    if (now < devices_due_ || !devices_.disk) return false;
    const auto request = devices_.disk->request(now);
    if (!request) return false;
    const core::Word18 word = request->to_core ? request->word : core_.read(request->address);
    const pdp7::Verb verb = request->to_core ? pdp7::Verb::break_write : pdp7::Verb::break_read;
    report(pdp7::Cycle{now, pdp7::machine_cycle, verb, request->address, word});
    now += pdp7::machine_cycle;
    ++counts_.stolen_cycles;
    if (request->to_core) core_.write(request->address, word);
    devices_.disk->served(word);
    return true;
  }

  // One data break of the display, if one is asked for.
  template <class Report>
  bool display_break(core::Instant& now, Report report) {
    if (now < display_due_) return false;
    bool granted = false;
    if (display_) {
      display_->advance(now);
      if (const auto* request = display_->break_request()) {
        grant(*request, now, report);
        granted = true;
      }
    }
    display_due_ = display_ ? next_display_event(now) : core::never;
    return granted;
  }

  // A word deposited for the display (Type 347) raises the next request at once: that is no deadline any
  // more.
  [[nodiscard]] core::Instant next_display_event(core::Instant now) const {
    return display_->break_request() != nullptr ? now : display_->deadline();
  }

  // The request is copied: it is the display's own and goes as soon as it is met.
  template <class Request, class Report>
  void grant(const Request request, core::Instant& now, Report report) {
    const core::Word18 word = request.write ? request.word : core_.read(request.address);
    const pdp7::Verb verb = request.write ? pdp7::Verb::break_write : pdp7::Verb::break_read;
    report(pdp7::Cycle{now, pdp7::machine_cycle, verb, request.address, word});
    now += pdp7::machine_cycle;
    ++counts_.stolen_cycles;
    if (request.write) {
      core_.write(request.address, word);
      display_->deposited(now);
    } else {
      display_->deliver(now, word);
    }
  }

  template <class Report>
  bool clock_tick(core::Instant& now, Report report) {
    constexpr pdp7::Address counter = 7;
    if (now < devices_due_ || !devices_.clock.take_tick(now)) return false;
    const core::Word18 count = core_.read(counter) + core::Word18(1);
    core_.write(counter, count);
    const core::Duration length = pdp7::machine_cycle * configuration_.timing.clock_tick_cycles;
    report(pdp7::Cycle{now, length, pdp7::Verb::break_modify, counter, count});
    now += length;
    counts_.stolen_cycles += static_cast<std::uint64_t>(configuration_.timing.clock_tick_cycles);
    if (count.value() == 0) devices_.clock.raise_flag();
    return true;
  }

  // The program or the host has touched a device: what it will do next is to be asked again.
  void forget_deadlines() { display_due_ = devices_due_ = core::Instant::min(); }

  struct IotEffect {
    pdp7::IotReply reply;
    core::Duration stretch;
    bool look;  // something may have become due
  };

  // The pulses of an IOT whose Fetch cycle ends at `now`.
  [[gnu::noinline]] IotEffect input_output(core::Instant now, std::uint32_t word, core::Word18 ac) {
    std::uint32_t elsewhere = 0;
    if (display_ && pdp7::reads_status(word) && display_->light_pen_flag(now))
      elsewhere = status::light_pen;
    pdp7::IotReply reply = devices_.iot(now, word, ac, elsewhere);
    if (display_ && is_display_iot(word)) display_iot(*display_, now, word, reply);
    if (display_ && (word & 07702U) == 03302U) display_->clear_flags(now);
    // A skip test changes nothing: what it found had a deadline, which is still the one the processor waits
    // for.
    const bool look = (word & 06U) != 0;
    if (look) forget_deadlines();
    return {reply, configuration_.timing.iot_stretch[(word >> 6) & 077U], look};
  }

  [[gnu::noinline]] core::Word18 switches(core::Instant now) { return console_.switches(now); }

  [[gnu::noinline]] void count_unanswered(std::uint32_t word, pdp7::Address at) {
    for (Unanswered& entry : unanswered_) {
      if (entry.word == word) {
        ++entry.count;
        return;
      }
    }
    unanswered_.push_back({word, 1, at});
  }

  Configuration configuration_;
  pdp7::State state_;
  core::Instant now_{};
  core::Duration asynchronous_{};
  pdp7::CoreMemory core_;
  Peripherals devices_;
  pdp7::Console console_;
  std::optional<Display> display_;
  // Nothing happens by itself before these. Valid inside a run.
  core::Instant display_due_{};
  core::Instant devices_due_{};
  Counts counts_;
  std::vector<Unanswered> unanswered_;
  Observer& observer_;
};

}  // namespace sightline::reference
