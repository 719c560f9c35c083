// See monitor.hpp.
#include "host/live/monitor.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "host/base/nearest_name.hpp"
#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/live/console.hpp"
#include "host/live/expression.hpp"
#include "host/live/snapshot.hpp"

namespace sightline::live {

namespace {

using guests::run::Limits;
using guests::run::Machine;
using guests::run::MachineDescription;
using guests::run::Probe;
using guests::run::Stop;
using base::without_blanks;
using Kind = Answer::Kind;

constexpr std::uint64_t most_listed = 4096;

// Between quotes blanks belong to the word.
std::string_view take_part(std::string_view& text) {
  text = without_blanks(text);
  if (!text.empty() && text.front() == '"') {
    const std::size_t end = std::min(text.find('"', 1), text.size());
    const std::string_view word = text.substr(1, end - 1);
    text = without_blanks(text.substr(std::min(end + 1, text.size())));
    return word;
  }
  return base::take_word(text);
}

// Where `word` stands by itself in the text, else npos.
std::size_t find_word(std::string_view text, std::string_view word) {
  std::size_t at = 0;
  while ((at = text.find(word, at)) != std::string_view::npos) {
    const bool begins = at == 0 || text[at - 1] == ' ';
    const bool ends = at + word.size() == text.size() || text[at + word.size()] == ' ';
    if (begins && ends) return at;
    ++at;
  }
  return at;
}

// A line of the monitor that is wrong; the text is the complaint.
struct Wrong {
  std::string text;
};

}  // namespace

class Monitor::Inside {
 public:
  Inside(const MachineDescription& description, Machine& machine, const Limits& limits, Symbols symbols,
         MonitorHost host)
      : description_(description),
        machine_(machine),
        host_(std::move(host)),
        own_(std::make_unique<Debugger>(description, machine, limits, std::move(symbols), host_.running)),
        debugger_(*own_) {}
  Inside(Debugger& debugger, MonitorHost host)
      : description_(debugger.description()), machine_(debugger.machine()), host_(std::move(host)), debugger_(debugger) {}

  void set_radix(int radix) { debugger_.set_radix(radix); }
  void set_key_codes(KeyCodes codes) { debugger_.set_key_codes(codes); }
  void set_dialect(std::string dialect) { debugger_.set_dialect(std::move(dialect)); }

  Answer execute(std::string_view line) {
    Answer answer;
    std::string rest(line);
    while (answer.kind == Kind::done) {
      const std::size_t end = end_of_command(rest);
      const Answer one = execute_one(without_blanks(std::string_view(rest).substr(0, end)));
      answer.kind = one.kind;
      answer.text += one.text;
      if (end >= rest.size()) break;
      rest.erase(0, end + 1);
    }
    return answer;
  }

  [[nodiscard]] std::string status() const { return debugger_.status(); }
  [[nodiscard]] std::vector<std::string> completions(std::string_view line, std::string_view word) const;
  [[nodiscard]] const Stop& last_stop() const { return debugger_.last_stop(); }

  struct Verb {
    std::string_view name;
    std::size_t shortest;  // letters that are enough
    std::string_view arguments;
    std::string_view help;
    Answer (Inside::*work)(std::string_view arguments);
  };
  static std::span<const Verb> verbs();
  // Null: there is none. `line` is left at what follows the verb.
  static const Verb* take_verb(std::string_view& line);

 private:
  [[nodiscard]] std::string address(std::uint32_t value) const { return debugger_.address(value); }
  [[nodiscard]] std::string word(std::uint32_t value) const { return debugger_.word(value); }
  [[nodiscard]] std::int64_t evaluated(std::string_view text) const { return take(debugger_.evaluate(text)); }
  [[nodiscard]] std::uint32_t address_of(std::string_view text) const { return take(debugger_.address_of(text)); }
  template <class T>
  static T take(base::Result<T> result) {
    if (!result) throw Wrong{result.error().message()};
    return std::move(*result);
  }
  // A count is decimal, whatever the radix of words is.
  [[nodiscard]] static std::uint64_t count_of(std::string_view text) {
    const auto count = base::count_number(text);
    if (!count) throw Wrong{fmt::format("found \"{}\", expected a count, decimal", text)};
    return *count;
  }
  // FIRST-LAST or one address; at a - that is followed by an expression of its own.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> range_of(std::string_view text) const {
    std::size_t depth = 0;
    for (std::size_t i = 1; i < text.size(); ++i) {
      if (text[i] == '(' || text[i] == '[') ++depth;
      if ((text[i] == ')' || text[i] == ']') && depth > 0) --depth;
      if (text[i] != '-' || depth != 0) continue;
      const std::uint32_t first = address_of(text.substr(0, i));
      const std::uint32_t last = address_of(text.substr(i + 1));
      if (last < first) throw Wrong{fmt::format("found {}, expected FIRST-LAST with the smaller address first", text)};
      return {first, last};
    }
    const std::uint32_t at = address_of(text);
    return {at, at};
  }

