// The fast engine: one function per instruction code, each ending with a jump to the next (../core/threads.hpp).
//
// The time allowance changes with every cycle and is passed by value; the rest is in the frame of the run. Only the slow
// paths call the machine, and pass by value, so that a compiler can keep the allowance in a register; every verb is inlined
// into the instruction for the same reason. Observed runs use pdp7_plain.cpp.
#include "pdp7.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "../core/allowance.hpp"
#include "../core/inline.hpp"
#include "../core/threads.hpp"
#include "../pdp7/cpu.hpp"

namespace sightline::pdp7 {

#if SIGHTLINE_THREADS

struct Machine::FastRun {
  using Allowance = core::Allowance<core::Nanosecond>;
  class Bus;
  class Thread;

  explicit FastRun(Machine& of)
      : machine(&of),
        core(of.core_.data()),
        words(of.core_.size()),
        bank(enter(of.state_.pc & bank_mask)),
        processor(of.options_.model, of.options_.timing, of.state_) {
    serve_boundary_at(of.now_, of.now_, 1);
  }

  [[nodiscard]] core::Instant now() const { return horizon - allowance.left(); }
  // The address of a bank's words in the host.
  core::Word18* enter(Address first) {
    bank_words = words > first ? words - first : 0;
    return core + first;
  }
  // Serves the first boundary at or after `deadline`; at most `most` instructions end before it.
  void serve_boundary_at(core::Instant now, core::Instant deadline, std::int64_t most) {
    horizon = deadline - core::Duration(1);
    allowance = Allowance(horizon - now, most);
  }
  StopReason run(std::uint64_t& left, core::Instant until);

  Machine* machine;
  core::Word18* core;
  std::uint32_t words;           // number of words that can be written
  std::uint32_t bank_words = 0;  // the same, counted from the beginning of the bank
  core::Word18* bank;            // the bank of direct addresses
  Processor processor;
  core::Instant horizon;  // the last instant that is not due
  Allowance allowance{core::Duration(0), 0};
};

// The verbs of ../pdp7/bus.hpp.
class Machine::FastRun::Bus {
 public:
  SIGHTLINE_INLINE explicit Bus(FastRun& run) : Bus(run, run.bank, run.allowance) {}
  SIGHTLINE_INLINE Bus(FastRun& run, core::Word18* bank, Allowance allowance) : run_(&run), bank_(bank), allowance_(allowance) {}

  [[nodiscard]] core::Word18* bank() const { return bank_; }
  [[nodiscard]] Allowance allowance() const { return allowance_; }
  void count_instruction() { allowance_.count_instruction(); }
  void save() {
    run_->bank = bank_;
    run_->allowance = allowance_;
  }
  void enter(Address bank) { bank_ = run_->enter(bank); }

  // The word of the next instruction, before its cycle.
  [[nodiscard]] SIGHTLINE_INLINE core::Word18 peek(Here here) const { return bank_[here.place]; }
  // The cycle that fetches it.
  SIGHTLINE_INLINE void fetch_peeked(Here, core::Word18) { allowance_.pass(machine_cycle); }

  template <class At>
  SIGHTLINE_INLINE core::Word18 fetch(At at) {
    return read(at);
  }
  template <class At>
  SIGHTLINE_INLINE core::Word18 read(At at) {
    allowance_.pass(machine_cycle);
    return *cell(at);
  }
  template <class At>
  SIGHTLINE_INLINE void write(At at, core::Word18 word) {
    put(at, word);
    allowance_.pass(machine_cycle);
  }
  template <class At>
  SIGHTLINE_INLINE core::Word18 modify(At at) {
    const core::Word18 word = *cell(at) + core::Word18(1);
    write(at, word);
    return word;
  }
  void interrupt(core::Word18 word) { write(Address{0}, word); }
  core::IotReply iot(std::uint32_t word, core::Word18 ac) {
    const IotEffect effect = run_->machine->input_output(now(), word, ac);
    idle(effect.stretch);
    if (effect.attention) attention();
    return effect.reply;
  }
  SIGHTLINE_INLINE void idle(core::Duration duration) {
    allowance_.pass(duration);
    run_->machine->asynchronous_ += duration;
  }
  core::Word18 switches() { return run_->machine->console_.switches(now()); }
  void unanswered(std::uint32_t word, Address at) { run_->machine->count_unanswered(word, at); }
  SIGHTLINE_INLINE void attention() {
    run_->horizon = now() - core::Duration(1);
    allowance_.end();
  }

