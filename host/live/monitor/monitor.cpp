#include "host/live/monitor/monitor.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "host/base/nearest_name.hpp"
#include "host/base/text.hpp"
#include "host/live/console.hpp"
#include "host/live/monitor/arguments.hpp"
#include "host/live/monitor/listings.hpp"

namespace sightline::live {

namespace {

using machines::Limits;
using machines::Machine;
using machines::MachineDescription;
using machines::Stop;
using base::without_blanks;
using monitor::Reader;
using monitor::take_part;
using Kind = Answer::Kind;

}  // namespace

class Monitor::Impl {
 public:
  Impl(const MachineDescription& description, Machine& machine, const Limits& limits, Symbols symbols,
         MonitorHost host)
      : description_(description),
        machine_(machine),
        host_(std::move(host)),
        own_(std::make_unique<Debugger>(description, machine, limits, std::move(symbols), host_.running)),
        debugger_(*own_) {}
  Impl(Debugger& debugger, MonitorHost host)
      : description_(debugger.description()), machine_(debugger.machine()), host_(std::move(host)), debugger_(debugger) {}

  void set_radix(int radix) { debugger_.set_radix(radix); }
  void set_key_codes(KeyCodes codes) { debugger_.set_key_codes(codes); }
  void set_dialect(std::string dialect) { debugger_.set_dialect(std::move(dialect)); }

  Answer execute(std::string_view line) {
    Answer answer;
    std::string rest(monitor::without_comment(line));
    while (answer.kind == Kind::done) {
      const std::size_t end = monitor::end_of_command(rest);
      const Answer one = execute_one(without_blanks(std::string_view(rest).substr(0, end)));
      answer.kind = one.kind;
      answer.text += one.text;
      if (end >= rest.size()) break;
      rest.erase(0, end + 1);
    }
    return answer;
  }

  Answer finish();
  [[nodiscard]] std::string status() const { return debugger_.status(); }
  [[nodiscard]] std::vector<std::string> completions(std::string_view line, std::string_view word) const;
  [[nodiscard]] const Stop& last_stop() const { return debugger_.last_stop(); }

  struct Verb {
    std::string_view name;
    std::size_t shortest;  // length of the shortest abbreviation
    std::string_view arguments;
    std::string_view help;
    Answer (Impl::*work)(std::string_view arguments);
  };
  static std::span<const Verb> verbs();
  // Removes the verb from `line` and returns it; null: unknown.
  static const Verb* take_verb(std::string_view& line);

 private:

  Answer answer_of(const Halted& halted) const;
  Answer run(const Goal& goal) { return answer_of(debugger_.run(goal)); }
  Answer back(std::string_view arguments);
  // Called before a medium is removed from its device.
  void write_media_back() {
    for (const auto& medium : machine_.changed_media()) {
      const auto done = host_.write(medium.path, medium.content);
      if (!done) throw base::usage_error(done.error().message());
    }
  }
  Answer save(std::string_view arguments);
  Answer restore(std::string_view arguments);

  // --- Verbs ---

  Answer execute_one(std::string_view line);
  Answer examine(std::string_view arguments);
  Answer deposit(std::string_view arguments);
  Answer step(std::string_view arguments);
  Answer cycle(std::string_view arguments);
  Answer over(std::string_view arguments);
  Answer out(std::string_view arguments);
  Answer go(std::string_view arguments);
  Answer start(std::string_view arguments);
  Answer reset(std::string_view arguments);
  Answer resume(std::string_view arguments);
  Answer run_until(std::string_view arguments);
  Answer set_break(std::string_view arguments);
  Answer set_watch(std::string_view arguments);
  Answer remove_break(std::string_view arguments);
  Answer history(std::string_view arguments);
  Answer list(std::string_view arguments);
  Answer evaluate_verb(std::string_view arguments);
  Answer show(std::string_view arguments);
  Answer who_wrote(std::string_view arguments);
  Answer attach(std::string_view arguments);
  Answer detach(std::string_view arguments);
  Answer send(std::string_view arguments);
  Answer expect(std::string_view arguments);
  Answer assert_verb(std::string_view arguments);
  Answer screenshot(std::string_view arguments);
  Answer trace(std::string_view arguments);
  Answer speed(std::string_view arguments);
  Answer read_commands(std::string_view arguments);
  Answer help(std::string_view arguments);
  Answer quit(std::string_view arguments) {
    if (!arguments.empty()) throw base::usage_error("expected no arguments");
    return {Kind::quit, {}};
  }
  void write_trace();