  Answer answer_of(const Halted& halted) const;
  // So many cycles, in the machine's unit.
  [[nodiscard]] std::int64_t cycles_of(std::string_view text) const {
    constexpr std::uint64_t most = std::uint64_t{1} << 40;
    return static_cast<std::int64_t>(std::min(text.empty() ? 1 : count_of(text), most)) * description_.ticks_a_cycle;
  }
  Answer run(const Goal& goal) { return answer_of(debugger_.run(goal)); }
  Answer back(std::string_view arguments);
  // Before a medium is taken out of its device.
  void write_media_back() {
    for (const auto& medium : machine_.changed_media()) {
      const auto done = host_.write(medium.path, medium.content);
      if (!done) throw Wrong{done.error().message};
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
  Answer quit(std::string_view) { return {Kind::quit, {}}; }

  static std::size_t end_of_command(std::string_view text) {
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '"') quoted = !quoted;
      if (text[i] == ';' && !quoted) return i;
    }
    return text.size();
  }
  static std::string labelled(const std::vector<guests::run::ReportLine>& lines) {
    std::string text;
    for (const auto& line : lines) text += fmt::format("{:<12} {}\n", line.label, line.text);
    return text;
  }
  Breakpoint parsed(std::string_view arguments, Breakpoint breakpoint);
  Answer add(Breakpoint breakpoint);
  [[nodiscard]] std::string memory_lines(std::uint32_t first, std::uint32_t last) const;
  [[nodiscard]] guests::run::Input file(const std::string& path) const {
    auto input = host_.read(path);
    if (!input) throw Wrong{input.error().message};
    return std::move(*input);
  }

  const MachineDescription& description_;
  Machine& machine_;
  MonitorHost host_;
  std::unique_ptr<Debugger> own_;  // unless it is another's
  Debugger& debugger_;
  std::string trace_;  // under way
  std::string trace_file_;
  int depth_ = 0;  // of files that are read
};

