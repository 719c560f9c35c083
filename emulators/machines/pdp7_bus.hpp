// The processor's side of the PDP-7's bus while a program runs: core memory, time, and the way to the
// devices.
//
// What changes with every cycle, the allowance of time, is a value in the hands of the processor; the rest is in the frame of
// the run. The machine is touched only on the slow paths, by value, so that a compiler can keep the allowance in a
// register; every verb is inlined into the instruction for the same reason.
//
// A run with an observer of marks (core/reporter.hpp) has two buses. An instruction that comes to no marked word is executed on one that tells
// nothing and leaves marks alone; every other, and what is rare, on one that tells all.
#pragma once

#include <array>
#include <cstdint>
#include <span>

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

// What an observer that looks at registers sees: L and AC as pdp7::Accumulator has them, the time, and what is in the frame.
struct Pdp7View {
  std::uint32_t accumulator;
  const pdp7::Registers* others;
  core::Instant now;
  std::span<const core::Word18> core;
};

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
        processor(of.configuration_.model, of.configuration_.timing, of.state_) {
    look_around_at(of.now_, of.now_, 1);
    if constexpr (core::Marks<Observer>) {
      for (const auto& [place, marks] : observer.marked_places()) of.core_.mark(place, marks);
      of.core_.mark_outside(end_of_banks());
    }
  }
  // After the run, with the same observer.
  void take_marks_off(const Observer& observer) {
    if constexpr (core::Marks<Observer>)
      for (const auto& [place, marks] : observer.marked_places()) machine->core_.unmark(place);
    if constexpr (core::Marks<Observer>) machine->core_.unmark_outside(end_of_banks());
  }
  // Behind all that the processor can reach.
  [[nodiscard]] pdp7::Address end_of_banks() const {
    return (processor.model->extend ? pdp7::address_mask : pdp7::in_bank_mask) + 1;
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
  core::Instant horizon;  // the last instant that is not due
  Allowance allowance{core::Duration(0), 0};
};

template <class Machine, class Observer, bool tells = Observer::cycles>
class Pdp7Bus {
 public:
  static constexpr bool has_marks = core::Marks<Observer>;
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
  void restore() {
    bank_ = frame_->bank;
    allowance_ = frame_->allowance;
  }
  void enter(pdp7::Address bank) { bank_ = frame_->enter(bank); }

  // The word of the next instruction, before its cycle; with its marks.
  [[nodiscard]] SIGHTLINE_INLINE core::Word18 peek(pdp7::Here here) const { return bank_[here.place]; }
  // The cycle that takes it.
  SIGHTLINE_INLINE void fetch_peeked(pdp7::Here here, core::Word18 word) { pass(pdp7::Verb::fetch, here, word); }

  // Of a run with marks.
  [[nodiscard]] SIGHTLINE_INLINE bool marked(pdp7::Here here) const {
    if (cell(here)->value() > core::Word18::mask) return true;
    // Outside core every word that a processor without extension can reach has a mark, and behind these there is nothing but
    // CAL, which is not executed here: put() need not look whether this one can be written.
    if (here.place >= frame_->bank_words) __builtin_unreachable();
    return false;
  }
  [[nodiscard]] SIGHTLINE_INLINE bool marked_for_reading(pdp7::Here here) const {
    return (cell(here)->value() & pdp7::core_mark::read) != 0;
  }