  Answer add(Breakpoint breakpoint);
  // A note about what a command has done, shown only to a person at the prompt. The line end may be missing.
  [[nodiscard]] Answer note(std::string_view text) const {
    if (!host_.person || depth_ > 0) return {};
    return {Kind::done, std::string(text) + (text.ends_with('\n') ? "" : "\n")};
  }
  [[nodiscard]] machines::Input file(const std::string& path) const {
    auto input = host_.read(path);
    if (!input) throw base::usage_error(input.error().message());
    return std::move(*input);
  }

  const MachineDescription& description_;
  Machine& machine_;
  MonitorHost host_;
  std::unique_ptr<Debugger> own_;  // empty if the debugger belongs to the caller
  Debugger& debugger_;
  Reader read_{debugger_};
  std::string trace_;  // lines of the current trace
  std::string trace_file_;
  int depth_ = 0;  // nesting of `do`
};

std::span<const Monitor::Impl::Verb> Monitor::Impl::verbs() {
  static constexpr std::array rows{
      Verb{"examine", 1, "[ADDRESS[-ADDRESS] | REGISTER]...", "show words with their instructions, or registers (all)",
           &Impl::examine},
      Verb{"deposit", 1, "ADDRESS WORD... | ADDRESS \"INSTRUCTION\" | REGISTER VALUE", "change words or a register",
           &Impl::deposit},
      Verb{"step", 1, "[N]", "execute N instructions (1) and show where the machine is", &Impl::step},
      Verb{"next", 1, "", "execute one instruction; a subroutine that it calls runs to its return", &Impl::over},
      Verb{"out", 1, "", "run to the return from the subroutine called last", &Impl::out},
      Verb{"cycle", 2, "[N]", "run N memory cycles or T-states (1), and show those of an instruction that is under way then", &Impl::cycle},
      Verb{"continue", 1, "", "continue from where the machine is", &Impl::resume},
      Verb{"go", 1, "[ADDRESS]", "go on from the address, or continue; an address ends a HALT, and on the PDP-7 START is pressed", &Impl::go},
      Verb{"start", 3, "[ADDRESS]", "reset, then run from the address, or from where the program began", &Impl::start},
      Verb{"reset", 4, "", "the 8080: the RESET line clears PC and INTE and ends HLT; the PDP-7: as START, all flags are cleared", &Impl::reset},
      Verb{"run", 2, "[until TIME | until EXPRESSION | for TIME | for N cycles | for N instructions]",
           "run to a goal; TIME is 0.5s, 20ms or 100us", &Impl::run_until},
      Verb{"break", 1, "[ADDRESS | iot DEVICE | interrupt | when EXPRESSION] [if EXPRESSION] [count N] [log \"TEXT\"]",
           "stop before an instruction, after an IOT or an interrupt, or when an expression becomes true; alone: at PC. count N: every Nth "
           "time; also =N, >N, >=N, <N, <=N. log: print the text instead, with the values of expressions in braces: \"ac is {ac}\"",
           &Impl::set_break},
      Verb{"watch", 1, "ADDRESS[-ADDRESS] | port N [r|w|rw] [value V] [if EXPRESSION] [count N] [log \"TEXT\"]",
           "stop after an access to memory (w) or a port (rw); count and log as for break", &Impl::set_watch},
      Verb{"delete", 3, "[N...]", "remove breakpoints by number, or all", &Impl::remove_break},
      Verb{"nobreak", 3, "[N...]", "the same", &Impl::remove_break},
      Verb{"history", 1, "[N]", "the last N instructions (20): time, address, word, instruction, word used, AC or A, L or F",
           &Impl::history},
      Verb{"list", 1, "[ADDRESS[-ADDRESS]]", "disassemble, ten instructions from PC or the address", &Impl::list},
      Verb{"disassemble", 3, "[ADDRESS[-ADDRESS]]", "the same", &Impl::list},
      Verb{"evaluate", 2, "EXPRESSION", "show the value of an expression", &Impl::evaluate_verb},
      Verb{"show", 2, "registers|devices|display|stack|time|breaks|conditions|symbols",
           "show one of these; the stack is found from the last instructions", &Impl::show},
      Verb{"who", 3, "ADDRESS", "show which instruction last wrote the word, when, and its value", &Impl::who_wrote},
      Verb{"attach", 2, "DEVICE FILE", "put a file into a device: reader, disk, pen (a script of its positions)", &Impl::attach},
      Verb{"detach", 3, "DEVICE", "take it out; a disk that was written is written back to its file", &Impl::detach},
      Verb{"send", 3, "\"KEYS\"", "type on the console when the program asks for keys in the next runs (\\r \\n \\t \\e \\NNN \\xHH)", &Impl::send},
      Verb{"expect", 3, "\"TEXT\" [within TIME]",
           "run until the program has printed the text; fail after TIME (60s), or earlier if it waits for a key", &Impl::expect},
      Verb{"assert", 3, "EXPRESSION", "fail unless it is true", &Impl::assert_verb},
      Verb{"back", 2, "[N]", "go back N instructions (1), to the state at that time", &Impl::back},
      Verb{"save", 2, "FILE", "save the whole machine as a snapshot", &Impl::save},
      Verb{"restore", 3, "FILE", "restore a snapshot of a machine with the same options", &Impl::restore},
      Verb{"screenshot", 3, "FILE", "write the picture as PNG", &Impl::screenshot},
      Verb{"trace", 2, "FILE | off", "write each executed instruction, in the format of history", &Impl::trace},
      Verb{"speed", 2, "real | max | N", "set the speed of runs with a console", &Impl::speed},
      Verb{"do", 2, "FILE", "read commands from a file; # begins a comment", &Impl::read_commands},
      Verb{"help", 1, "[VERB]", "this, or one verb", &Impl::help},
      Verb{"quit", 1, "", "end", &Impl::quit},
      Verb{"exit", 3, "", "the same", &Impl::quit},
  };
  return rows;
}

const Monitor::Impl::Verb* Monitor::Impl::take_verb(std::string_view& line) {
  const std::string typed = base::lower_case(take_part(line));
  const auto found = std::find_if(verbs().begin(), verbs().end(), [&typed](const Verb& verb) {
    return typed.size() >= verb.shortest && verb.name.starts_with(typed);
  });
  return found == verbs().end() ? nullptr : &*found;
}

Answer Monitor::Impl::execute_one(std::string_view line) {
  if (line.empty()) return {};
  std::string_view rest = line;
  const Verb* const found = take_verb(rest);
  if (found == nullptr) {
    std::string_view whole = line;
    const std::string typed = base::lower_case(take_part(whole));
    std::vector<std::string> names;
    for (const Verb& verb : verbs()) names.emplace_back(verb.name);
    const std::string remedy = base::did_you_mean(typed, names);
    return {Kind::wrong, fmt::format("unknown command \"{}\"; {}\n", typed, remedy.empty() ? "help lists them" : remedy)};
  }
  try {
    monitor::reject_open_quotes(rest);
    return (this->*found->work)(rest);
  } catch (const base::Error& wrong) {
    return {Kind::wrong, fmt::format("{}: {}\n", found->name, wrong.message())};
  }
}

// --- Memory and registers ---

Answer Monitor::Impl::examine(std::string_view arguments) {
  if (arguments.empty()) return show("registers");
  std::string text;
  while (!arguments.empty()) {
    const std::string_view what = take_part(arguments);
    if (const auto n = debugger_.register_named(what)) {
      text += debugger_.register_text(*n) + "\n";
    } else if (const auto pair = debugger_.pair_named(what)) {
      text += debugger_.pair_text(*pair) + "\n";
    } else {
      const auto [first, last] = read_.range(what);
      text += monitor::memory(debugger_, first, last);
    }
  }
  return {Kind::done, text};
}

Answer Monitor::Impl::deposit(std::string_view arguments) {
  const std::string_view where = take_part(arguments);
  if (where.empty() || arguments.empty()) throw base::usage_error("expected ADDRESS WORD..., ADDRESS \"INSTRUCTION\" or REGISTER VALUE");
  if (const auto n = debugger_.register_named(where)) {
    const auto& each = description_.registers[*n];
    const std::int64_t value = read_.value(arguments);
    const std::int64_t most = (std::int64_t{1} << each.bits) - 1;
    if (value < 0 || value > most)
      throw base::usage_error(fmt::format("found {} for {}, expected {} of {} bits", arguments, each.name, each.what, each.bits));
    debugger_.set(*n, static_cast<std::uint32_t>(value));
    return note(debugger_.register_text(*n));
  }
  if (const auto pair = debugger_.pair_named(where)) {
    const std::int64_t value = read_.value(arguments);
    if (value < 0 || value > debugger_.most_of(*pair))
      throw base::usage_error(fmt::format("found {} for {}, expected 0 to {:X}", arguments, where, debugger_.most_of(*pair)));
    debugger_.set(*pair, static_cast<std::uint32_t>(value));
    return note(debugger_.pair_text(*pair));
  }
  std::uint32_t at = read_.address(where);
  if (arguments.front() == '"') {
    const std::string_view text = take_part(arguments);
    static_cast<void>(base::value_of(debugger_.put_instruction(at, text)));
    return note(monitor::memory(debugger_, at, at));
  }
  const std::int64_t most = (std::int64_t{1} << description_.word_bits) - 1;
  std::vector<std::uint32_t> words;
  while (!arguments.empty()) {
    const std::string_view text = take_part(arguments);
    const auto read = debugger_.evaluate(text);
    if (!read) throw base::usage_error(read.error().message() + "; an instruction must be in quotes, \"" + std::string(text) + " ...\"");
    const std::int64_t value = *read;
    if (value < 0 || value > most)
      throw base::usage_error(fmt::format("found {}, expected a word of {} bits", text, description_.word_bits));
    words.push_back(static_cast<std::uint32_t>(value));
  }
  if (words.size() > machine_.words() - at) throw base::usage_error("found more words than memory has from that address on");
  const std::uint32_t first = at;
  for (const std::uint32_t value : words) debugger_.put(at++, value);
  if (words.size() == 1) return note(monitor::memory(debugger_, first, first));
  return note(fmt::format("{} words in {}-{}", words.size(), debugger_.address(first), debugger_.address(at - 1)));
}

Answer Monitor::Impl::list(std::string_view arguments) {
  constexpr std::uint32_t instructions = 10;
  const std::uint32_t end_of_memory = machine_.words() - 1;
  if (arguments.empty()) return {Kind::done, monitor::disassembly(debugger_, debugger_.pc(), end_of_memory, instructions)};
  const auto [first, last] = read_.range(take_part(arguments));
  return {Kind::done, first == last ? monitor::disassembly(debugger_, first, end_of_memory, instructions)
                                    : monitor::disassembly(debugger_, first, last, monitor::most_listed)};
}

Answer Monitor::Impl::evaluate_verb(std::string_view arguments) {
  return {Kind::done, debugger_.value_text(read_.value(arguments)) + "\n"};
}

Answer Monitor::Impl::who_wrote(std::string_view arguments) {
  return {Kind::done, monitor::writer(debugger_, read_.address(arguments))};
}

// --- Breakpoints ---

Answer Monitor::Impl::add(Breakpoint breakpoint) {
  if (breakpoint.text.empty()) breakpoint.text = debugger_.address(breakpoint.first);
  const std::string text = breakpoint.text;
  return {Kind::done, fmt::format("breakpoint {}: {}\n", debugger_.breakpoints().add(std::move(breakpoint)), text)};
}

Answer Monitor::Impl::set_break(std::string_view arguments) {
  return add(read_.breakpoint(arguments));
}

Answer Monitor::Impl::set_watch(std::string_view arguments) {
  return add(read_.watchpoint(arguments));
}

Answer Monitor::Impl::remove_break(std::string_view arguments) {
  std::size_t removed = 0;
  if (arguments.empty()) {
    removed = debugger_.breakpoints().all().size();
    debugger_.breakpoints().clear();
  }
  while (!arguments.empty()) {
    const std::string_view text = take_part(arguments);
    const std::uint64_t number = std::min<std::uint64_t>(Reader::count(text), std::numeric_limits<int>::max());
    if (!debugger_.breakpoints().remove(static_cast<int>(number)))
      throw base::usage_error(fmt::format("there is no breakpoint {}; show breaks lists them", text));
    ++removed;
  }
  return note(fmt::format("{} breakpoint{} removed", removed, removed == 1 ? "" : "s"));
}

// --- Running ---

Answer Monitor::Impl::answer_of(const Halted& halted) const {
  const std::string reason = halted.reason.empty() ? std::string() : halted.reason + "\n";
  return {Kind::done, reason + debugger_.status()};
}

Answer Monitor::Impl::back(std::string_view arguments) {
  static_cast<void>(base::value_of(debugger_.back(arguments.empty() ? 1 : Reader::count(arguments))));
  return {Kind::done, status()};
}

Answer Monitor::Impl::save(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw base::usage_error("expected a file");
  const auto snapshot = debugger_.save();
  const auto done = host_.write(path, snapshot);
  if (!done) throw base::usage_error(done.error().message());
  return note(fmt::format("{}: {} bytes", path, snapshot.size()));
}

Answer Monitor::Impl::restore(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw base::usage_error("expected a file");
  const machines::Input input = file(path);
  static_cast<void>(base::value_of(debugger_.restore(input.bytes, path)));
  return {Kind::done, status()};
}

Answer Monitor::Impl::step(std::string_view arguments) {
  const std::uint64_t n = arguments.empty() ? 1 : Reader::count(arguments);
  if (n == 0) return {};
  constexpr std::uint64_t most_shown = 100;
  if (n > most_shown) return run({.instructions = n});
  std::string text;
  for (std::uint64_t i = 0; i < n; ++i) {
    const std::uint64_t before = machine_.instructions();
    const Answer answer = run({.instructions = 1});
    text += answer.text;
    if (machine_.instructions() == before) break;
    if (last_stop().name == "halt" && i + 1 < n) break;
  }
  return {Kind::done, text};
}

Answer Monitor::Impl::over(std::string_view arguments) {
  if (!arguments.empty()) throw base::usage_error("expected no arguments");
  return answer_of(debugger_.step_over());
}

Answer Monitor::Impl::out(std::string_view arguments) {
  if (!arguments.empty()) throw base::usage_error("expected no arguments");
  return answer_of(base::value_of(debugger_.step_out()));
}

Answer Monitor::Impl::cycle(std::string_view arguments) {
  const Debugger::Cycled cycled = base::value_of(debugger_.run_cycles(read_.cycles(arguments)));
  return cycled.cycles.empty() ? answer_of(cycled.halted) : Answer{Kind::done, monitor::cycles(debugger_, cycled)};
}

Answer Monitor::Impl::resume(std::string_view arguments) {
  if (!arguments.empty()) throw base::usage_error("expected no arguments");
  return run({});
}

Answer Monitor::Impl::go(std::string_view arguments) {
  if (!arguments.empty()) debugger_.start(read_.address(arguments));
  return run({});
}

Answer Monitor::Impl::start(std::string_view arguments) {
  const std::uint32_t at = arguments.empty() ? machine_.beginning() : read_.address(arguments);
  debugger_.reset();
  debugger_.start(at);
  return run({});
}

Answer Monitor::Impl::reset(std::string_view arguments) {
  if (!arguments.empty()) throw base::usage_error("expected no arguments");
  debugger_.reset();
  return note(status());
}

Answer Monitor::Impl::run_until(std::string_view arguments) {
  return run(read_.goal(arguments));
}

Answer Monitor::Impl::history(std::string_view arguments) {
  return {Kind::done, monitor::history(debugger_, arguments.empty() ? 20 : Reader::count(arguments))};
}

// --- Descriptions ---

Answer Monitor::Impl::show(std::string_view arguments) {
  return {Kind::done, monitor::state(debugger_, arguments)};
}

// --- The world outside ---

Answer Monitor::Impl::attach(std::string_view arguments) {
  const std::string device = base::lower_case(take_part(arguments));
  if (device.empty() || arguments.empty()) throw base::usage_error("expected DEVICE FILE, such as reader tape.rim");
  const machines::Input input = file(std::string(take_part(arguments)));
  write_media_back();
  const auto done = machine_.attach(device, input);
  debugger_.forget_past();
  if (!done) throw base::usage_error(done.error().message());
  return note(fmt::format("{}: {}, {} bytes", device, input.name, input.bytes.size()));
}

Answer Monitor::Impl::detach(std::string_view arguments) {
  write_media_back();
  const std::string device = base::lower_case(arguments);
  const auto done = machine_.attach(device, {});
  debugger_.forget_past();
  if (!done) throw base::usage_error(done.error().message());
  return note(fmt::format("{}: detached", device));
}

Answer Monitor::Impl::send(std::string_view arguments) {
  if (arguments.empty()) throw base::usage_error("expected \"KEYS\", such as \"hello\\r\"");
  const auto keys = plain_text("a text", take_part(arguments));
  if (!keys) throw base::usage_error(keys.error().message());
  if (!arguments.empty()) throw base::usage_error(fmt::format("found {} after the keys, expected one text; one with blanks is in quotes", arguments));
  debugger_.send(*keys);
  return note(fmt::format("{} {} typed in the next run", keys->size(), keys->size() == 1 ? "key is" : "keys are"));
}

Answer Monitor::Impl::expect(std::string_view arguments) {
  if (arguments.empty()) throw base::usage_error("expected \"TEXT\" or \"TEXT\" within TIME, such as expect \"OK\" within 90s");
  const auto text = plain_text("a text", take_part(arguments));
  if (!text) throw base::usage_error(text.error().message());
  const std::int64_t limit = read_.limit(arguments).value_or(60 * machine_.ticks_per_second());
  const std::int64_t end = machine_.ticks() + std::min(limit, std::numeric_limits<std::int64_t>::max() - machine_.ticks());
  while (true) {
    debugger_.show_printed();
    const std::size_t found = debugger_.printed().find(*text);
    if (found != std::string::npos) {
      debugger_.forget_printed(found + text->size());
      return {};
    }
    const auto not_printed = [&](std::string_view why) {
      return Answer{Kind::failed, fmt::format("expect: {}; printed since the last expect: \"{}\"\n", why, debugger_.printed())};
    };
    if (machine_.ticks() >= end) {
      const double seconds = static_cast<double>(limit) / static_cast<double>(machine_.ticks_per_second());
      return not_printed(fmt::format("not printed in {:g} s", seconds));
    }
    const Halted halted =
        debugger_.run({.until = std::min(end, machine_.ticks() + machine_.ticks_per_second() / 50), .ends_in_waiting = true});
    if (halted.why == Halted::Why::goal || debugger_.printed().find(*text) != std::string::npos) continue;
    if (halted.stop.name == end_of_input) return not_printed("not printed, and the program waits for a key");
    return {Kind::failed, answer_of(halted).text};
  }
}

Answer Monitor::Impl::assert_verb(std::string_view arguments) {
  if (read_.value(arguments) != 0) return {};
  return {Kind::failed, fmt::format("assert: {} is not true\n{}", arguments, status())};
}

Answer Monitor::Impl::screenshot(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw base::usage_error("expected a file");
  // The photograph of a vector display, or the picture of a raster board.
  auto picture = machine_.output("--phosphor");
  if (picture.empty()) picture = machine_.output("--png");
  if (picture.empty()) throw base::usage_error("this machine has no display or raster board, or its program has not used the display yet");
  const auto done = host_.write(path, picture);
  if (!done) throw base::usage_error(done.error().message());
  return note(fmt::format("{}: {} bytes", path, picture.size()));
}

Answer Monitor::Impl::trace(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw base::usage_error("expected a file, or off");
  if (path != "off") {
    write_trace();
    // Reports now, not at the end, that the file cannot be written.
    if (const auto done = host_.write(path, {}); !done) throw base::usage_error(done.error().message());
    trace_file_ = path;
    machine_.probe()->on_instruction = [this](const Past::Entry& entry) { trace_ += machine_.history_line(entry) + "\n"; };
    return note(fmt::format("{}: written by `trace off` or at the end of the session", path));
  }
  if (trace_file_.empty()) throw base::usage_error("no trace is being written");
  const std::string written = trace_file_;
  const auto instructions = std::count(trace_.begin(), trace_.end(), '\n');
  write_trace();
  return note(fmt::format("{}: {} instruction{}", written, instructions, instructions == 1 ? "" : "s"));
}

// Writes and ends the current trace.
void Monitor::Impl::write_trace() {
  machine_.probe()->on_instruction = nullptr;
  if (trace_file_.empty()) return;
  const std::span<const char> text = trace_;
  const auto done =
      host_.write(trace_file_, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  trace_file_.clear();
  trace_.clear();
  if (!done) throw base::usage_error(done.error().message());
}

Answer Monitor::Impl::finish() {
  try {
    write_trace();
  } catch (const base::Error& wrong) {
    return {Kind::wrong, fmt::format("trace: {}\n", wrong.message())};
  }
  return {};
}

Answer Monitor::Impl::speed(std::string_view arguments) {
  const auto done = host_.speed(std::string(arguments));
  if (!done) throw base::usage_error(done.error().message());
  return note(arguments == "max" ? "as fast as this computer can" : arguments == "real" ? "the speed of the machine" : fmt::format("{} times the speed of the machine", arguments));
}

Answer Monitor::Impl::read_commands(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw base::usage_error("expected a file of commands");
  constexpr int deepest = 8;
  if (depth_ == deepest) throw base::usage_error(fmt::format("{}: found a file within {} others, expected fewer", path, deepest));
  const machines::Input input = file(path);
  const std::string text(input.bytes.begin(), input.bytes.end());
  std::string_view rest = text;
  Answer all;
  ++depth_;
  for (std::size_t number = 1; !rest.empty() && all.kind == Kind::done; ++number) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const Answer answer = execute(line);
    all.kind = answer.kind;
    if (answer.kind == Kind::wrong || answer.kind == Kind::failed) all.text += fmt::format("{}: line {}: ", path, number);
    all.text += answer.text;
  }
  --depth_;
  return all;
}

Answer Monitor::Impl::help(std::string_view arguments) {
  const std::string wanted = base::lower_case(arguments);
  std::string text;
  for (const Verb& verb : verbs()) {
    if (!wanted.empty() && !verb.name.starts_with(wanted)) continue;
    const std::string name = fmt::format("{}{}", verb.name.substr(0, verb.shortest),
                                         verb.shortest == verb.name.size()
                                             ? std::string()
                                             : fmt::format("[{}]", verb.name.substr(verb.shortest)));
    text += fmt::format("{} {}\n        {}\n", name, verb.arguments, verb.help);
  }
  if (text.empty()) throw base::usage_error(fmt::format("unknown command \"{}\"", wanted));
  if (wanted.empty()) {
    text += fmt::format("Addresses and words are {}, 10. is decimal, counts are decimal. Expressions know registers, symbols, "
                        "[ADDRESS], time, instructions and the operators of C. `;` separates commands.\n",
                        debugger_.radix() == 8 ? "octal" : debugger_.radix() == 16 ? "hexadecimal" : "decimal");
  }
  return {Kind::done, text};
}

std::vector<std::string> Monitor::Impl::completions(std::string_view line, std::string_view begun) const {
  std::vector<std::string> names;
  const auto offer = [&](std::string_view name) {
    if (base::lower_case(name).starts_with(base::lower_case(begun))) names.emplace_back(name);
  };
  if (without_blanks(line).size() <= begun.size()) {
    for (const Verb& verb : verbs()) offer(verb.name);
    return names;
  }
  for (const auto& each : description_.registers) offer(base::lower_case(each.name));
  for (const auto& [name, holds] : machine_.conditions()) offer(name);
  for (const auto& [name, value] : debugger_.symbols().all()) offer(name);
  return names;
}

Monitor::Monitor(const MachineDescription& description, Machine& machine, const Limits& limits, Symbols symbols,
                 MonitorHost host)
    : impl_(std::make_unique<Impl>(description, machine, limits, std::move(symbols), std::move(host))) {}
Monitor::Monitor(Debugger& debugger, MonitorHost host) : impl_(std::make_unique<Impl>(debugger, std::move(host))) {}
Monitor::~Monitor() = default;

void Monitor::set_radix(int radix) {
  impl_->set_radix(radix);
}
void Monitor::set_dialect(std::string dialect) {
  impl_->set_dialect(std::move(dialect));
}
void Monitor::set_key_codes(KeyCodes codes) {
  impl_->set_key_codes(codes);
}
bool Monitor::is_command(std::string_view line) {
  return Impl::take_verb(line) != nullptr;
}
std::vector<std::string_view> Monitor::verbs() {
  std::vector<std::string_view> names;
  for (const Impl::Verb& verb : Impl::verbs()) names.push_back(verb.name);
  return names;
}
Answer Monitor::execute(std::string_view line) {
  return impl_->execute(line);
}
Answer Monitor::finish() {
  return impl_->finish();
}
std::string Monitor::status() const {
  return impl_->status();
}
std::vector<std::string> Monitor::completions(std::string_view line, std::string_view word) const {
  return impl_->completions(line, word);
}
const Stop& Monitor::last_stop() const {
  return impl_->last_stop();
}

}  // namespace sightline::live
