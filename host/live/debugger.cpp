#include "host/live/debugger.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "host/base/text.hpp"
#include "host/live/console.hpp"
#include "host/live/snapshot.hpp"

namespace sightline::live {

using base::Done;
using machines::Limits;
using machines::Machine;
using machines::Probe;
using machines::Stop;

Debugger::Debugger(const machines::MachineDescription& description, Machine& machine, const Limits& limits,
                   Symbols symbols, RunHost host)
    : description_(description),
      machine_(machine),
      limits_(limits),
      symbols_(std::move(symbols)),
      host_(std::move(host)),
      past_(description.name, machine),
      key_codes_(description.radix == 8 ? KeyCodes::parity : KeyCodes::ascii),
      idle_loop_(machine),
      names_{description.radix, [this](std::string_view name) { return value_of(name); },
             [this](std::int64_t at) -> std::optional<std::int64_t> {
               if (at < 0 || at >= machine_.words()) return std::nullopt;
               return machine_.word(static_cast<std::uint32_t>(at));
             },
             [this](std::string_view name) { return reader_of(name); }},
      holds_([this](const std::string& condition) {
        const Expression* const expression = condition_of(condition);
        return expression == nullptr || expression->holds();
      }) {
  for (std::size_t n = 0; n < description.registers.size(); ++n)
    if (description.registers[n].name == "PC") pc_ = n;
}

// --- Texts ---

void Debugger::set_radix(int radix) {
  names_.radix = radix;
  conditions_.clear();
}

std::string Debugger::number_text(std::uint32_t value, unsigned bits) const {
  switch (radix()) {
    case 8: return fmt::format("{:0{}o}", value, (bits + 2) / 3);
    case 16: return fmt::format("{:0{}X}", value, (bits + 3) / 4);
    default: return fmt::format("{}", value);
  }
}

std::string Debugger::address(std::uint32_t value) const {
  return number_text(value, description_.address_bits);
}

std::string Debugger::word(std::uint32_t value) const {
  return number_text(value, description_.word_bits);
}

std::string Debugger::register_text(std::size_t number) const {
  const auto& each = description_.registers[number];
  return fmt::format("{} {}", each.name, number_text(machine_.get(number), each.bits));
}

std::string Debugger::instruction_text(std::uint32_t at) const {
  std::string text = symbols_.near(at);
  if (!text.empty()) text += ": ";
  text += machine_.instruction_at(at).text;
  const std::string_view source = symbols_.source(at);
  return source.empty() ? text : fmt::format("{}  ; {}", text, source);
}

std::vector<std::uint32_t> Debugger::instructions_before(std::uint32_t at, std::size_t count) const {
  constexpr std::uint32_t longest = 3, slack = 16;
  const auto wanted = static_cast<std::uint32_t>(std::min<std::size_t>(count, at));
  const std::uint32_t earliest = at - std::min(at, longest * wanted + slack);
  std::vector<unsigned> words;  // length of the instruction that would begin at each address
  for (std::uint32_t place = earliest; place < at; ++place) words.push_back(std::max(1U, machine_.instruction_at(place).words));
  // Begins at the farthest address from which disassembly reaches `at`: wrong starts soon meet the true instructions.
  std::vector<std::uint32_t> starts;
  for (std::uint32_t begin = earliest; begin < at && starts.size() < wanted; ++begin) {
    std::vector<std::uint32_t> found;
    std::uint32_t place = begin;
    for (; place < at; place += words[place - earliest]) found.push_back(place);
    if (place == at && found.size() > starts.size()) starts = std::move(found);
  }
  if (starts.size() > count) starts.erase(starts.begin(), starts.end() - static_cast<std::ptrdiff_t>(count));
  return starts;
}

std::string Debugger::time_text(std::int64_t ticks) const {
  const std::int64_t second = machine_.ticks_per_second();
  const auto nanoseconds =
      static_cast<std::int64_t>(static_cast<double>(ticks % second) * (1e9 / static_cast<double>(second)));
  return fmt::format("{}.{:09} s", ticks / second, nanoseconds);
}

std::string Debugger::status() const {
  std::string text = fmt::format("{} {}", address(pc()), instruction_text(pc()));
  for (std::size_t n = 0; n < description_.registers.size(); ++n) {
    if (n != pc_ && description_.registers[n].in_dump) text += fmt::format("  {}", register_text(n));
  }
  return fmt::format("{}  {}\n", text, time_text(machine_.ticks()));
}

// --- Values ---

std::optional<std::size_t> Debugger::register_named(std::string_view name) const {
  for (std::size_t n = 0; n < description_.registers.size(); ++n)
    if (base::lower_case(description_.registers[n].name) == base::lower_case(name)) return n;
  return std::nullopt;
}

std::optional<Debugger::Pair> Debugger::pair_named(std::string_view name) const {
  if (description_.radix != 16) return std::nullopt;
  const std::string lowered = base::lower_case(name);
  for (const std::string_view pair : {"bc", "de", "hl", "af"}) {
    if (lowered != pair) continue;
    const auto high = register_named(pair.substr(0, 1)), low = register_named(pair.substr(1));
    if (high && low) return Pair{*high, *low};
  }
  return std::nullopt;
}

std::uint32_t Debugger::pair_value(const Pair& pair) const {
  return machine_.get(pair.high) << description_.registers[pair.low].bits | machine_.get(pair.low);
}

std::uint32_t Debugger::most_of(const Pair& pair) const {
  return (std::uint32_t{1} << (description_.registers[pair.high].bits + description_.registers[pair.low].bits)) - 1;
}

std::string Debugger::pair_text(const Pair& pair) const {
  const auto& high = description_.registers[pair.high];
  const auto& low = description_.registers[pair.low];
  return fmt::format("{}{} {}", high.name, low.name, number_text(pair_value(pair), high.bits + low.bits));
}

std::optional<std::int64_t> Debugger::value_of(std::string_view name) const {
  if (const auto n = register_named(name)) return machine_.get(*n);
  const std::string lowered = base::lower_case(name);
  if (lowered == "time") return machine_.ticks();
  if (lowered == "instructions") return static_cast<std::int64_t>(machine_.instructions());
  for (const auto& [condition, holds] : machine_.conditions())
    if (condition == lowered) return holds ? 1 : 0;
  if (const auto pair = pair_named(name)) return pair_value(*pair);
  if (const auto value = symbols_.value(name)) return *value;
  return std::nullopt;
}

// Empty for symbols, because their values do not change.
std::function<std::int64_t()> Debugger::reader_of(std::string_view name) const {
  if (const auto n = register_named(name)) return [this, n = *n] { return std::int64_t{machine_.get(n)}; };
  if (const auto pair = pair_named(name); pair && !is_state(name)) return [this, of = *pair] { return std::int64_t{pair_value(of)}; };
  const std::string lowered = base::lower_case(name);
  if (lowered == "time") return [this] { return machine_.ticks(); };
  if (lowered == "instructions") return [this] { return static_cast<std::int64_t>(machine_.instructions()); };
  const auto conditions = machine_.conditions();
  for (std::size_t n = 0; n < conditions.size(); ++n)
    if (conditions[n].first == lowered) return [this, n] { return std::int64_t{machine_.condition(n) ? 1 : 0}; };
  return nullptr;
}

const Expression* Debugger::condition_of(const std::string& text) {
  auto known = conditions_.find(text);
  if (known == conditions_.end()) {
    auto expression = Expression::read(text, names_);
    known = conditions_.emplace(text, expression ? std::optional<Expression>(std::move(*expression)) : std::nullopt).first;
  }
  return known->second ? &*known->second : nullptr;
}

void Debugger::watch_conditions(const std::string& goal) {
  std::vector<std::pair<const Expression*, bool>> all;
  if (!goal.empty()) all.emplace_back(condition_of(goal), false);
  for (const Breakpoint& each : breakpoints_.all())
    if (each.kind == Breakpoint::Kind::condition) all.emplace_back(condition_of(each.condition), each.was_true);
  machine_.probe()->condition_changed = [all = std::move(all)] {
    for (const auto& [expression, was_true] : all)
      if ((expression == nullptr || expression->holds()) != was_true) return true;
    return false;
  };
}

void Debugger::end_at_times(const std::string& goal, Limits& limits) {
  const auto end_at_times_of = [&](const std::string& condition) {
    const Expression* const expression = condition_of(condition);
    const auto points = expression == nullptr ? std::nullopt : expression->change_points();
    if (!points) return;
    for (const std::string& name : expression->names())
      if (base::lower_case(name) != "time") return;
    for (const std::int64_t at : *points)
      if (at > machine_.ticks()) limits.until = std::min(limits.until, at);
  };
  if (!goal.empty()) end_at_times_of(goal);
  for (const Breakpoint& each : breakpoints_.all())
    if (each.kind == Breakpoint::Kind::condition) end_at_times_of(each.condition);
}

bool Debugger::is_state(std::string_view name) const {
  const std::string lowered = base::lower_case(name);
  if (lowered == "time" || lowered == "instructions") return true;
  const auto conditions = machine_.conditions();
  return std::any_of(conditions.begin(), conditions.end(), [&lowered](const auto& each) { return each.first == lowered; });
}

std::vector<std::string> Debugger::names() const {
  std::vector<std::string> names{"time", "instructions"};
  for (const auto& each : description_.registers) names.push_back(base::lower_case(each.name));
  for (const auto& [name, holds] : machine_.conditions()) names.emplace_back(name);
  for (const auto& [name, value] : symbols_.all()) names.push_back(name);
  return names;
}

base::Result<std::int64_t> Debugger::evaluate(std::string_view expression) const {
  return live::evaluate(expression, names_);
}

base::Result<std::uint32_t> Debugger::address_of(std::string_view expression) const {
  const auto value = evaluate(expression);
  if (!value) return value.error();
  if (*value < 0 || *value >= machine_.words()) {
    return base::bad_input(fmt::format("found address {}, expected one in {}, {}-{}", expression, description_.memory_name,
                                  address(0), address(machine_.words() - 1)));
  }
  return static_cast<std::uint32_t>(*value);
}

std::string Debugger::value_text(std::int64_t value) const {
  const auto bits = static_cast<std::uint64_t>(value);
  std::string text = radix() == 16 ? fmt::format("{:X} = ", bits) : radix() == 8 ? fmt::format("{:o} = ", bits) : std::string();
  text += fmt::format("{}.", value);
  const std::int64_t sign = std::int64_t{1} << (description_.word_bits - 1);
  if (value >= sign && value < 2 * sign) text += fmt::format(" = {}. as a word with a sign", value - 2 * sign);
  if (value >= 0 && value < machine_.words()) {
    const std::string near = symbols_.near(static_cast<std::uint32_t>(value));
    if (!near.empty()) text += " = " + near;
  }
  return text;
}

base::Result<std::string> Debugger::log_text(std::string_view text) const {
  std::string line;
  while (!text.empty()) {
    const char next = text.front();
    text.remove_prefix(1);
    if (next != '{' && next != '}') {
      line += next;
    } else if (text.starts_with(next)) {
      line += next;
      text.remove_prefix(1);
    } else {
      const std::size_t end = text.find('}');
      if (next == '}' || end == std::string_view::npos) {
        return base::Error{.found = fmt::format("found {} alone", next),
                           .expected = "an expression in braces, such as {pc}; {{ and }} print a brace"};
      }
      const auto expression = Expression::read(text.substr(0, end), names_);
      if (!expression) return expression.error();
      const auto value = expression->value();
      const bool fits = value && *value >= 0 && *value < std::int64_t{1} << std::max(description_.word_bits, description_.address_bits);
      line += !value ? "(" + value.error().message() + ")"
              : !fits ? fmt::format("{}.", *value)
              : *value < std::int64_t{1} << description_.word_bits ? word(static_cast<std::uint32_t>(*value))
                                                                   : address(static_cast<std::uint32_t>(*value));
      text.remove_prefix(end + 1);
    }
  }
  return line;
}

// --- Changes ---

void Debugger::put(std::uint32_t at, std::uint32_t word) {
  forget_run();
  machine_.put(at, word);
  past_.changed();
}

void Debugger::set(std::size_t register_number, std::uint32_t value) {
  forget_run();
  machine_.set(register_number, value);
  past_.changed();
}

void Debugger::set(const Pair& pair, std::uint32_t value) {
  const unsigned bits = description_.registers[pair.low].bits;
  set(pair.high, value >> bits);
  set(pair.low, value & ((std::uint32_t{1} << bits) - 1));
}

void Debugger::start(std::uint32_t at) {
  forget_run();
  machine_.start(at);
  past_.changed();
}

void Debugger::reset() {
  forget_run();
  machine_.reset();
  past_.changed();
}

base::Result<Done> Debugger::put_instruction(std::uint32_t at, std::string_view text) {
  std::string source;
  machines::Arguments options(description_.assembler.options);
  if (!dialect_.empty()) options.value("--dialect").text = dialect_;
  if (dialect_ == "bell") {
    source = "..=0\n";
    for (const auto& [name, value] : symbols_.all()) source += fmt::format("{}=0{:o}\n", name, value);
    source += fmt::format(".=0{:o}\n {}\n", at, text);
  } else if (description_.radix == 8) {
    for (const auto& [name, value] : symbols_.all()) source += fmt::format("{}={:o}\n", name, value);
    source += fmt::format("{:o}/\n\t{}\n", at, text);
  } else {
    for (const auto& [name, value] : symbols_.all()) source += fmt::format("{}\tEQU 0{:X}H\n", name, value);
    source += fmt::format("\tORG 0{:X}H\n\t{}\n", at, text);
  }
  const std::array sources{assembler::SourceFile{"deposit", source}};
  const auto assembled = description_.assembler.assemble(sources, options, {});
  if (!assembled) return base::bad_input(assembled.error().message());
  for (const auto& diagnostic : assembled->diagnostics) {
    if (diagnostic.severity == assembler::Severity::error)
      return base::bad_input(fmt::format("found {}, expected {}", diagnostic.found, diagnostic.expected));
  }
  for (const auto& [where, value] : assembled->program.words) {
    if (where < machine_.words()) put(where, value);
  }
  return Done{};
}

// --- Running ---

void Debugger::type_next() {
  if (keys_.empty() || !machine_.wants_key()) return;
  machine_.type(code_of_key(key_codes_, keys_.front()));
  keys_.erase(0, 1);
}

void Debugger::show_printed() {
  const std::string text = shown_text(machine_.take_printed());
  if (text.empty()) return;
  printed_ += text;
  host_.print(text);
}

void Debugger::log(const std::string& text) {
  const auto line = log_text(text);
  const std::string shown = line ? *line : line.error().message();
  show_printed();
  if (host_.log) return host_.log(shown);
  host_.print(shown + "\n");
}

Debugger::Reason Debugger::reason_of(const Breakpoints::Hit& hit) const {
  const int number = hit.breakpoint.number;
  if (!hit.event) return {number, fmt::format("breakpoint {}: {}", number, hit.breakpoint.condition)};
  const Probe::Event& event = *hit.event;
  std::string text = fmt::format("breakpoint {}", number);
  switch (hit.breakpoint.kind) {
    case Breakpoint::Kind::memory:
      text += fmt::format(": {} {} {} {}", address(event.address), symbols_.near(event.address),
                          event.kind == Probe::Kind::read ? "read, it is" : "written with", word(event.value));
      break;
    case Breakpoint::Kind::port:
      text += description_.radix == 8
                  ? fmt::format(": IOT {:06o}", event.value)
                  : fmt::format(": port {:02X} {} {:02X}", event.address,
                                event.kind == Probe::Kind::port_read ? "read as" : "written with", event.value);
      break;
    case Breakpoint::Kind::interrupt: text += fmt::format(": interrupt before {}", address(event.address)); break;
    case Breakpoint::Kind::execution:
    case Breakpoint::Kind::condition: break;
  }
  return {number, text};
}

// Called when the machine has been changed from outside.
void Debugger::forget_run() {
  inside_.reset();
  idle_loop_.forget();
}

Halted Debugger::run(const Goal& goal) {
  inside_.reset();
  Limits limits = limits_;
  const std::uint64_t begun = machine_.instructions();
  if (goal.instructions < limits.instructions - std::min(begun, limits.instructions))
    limits.instructions = begun + goal.instructions;
  limits.until = std::min(limits.until, goal.until);
  const bool conditions = !goal.condition.empty() || breakpoints_.has_conditions();
  Probe& probe = *machine_.probe();
  breakpoints_.mark(probe);
  probe.wants = [this](const Probe::Event& event) { return breakpoints_.wants(event); };
  probe.resume();
  std::optional<Reason> reason;
  const Breakpoints::Log log = [this](const std::string& text) { this->log(text); };
  const bool for_ever = goal.instructions == Goal{}.instructions && goal.until == Goal{}.until && goal.condition.empty();
  const bool may_wait = for_ever || goal.ends_in_waiting;
  Stop stop{machines::stopped_by_probe, {}};
  while (!reason && stop.name == machines::stopped_by_probe) {
    type_next();
    past_.remember();
    if (conditions) watch_conditions(goal.condition);
    Limits part = limits;
    part.instructions = std::min(limits.instructions, machine_.instructions() + past_.instructions_apart());
    if (conditions) end_at_times(goal.condition, part);
    constexpr std::int64_t looks_for_keys_a_second = 50;
    if (!keys_.empty())
      part.until = std::min(part.until, machine_.ticks() + machine_.ticks_per_second() / looks_for_keys_a_second);
    const std::size_t printed = printed_.size();
    std::optional<Stop> early;
    const bool only_send_types = may_wait && !host_.person_types && keys_.empty();
    if (only_send_types && machine_.wants_key()) {
      if (part.until - machine_.ticks() > machine_.ticks_per_second()) part.until = machine_.ticks() + machine_.ticks_per_second();
      early = idle_loop_.look(part);
    }
    stop = early ? *early : host_.run(machine_, part, [this](std::string_view text) { printed_ += text; });
    const bool part_done = (stop.at_until && machine_.ticks() < limits.until) ||
                           (stop.name == "instruction_limit" && machine_.instructions() < limits.instructions);
    const bool key_due = stop.name == end_of_input && !keys_.empty();
    if (part_done || key_due) stop = {machines::stopped_by_probe, {}};
    if (printed_.size() != printed || !keys_.empty()) idle_loop_.forget();
    const bool could_run_on = stop.name == machines::stopped_by_probe || stop.at_until || stop.name == "instruction_limit";
    if (could_run_on && probe.events().empty() && only_send_types) {
      if (idle_loop_.waits_for_ever()) {
        stop = {end_of_input, std::string(no_key)};
      } else if (host_.nobody_interrupts && idle_loop_.waits_in_vain(host_.patience)) {
        stop = {end_of_input, fmt::format("the program has only waited for a key for {} s of its time, and there is none: `send` types "
                                          "keys, and `run for TIME` runs on without",
                                          host_.patience)};
      }
    }
    if (stop.name == machines::stopped_by_probe && host_.interrupted()) stop = {machines::interrupted, {}};
    if (const auto hit = breakpoints_.find_hit(probe.events(), holds_, log)) reason = reason_of(*hit);
    probe.resume();
    if (conditions) {
      if (const auto hit = breakpoints_.find_true_condition(holds_, log); hit && !reason) reason = reason_of(*hit);
      if (!reason && !goal.condition.empty() && holds_(goal.condition)) reason = Reason{0, goal.condition};
    }
  }
  probe.condition_changed = nullptr;
  probe.wants = nullptr;
  show_printed();
  if (reason) {
    const auto why = reason->breakpoint == 0 ? Halted::Why::goal : Halted::Why::breakpoint;
    return {why, reason->breakpoint, reason->text, stop};
  }
  const bool goal_reached = (stop.name == "instruction_limit" && machine_.instructions() < limits_.instructions) ||
                            (stop.at_until && machine_.ticks() < limits_.until);
  if (goal_reached) return {Halted::Why::goal, 0, {}, stop};
  // The operator's action to continue cannot be repeated from a snapshot.
  past_.changed();
  last_stop_ = stop;
  std::string name(stop.name);
  std::replace(name.begin(), name.end(), '_', ' ');
  std::string text = "stopped by " + name;
  if (!stop.complaint.empty()) text += "\n" + stop.complaint;
  if (machine_.halted() && machine_.instructions() == begun) text += "\nonly an interrupt, `go ADDRESS`, `start` or `reset` ends it";
  return {Halted::Why::machine, 0, text, stop};
}

base::Result<Debugger::Cycled> Debugger::run_cycles(std::int64_t ticks) {
  const std::int64_t from = inside_ && inside_->boundary == machine_.ticks() ? inside_->at : machine_.ticks();
  const std::int64_t at = from + std::min(ticks, std::numeric_limits<std::int64_t>::max() - from);
  const std::uint64_t begun = machine_.instructions();
  Cycled cycled{run({.until = at}), machine_.ticks()};
  const bool came = cycled.halted.why == Halted::Why::goal && cycled.halted.stop.at_until;
  if (!came || machine_.ticks() <= at || machine_.instructions() == begun) return cycled;
  auto cycles = past_.go_back_into_instruction();
  if (!cycles) return cycles.error();
  inside_ = {machine_.ticks(), at};
  cycled.at = at;
  cycled.cycles = std::move(*cycles);
  return cycled;
}

std::uint32_t Debugger::behind(std::uint32_t at, std::uint32_t words) const {
  return (at + words) % machine_.words();
}

// A subroutine of the PDP-7 may return to an address after arguments that follow its call. One of the 8080 has returned when the
// stack pointer has its old value again: it may have called itself.
Halted Debugger::run_to_return(const Frame& frame) {
  constexpr std::uint32_t most_arguments = 8;
  Breakpoint there;
  there.first = there.last = frame.behind;
  if (description_.radix == 8) {
    there.last = std::min(frame.behind + most_arguments, machine_.words() - 1);
    if (frame.entry > frame.behind) there.last = std::min(there.last, frame.entry - 1);
    there.last = std::max(there.last, there.first);
  } else if (const auto sp = value_of("sp")) {
    there.condition = fmt::format("((sp-0x{0:X})&0xFFFF)>0 && ((sp-0x{0:X})&0xFFFF)<0x8000", *sp);
  }
  const int number = breakpoints_.add(there);
  Halted halted = run({});
  static_cast<void>(breakpoints_.remove(number));
  if (halted.breakpoint == number) halted = {Halted::Why::goal, 0, {}, halted.stop};
  return halted;
}

Halted Debugger::step_over() {
  const auto instruction = machine_.instruction_at(pc());
  std::uint32_t word = 0;
  for (std::uint32_t n = instruction.words; n-- > 0;)
    word = word << description_.word_bits | machine_.word(behind(pc(), n));
  if (machine_.flow_of(word) != Machine::Flow::call) return run({.instructions = 1});
  const std::uint32_t at = pc();
  const std::uint32_t next = behind(at, instruction.words);
  Halted halted = run({.instructions = 1});
  const bool called = pc() != next;
  if (halted.why != Halted::Why::goal || !called) return halted;
  return run_to_return({at, pc(), next});
}

base::Result<Halted> Debugger::step_out() {
  const std::vector<Frame> frames = stack();
  if (frames.empty()) return base::bad_input("found no subroutine that was called and not left in the last instructions");
  return run_to_return(frames.front());
}

// --- The past ---

base::Result<Done> Debugger::back(std::uint64_t instructions) {
  forget_run();
  const std::uint64_t reach = past_.reach();
  if (instructions > reach) {
    return base::bad_input(fmt::format("found {} instructions, expected at most {}: the past reaches no further", instructions,
                                  reach));
  }
  return past_.go_back_to(machine_.instructions() - instructions);
}

base::Result<std::optional<bool>> Debugger::back_to_breakpoint() {
  show_printed();
  return past_.go_back_to_event([this](Probe& probe) { breakpoints_.mark(probe, true); }, host_.interrupted);
}

std::vector<Past::Entry> Debugger::history(std::size_t n) {
  show_printed();
  return past_.history(n);
}

std::optional<Past::Writer> Debugger::last_writer(std::uint32_t at) {
  show_printed();
  return past_.last_writer(at, pc_, host_.interrupted);
}

std::vector<Frame> Debugger::stack() {
  const std::vector<Past::Entry> entries = history(Past::most_history);
  std::vector<Frame> frames;
  for (std::size_t n = 0; n < entries.size(); ++n) {
    const Past::Entry& entry = entries[n];
    const std::uint32_t next = n + 1 < entries.size() ? entries[n + 1].pc : pc();
    const std::uint32_t words = entry.supplied ? 0 : machine_.instruction_at(entry.pc).words;
    if (next == behind(entry.pc, words)) continue;
    switch (machine_.flow_of(entry.word)) {
      case Machine::Flow::call: frames.push_back({entry.pc, next, behind(entry.pc, words)}); break;
      case Machine::Flow::leave: {
        if (description_.radix != 8) {
          if (!frames.empty()) frames.pop_back();
          break;
        }
        // JMP I through the word in which JMS stored the return address also leaves all subroutines that were called since.
        const auto left = std::find_if(frames.rbegin(), frames.rend(), [&entry](const Frame& frame) {
          return frame.entry == entry.address + 1;
        });
        if (left != frames.rend()) frames.erase(left.base() - 1, frames.end());
        break;
      }
      case Machine::Flow::plain: break;
    }
  }
  std::reverse(frames.begin(), frames.end());
  return frames;
}

machines::Bytes Debugger::save() {
  return save_snapshot(description_.name, machine_);
}

base::Result<Done> Debugger::restore(std::span<const std::uint8_t> snapshot, const std::string& file) {
  auto done = restore_snapshot(description_.name, machine_, snapshot, file);
  forget_run();
  if (done) past_.forget();
  return done;
}

}  // namespace sightline::live