  template <class At>
  SIGHTLINE_INLINE core::Word18 fetch(At at) {
    const core::Word18 word = word_at(at);
    pass(pdp7::Verb::fetch, at, word);
    return word;
  }
  template <class At>
  SIGHTLINE_INLINE core::Word18 read(At at) {
    const core::Word18 word = word_at(at);
    pass(pdp7::Verb::read, at, word);
    return word;
  }
  // The same, for those who do not look at the bits above L.
  template <class At>
    requires(has_marks && !tells)
  SIGHTLINE_INLINE core::Word18 read_with_marks(At at) {
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
    put_into(frame_->core[0], word);
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
    if (here.place < frame_->bank_words) [[likely]] put_into(*cell(here), word);
  }
  SIGHTLINE_INLINE void put(pdp7::Address address, core::Word18 word) {
    if (address < frame_->words) put_into(*cell(address), word);
  }
  // Who tells nothing has looked whether the word has a mark.
  SIGHTLINE_INLINE static void put_into(core::Word18& cell, core::Word18 word) {
    if constexpr (has_marks && tells) pdp7::CoreMemory::put_under_marks(cell, word);
    else cell = word;
  }
  template <class At>
  [[nodiscard]] SIGHTLINE_INLINE core::Word18 word_at(At at) const {
    if constexpr (has_marks) return cell(at)->without_marks();
    else return *cell(at);
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
    if constexpr (tells) {
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
  static constexpr bool has_marks = core::Marks<Observer>;
  using Frame = Pdp7Frame<Machine, Observer>;
  using Telling = pdp7::Execution<Pdp7Bus<Machine, Observer>>;
  using Bus = Pdp7Bus<Machine, Observer, Observer::cycles && !has_marks>;
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
    if constexpr (has_marks) {
      const Bus& bus = execution_.bus();
      Telling telling(Pdp7Bus<Machine, Observer>(*frame_, bus.bank(), bus.allowance()), frame_->processor, execution_.accumulator(),
                      execution_.next().place);
      const pdp7::Outcome outcome = telling.step(word_ & core::Word18::mask);
      execution_ = Execution(Bus(*frame_, telling.bus().bank(), telling.bus().allowance()), frame_->processor, telling.accumulator(),
                             telling.next().place);
      take(outcome);
    } else {
      take(execution_.step(word_));
    }
  }
  static constexpr bool looks = false;  // who looks has marks
  template <unsigned code>
  [[nodiscard]] SIGHTLINE_INLINE bool leaves() const {
    return leaves();
  }
  [[nodiscard]] SIGHTLINE_INLINE bool leaves() const {
    if constexpr (has_marks) {
      if (frame_->arrives.look().asks(pdp7::Address{execution_.next()}, view())) return true;
    } else if constexpr (Observer::stops) {
      if (frame_->arrives(pdp7::Address{execution_.next()})) [[unlikely]] return true;
    }
    return execution_.bus().due();
  }
  SIGHTLINE_INLINE void leave() { execution_.save(); }

  // For marked_threads.hpp. Tests are bits of pdp7::change, of what an instruction may have changed, and two more.
  static constexpr unsigned first_mark = pdp7::core_mark::first_bit - 13, mark_bits = pdp7::core_mark::bits;
  static constexpr unsigned of_reads = 0x100, of_writes = 0x200;
  static constexpr std::array<unsigned, 6> kinds{
      pdp7::change::eae,
      pdp7::change::eae | pdp7::change::accumulator,
      of_writes,
      of_writes | of_reads,
      of_writes | of_reads | pdp7::change::eae | pdp7::change::accumulator,
      of_writes | of_reads | pdp7::change::eae | pdp7::change::accumulator | pdp7::change::memory};
  [[nodiscard]] static unsigned tests_of(const Frame& frame) {
    const auto& look = frame.arrives.look();
    return (look.changes() & ~unsigned{pdp7::change::modes}) | ((look.marks() & pdp7::core_mark::read) != 0 ? of_reads : 0U) |
           (look.marks() != 0 ? of_writes : 0U);
  }
  // Only rare instructions change the modes.
  template <unsigned code>
  static constexpr unsigned useful_tests = (Execution::template is_always_rare<code> ? 0U : Execution::template changes<code>) |
                                           (Execution::template may_read<code> ? of_reads : 0U) |
                                           (Execution::template may_write<code> ? of_writes : 0U);
  template <unsigned code, unsigned tests>
  [[nodiscard]] SIGHTLINE_INLINE bool is_rare() const {
    return is_rare<code>() || execution_.template meets_mark<code, (tests & of_reads) != 0, (tests & of_writes) != 0>(word_);
  }
  template <unsigned code, unsigned tests>
  [[nodiscard]] SIGHTLINE_INLINE bool leaves() const {
    if (execution_.bus().due()) [[unlikely]] return true;
    return frame_->arrives.look().template may_ask<tests & useful_tests<code>>(view());
  }
  [[nodiscard]] bool leaves_after_any() const { return execution_.bus().due() || frame_->arrives.look().may_ask(view()); }

  // One instruction, whatever its code.
  void step() {
    execution_.bus().count_instruction();
    take(execution_.step());
    leave();
  }

 private:
  SIGHTLINE_INLINE Pdp7Thread(Frame& frame, const Execution& execution, std::uint32_t word)
      : frame_(&frame), execution_(execution), word_(word) {}

  [[nodiscard]] SIGHTLINE_INLINE Pdp7View view() const {
    return {execution_.accumulator().bits(), &frame_->processor.registers, execution_.bus().now(), {frame_->core, frame_->words}};
  }
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
