// See monitor.hpp.
#include "host/live/monitor.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>
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

std::string lower(std::string_view text) {
  std::string lowered(text);
  for (char& c : lowered) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lowered;
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
        limits_(limits),
        symbols_(std::move(symbols)),
        host_(std::move(host)),
        probe_(*machine.probe()) {
    for (std::size_t n = 0; n < description.registers.size(); ++n)
      if (description.registers[n].name == "PC") pc_ = n;
  }

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

  [[nodiscard]] std::string status() const {
    const std::uint32_t pc = machine_.get(pc_);
    std::string text = fmt::format("{} {}", address(pc), instruction_text(pc));
    for (std::size_t n = 0; n < description_.registers.size(); ++n) {
      if (n != pc_ && description_.registers[n].in_dump) text += fmt::format("  {}", register_text(n));
    }
    return fmt::format("{}  {}\n", text, time_text(machine_.ticks()));
  }

  [[nodiscard]] std::vector<std::string> completions(std::string_view line, std::string_view word) const;
  [[nodiscard]] const Stop& last_stop() const { return last_stop_; }

 private:
  struct Verb {
    std::string_view name;
    std::size_t shortest;  // letters that are enough
    std::string_view arguments;
    std::string_view help;
    Answer (Inside::*work)(std::string_view arguments);
  };
  static std::span<const Verb> verbs();

  // What the machine is stopped for.
  struct Breakpoint {
    enum class Kind : std::uint8_t { execution, memory, port, interrupt, condition };
    int number = 0;
    Kind kind = Kind::execution;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint8_t access = Probe::executed;
    std::optional<std::uint32_t> value;  // read or written
    std::string condition;               // empty: always
    std::uint64_t count = 1;             // stops when this many have passed
    std::uint64_t passed = 0;
    bool was_true = false;  // of a condition: stops when it becomes true
    std::string text;       // as typed
  };

  // --- Texts ---

  [[nodiscard]] std::string address(std::uint32_t value) const {
    return digits(description_, value, description_.address_bits);
  }
  [[nodiscard]] std::string word(std::uint32_t value) const {
    return digits(description_, value, description_.word_bits);
  }
  [[nodiscard]] std::string register_text(std::size_t n) const {
    const auto& each = description_.registers[n];
    return fmt::format("{} {}", each.name, digits(description_, machine_.get(n), each.bits));
  }
  // "begin+5: lac i 00010", with the line of the source if there is one.
  [[nodiscard]] std::string instruction_text(std::uint32_t at) const {
    std::string text = symbols_.near(at);
    if (!text.empty()) text += ": ";
    text += machine_.instruction_at(at).text;
    const std::string_view source = symbols_.source(at);
    return source.empty() ? text : fmt::format("{}  ; {}", text, source);
  }
  [[nodiscard]] std::string time_text(std::int64_t ticks) const {
    const std::int64_t second = machine_.ticks_a_second();
    const auto nanoseconds =
        static_cast<std::int64_t>(static_cast<double>(ticks % second) * (1e9 / static_cast<double>(second)));
    return fmt::format("{}.{:09} s", ticks / second, nanoseconds);
  }

  // --- Expressions ---

  [[nodiscard]] std::optional<std::size_t> register_named(std::string_view name) const {
    for (std::size_t n = 0; n < description_.registers.size(); ++n)
      if (lower(description_.registers[n].name) == lower(name)) return n;
    return std::nullopt;
  }
  // Pairs of the 8080 and what every machine has.
  [[nodiscard]] std::optional<std::int64_t> value_of(std::string_view name) const {
    if (const auto n = register_named(name)) return machine_.get(*n);
    const std::string lowered = lower(name);
    if (lowered == "time") return machine_.ticks();
    if (lowered == "instructions") return static_cast<std::int64_t>(machine_.instructions());
    for (const auto& [condition, holds] : machine_.conditions())
      if (condition == lowered) return holds ? 1 : 0;
    if (lowered.size() == 2) {
      const auto high = register_named(lowered.substr(0, 1));
      const auto low = register_named(lowered.substr(1));
      if (high && low && description_.radix == 16) return machine_.get(*high) << 8 | machine_.get(*low);
    }
    if (const auto value = symbols_.value(name)) return *value;
    return std::nullopt;
  }
  [[nodiscard]] std::int64_t evaluated(std::string_view text) const {
    const auto value = live::evaluate(text, names_);
    if (!value) throw Wrong{value.error().message()};
    return *value;
  }
  [[nodiscard]] std::uint32_t address_of(std::string_view text) const {
    const std::int64_t value = evaluated(text);
    if (value < 0 || value >= machine_.words()) {
      throw Wrong{fmt::format("found address {}, expected one in {}, {}-{}", text, description_.memory_name,
                              address(0), address(machine_.words() - 1))};
    }
    return static_cast<std::uint32_t>(value);
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

  // --- Running ---

  // Goes on to a stop of the machine, a breakpoint, the limits of the run or this goal; the answer says where it is.
  struct Goal {
    std::uint64_t instructions = std::numeric_limits<std::uint64_t>::max();  // from here
    std::int64_t until = std::numeric_limits<std::int64_t>::max();
    std::string condition = {};
    bool quiet = false;  // no status line
  };
  Answer run(const Goal& goal);
  [[nodiscard]] std::optional<std::string> reason_to_stop();
  [[nodiscard]] std::optional<std::string> condition_met();
  [[nodiscard]] bool counts(Breakpoint& breakpoint);
  [[nodiscard]] Stop run_by_instructions(const Limits& limits, const std::string& condition,
                                         std::optional<std::string>& reason);
  void set_probe();

  // Going back: the machine as it was, from which a run to any later instruction is repeated.
  struct Past {
    std::uint64_t instructions;
    std::uint64_t remembered;  // by the probe
    guests::run::Bytes snapshot;
  };
  void remember_past();
  void forget_past() { past_.clear(); }
  Answer back(std::string_view arguments);
  Answer save(std::string_view arguments);
  Answer restore(std::string_view arguments);
  // Without a console that says otherwise the keys of the PDP-7 have channel 8, as those of the KSR 33.
  void type_next() {
    if (keys_.empty() || !machine_.wants_key()) return;
    machine_.type(code_of_key(description_.radix == 8 ? KeyCodes::parity : KeyCodes::ascii, keys_.front()));
    keys_.erase(0, 1);
  }
  void show_printed() {
    const std::string text = shown_text(machine_.take_printed());
    if (text.empty()) return;
    printed_ += text;
    host_.print(text);
  }

  // --- Verbs ---

  Answer execute_one(std::string_view line);
  Answer examine(std::string_view arguments);
  Answer deposit(std::string_view arguments);
  Answer step(std::string_view arguments);
  Answer cycle(std::string_view arguments);
  Answer over(std::string_view arguments);
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
  Breakpoint parsed(std::string_view arguments, Breakpoint breakpoint);
  Answer add(Breakpoint breakpoint);
  void deposit_instruction(std::uint32_t at, std::string_view text);
  [[nodiscard]] std::string memory_lines(std::uint32_t first, std::uint32_t last) const;
  [[nodiscard]] guests::run::Input file(const std::string& path) const {
    auto input = host_.read(path);
    if (!input) throw Wrong{input.error().message};
    return std::move(*input);
  }

  const MachineDescription& description_;
  Machine& machine_;
  Limits limits_;
  Symbols symbols_;
  MonitorHost host_;
  Probe& probe_;
  std::size_t pc_ = 0;
  std::vector<Breakpoint> breakpoints_;
  std::vector<Past> past_;  // in order of instructions
  int last_number_ = 0;
  Stop last_stop_{"operator", {}};
  std::string printed_;  // since the last expect
  std::string keys_;     // of `send`, to be typed as the program asks
  std::string trace_;    // under way
  std::string trace_file_;
  int depth_ = 0;  // of files that are read
  Names names_{description_.radix, [this](std::string_view name) { return value_of(name); },
               [this](std::int64_t at) -> std::optional<std::int64_t> {
                 if (at < 0 || at >= machine_.words()) return std::nullopt;
                 return machine_.word(static_cast<std::uint32_t>(at));
               }};
};

std::span<const Monitor::Inside::Verb> Monitor::Inside::verbs() {
  static constexpr std::array rows{
      Verb{"examine", 1, "[ADDRESS[-ADDRESS] | REGISTER]...", "show words with their instructions, or registers (all)",
           &Inside::examine},
      Verb{"deposit", 1, "ADDRESS WORD... | ADDRESS \"INSTRUCTION\" | REGISTER VALUE", "change words or a register",
           &Inside::deposit},
      Verb{"step", 1, "[N]", "obey N instructions (1) and show where the machine is", &Inside::step},
      Verb{"next", 1, "", "one instruction; a subroutine that it calls runs to its return", &Inside::over},
      Verb{"cycle", 2, "[N]", "run to the first boundary N memory cycles or T-states on (1)", &Inside::cycle},
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
      Verb{"show", 2, "registers|devices|time|breaks|conditions|symbols", "show that", &Inside::show},
      Verb{"who", 3, "ADDRESS", "which instruction last wrote the word, when and what", &Inside::who_wrote},
      Verb{"attach", 2, "DEVICE FILE", "put a file into a device: reader", &Inside::attach},
      Verb{"detach", 3, "DEVICE", "take it out", &Inside::detach},
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

Answer Monitor::Inside::execute_one(std::string_view line) {
  if (line.empty() || line.front() == '#') return {};
  std::string_view rest = line;
  const std::string typed = lower(take_part(rest));
  const auto found = std::find_if(verbs().begin(), verbs().end(), [&typed](const Verb& verb) {
    return typed.size() >= verb.shortest && verb.name.starts_with(typed);
  });
  if (found == verbs().end()) {
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
      text += fmt::format("{} {}  {}\n", address(at), word(machine_.word(at)), instruction_text(at));
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
    if (const auto n = register_named(what)) {
      text += register_text(*n) + "\n";
    } else {
      const auto [first, last] = range_of(what);
      text += memory_lines(first, last);
    }
  }
  return {Kind::done, text};
}

// An instruction is what contains a blank or begins with a letter and has no value.
void Monitor::Inside::deposit_instruction(std::uint32_t at, std::string_view text) {
  std::string source;
  if (description_.radix == 8) {
    for (const auto& [name, value] : symbols_.all()) source += fmt::format("{}={:o}\n", name, value);
    source += fmt::format("{:o}/\n\t{}\n", at, text);
  } else {
    for (const auto& [name, value] : symbols_.all()) source += fmt::format("{}\tEQU 0{:X}H\n", name, value);
    source += fmt::format("\tORG 0{:X}H\n\t{}\n", at, text);
  }
  const std::array sources{assembler::SourceFile{"deposit", source}};
  const guests::run::Arguments none(description_.assembler.options);
  const auto assembled = description_.assembler.assemble(sources, none, {});
  if (!assembled) throw Wrong{assembled.error().message};
  for (const auto& diagnostic : assembled->diagnostics)
    if (diagnostic.severity == assembler::Severity::error) throw Wrong{fmt::format("found {}, expected {}", diagnostic.found, diagnostic.expected)};
  for (const auto& [where, value] : assembled->program.words) {
    if (where < machine_.words()) machine_.put(where, value);
  }
}

Answer Monitor::Inside::deposit(std::string_view arguments) {
  const std::string_view where = take_part(arguments);
  if (where.empty() || arguments.empty()) throw Wrong{"expected ADDRESS WORD..., ADDRESS \"INSTRUCTION\" or REGISTER VALUE"};
  if (const auto n = register_named(where)) {
    const auto& each = description_.registers[*n];
    const std::int64_t value = evaluated(arguments);
    const std::int64_t most = (std::int64_t{1} << each.bits) - 1;
    if (value < 0 || value > most)
      throw Wrong{fmt::format("found {} for {}, expected {} of {} bits", arguments, each.name, each.what, each.bits)};
    machine_.set(*n, static_cast<std::uint32_t>(value));
    return {};
  }
  std::uint32_t at = address_of(where);
  if (arguments.front() == '"') {
    const std::string_view text = take_part(arguments);
    deposit_instruction(at, text);
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
  for (const std::uint32_t value : words) machine_.put(at++, value);
  return {};
}

Answer Monitor::Inside::list(std::string_view arguments) {
  constexpr int instructions = 10;
  std::uint32_t at = machine_.get(pc_);
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
    text += fmt::format("{}{} {:<{}}  {}\n", at == machine_.get(pc_) ? ">" : " ", address(at), words, width,
                        instruction_text(at));
    at += std::max(1U, instruction.words);
  }
  return {Kind::done, text};
}

Answer Monitor::Inside::evaluate_verb(std::string_view arguments) {
  const std::int64_t value = evaluated(arguments);
  const auto bits = static_cast<std::uint64_t>(value);
  std::string text = description_.radix == 16 ? fmt::format("{:X}", bits) : fmt::format("{:o}", bits);
  text += fmt::format(" = {}.", value);
  const std::int64_t sign = std::int64_t{1} << (description_.word_bits - 1);
  if (value >= sign && value < 2 * sign) text += fmt::format(" = {}. as a word with a sign", value - 2 * sign);
  if (value >= 0 && value < machine_.words()) {
    const std::string near = symbols_.near(static_cast<std::uint32_t>(value));
    if (!near.empty()) text += " = " + near;
  }
  return {Kind::done, text + "\n"};
}

Answer Monitor::Inside::who_wrote(std::string_view arguments) {
  const std::uint32_t at = address_of(arguments);
  const Probe::Writer& writer = probe_.writers[at];
  if (writer.time < 0) return {Kind::done, fmt::format("{}: nothing has written there since the monitor began\n", address(at))};
  const std::string by = writer.device ? fmt::format("a data break while PC was {}", address(writer.pc))
                                       : fmt::format("{} {}", address(writer.pc), instruction_text(writer.pc));
  return {Kind::done, fmt::format("{}: {} was written at {} by {}\n", address(at), word(writer.value),
                                  time_text(writer.time), by)};
}

// --- Breakpoints ---

Monitor::Inside::Breakpoint Monitor::Inside::parsed(std::string_view arguments, Breakpoint breakpoint) {
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
  const std::string first = lower(take_part(what));
  if (breakpoint.kind == Breakpoint::Kind::memory) {
    if (first.empty()) throw Wrong{"expected an address, FIRST-LAST or port N"};
    std::string place = first;
    if (first == "port" || first == "iot") {
      breakpoint.kind = Breakpoint::Kind::port;
      breakpoint.access = description_.radix == 8 ? Probe::executed : Probe::is_read | Probe::is_written;
      place = lower(take_part(what));
    }
    const std::string how = lower(take_part(what));
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
      if (number < 0 || number >= static_cast<std::int64_t>(probe_.at_port.size()))
        throw Wrong{fmt::format("found port {}, expected one below {:X} (hexadecimal)", place, probe_.at_port.size())};
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
    breakpoint.first = breakpoint.last = first.empty() ? machine_.get(pc_) : address_of(first);
  }
  return breakpoint;
}

Answer Monitor::Inside::add(Breakpoint breakpoint) {
  breakpoint.number = ++last_number_;
  const std::string text =
      fmt::format("breakpoint {}: {}\n", breakpoint.number,
                  breakpoint.text.empty() ? address(breakpoint.first) : breakpoint.text);
  if (breakpoint.text.empty()) breakpoint.text = address(breakpoint.first);
  breakpoints_.push_back(std::move(breakpoint));
  set_probe();
  return {Kind::done, text};
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
  if (arguments.empty()) breakpoints_.clear();
  while (!arguments.empty()) {
    const std::string_view text = take_part(arguments);
    const std::uint64_t number = count_of(text);
    const auto found = std::find_if(breakpoints_.begin(), breakpoints_.end(), [number](const Breakpoint& each) {
      return static_cast<std::uint64_t>(each.number) == number;
    });
    if (found == breakpoints_.end()) throw Wrong{fmt::format("there is no breakpoint {}; show breaks lists them", text)};
    breakpoints_.erase(found);
  }
  set_probe();
  return {};
}

void Monitor::Inside::set_probe() {
  std::fill(probe_.at_address.begin(), probe_.at_address.end(), std::uint8_t{0});
  std::fill(probe_.at_port.begin(), probe_.at_port.end(), std::uint8_t{0});
  probe_.at_interrupt = false;
  for (const Breakpoint& each : breakpoints_) {
    switch (each.kind) {
      case Breakpoint::Kind::execution:
      case Breakpoint::Kind::memory:
        for (std::uint32_t at = each.first; at <= each.last; ++at) probe_.at_address[at] |= each.access;
        break;
      case Breakpoint::Kind::port: probe_.at_port[each.first] |= each.access; break;
      case Breakpoint::Kind::interrupt: probe_.at_interrupt = true; break;
      case Breakpoint::Kind::condition: break;
    }
  }
}

bool Monitor::Inside::counts(Breakpoint& breakpoint) {
  if (breakpoint.kind != Breakpoint::Kind::condition && !breakpoint.condition.empty()) {
    const auto value = live::evaluate(breakpoint.condition, names_);
    if (value && *value == 0) return false;
  }
  return ++breakpoint.passed % breakpoint.count == 0;
}

// What of the events since the last look is a reason to stop.
std::optional<std::string> Monitor::Inside::reason_to_stop() {
  std::optional<std::string> reason;
  for (const Probe::Event& event : probe_.events) {
    const auto [kind, access] = [&event]() -> std::pair<Breakpoint::Kind, std::uint8_t> {
      switch (event.kind) {
        case Probe::Kind::execution: return {Breakpoint::Kind::execution, Probe::executed};
        case Probe::Kind::read: return {Breakpoint::Kind::memory, Probe::is_read};
        case Probe::Kind::write: return {Breakpoint::Kind::memory, Probe::is_written};
        case Probe::Kind::port_read: return {Breakpoint::Kind::port, Probe::is_read};
        case Probe::Kind::port_write: return {Breakpoint::Kind::port, Probe::is_written | Probe::executed};
        case Probe::Kind::interrupt: break;
      }
      return {Breakpoint::Kind::interrupt, Probe::executed};
    }();
    for (Breakpoint& each : breakpoints_) {
      if (each.kind != kind || (each.access & access) == 0) continue;
      if (kind != Breakpoint::Kind::interrupt && (event.address < each.first || event.address > each.last)) continue;
      if (each.value && *each.value != event.value) continue;
      if (!counts(each) || reason) continue;
      reason = fmt::format("breakpoint {}", each.number);
      if (kind == Breakpoint::Kind::memory) {
        *reason += fmt::format(": {} {} {} {}", address(event.address), symbols_.near(event.address),
                               event.kind == Probe::Kind::read ? "read, it is" : "written with", word(event.value));
      } else if (kind == Breakpoint::Kind::port) {
        *reason += description_.radix == 8 ? fmt::format(": IOT {:06o}", event.value)
                                           : fmt::format(": port {:02X} {} {:02X}", event.address,
                                                         access == Probe::is_read ? "read as" : "written with",
                                                         event.value);
      } else if (kind == Breakpoint::Kind::interrupt) {
        *reason += fmt::format(": interrupt before {}", address(event.address));
      }
    }
  }
  return reason;
}

// A condition that has become true since the last boundary.
std::optional<std::string> Monitor::Inside::condition_met() {
  std::optional<std::string> reason;
  for (Breakpoint& each : breakpoints_) {
    if (each.kind != Breakpoint::Kind::condition) continue;
    const auto value = live::evaluate(each.condition, names_);
    const bool holds = value && *value != 0;
    const bool became = holds && !each.was_true;
    each.was_true = holds;
    if (became && counts(each) && !reason) reason = fmt::format("breakpoint {}: {}", each.number, each.condition);
  }
  return reason;
}

// --- Running ---

// Looks at conditions after each instruction.
Stop Monitor::Inside::run_by_instructions(const Limits& limits, const std::string& condition,
                                          std::optional<std::string>& reason) {
  constexpr std::uint64_t between_questions = 4096;
  for (std::uint64_t n = 1;; ++n) {
    Limits one = limits;
    one.instructions = std::min(limits.instructions, machine_.instructions() + 1);
    std::optional<Stop> stop;
    while (!stop && !machine_.waits_for_key()) stop = machine_.run(one, false);
    const bool one_done = stop && stop->name == "instruction_limit" && machine_.instructions() < limits.instructions;
    if (!probe_.events.empty()) {
      reason = reason_to_stop();
      probe_.resume();
    }
    if (!reason) reason = condition_met();
    if (!reason && !condition.empty() && evaluated(condition) != 0) reason = condition;
    if (reason) return {"event", {}};
    if (stop && !one_done && stop->name != "event") return *stop;
    if (machine_.waits_for_key()) return {end_of_input, {}};
    if (n % between_questions == 0) {
      show_printed();
      if (host_.interrupted()) return {std::string_view(guests::run::interrupted), {}};
    }
  }
}

Answer Monitor::Inside::run(const Goal& goal) {
  Limits limits = limits_;
  const std::uint64_t begun = machine_.instructions();
  if (goal.instructions < limits.instructions - std::min(begun, limits.instructions))
    limits.instructions = begun + goal.instructions;
  limits.until = std::min(limits.until, goal.until);
  const bool by_instructions =
      !goal.condition.empty() || std::any_of(breakpoints_.begin(), breakpoints_.end(), [](const Breakpoint& each) {
        return each.kind == Breakpoint::Kind::condition;
      });
  std::optional<std::string> reason;
  Stop stop{"event", {}};
  probe_.resume();
  while (!reason && stop.name == "event") {
    type_next();
    Limits part = limits;
    const bool live = host_.is_live();
    if (!live) remember_past();
    constexpr std::int64_t slices_a_second = 50;
    const std::int64_t slice = machine_.ticks() + machine_.ticks_a_second() / slices_a_second;
    if (!live || !keys_.empty()) part.until = std::min(limits.until, slice);
    stop = by_instructions ? run_by_instructions(part, goal.condition, reason) : host_.run(machine_, part, [this](std::string_view text) { printed_ += text; });
    const bool slice_done = stop.at_until && part.until < limits.until;
    const bool key_due = stop.name == end_of_input && !keys_.empty();
    if (live) forget_past();
    if (slice_done || key_due) stop = {"event", {}};
    if (stop.name == "event" && host_.interrupted()) stop = {std::string_view(guests::run::interrupted), {}};
    if (!by_instructions && (stop.name == "event" || stop.name == guests::run::interrupted)) {
      reason = reason_to_stop();
      probe_.resume();
    }
  }
  show_printed();
  if (!trace_file_.empty() && probe_.on_instruction == nullptr) trace_file_.clear();
  std::string text;
  Kind kind = Kind::done;
  const bool goal_reached = (stop.name == "instruction_limit" && machine_.instructions() < limits_.instructions) ||
                            (stop.at_until && machine_.ticks() < limits_.until);
  if (reason) {
    text = fmt::format("{}\n", *reason);
  } else if (!goal_reached) {
    last_stop_ = stop;
    std::string name(stop.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    text = fmt::format("stopped by {}\n", name);
    if (!stop.complaint.empty()) text += stop.complaint + "\n";
  }
  if (!goal.quiet || !text.empty()) text += status();
  return {kind, text};
}

// The state where a run begins counts, whatever was deposited or typed before it.
void Monitor::Inside::remember_past() {
  while (!past_.empty() && past_.back().instructions >= machine_.instructions()) past_.pop_back();
  past_.push_back({machine_.instructions(), probe_.remembered(), save_snapshot(description_.name, machine_)});
  constexpr std::size_t most = 512;
  if (past_.size() <= most) return;
  // Every other of the older half: what is longer ago takes longer to come back to.
  std::vector<Past> kept;
  for (std::size_t n = 0; n < past_.size(); ++n) {
    if (n >= most / 2 || n % 2 == 0) kept.push_back(std::move(past_[n]));
  }
  past_ = std::move(kept);
}

Answer Monitor::Inside::back(std::string_view arguments) {
  const std::uint64_t n = arguments.empty() ? 1 : count_of(arguments);
  const std::uint64_t here = machine_.instructions();
  if (past_.empty() || n > here - std::min(here, past_.front().instructions)) {
    const std::uint64_t most = past_.empty() ? 0 : here - std::min(here, past_.front().instructions);
    throw Wrong{fmt::format("found {} instructions, expected at most {}: the monitor remembers no more", n, most)};
  }
  const std::uint64_t target = here - n;
  while (past_.back().instructions > target) past_.pop_back();
  const Past& from = past_.back();
  const auto done = restore_snapshot(description_.name, machine_, from.snapshot, "snapshot");
  if (!done) throw Wrong{done.error().message()};
  probe_.go_back_to(from.remembered);
  // No breakpoint is counted again.
  const std::vector<Breakpoint> all = std::exchange(breakpoints_, {});
  set_probe();
  Limits limits;
  limits.instructions = target;
  while (machine_.instructions() < target && !machine_.waits_for_key()) {
    if (machine_.run(limits, false)) break;
  }
  static_cast<void>(machine_.take_printed());
  breakpoints_ = all;
  set_probe();
  return {Kind::done, status()};
}

Answer Monitor::Inside::save(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw Wrong{"expected a file"};
  const auto done = host_.write(path, save_snapshot(description_.name, machine_));
  if (!done) throw Wrong{done.error().message};
  return {};
}

Answer Monitor::Inside::restore(std::string_view arguments) {
  const std::string path(take_part(arguments));
  if (path.empty()) throw Wrong{"expected a file"};
  const guests::run::Input input = file(path);
  const auto done = restore_snapshot(description_.name, machine_, input.bytes, path);
  if (!done) throw Wrong{done.error().message()};
  forget_past();
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
    if (last_stop_.name == "halt" && i + 1 < n) break;
  }
  return {Kind::done, text};
}

Answer Monitor::Inside::over(std::string_view arguments) {
  if (!arguments.empty()) throw Wrong{"expected nothing behind it"};
  const std::uint32_t pc = machine_.get(pc_);
  const auto instruction = machine_.instruction_at(pc);
  const std::string name = lower(instruction.text.substr(0, instruction.text.find_first_of(" \t")));
  const bool calls = description_.radix == 8 ? name == "jms" || name == "cal"
                                             : (name.front() == 'c' && name != "cma" && name != "cmc" && name != "cmp" &&
                                                name != "cpi") || name == "rst";
  if (!calls) return run({.instructions = 1});
  Breakpoint back;
  back.number = 0;
  back.first = back.last = (pc + instruction.words) % machine_.words();
  breakpoints_.push_back(back);
  set_probe();
  Answer answer = run({});
  breakpoints_.erase(std::find_if(breakpoints_.begin(), breakpoints_.end(),
                                  [](const Breakpoint& each) { return each.number == 0; }));
  set_probe();
  constexpr std::string_view own = "breakpoint 0\n";
  if (answer.text.starts_with(own)) answer.text.erase(0, own.size());
  return answer;
}

Answer Monitor::Inside::cycle(std::string_view arguments) {
  const std::uint64_t n = arguments.empty() ? 1 : count_of(arguments);
  constexpr std::uint64_t most = std::uint64_t{1} << 40;
  return run({.until = machine_.ticks() +
                       static_cast<std::int64_t>(std::min(n, most)) * description_.ticks_a_cycle});
}

Answer Monitor::Inside::resume(std::string_view arguments) {
  if (!arguments.empty()) throw Wrong{"expected nothing behind it"};
  return run({});
}

Answer Monitor::Inside::go(std::string_view arguments) {
  if (!arguments.empty()) machine_.start(address_of(arguments));
  return run({});
}

Answer Monitor::Inside::run_until(std::string_view arguments) {
  if (arguments.empty()) return run({});
  std::string_view rest = arguments;
  const std::string word = lower(take_part(rest));
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
  if (unit == "cycles" || unit == "cycle") return cycle(count);
  if (unit == "instructions" || unit == "instruction") return run({.instructions = count_of(count)});
  throw Wrong{fmt::format("found \"{}\", expected a time such as 20ms, N cycles or N instructions", rest)};
}

Answer Monitor::Inside::history(std::string_view arguments) {
  const std::uint64_t n = arguments.empty() ? 20 : count_of(arguments);
  std::string text;
  for (const Probe::Entry& entry : probe_.last(static_cast<std::size_t>(std::min<std::uint64_t>(n, Probe::history_length))))
    text += machine_.history_line(entry) + "\n";
  return {Kind::done, text.empty() ? "no instruction has been obeyed yet\n" : text};
}

// --- Descriptions ---

Answer Monitor::Inside::show(std::string_view arguments) {
  const std::string what = lower(arguments);
  std::string text;
  const auto is = [&what](std::string_view name) { return !what.empty() && name.starts_with(what); };
  if (is("registers")) {
    for (std::size_t n = 0; n < description_.registers.size(); ++n) text += register_text(n) + "\n";
  } else if (is("devices")) {
    for (const auto& line : machine_.device_lines()) text += fmt::format("{:<12} {}\n", line.label, line.text);
  } else if (is("time")) {
    text = fmt::format("{}, {} instructions\n", time_text(machine_.ticks()), machine_.instructions());
  } else if (is("breaks") || is("breakpoints")) {
    for (const Breakpoint& each : breakpoints_)
      text += fmt::format("{}: {}, passed {} times\n", each.number, each.text, each.passed);
    if (text.empty()) text = "no breakpoints\n";
  } else if (is("conditions")) {
    for (const auto& [name, holds] : machine_.conditions()) text += fmt::format("{:<12} {}\n", name, holds ? 1 : 0);
    if (text.empty()) text = "this machine has none\n";
  } else if (is("symbols")) {
    for (const auto& [name, value] : symbols_.all()) text += fmt::format("{:<16} {}\n", name, address(value));
    if (text.empty()) text = "no symbols; begin with a source file or --symbols FILE\n";
  } else {
    throw Wrong{fmt::format("found \"{}\", expected registers, devices, time, breaks, conditions or symbols", arguments)};
  }
  return {Kind::done, text};
}

// --- The world outside ---

Answer Monitor::Inside::attach(std::string_view arguments) {
  const std::string device = lower(take_part(arguments));
  if (device.empty() || arguments.empty()) throw Wrong{"expected DEVICE FILE, such as reader tape.rim"};
  const auto done = machine_.attach(device, file(std::string(take_part(arguments))));
  if (!done) throw Wrong{done.error().message};
  return {};
}

Answer Monitor::Inside::detach(std::string_view arguments) {
  const auto done = machine_.attach(lower(arguments), {});
  if (!done) throw Wrong{done.error().message};
  return {};
}

Answer Monitor::Inside::send(std::string_view arguments) {
  const auto keys = plain_text("send", take_part(arguments));
  if (!keys) throw Wrong{keys.error().message};
  keys_ += *keys;
  return {};
}

Answer Monitor::Inside::expect(std::string_view arguments) {
  const auto text = plain_text("expect", take_part(arguments));
  if (!text) throw Wrong{text.error().message};
  if (text->empty()) throw Wrong{"expected a text"};
  constexpr std::int64_t most_seconds = 60;
  const std::int64_t end = machine_.ticks() + most_seconds * machine_.ticks_a_second();
  Goal goal{.quiet = true};
  while (true) {
    show_printed();
    const std::size_t found = printed_.find(*text);
    if (found != std::string::npos) {
      printed_.erase(0, found + text->size());
      return {};
    }
    if (machine_.ticks() >= end || machine_.waits_for_key())
      return {Kind::failed, fmt::format("expect: not printed in {} s; printed since the last expect: \"{}\"\n",
                                        most_seconds, printed_)};
    goal.until = std::min(end, machine_.ticks() + machine_.ticks_a_second() / 50);
    const Answer answer = run(goal);
    if (!answer.text.empty() && printed_.find(*text) == std::string::npos) return {Kind::failed, answer.text};
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
    probe_.on_instruction = [this](const Probe::Entry& entry) { trace_ += machine_.history_line(entry) + "\n"; };
    return {};
  }
  probe_.on_instruction = nullptr;
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
  const std::string wanted = lower(arguments);
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
                        description_.radix == 8 ? "octal" : "hexadecimal");
  }
  return {Kind::done, text};
}

std::vector<std::string> Monitor::Inside::completions(std::string_view line, std::string_view begun) const {
  std::vector<std::string> names;
  const auto offer = [&](std::string_view name) {
    if (lower(name).starts_with(lower(begun))) names.emplace_back(name);
  };
  if (without_blanks(line).size() <= begun.size()) {
    for (const Verb& verb : verbs()) offer(verb.name);
    return names;
  }
  for (const auto& each : description_.registers) offer(lower(each.name));
  for (const auto& [name, holds] : machine_.conditions()) offer(name);
  for (const auto& [name, value] : symbols_.all()) offer(name);
  return names;
}

Monitor::Monitor(const MachineDescription& description, Machine& machine, const Limits& limits, Symbols symbols,
                 MonitorHost host)
    : inside_(std::make_unique<Inside>(description, machine, limits, std::move(symbols), std::move(host))) {}
Monitor::~Monitor() = default;

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
