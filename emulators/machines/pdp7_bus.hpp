// The processor's side of the PDP-7's bus while a program runs: core memory, time, and the way to the
// devices.
//
// What changes with every cycle, the allowance of time, is a value in the hands of the processor; the rest is in the frame of
// the run. The machine is touched only on the slow paths, by value, so that a compiler can keep the allowance in a
// register; every verb is inlined into the instruction for the same reason.
#pragma once

#include <cstdint>

#include "../core/allowance.hpp"
#include "../core/inline.hpp"
#include "../core/reporter.hpp"
#include "../core/threads.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"
#include "../pdp7/bus.hpp"
#include "../pdp7/core_memory.hpp"
#include "../pdp7/cpu.hpp"
#include "../pdp7/timing.hpp"

namespace sightline::machines {

// One run of a machine.
template <class Machine, class Observer>
struct Pdp7Frame {
  using Allowance = core::Allowance<core::Nanosecond>;

  Pdp7Frame(Machine& of, Observer& observer)
      : machine(&of),
        report(observer),
        arrives(observer),
        core(of.core_.data()),
        words(of.core_.size()),
        bank(enter(of.state_.pc & pdp7::bank_mask)),
        processor(of.configuration_.model, of.configuration_.timing, of.state_),
        begun(of.counts_.instructions) {
    look_around_at(of.now_, of.now_, 1);
  }

  [[nodiscard]] core::Instant now() const { return horizon - allowance.left(); }
  [[nodiscard]] bool due() const { return allowance.over(); }
  // Where the words of a bank lie.
  core::Word18* enter(pdp7::Address first) {
    bank_words = words > first ? words - first : 0;
    return core + first;
  }
  // At the first boundary at or after `deadline`; `instructions` as Allowance wants them.
  void look_around_at(core::Instant now, core::Instant deadline, std::int64_t instructions) {
    horizon = deadline - core::Duration(1);
    allowance = Allowance(horizon - now, instructions);
  }

  Machine* machine;
  [[no_unique_address]] core::Reporter<Observer> report;
  [[no_unique_address]] core::Arrivals<Observer> arrives;
  core::Word18* core;
  std::uint32_t words;           // that can be written
  std::uint32_t bank_words = 0;  // likewise, from the beginning of the bank on
  core::Word18* bank;            // where direct addresses lie
  pdp7::Processor processor;
  std::uint64_t begun;    // instructions before the run
  core::Instant horizon;  // the last instant that is not due
  Allowance allowance{core::Duration(0), 0};
};

template <class Machine, class Observer>
class Pdp7Bus {
 public:
  using Frame = Pdp7Frame<Machine, Observer>;
  using Allowance = typename Frame::Allowance;

  SIGHTLINE_INLINE explicit Pdp7Bus(Frame& frame) : Pdp7Bus(frame, frame.bank, frame.allowance) {}
  SIGHTLINE_INLINE Pdp7Bus(Frame& frame, core::Word18* bank, Allowance allowance)
      : frame_(&frame), bank_(bank), allowance_(allowance) {}

  [[nodiscard]] core::Word18* bank() const { return bank_; }
  [[nodiscard]] Allowance allowance() const { return allowance_; }
  void count_instruction() { allowance_.count_instruction(); }
  void save() {
    frame_->bank = bank_;
    frame_->allowance = allowance_;
  }
  void enter(pdp7::Address bank) { bank_ = frame_->enter(bank); }

  // The word of the next instruction, before its cycle.
  [[nodiscard]] SIGHTLINE_INLINE core::Word18 peek(pdp7::Here here) const { return bank_[here.place]; }
  // The cycle that takes it.
  SIGHTLINE_INLINE void fetch_peeked(pdp7::Here here, core::Word18 word) { pass(pdp7::Verb::fetch, here, word); }

  template <class At>
  SIGHTLINE_INLINE core::Word18 fetch(At at) {
    const core::Word18 word = *cell(at);
    pass(pdp7::Verb::fetch, at, word);
    return word;
  }
  template <class At>
  SIGHTLINE_INLINE core::Word18 read(At at) {
    const core::Word18 word = *cell(at);
    pass(pdp7::Verb::read, at, word);
    return word;
  }
  template <class At>
  SIGHTLINE_INLINE void write(At at, core::Word18 word) {
    put(at, word);
    pass(pdp7::Verb::write, at, word);
  }
  template <class At>
  SIGHTLINE_INLINE core::Word18 modify(At at) {
    const core::Word18 word = *cell(at) + core::Word18(1);
    put(at, word);
    pass(pdp7::Verb::modify, at, word);
    return word;
  }
  void interrupt(core::Word18 word) {
    frame_->core[0] = word;
    pass(pdp7::Verb::interrupt, pdp7::Address{0}, word);
  }
  pdp7::IotReply iot(std::uint32_t word, core::Word18 ac) {
    const auto effect = frame_->machine->input_output(now(), word, ac);
    report(effect.stretch, pdp7::Verb::iot, word & 07777U, effect.reply.ac);
    take_asynchronous(effect.stretch);
    if (effect.look) attention();
    return effect.reply;
  }
  SIGHTLINE_INLINE void idle(core::Duration duration) {
    report(duration, pdp7::Verb::idle, pdp7::Address{0}, core::Word18(0));
    take_asynchronous(duration);
  }
  core::Word18 switches() { return frame_->machine->switches(now()); }
  void unanswered(std::uint32_t word, pdp7::Address at) { frame_->machine->count_unanswered(word, at); }
  SIGHTLINE_INLINE void attention() {
    frame_->horizon = now() - core::Duration(1);
    allowance_.end();
  }