std::span<const Monitor::Inside::Verb> Monitor::Inside::verbs() {
  static constexpr std::array rows{
      Verb{"examine", 1, "[ADDRESS[-ADDRESS] | REGISTER]...", "show words with their instructions, or registers (all)",
           &Inside::examine},
      Verb{"deposit", 1, "ADDRESS WORD... | ADDRESS \"INSTRUCTION\" | REGISTER VALUE", "change words or a register",
           &Inside::deposit},
      Verb{"step", 1, "[N]", "obey N instructions (1) and show where the machine is", &Inside::step},
      Verb{"next", 1, "", "one instruction; a subroutine that it calls runs to its return", &Inside::over},
      Verb{"out", 1, "", "run on to the return from the subroutine called last", &Inside::out},
      Verb{"cycle", 2, "[N]", "run N memory cycles or T-states (1), and show those of an instruction that is under way then", &Inside::cycle},
      Verb{"continue", 1, "", "run on from where the machine is", &Inside::resume},
      Verb{"go", 1, "[ADDRESS]", "press START at the address, or run on", &Inside::go},
      Verb{"run", 2, "[until TIME | until EXPRESSION | for TIME | for N cycles | for N instructions]",
           "run on to a goal; TIME is 0.5s, 20ms or 100us", &Inside::run_until},
      Verb{"break", 1, "[ADDRESS | iot DEVICE | interrupt | when EXPRESSION] [if EXPRESSION] [count N]",
           "stop before an instruction, after an IOT or an interrupt, or when something becomes true; alone: where PC is",
           &Inside::set_break},
      Verb{"watch", 1, "ADDRESS[-ADDRESS] | port N [r|w|rw] [value V] [if EXPRESSION] [count N]",
           "stop after an access to memory (w) or a port (rw)", &Inside::set_watch},
      Verb{"delete", 3, "[N...]", "remove breakpoints by number, or all", &Inside::remove_break},
      Verb{"nobreak", 3, "[N...]", "the same", &Inside::remove_break},
      Verb{"history", 1, "[N]", "the last N instructions (20): time, address, word, instruction, word used, AC or A, L or F",
           &Inside::history},
      Verb{"list", 1, "[ADDRESS[-ADDRESS]]", "disassemble, ten instructions from PC or the address", &Inside::list},
      Verb{"disassemble", 3, "[ADDRESS[-ADDRESS]]", "the same", &Inside::list},
      Verb{"evaluate", 2, "EXPRESSION", "show its value", &Inside::evaluate_verb},
      Verb{"show", 2, "registers|devices|display|stack|time|breaks|conditions|symbols",
           "show that; the stack as the last instructions tell it", &Inside::show},
      Verb{"who", 3, "ADDRESS", "which instruction last wrote the word, when and what", &Inside::who_wrote},
      Verb{"attach", 2, "DEVICE FILE", "put a file into a device: reader, disk, pen (a script of where it points)", &Inside::attach},
      Verb{"detach", 3, "DEVICE", "take it out; a disk that was written is written back to its file", &Inside::detach},
      Verb{"send", 3, "\"KEYS\"", "type on the console, as the program asks for keys in the runs that follow (\\r \\n \\t \\e \\NNN \\xHH)", &Inside::send},
      Verb{"expect", 3, "\"TEXT\"", "run on until the program has printed the text", &Inside::expect},
      Verb{"assert", 3, "EXPRESSION", "fail unless it is true", &Inside::assert_verb},
      Verb{"back", 2, "[N]", "N instructions (1) back in time, to the state as it was", &Inside::back},
      Verb{"save", 2, "FILE", "the whole machine into a snapshot", &Inside::save},
      Verb{"restore", 3, "FILE", "the machine of a snapshot, made with the same options", &Inside::restore},
      Verb{"screenshot", 3, "FILE", "the picture as PNG", &Inside::screenshot},
      Verb{"trace", 2, "FILE | off", "write each instruction that is obeyed, as history shows it", &Inside::trace},
      Verb{"speed", 2, "real | max | N", "of runs with a console", &Inside::speed},
      Verb{"do", 2, "FILE", "read commands from a file; # begins a comment", &Inside::read_commands},
      Verb{"help", 1, "[VERB]", "this, or one verb", &Inside::help},
      Verb{"quit", 1, "", "end", &Inside::quit},
      Verb{"exit", 3, "", "the same", &Inside::quit},
  };
  return rows;
}

const Monitor::Inside::Verb* Monitor::Inside::take_verb(std::string_view& line) {
  const std::string typed = base::lower_case(take_part(line));
  const auto found = std::find_if(verbs().begin(), verbs().end(), [&typed](const Verb& verb) {
    return typed.size() >= verb.shortest && verb.name.starts_with(typed);
  });
  return found == verbs().end() ? nullptr : &*found;
}

Answer Monitor::Inside::execute_one(std::string_view line) {
  if (line.empty() || line.front() == '#') return {};
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
    return (this->*found->work)(rest);
  } catch (const Wrong& wrong) {
    return {Kind::wrong, fmt::format("{}: {}\n", found->name, wrong.text)};
  }
}

// --- Memory and registers ---

std::string Monitor::Inside::memory_lines(std::uint32_t first, std::uint32_t last) const {
  std::string text;
  if (last - first >= most_listed)
    throw Wrong{fmt::format("found {} words, expected at most {}", last - first + 1, most_listed)};
  if (description_.radix == 8 || first == last) {
    for (std::uint32_t at = first; at <= last; ++at)
      text += fmt::format("{} {}  {}\n", address(at), word(machine_.word(at)), debugger_.instruction_text(at));
    return text;
  }
  for (std::uint32_t line = first; line <= last; line += 16) {
    std::string bytes;
    std::string characters;
    for (std::uint32_t at = line; at <= std::min(line + 15, last); ++at) {
      const std::uint32_t byte = machine_.word(at);
      bytes += " " + word(byte);
      characters.push_back(byte >= ' ' && byte < 0x7F ? static_cast<char>(byte) : '.');
    }
    text += fmt::format("{} {:<48}  {}\n", address(line), bytes, characters);
  }
  return text;
}

Answer Monitor::Inside::examine(std::string_view arguments) {
  if (arguments.empty()) return show("registers");
  std::string text;
  while (!arguments.empty()) {
    const std::string_view what = take_part(arguments);
    if (const auto n = debugger_.register_named(what)) {
      text += debugger_.register_text(*n) + "\n";
    } else {
      const auto [first, last] = range_of(what);
      text += memory_lines(first, last);
    }
  }
  return {Kind::done, text};
}

