// See pdp7.hpp.
#include "host/guests/run/pdp7.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "tools/disasm/disasm.hpp"

namespace sightline::harness {

namespace {

// Emulated in some ten milliseconds: short enough for Ctrl-C, long enough to cost nothing.
constexpr std::uint64_t cycles_between_calls = std::uint64_t{1} << 22;

class Tracer {
 public:
  static constexpr bool instructions = true;
  static constexpr bool cycles = false;
  static constexpr bool stops = false;

  explicit Tracer(const TextTaker& taker) : taker_(taker) {}

  void instruction(const machines::InstructionRecord& record) {
    fmt::format_to(std::back_inserter(text_), "{:>12} {:05o} {:06o}  {:<18} {:06o} {:o} {:06o}\n",
                   core::nanoseconds_of(record.time), record.pc, record.word.value(),
                   instruction_text(record), record.after.ac.value(), record.after.link ? 1 : 0,
                   record.after.mq.value());
    if (text_.size() >= block_size) finish();
  }
  void finish() {
    if (text_.size() != 0) taker_({text_.data(), text_.size()});
    text_.clear();
  }

 private:
  static constexpr std::size_t block_size = 65536;

  // A loop meets the same words at the same places.
  struct Remembered {
    core::Word18 word;
    std::string text;
  };
  const std::string& instruction_text(const machines::InstructionRecord& record) {
    Remembered& known = remembered_[record.pc & pdp7::address_mask];
    if (known.text.empty() || known.word != record.word) {
      known = {record.word, disassembler::disassemble_word(record.word, record.pc)};
    }
    return known.text;
  }

  const TextTaker& taker_;
  fmt::memory_buffer text_;
  std::vector<Remembered> remembered_{std::size_t{pdp7::address_mask} + 1};
};

Stop stop_of(machines::StopReason reason) {
  switch (reason) {
    case machines::StopReason::halt: return Stop::halt;
    case machines::StopReason::instruction_limit: return Stop::instruction_limit;
    case machines::StopReason::time_limit: return Stop::time_limit;
    case machines::StopReason::xct_chain: return Stop::xct_chain;
    case machines::StopReason::unanswered: return Stop::unanswered;
    case machines::StopReason::observer: break;
  }
  return Stop::interrupted;
}

template <class Machine>
void set_up(Machine& machine, const Pdp7Job& job) {
  for (const auto& [address, word] : job.core) machine.deposit(address, word);
  if (!job.reader_tape.empty()) machine.devices().reader.load(job.reader_tape);
  for (const KeyPress& key : job.keys) machine.devices().keyboard.press(key.time, key.code);
  machine.console().schedule(job.switch_script);
  if (job.start) machine.start(*job.start);
  const RegisterSettings& set = job.registers;
  pdp7::State& state = machine.registers();
  state.pc = set.pc.value_or(state.pc);
  state.ac = set.ac.value_or(state.ac);
  state.mq = set.mq.value_or(state.mq);
  state.sc = set.sc.value_or(state.sc);
  state.link = set.link.value_or(state.link);
  state.interrupts_on = set.interrupts_on.value_or(state.interrupts_on);
  machine.console().set(set.switches.value_or(core::Word18(0)));
}

// Moves the pen as far as the script has come, and says when it goes on. The display stands at the machine's
// own time between runs, which is what its pen asks for.
template <class Machine>
core::Instant move_pen(Machine& machine, std::span<const PenMove>& script) {
  while (!script.empty() && script.front().time <= machine.now()) {
    machine.display()->point_light_pen(script.front().pen);
    script = script.subspan(1);
  }
  return script.empty() ? core::never : script.front().time;
}

// In slices only if somebody wants to be asked in between or moves the light pen; a slice's end changes
// nothing in the machine.
template <class Machine>
Stop run_to_stop(Machine& machine, const Pdp7Job& job) {
  std::span<const PenMove> script;
  if (machine.display() != nullptr) script = job.pen_script;
  std::uint64_t left = job.limits.instructions;
  while (true) {
    const core::Instant until = std::min(job.limits.until, move_pen(machine, script));
    const std::uint64_t now = job.keep_running ? std::min(left, cycles_between_calls) : left;
    const std::uint64_t before = machine.counts().instructions;
    const Stop stop = stop_of(machine.run({now, until}));
    left -= machine.counts().instructions - before;
    const bool slice_done = stop == Stop::instruction_limit && left != 0;
    const bool pen_due = stop == Stop::time_limit && machine.now() < job.limits.until;
    if (!slice_done && !pen_due) return stop;
    if (job.keep_running && !job.keep_running({machine.counts().instructions, machine.now()}))
      return Stop::interrupted;
  }
}

template <class Sink, class Observer>
Pdp7Report run_with(const Pdp7Job& job, Sink& sink, Observer& observer) {
  machines::Pdp7<Sink, Observer> machine(job.machine, sink, observer);
  set_up(machine, job);
  Pdp7Report report;
  report.stop = run_to_stop(machine, job);
  report.registers = machine.registers();
  report.switches = machine.console().switches(machine.now());
  report.end = machine.now();
  report.counts = machine.counts();
  if (const auto* display = machine.display()) {
    report.display_words = display->counters().words;
    report.passes_started = display->counters().passes_started;
    report.passes = display->counters().passes_stopped;
  }
  report.unanswered = machine.unanswered();
  const auto words = machine.core().first(job.machine.configuration.core_words);
  report.core.assign(words.begin(), words.end());
  report.punched = machine.devices().punch.tape();
  report.printed = machine.devices().printer.printed();
  report.reader_out_of_tape = machine.devices().reader.out_of_tape();
  return report;
}

template <class Sink>
Pdp7Report run_observed(const Pdp7Job& job, Sink& sink) {
  if (!job.trace) {
    machines::NoObserver nobody;
    return run_with(job, sink, nobody);
  }
  Tracer tracer(job.trace);
  Pdp7Report report = run_with(job, sink, tracer);
  tracer.finish();
  return report;
}

}  // namespace

std::string_view name_of(Stop stop) {
  switch (stop) {
    case Stop::halt: return "halt";
    case Stop::instruction_limit: return "instruction_limit";
    case Stop::time_limit: return "time_limit";
    case Stop::xct_chain: return "xct_chain";
    case Stop::unanswered: return "strict";
    case Stop::interrupted: break;
  }
  return "interrupted";
}

Pdp7Report run_pdp7(const Pdp7Job& job) {
  if (job.screen == nullptr) {
    core::NoStrokes nobody;
    return run_observed(job, nobody);
  }
  Pdp7Report report = run_observed(job, *job.screen);
  job.screen->finish();
  return report;
}

std::string dump_text(const Pdp7Report& report) {
  const pdp7::State& r = report.registers;
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{:05o} {:06o} {:o} {:06o} {:02o}\n", r.pc, r.ac.value(),
                 r.link ? 1 : 0, r.mq.value(), r.sc.value());
  constexpr std::size_t words_a_line = 8;
  for (std::size_t a = 0; a < report.core.size(); ++a) {
    const bool last_in_line = a % words_a_line == words_a_line - 1 || a + 1 == report.core.size();
    fmt::format_to(std::back_inserter(text), "{:06o}{}", report.core[a].value(), last_in_line ? '\n' : ' ');
  }
  return fmt::to_string(text);
}

}  // namespace sightline::harness
