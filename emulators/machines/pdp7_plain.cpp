// The plain loop: executes a PDP-7 instruction by instruction and calls the observer. Observed runs use it, and all runs
// where the fast engine cannot be compiled (WebAssembly, sanitizers).
#include "pdp7.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "../core/inline.hpp"
#include "../pdp7/cpu.hpp"
#include "pdp7_observer_calls.hpp"

namespace sightline::pdp7 {

struct Machine::PlainRun {
  class Bus;

  StopReason run(const Limits& limits);

  Machine& machine;
  ObserverCalls calls;
  Processor processor{machine.options_.model, machine.options_.timing, machine.state_};
};

// The verbs of ../pdp7/bus.hpp: each reports its cycle and advances the time.
class Machine::PlainRun::Bus {
 public:
  explicit Bus(PlainRun& run)
      : run_(&run), core_(run.machine.core_.data()), words_(run.machine.core_.size()), now_(run.machine.now_), due_(now_) {}

  [[nodiscard]] core::Instant now() const { return now_; }
  [[nodiscard]] bool due() const { return now_ >= due_; }
  void serve_boundary(core::Instant now, core::Instant due) {
    now_ = now;
    due_ = due;
  }

  SIGHTLINE_INLINE core::Word18 fetch(Address address) {
    return access(mark::fetched, Verb::fetch, address, core_[address]);
  }
  SIGHTLINE_INLINE core::Word18 read(Address address) { return access(mark::read, Verb::read, address, core_[address]); }
  SIGHTLINE_INLINE void write(Address address, core::Word18 word) {
    put(address, word);
    access(mark::written, Verb::write, address, word);
  }
  SIGHTLINE_INLINE core::Word18 modify(Address address) {
    const core::Word18 word = core_[address] + core::Word18(1);
    put(address, word);
    return access(mark::read | mark::written, Verb::modify, address, word);
  }
  void interrupt(core::Word18 word) {
    put(0, word);
    run_->calls.event({now_, machine_cycle, Verb::interrupt, 0, word});
    now_ += machine_cycle;
  }
  core::IotReply iot(std::uint32_t word, core::Word18 ac) {
    const IotEffect effect = run_->machine.input_output(now_, word, ac);
    run_->calls.event({now_, effect.stretch, Verb::iot, word & 07777U, effect.reply.ac});
    pass_asynchronous(effect.stretch);
    if (effect.attention) attention();
    return effect.reply;
  }
  void idle(core::Duration duration) {
    run_->calls.idle({now_, duration, Verb::idle, 0, core::Word18(0)});
    pass_asynchronous(duration);
  }
  core::Word18 switches() { return run_->machine.console_.switches(now_); }
  void unanswered(std::uint32_t word, Address at) { run_->machine.count_unanswered(word, at); }
  void attention() { due_ = now_; }

 private:
  // Writes outside core are ignored.
  SIGHTLINE_INLINE void put(Address address, core::Word18 word) {
    if (address < words_) core_[address] = word;
  }
  SIGHTLINE_INLINE core::Word18 access(std::uint8_t mark, Verb verb, Address address, core::Word18 word) {
    run_->calls.access(mark, {now_, machine_cycle, verb, address, word});
    now_ += machine_cycle;
    return word;
  }
  void pass_asynchronous(core::Duration duration) {
    now_ += duration;
    run_->machine.asynchronous_ += duration;
  }

  PlainRun* run_;
  core::Word18* core_;
  std::uint32_t words_;  // number of words that can be written
  core::Instant now_;
  core::Instant due_;  // before it only instructions happen
};

StopReason Machine::PlainRun::run(const Limits& limits) {
  Execution<Bus> execution(Bus(*this), processor);
  Bus& bus = execution.bus();
  bool is_shown = false;
  const auto show = [&] {
    execution.save();
    machine.state_ = processor.registers.state();
    machine.now_ = bus.now();
    is_shown = true;
  };
  const auto ends = [&](StopReason reason) {
    show();
    return reason;
  };
  const bool records = calls.observer() != nullptr && calls.observer()->instructions;

  for (std::uint64_t left = limits.instructions;; --left) {
    // The boundary.
    for (bool interrupted = true; interrupted;) {
      const Address next = execution.next();
      if (left != 0 && calls.wants_stop(next)) {
        if (!is_shown) show();
        if (calls.stop(bus.now(), next)) return StopReason::observer;
      }
      if (left == 0) return ends(StopReason::instruction_limit);
      interrupted = false;
      if (bus.due()) {
        if (std::exchange(machine.stop_requested_, false)) return ends(StopReason::observer);
        if (bus.now() >= limits.until) return ends(StopReason::time_limit);
        const Boundary boundary = machine.serve_boundary(bus.now(), processor.registers, &calls);
        bus.serve_boundary(boundary.now, std::min(boundary.due, limits.until));
        interrupted = boundary.interrupt;
        if (interrupted) execution.interrupt();
        is_shown = false;
      }
    }
    // The instruction.
    Outcome outcome{};
    if (!records) {
      outcome = execution.step();
      ++machine.counts_.instructions;
      is_shown = false;
    } else {
      if (!is_shown) show();
      const State before = machine.state_;
      const core::Instant begun = bus.now();
      const core::Word18 word = machine.core_.read(before.pc);
      outcome = execution.step();
      ++machine.counts_.instructions;
      show();
      calls.observer()->instruction({begun, bus.now(), before.pc, word, before, machine.state_});
    }
    if (outcome != Outcome::completed) return ends(reason_of(outcome));
  }
}

StopReason Machine::run(const Limits& limits, Observer& observer) {
  begin_run();
  const StopReason reason = PlainRun{*this, ObserverCalls(&observer)}.run(limits);
  end_run();
  return reason;
}

StopReason Machine::run_plainly(const Limits& limits) {
  begin_run();
  const StopReason reason = PlainRun{*this, ObserverCalls(nullptr)}.run(limits);
  end_run();
  return reason;
}

}  // namespace sightline::pdp7