Answer Monitor::Inside::deposit(std::string_view arguments) {
  const std::string_view where = take_part(arguments);
  if (where.empty() || arguments.empty()) throw Wrong{"expected ADDRESS WORD..., ADDRESS \"INSTRUCTION\" or REGISTER VALUE"};
  if (const auto n = debugger_.register_named(where)) {
    const auto& each = description_.registers[*n];
    const std::int64_t value = evaluated(arguments);
    const std::int64_t most = (std::int64_t{1} << each.bits) - 1;
    if (value < 0 || value > most)
      throw Wrong{fmt::format("found {} for {}, expected {} of {} bits", arguments, each.name, each.what, each.bits)};
    debugger_.set(*n, static_cast<std::uint32_t>(value));
    return {};
  }
  std::uint32_t at = address_of(where);
  if (arguments.front() == '"') {
    const std::string_view text = take_part(arguments);
    static_cast<void>(take(debugger_.put_instruction(at, text)));
    return {};
  }
  const std::int64_t most = (std::int64_t{1} << description_.word_bits) - 1;
  std::vector<std::uint32_t> words;
  while (!arguments.empty()) {
    const std::string_view text = take_part(arguments);
    const std::int64_t value = evaluated(text);
    if (value < 0 || value > most)
      throw Wrong{fmt::format("found {}, expected a word of {} bits", text, description_.word_bits)};
    words.push_back(static_cast<std::uint32_t>(value));
  }
  if (words.size() > machine_.words() - at) throw Wrong{"found more words than memory has behind that address"};
  for (const std::uint32_t value : words) debugger_.put(at++, value);
  return {};
}

Answer Monitor::Inside::list(std::string_view arguments) {
  constexpr int instructions = 10;
  std::uint32_t at = debugger_.pc();
  std::uint32_t last = machine_.words() - 1;
  int left = instructions;
  if (!arguments.empty()) {
    const auto [first, end] = range_of(take_part(arguments));
    at = first;
    if (end != first) {
      last = end;
      left = static_cast<int>(most_listed);
    }
  }
  std::string text;
  for (; left > 0 && at <= last; --left) {
    const auto instruction = machine_.instruction_at(at);
    std::string words;
    for (std::uint32_t n = 0; n < instruction.words && at + n < machine_.words(); ++n)
      words += (description_.radix == 16 || words.empty() ? "" : " ") + word(machine_.word(at + n));
    const int width = description_.radix == 16 ? 6 : 0;
    text += fmt::format("{}{} {:<{}}  {}\n", at == debugger_.pc() ? ">" : " ", address(at), words, width,
                        debugger_.instruction_text(at));
    at += std::max(1U, instruction.words);
  }
  return {Kind::done, text};
}

Answer Monitor::Inside::evaluate_verb(std::string_view arguments) {
  const std::int64_t value = evaluated(arguments);
  const auto bits = static_cast<std::uint64_t>(value);
  std::string text = debugger_.radix() == 16  ? fmt::format("{:X} = ", bits)
                     : debugger_.radix() == 8 ? fmt::format("{:o} = ", bits)
                                              : std::string();
  text += fmt::format("{}.", value);
  const std::int64_t sign = std::int64_t{1} << (description_.word_bits - 1);
  if (value >= sign && value < 2 * sign) text += fmt::format(" = {}. as a word with a sign", value - 2 * sign);
  if (value >= 0 && value < machine_.words()) {
    const std::string near = debugger_.symbols().near(static_cast<std::uint32_t>(value));
    if (!near.empty()) text += " = " + near;
  }
  return {Kind::done, text + "\n"};
}

Answer Monitor::Inside::who_wrote(std::string_view arguments) {
  const std::uint32_t at = address_of(arguments);
  const auto writer = debugger_.last_writer(at);
  if (!writer)
    return {Kind::done, fmt::format("{}: nothing has written there since the monitor began\n", address(at))};
  std::string by = fmt::format("{} {}", address(writer->pc), debugger_.instruction_text(writer->pc));
  if (writer->event.kind == Probe::Kind::break_write) by = fmt::format("a data break while PC was {}", address(writer->pc));
  if (writer->event.kind == Probe::Kind::interrupt_write) by = fmt::format("the interrupt before {}", address(writer->pc));
  return {Kind::done, fmt::format("{}: {} was written at {} by {}\n", address(at), word(writer->event.value),
                                  debugger_.time_text(writer->event.time), by)};
}