  [[nodiscard]] SIGHTLINE_INLINE bool due() const { return allowance_.over(); }
  [[nodiscard]] SIGHTLINE_INLINE core::Instant now() const { return frame_->horizon - allowance_.left(); }

 private:
  [[nodiscard]] SIGHTLINE_INLINE core::Word18* cell(pdp7::Here here) const { return bank_ + here.place; }
  [[nodiscard]] SIGHTLINE_INLINE core::Word18* cell(pdp7::Address address) const {
    return frame_->core + address;
  }
  // Outside core nothing is written.
  SIGHTLINE_INLINE void put(pdp7::Here here, core::Word18 word) {
    if (here.place < frame_->bank_words) [[likely]] *cell(here) = word;
  }
  SIGHTLINE_INLINE void put(pdp7::Address address, core::Word18 word) {
    if (address < frame_->words) *cell(address) = word;
  }

  SIGHTLINE_INLINE void take_asynchronous(core::Duration duration) {
    allowance_.pass(duration);
    frame_->machine->asynchronous_ += duration;
  }
  SIGHTLINE_INLINE void pass(pdp7::Verb verb, pdp7::Address address, core::Word18 word) {
    report(pdp7::machine_cycle, verb, address, word);
    allowance_.pass(pdp7::machine_cycle);
  }
  SIGHTLINE_INLINE void report(core::Duration length, pdp7::Verb verb, pdp7::Address address, core::Word18 word) {
    if constexpr (Observer::cycles) {
      if (frame_->report(pdp7::Cycle{now(), length, verb, address, word})) attention();
    }
  }

  Frame* frame_;
  core::Word18* bank_;
  Allowance allowance_;
};

// The processor on it, as threads.hpp runs it.
template <class Machine, class Observer>
class Pdp7Thread {
 public:
  using Frame = Pdp7Frame<Machine, Observer>;
  using Bus = Pdp7Bus<Machine, Observer>;
  using Execution = pdp7::Execution<Bus>;
  static constexpr unsigned codes = Execution::codes;
  static constexpr bool has_spare_word = true;

  SIGHTLINE_INLINE explicit Pdp7Thread(Frame& frame) : frame_(&frame), execution_(Bus(frame), frame.processor) {}

  SIGHTLINE_INLINE static Pdp7Thread resume(Frame& frame, const core::HostWords& words) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): it was made by host_words()
    auto* const bank = reinterpret_cast<core::Word18*>(static_cast<std::uintptr_t>(words.a));
    const Bus bus(frame, bank, typename Bus::Allowance(words.b));
    const auto place = static_cast<pdp7::Address>(words.d);
    return Pdp7Thread(frame, Execution(bus, frame.processor, pdp7::Accumulator(words.c), place), bank[words.d].value());
  }
  [[nodiscard]] SIGHTLINE_INLINE core::HostWords host_words() const {
    return {reinterpret_cast<std::uintptr_t>(execution_.bus().bank()), execution_.bus().allowance().host_word(),
            execution_.accumulator().bits(), execution_.next().place};
  }

  [[nodiscard]] SIGHTLINE_INLINE unsigned code() {
    word_ = execution_.bus().peek(execution_.next()).value();
    return Execution::code_of(word_);
  }
  template <unsigned code>
  [[nodiscard]] SIGHTLINE_INLINE bool is_rare() const {
    return execution_.template is_rare<code>(word_);
  }
  template <unsigned code>
  SIGHTLINE_INLINE void execute() {
    execution_.bus().count_instruction();
    execution_.template step_as<code>(word_);
  }
  void execute_any() {
    execution_.bus().count_instruction();
    take(execution_.step(word_));
  }
  [[nodiscard]] SIGHTLINE_INLINE bool leaves() const {
    if constexpr (Observer::stops) {
      if (frame_->arrives(pdp7::Address{execution_.next()})) [[unlikely]] return true;
    }
    return execution_.bus().due();
  }
  SIGHTLINE_INLINE void leave() { execution_.save(); }

  // One instruction, whatever its code.
  void step() {
    execution_.bus().count_instruction();
    take(execution_.step());
    leave();
  }

 private:
  SIGHTLINE_INLINE Pdp7Thread(Frame& frame, const Execution& execution, std::uint32_t word)
      : frame_(&frame), execution_(execution), word_(word) {}

  void take(pdp7::Outcome outcome) {
    if (outcome == pdp7::Outcome::completed) return;
    frame_->processor.outcome = outcome;
    execution_.bus().attention();
  }

  Frame* frame_;
  Execution execution_;
  std::uint32_t word_ = 0;  // that has been taken
};

}  // namespace sightline::machines
