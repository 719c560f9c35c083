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

#include "../core/inline.hpp"
#include "../core/reporter.hpp"
#include "../core/state_visitor.hpp"
#include "../core/threads.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"
#include "../pdp7/console.hpp"
#include "../pdp7/core_memory.hpp"
#include "../pdp7/cpu.hpp"
#include "../pdp7/peripherals.hpp"
#include "../pdp7/timing.hpp"
#include "display_iots.hpp"
#include "observer.hpp"
#include "pdp7_bus.hpp"

namespace sightline::machines {

// How the machine is put together.
struct Configuration {
  std::uint32_t core_words = 8192;  // 4096, 8192, 16384 or 32768
  pdp7::Model model{};              // extend is implied by more than 8192 words
  pdp7::Devices devices{};
  pdp7::Timing timing{};
};

enum class StopReason : std::uint8_t {
  halt,               // HLT
  instruction_limit,  // Limits::instructions done
  time_limit,         // the first boundary at or after Limits::until
  observer,           // the observer asked for it
  xct_chain,          // more than 16 XCTs in a chain
  unanswered,         // strict: an instruction nothing in this machine obeys
};

struct Limits {
  std::uint64_t instructions = ~std::uint64_t{0};
  core::Instant until = core::never;
};

struct Counts {
  std::uint64_t instructions = 0;
  std::uint64_t machine_cycles = 0;  // stolen ones included, asynchronous time not
  std::uint64_t stolen_cycles = 0;   // data breaks and clock ticks; the display counts its own words
};

// An instruction nothing obeyed: how often, and where first.
struct Unanswered {
  std::uint32_t word;
  std::uint64_t count;
  pdp7::Address first_pc;
};

template <class Display, class Observer = NoObserver>
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
  // The same, plugged in by the first IOT of such a display (uses_display): a program that uses it cannot tell it from one that was there all the
  // time, unless it begins with an IOT of a Graphic-2, such as 700547, and a program that does not use it has none.
  template <class... Arguments>
  void attach_display_when_used(Arguments&&... arguments) {
    spare_display_.emplace(std::forward<Arguments>(arguments)...);
  }
  // Of a machine with such a display, between runs: plugs it in as new, or takes it out.
  void plug_in_display(bool in) {
    if (in) plug_in_spare_display();
    else display_.reset();
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
  [[nodiscard]] pdp7::Peripherals& devices() { return devices_; }
  [[nodiscard]] const pdp7::Peripherals& devices() const { return devices_; }
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

  // All that a further run depends on, as it is between two runs (../core/state_visitor.hpp).
  void visit_state(core::StateVisitor& visit) {
    visit.section("processor", state_);
    visit.section("time", [this](auto& fields) {
      fields("now", now_);
      fields("asynchronous", asynchronous_);
      fields("instructions", counts_.instructions);
      fields("stolen_cycles", counts_.stolen_cycles);
      fields.require(asynchronous_ <= now_.time_since_epoch(), "asynchronous", "no more than the time");
    });
    visit.section("core", core_);
    visit.section("console", console_);
    devices_.visit_state(visit);
    visit.require(devices_.clock.deadline() > now_ - core::seconds(1), "clock", "no tick of an earlier second");
    if (display_) {
      visit.section("display", *display_);
      visit.require(display_->next_pulse() > now_, "display", "all pulses after the time");
    }
    visit.section("unanswered", [this](auto& fields) {
      fields.list("words", unanswered_, [&fields](Unanswered& entry) {
        fields("word", entry.word, core::Word18::mask);
        fields("count", entry.count);
        fields("first_pc", entry.first_pc, pdp7::address_mask);
      });
    });
  }

  // The START key: clears all flags, leaves core, AC, L, MQ and SC alone, and makes the next fetch at
  // `address`.
  void start(pdp7::Address address) {
    devices_.clear(now_);
    if (display_) display_->power_clear(now_);
    state_ = {.ac = state_.ac, .mq = state_.mq, .sc = state_.sc, .pc = address & pdp7::address_mask, .link = state_.link};
  }

  // Runs from the state as it is (the CONTINUE key) until something stops it; what is due at the boundary
  // where it stops is left to the next run, but the display has drawn everything up to that instant.
  StopReason run(const Limits& limits) { return run(limits, observer_); }

  // The same, watched by another than the machine's own observer.
  template <class Watcher>
  [[gnu::noinline]] StopReason run(const Limits& limits, Watcher& watcher) {
    Pdp7Frame<BasicPdp7, Watcher> frame(*this, watcher);
    forget_deadlines();
    std::uint64_t left = limits.instructions;
    const StopReason reason = run_frame(frame, watcher, limits, left);
    publish(frame, limits.instructions - left);
    if (display_) display_->advance(now_);
    return reason;
  }

 private:
  template <class, class>
  friend struct Pdp7Frame;
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

  template <class Frame, class Watcher>
  StopReason run_frame(Frame& frame, Watcher& watcher, const Limits& limits, std::uint64_t& left) {
    const auto pc = [&frame] { return frame.processor.registers.pc(); };
    const core::Instant until = limits.until;
    for (;;) {
      if constexpr (Watcher::stops) {
        if (frame.arrives(pc()) && left != 0) {
          if (core::reads_machine(watcher)) publish(frame, limits.instructions - left);
          if (watcher.stop(frame.now(), pc())) return StopReason::observer;
        }
      }
      if (frame.due()) {
        if (left == 0) return StopReason::instruction_limit;
        if constexpr (core::Filtered<Watcher>) {
          if (watcher.stop(frame.now(), pc())) return StopReason::observer;
        }
        if (frame.now() >= until) return StopReason::time_limit;
        const bool interrupted = attend(frame, until, left);
        if constexpr (core::Filtered<Watcher>) {
          if (frame.arrives.asks_again()) frame.look_around_at(frame.now(), frame.now(), 1);
        }
        if (interrupted) continue;
      }
      const std::int64_t before = frame.allowance.instructions();
      go_on(frame, watcher);
      left -= static_cast<std::uint64_t>(before - frame.allowance.instructions());
      if (frame.processor.outcome != pdp7::Outcome::completed) [[unlikely]]
        return reason_of(frame.processor.outcome);
    }
  }

  // What the machine shows, at a boundary so many instructions after the beginning of the run.
  template <class Frame>
  void publish(const Frame& frame, std::uint64_t instructions) {
    state_ = frame.processor.registers.state();
    now_ = frame.now();
    counts_.instructions = frame.begun + instructions;
  }

  // Instructions up to the next boundary at which something is due, one at least; one, if the observer follows each.
  template <class Watcher>
  void go_on(Pdp7Frame<BasicPdp7, Watcher>& frame, Watcher& watcher) {
    using Thread = Pdp7Thread<BasicPdp7, Watcher>;
    if constexpr (Watcher::instructions) {
      const core::Instant begun = frame.now();
      const pdp7::State before = frame.processor.registers.state();
      const core::Word18 word = core_.read(before.pc);
      Thread(frame).step();
      watcher.instruction(
          InstructionRecord{begun, frame.now(), before.pc, word, before, frame.processor.registers.state()});
    } else if constexpr (core::follows_instructions<Watcher>) {
      Thread(frame).step();
    } else {
      core::Runner<Thread, Watcher>::run(frame);
    }
  }

  // A boundary at which something may be due. True when the program interrupt was taken: its cycle ends at a
  // boundary of its own.
  template <class Watcher>
  SIGHTLINE_INLINE bool attend(Pdp7Frame<BasicPdp7, Watcher>& frame, core::Instant until, std::uint64_t left) {
    pdp7::Registers& registers = frame.processor.registers;
    const bool deferred = registers.is(pdp7::mode::interrupts_deferred);
    const bool open = registers.is(pdp7::mode::interrupts_on) && !deferred;
    const auto most = std::min(left, static_cast<std::uint64_t>(Pdp7Frame<BasicPdp7, Watcher>::Allowance::most));
    const auto instructions = static_cast<std::int64_t>(most);
    const Attention found = look_around(frame.now(), open, until, instructions, frame.report);
    registers.modes &= ~pdp7::mode::interrupts_deferred;
    frame.look_around_at(found.now, deferred ? found.now : found.deadline, instructions);
    if (found.interrupt) {
      typename Pdp7Thread<BasicPdp7, Watcher>::Execution execution(Pdp7Bus<BasicPdp7, Watcher>(frame), frame.processor);
      execution.interrupt();
      execution.save();
    }
    return found.interrupt;
  }

  struct Attention {
    core::Instant now;
    core::Instant deadline;
    bool interrupt;
  };

  // Gives the devices the cycles they ask for. Nearly always the display alone wants one.
  template <class Report>
  SIGHTLINE_INLINE Attention look_around(core::Instant now, bool interrupts_open, core::Instant until,
                                               std::int64_t instructions, const Report& report) {
    if (now < devices_due_) display_break(now, report);
    if (now >= earlier(display_due_, devices_due_)) now = serve_all(now, report);
    const bool interrupt = interrupts_open && (devices_request_ || (display_ && display_->interrupt_request()));
    const core::Instant event = earlier(display_due_, devices_due_);
    // No run of so many instructions ends before `shortest`, because each takes a cycle at least. So they need to be counted,
    // but their number to be compared only with the other deadlines.
    const core::Instant shortest = now + pdp7::machine_cycle * instructions;
    return {now, earlier(event, earlier(until, shortest)), interrupt};
  }

  static constexpr core::Instant earlier(core::Instant a, core::Instant b) { return a < b ? a : b; }

  template <class Report>
  [[gnu::noinline]] core::Instant serve_all(core::Instant now, const Report& report) {
    while (disk_break(now, report) || display_break(now, report) || clock_tick(now, report)) {
    }
    if (now >= devices_due_) {
      devices_.advance(now);
      devices_due_ = devices_.deadline();
      devices_request_ = devices_.interrupt_request();
    }
    return now;
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
  SIGHTLINE_INLINE bool display_break(core::Instant& now, Report report) {
    if (now < display_due_) return false;
    if (!display_) {
      display_due_ = core::never;
      return false;
    }
    display_->advance(now);
    const auto* const request = display_->break_request();
    if (request == nullptr) {
      display_due_ = display_->deadline();
      return false;
    }
    grant(*request, now, report);
    return true;
  }

  // The request is copied: it is the display's own and goes as soon as it is met.
  template <class Request, class Report>
  SIGHTLINE_INLINE void grant(const Request request, core::Instant& now, Report report) {
    const core::Word18 word = request.write ? request.word : core_.read(request.address);
    const pdp7::Verb verb = request.write ? pdp7::Verb::break_write : pdp7::Verb::break_read;
    report(pdp7::Cycle{now, pdp7::machine_cycle, verb, request.address, word});
    now += pdp7::machine_cycle;
    ++counts_.stolen_cycles;
    if (request.write) [[unlikely]] {
      core_.write(request.address, word);
      display_->deposited(now);
      // It raises the next request at once, which is no deadline any more (Type 347).
      display_due_ = display_->break_request() != nullptr ? now : display_->deadline();
    } else {
      display_->deliver(now, word);
      display_due_ = display_->deadline();
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
      elsewhere = pdp7::status::light_pen;
    pdp7::IotReply reply = devices_.iot(now, word, ac, elsewhere);
    if (is_display_iot(word)) {
      if (!display_ && uses_display(word)) plug_in_spare_display();
      if (display_) display_iot(*display_, now, word, reply);
    }
    if (display_ && pdp7::clears_all_flags(word)) display_->clear_flags(now);
    // A skip test changes nothing: what it found had a deadline, which is still the one the processor waits
    // for.
    const bool look = (word & 06U) != 0;
    if (look) forget_deadlines();
    return {reply, configuration_.timing.iot_stretch[(word >> 6) & 077U], look};
  }

  void plug_in_spare_display() {
    if (spare_display_) display_.emplace(*spare_display_);
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
  pdp7::Peripherals devices_;
  pdp7::Console console_;
  std::optional<Display> display_;
  // Nothing happens by itself before these. Valid inside a run.
  core::Instant display_due_{};
  core::Instant devices_due_{};
  bool devices_request_ = false;  // an interrupt, up to devices_due_
  Counts counts_;
  std::vector<Unanswered> unanswered_;
  std::optional<Display> spare_display_;  // as new
  Observer& observer_;
};

}  // namespace sightline::machines