// --- Breakpoints ---

Breakpoint Monitor::Inside::parsed(std::string_view arguments, Breakpoint breakpoint) {
  breakpoint.text = std::string(arguments);
  std::string rest(arguments);
  const auto take_tail = [&rest](std::string_view name) -> std::optional<std::string> {
    const std::size_t at = find_word(rest, name);
    if (at == std::string::npos) return std::nullopt;
    std::string tail(without_blanks(std::string_view(rest).substr(at + name.size())));
    rest.erase(at);
    return tail;
  };
  if (const auto count = take_tail("count")) breakpoint.count = std::max<std::uint64_t>(1, count_of(*count));
  if (const auto condition = take_tail("if")) breakpoint.condition = *condition;
  if (const auto value = take_tail("value")) breakpoint.value = static_cast<std::uint32_t>(evaluated(*value));
  if (!breakpoint.condition.empty()) static_cast<void>(evaluated(breakpoint.condition));
  std::string_view what = rest;
  const std::string first = base::lower_case(take_part(what));
  if (breakpoint.kind == Breakpoint::Kind::memory) {
    if (first.empty()) throw Wrong{"expected an address, FIRST-LAST or port N"};
    std::string place = first;
    if (first == "port" || first == "iot") {
      breakpoint.kind = Breakpoint::Kind::port;
      breakpoint.access = description_.radix == 8 ? Probe::executed : Probe::is_read | Probe::is_written;
      place = base::lower_case(take_part(what));
    }
    const std::string how = base::lower_case(take_part(what));
    if (how == "r") {
      breakpoint.access = Probe::is_read;
    } else if (how == "w") {
      breakpoint.access = Probe::is_written;
    } else if (how == "rw") {
      breakpoint.access = Probe::is_read | Probe::is_written;
    } else if (!how.empty()) {
      throw Wrong{fmt::format("found \"{}\", expected r, w, rw, value, if or count", how)};
    }
    if (breakpoint.kind == Breakpoint::Kind::port) {
      const std::int64_t number = evaluated(place);
      if (number < 0 || number >= static_cast<std::int64_t>(machine_.probe()->ports()))
        throw Wrong{fmt::format("found port {}, expected one below {:X} (hexadecimal)", place, machine_.probe()->ports())};
      breakpoint.first = breakpoint.last = static_cast<std::uint32_t>(number);
      if (description_.radix == 8) breakpoint.access = Probe::executed;
    } else {
      std::tie(breakpoint.first, breakpoint.last) = range_of(place);
    }
    return breakpoint;
  }
  if (first == "interrupt") {
    breakpoint.kind = Breakpoint::Kind::interrupt;
  } else if (first == "when") {
    breakpoint.kind = Breakpoint::Kind::condition;
    breakpoint.condition = std::string(what);
    if (breakpoint.condition.empty()) throw Wrong{"expected an expression behind `when`"};
    breakpoint.was_true = evaluated(breakpoint.condition) != 0;
  } else if (first == "iot" || first == "port") {
    return parsed("port " + std::string(what), [&] {
      Breakpoint port = breakpoint;
      port.kind = Breakpoint::Kind::memory;
      return port;
    }());
  } else {
    const auto conditions = machine_.conditions();
    const bool is_condition = std::any_of(conditions.begin(), conditions.end(),
                                          [&first](const auto& each) { return each.first == first; });
    if (is_condition) return parsed("when " + rest, breakpoint);
    breakpoint.first = breakpoint.last = first.empty() ? debugger_.pc() : address_of(first);
  }
  return breakpoint;
}

Answer Monitor::Inside::add(Breakpoint breakpoint) {
  if (breakpoint.text.empty()) breakpoint.text = address(breakpoint.first);
  const std::string text = breakpoint.text;
  return {Kind::done, fmt::format("breakpoint {}: {}\n", debugger_.breakpoints().add(std::move(breakpoint)), text)};
}

Answer Monitor::Inside::set_break(std::string_view arguments) {
  Breakpoint breakpoint = parsed(arguments, {});
  breakpoint.text = std::string(arguments);
  return add(std::move(breakpoint));
}

Answer Monitor::Inside::set_watch(std::string_view arguments) {
  Breakpoint of_memory;
  of_memory.kind = Breakpoint::Kind::memory;
  of_memory.access = Probe::is_written;
  Breakpoint breakpoint = parsed(arguments, of_memory);
  breakpoint.text = "watch " + std::string(arguments);
  return add(std::move(breakpoint));
}