  [[nodiscard]] SIGHTLINE_INLINE bool due() const { return allowance_.over(); }

 private:
  [[nodiscard]] SIGHTLINE_INLINE core::Instant now() const { return run_->horizon - allowance_.left(); }
  [[nodiscard]] SIGHTLINE_INLINE core::Word18* cell(Here here) const { return bank_ + here.place; }
  [[nodiscard]] SIGHTLINE_INLINE core::Word18* cell(Address address) const { return run_->core + address; }
  // Writes outside core are ignored.
  SIGHTLINE_INLINE void put(Here here, core::Word18 word) {
    if (here.place < run_->bank_words) [[likely]] *cell(here) = word;
  }
  SIGHTLINE_INLINE void put(Address address, core::Word18 word) {
    if (address < run_->words) *cell(address) = word;
  }

  FastRun* run_;
  core::Word18* bank_;
  Allowance allowance_;
};

// The processor on that bus, in the form that threads.hpp runs.
class Machine::FastRun::Thread {
 public:
  using Frame = FastRun;
  using Execution = pdp7::Execution<Bus>;
  static constexpr unsigned codes = Execution::codes;
  static constexpr bool has_spare_word = true;

  SIGHTLINE_INLINE explicit Thread(FastRun& run) : run_(&run), execution_(Bus(run), run.processor) {}

  SIGHTLINE_INLINE static Thread resume(FastRun& run, const core::HostWords& words) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): it was made by host_words()
    auto* const bank = reinterpret_cast<core::Word18*>(static_cast<std::uintptr_t>(words.a));
    const Bus bus(run, bank, Allowance(words.b));
    const auto place = static_cast<Address>(words.d);
    return Thread(run, Execution(bus, run.processor, Accumulator(words.c), place), bank[words.d].value());
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
    const Outcome outcome = execution_.step(word_);
    if (outcome == Outcome::completed) return;
    run_->processor.outcome = outcome;
    execution_.bus().attention();
  }
  void interrupt() {
    execution_.interrupt();
    leave();
  }
  [[nodiscard]] SIGHTLINE_INLINE bool leaves() const { return execution_.bus().due(); }
  SIGHTLINE_INLINE void leave() { execution_.save(); }

 private:
  SIGHTLINE_INLINE Thread(FastRun& run, const Execution& execution, std::uint32_t word)
      : run_(&run), execution_(execution), word_(word) {}

  FastRun* run_;
  Execution execution_;
  std::uint32_t word_ = 0;  // the word that was fetched
};

// `left`: the number of instructions to execute; on return, of those not executed.
StopReason Machine::FastRun::run(std::uint64_t& left, core::Instant until) {
  for (;;) {
    if (allowance.over()) {
      if (left == 0) return StopReason::instruction_limit;
      if (std::exchange(machine->stop_requested_, false)) return StopReason::observer;
      if (now() >= until) return StopReason::time_limit;
      const Boundary boundary = machine->serve_boundary(now(), processor.registers, nullptr);
      // `most` instructions cannot end before `shortest`, because each takes at least a cycle. So they are counted, but
      // their number is compared only at the other deadlines.
      const auto most = static_cast<std::int64_t>(std::min(left, static_cast<std::uint64_t>(Allowance::most)));
      const core::Instant shortest = boundary.now + machine_cycle * most;
      serve_boundary_at(boundary.now, std::min(boundary.due, std::min(until, shortest)), most);
      if (boundary.interrupt) {
        Thread(*this).interrupt();
        continue;
      }
    }
    const std::int64_t before = allowance.instructions();
    core::Threads<Thread>::run(*this);
    left -= static_cast<std::uint64_t>(before - allowance.instructions());
    if (processor.outcome != Outcome::completed) [[unlikely]] return reason_of(processor.outcome);
  }
}

StopReason Machine::run(const Limits& limits) {
  begin_run();
  FastRun run(*this);
  std::uint64_t left = limits.instructions;
  const StopReason reason = run.run(left, limits.until);
  counts_.instructions += limits.instructions - left;
  state_ = run.processor.registers.state();
  now_ = run.now();
  end_run();
  return reason;
}

#else

StopReason Machine::run(const Limits& limits) {
  return run_plainly(limits);
}

#endif

}  // namespace sightline::pdp7