Answer Monitor::Inside::remove_break(std::string_view arguments) {
  if (arguments.empty()) debugger_.breakpoints().clear();
  while (!arguments.empty()) {
    const std::string_view text = take_part(arguments);
    const std::uint64_t number = std::min<std::uint64_t>(count_of(text), std::numeric_limits<int>::max());
    if (!debugger_.breakpoints().remove(static_cast<int>(number)))
      throw Wrong{fmt::format("there is no breakpoint {}; show breaks lists them", text)};
  }
  return {};
}

// --- Running ---

Answer Monitor::Inside::answer_of(const Halted& halted) const {
  const std::string reason = halted.reason.empty() ? std::string() : halted.reason + "\n";
  return {Kind::done, reason + debugger_.status()};
}

Answer Monitor::Inside::back(std::string_view arguments) {
  static_cast<void>(take(debugger_.back(arguments.empty() ? 1 : count_of(arguments))));
  return {Kind::done, status()};
}

Answer Monitor::Inside::save(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw Wrong{"expected a file"};
  const auto done = host_.write(path, debugger_.save());
  if (!done) throw Wrong{done.error().message};
  return {};
}

Answer Monitor::Inside::restore(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw Wrong{"expected a file"};
  const guests::run::Input input = file(path);
  static_cast<void>(take(debugger_.restore(input.bytes, path)));
  return {Kind::done, status()};
}

Answer Monitor::Inside::step(std::string_view arguments) {
  const std::uint64_t n = arguments.empty() ? 1 : count_of(arguments);
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

Answer Monitor::Inside::over(std::string_view arguments) {
  if (!arguments.empty()) throw Wrong{"expected nothing behind it"};
  return answer_of(debugger_.step_over());
}

Answer Monitor::Inside::out(std::string_view arguments) {
  if (!arguments.empty()) throw Wrong{"expected nothing behind it"};
  return answer_of(take(debugger_.step_out()));
}

Answer Monitor::Inside::cycle(std::string_view arguments) {
  const Debugger::Cycled cycled = take(debugger_.run_cycles(cycles_of(arguments)));
  if (cycled.cycles.empty()) return answer_of(cycled.halted);
  std::string text = fmt::format("at {}, inside the instruction that begins at {}:\n", debugger_.time_text(cycled.at),
                                 debugger_.time_text(machine_.ticks()));
  for (std::size_t n = 0; n < cycled.cycles.size(); ++n) {
    const Past::Cycle& each = cycled.cycles[n];
    const std::int64_t end = n + 1 < cycled.cycles.size() ? cycled.cycles[n + 1].time : std::max(cycled.at + 1, each.time + each.length);
    const bool begun = each.time < cycled.at;
    const std::string_view state = !begun ? "to come" : end <= cycled.at ? "done" : "under way";
    text += fmt::format("{} {:<9}  {:<14}", debugger_.time_text(each.time), state, each.name);
    if (each.has_address) text += fmt::format(" {} {}", address(each.address), begun ? word(each.value) : std::string());
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return {Kind::done, text + "before it: " + debugger_.status()};
}

Answer Monitor::Inside::resume(std::string_view arguments) {
  if (!arguments.empty()) throw Wrong{"expected nothing behind it"};
  return run({});
}

Answer Monitor::Inside::go(std::string_view arguments) {
  if (!arguments.empty()) debugger_.start(address_of(arguments));
  return run({});
}

Answer Monitor::Inside::run_until(std::string_view arguments) {
  if (arguments.empty()) return run({});
  std::string_view rest = arguments;
  const std::string word = base::lower_case(take_part(rest));
  if ((word != "until" && word != "for") || rest.empty())
    throw Wrong{fmt::format("found \"{}\", expected until or for with a time, an expression or a count", arguments)};
  // "0.5s", "20ms", "100us"
  const auto ticks = [&](std::string_view text) -> std::optional<std::int64_t> {
    double unit = 0;
    for (const auto& [name, seconds] :
         {std::pair<std::string_view, double>{"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}, {"s", 1.0}}) {
      if (unit == 0 && text.ends_with(name)) {
        unit = seconds;
        text.remove_suffix(name.size());
      }
    }
    const auto value = base::fixed_number(text, 0, 1e12);
    if (unit == 0 || !value) return std::nullopt;
    return static_cast<std::int64_t>(std::llround(
        std::min(*value * unit * static_cast<double>(machine_.ticks_a_second()), 4e18)));
  };
  if (const auto time = ticks(rest)) return run({.until = word == "for" ? machine_.ticks() + *time : *time});
  if (word == "until") {
    static_cast<void>(evaluated(rest));
    return run({.condition = std::string(rest)});
  }
  std::string_view unit = rest;
  const std::string_view count = take_part(unit);
  if (unit == "cycles" || unit == "cycle") return run({.until = machine_.ticks() + cycles_of(count)});
  if (unit == "instructions" || unit == "instruction") return run({.instructions = count_of(count)});
  throw Wrong{fmt::format("found \"{}\", expected a time such as 20ms, N cycles or N instructions", rest)};
}

Answer Monitor::Inside::history(std::string_view arguments) {
  const std::uint64_t n = arguments.empty() ? 20 : count_of(arguments);
  std::string text;
  for (const Past::Entry& entry : debugger_.history(static_cast<std::size_t>(std::min<std::uint64_t>(n, Past::most_history))))
    text += machine_.history_line(entry) + "\n";
  return {Kind::done, text.empty() ? "no instruction has been obeyed yet\n" : text};
}

// --- Descriptions ---

Answer Monitor::Inside::show(std::string_view arguments) {
  const std::string what = base::lower_case(arguments);
  std::string text;
  const auto is = [&what](std::string_view name) { return !what.empty() && name.starts_with(what); };
  if (is("registers")) {
    for (std::size_t n = 0; n < description_.registers.size(); ++n) text += debugger_.register_text(n) + "\n";
  } else if (is("devices")) {
    text = labelled(machine_.device_lines());
  } else if (is("display")) {
    text = labelled(machine_.display_lines());
    if (text.empty()) text = "no display is attached\n";
  } else if (is("stack")) {
    for (const Frame& frame : debugger_.stack())
      text += fmt::format("{} called from {}  {}\n", address(frame.entry), address(frame.caller),
                          debugger_.instruction_text(frame.caller));
    if (text.empty()) text = "no subroutine was called and not left in the last instructions\n";
  } else if (is("time")) {
    text = fmt::format("{}, {} instructions\n", debugger_.time_text(machine_.ticks()), machine_.instructions());
  } else if (is("breaks") || is("breakpoints")) {
    for (const Breakpoint& each : debugger_.breakpoints().all())
      text += fmt::format("{}: {}, passed {} times\n", each.number, each.text, each.passed);
    if (text.empty()) text = "no breakpoints\n";
  } else if (is("conditions")) {
    for (const auto& [name, holds] : machine_.conditions()) text += fmt::format("{:<12} {}\n", name, holds ? 1 : 0);
    if (text.empty()) text = "this machine has none\n";
  } else if (is("symbols")) {
    for (const auto& [name, value] : debugger_.symbols().all()) text += fmt::format("{:<16} {}\n", name, address(value));
    if (text.empty()) text = "no symbols; begin with a source file or --symbols FILE\n";
  } else {
    throw Wrong{fmt::format("found \"{}\", expected registers, devices, display, stack, time, breaks, conditions or symbols", arguments)};
  }
  return {Kind::done, text};
}

// --- The world outside ---

Answer Monitor::Inside::attach(std::string_view arguments) {
  const std::string device = base::lower_case(take_part(arguments));
  if (device.empty() || arguments.empty()) throw Wrong{"expected DEVICE FILE, such as reader tape.rim"};
  const guests::run::Input input = file(std::string(take_part(arguments)));
  write_media_back();
  const auto done = machine_.attach(device, input);
  debugger_.forget_past();
  if (!done) throw Wrong{done.error().message};
  return {};
}

Answer Monitor::Inside::detach(std::string_view arguments) {
  write_media_back();
  const auto done = machine_.attach(base::lower_case(arguments), {});
  debugger_.forget_past();
  if (!done) throw Wrong{done.error().message};
  return {};
}

Answer Monitor::Inside::send(std::string_view arguments) {
  const auto keys = plain_text("send", take_part(arguments));
  if (!keys) throw Wrong{keys.error().message};
  debugger_.send(*keys);
  return {};
}

Answer Monitor::Inside::expect(std::string_view arguments) {
  const auto text = plain_text("expect", take_part(arguments));
  if (!text) throw Wrong{text.error().message};
  if (text->empty()) throw Wrong{"expected a text"};
  constexpr std::int64_t most_seconds = 60;
  const std::int64_t end = machine_.ticks() + most_seconds * machine_.ticks_a_second();
  while (true) {
    debugger_.show_printed();
    const std::size_t found = debugger_.printed().find(*text);
    if (found != std::string::npos) {
      debugger_.forget_printed(found + text->size());
      return {};
    }
    if (machine_.ticks() >= end || (machine_.waits_for_key() && !debugger_.keys_wait())) {
      return {Kind::failed, fmt::format("expect: not printed in {} s; printed since the last expect: \"{}\"\n",
                                        most_seconds, debugger_.printed())};
    }
    const Halted halted = debugger_.run({.until = std::min(end, machine_.ticks() + machine_.ticks_a_second() / 50)});
    const bool stopped = halted.why != Halted::Why::goal;
    if (stopped && debugger_.printed().find(*text) == std::string::npos) return {Kind::failed, answer_of(halted).text};
  }
}

Answer Monitor::Inside::assert_verb(std::string_view arguments) {
  if (evaluated(arguments) != 0) return {};
  return {Kind::failed, fmt::format("assert: {} is not true\n{}", arguments, status())};
}

Answer Monitor::Inside::screenshot(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw Wrong{"expected a file"};
  // Of a vector display the photograph of its screen, of a raster board what it shows.
  auto picture = machine_.output("--phosphor");
  if (picture.empty()) picture = machine_.output("--png");
  if (picture.empty()) throw Wrong{"this machine has no display or raster board; attach one when you begin"};
  const auto done = host_.write(path, picture);
  if (!done) throw Wrong{done.error().message};
  return {};
}

Answer Monitor::Inside::trace(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw Wrong{"expected a file, or off"};
  if (path != "off") {
    trace_.clear();
    trace_file_ = path;
    machine_.probe()->on_instruction = [this](const Past::Entry& entry) { trace_ += machine_.history_line(entry) + "\n"; };
    return {};
  }
  machine_.probe()->on_instruction = nullptr;
  if (trace_file_.empty()) throw Wrong{"no trace is under way"};
  const std::span<const char> text = trace_;
  const auto done =
      host_.write(trace_file_, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  trace_file_.clear();
  trace_.clear();
  if (!done) throw Wrong{done.error().message};
  return {};
}

Answer Monitor::Inside::speed(std::string_view arguments) {
  const auto done = host_.speed(std::string(arguments));
  if (!done) throw Wrong{done.error().message};
  return {};
}

Answer Monitor::Inside::read_commands(std::string_view arguments) {
  const std::string path(take_part(arguments));
  constexpr int deepest = 8;
  if (depth_ == deepest) throw Wrong{fmt::format("{}: found a file within {} others, expected fewer", path, deepest)};
  const guests::run::Input input = file(path);
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

Answer Monitor::Inside::help(std::string_view arguments) {
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
  if (text.empty()) throw Wrong{fmt::format("unknown command \"{}\"", wanted)};
  if (wanted.empty()) {
    text += fmt::format("Addresses and words are {}, 10. is decimal, counts are decimal. Expressions know registers, symbols, "
                        "[ADDRESS], time, instructions and the operators of C. `;` separates commands.\n",
                        debugger_.radix() == 8 ? "octal" : debugger_.radix() == 16 ? "hexadecimal" : "decimal");
  }
  return {Kind::done, text};
}

std::vector<std::string> Monitor::Inside::completions(std::string_view line, std::string_view begun) const {
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
    : inside_(std::make_unique<Inside>(description, machine, limits, std::move(symbols), std::move(host))) {}
Monitor::Monitor(Debugger& debugger, MonitorHost host) : inside_(std::make_unique<Inside>(debugger, std::move(host))) {}
Monitor::~Monitor() = default;

void Monitor::set_radix(int radix) {
  inside_->set_radix(radix);
}
void Monitor::set_dialect(std::string dialect) {
  inside_->set_dialect(std::move(dialect));
}
void Monitor::set_key_codes(KeyCodes codes) {
  inside_->set_key_codes(codes);
}
bool Monitor::is_command(std::string_view line) {
  return Inside::take_verb(line) != nullptr;
}
std::vector<std::string_view> Monitor::verbs() {
  std::vector<std::string_view> names;
  for (const Inside::Verb& verb : Inside::verbs()) names.push_back(verb.name);
  return names;
}
Answer Monitor::execute(std::string_view line) {
  return inside_->execute(line);
}
std::string Monitor::status() const {
  return inside_->status();
}
std::vector<std::string> Monitor::completions(std::string_view line, std::string_view word) const {
  return inside_->completions(line, word);
}
const Stop& Monitor::last_stop() const {
  return inside_->last_stop();
}

}  // namespace sightline::live
