#include "host/live/monitor/arguments.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "host/base/number.hpp"
#include "host/base/text.hpp"

namespace sightline::live::monitor {

using base::without_blanks;
using machines::Probe;

namespace {

// The position of `word` as a separate word in the text, or npos.
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

}  // namespace

std::string_view without_comment(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == '#' && !quoted && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t' || line[i - 1] == ';')) return line.substr(0, i);
  }
  return line;
}

void reject_open_quotes(std::string_view text) {
  if (std::count(text.begin(), text.end(), '"') % 2 != 0)
    throw base::usage_error(fmt::format("found {} without a \" at its end, expected one; inside a text a quote is \\x22", text.substr(text.rfind('"'))));
}

std::size_t end_of_command(std::string_view text) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (text[i] == ';' && !quoted) return i;
  }
  return text.size();
}

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

std::uint64_t Reader::count(std::string_view text) {
  const auto count = base::count_number(text);
  if (!count) throw base::usage_error(fmt::format("found \"{}\", expected a count, decimal", text));
  return *count;
}

std::pair<std::uint32_t, std::uint32_t> Reader::range(std::string_view text) const {
  std::size_t depth = 0;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '(' || text[i] == '[') ++depth;
    if ((text[i] == ')' || text[i] == ']') && depth > 0) --depth;
    if (text[i] != '-' || depth != 0) continue;
    const std::uint32_t first = address(text.substr(0, i));
    const std::uint32_t last = address(text.substr(i + 1));
    if (last < first) throw base::usage_error(fmt::format("found {}, expected FIRST-LAST with the smaller address first", text));
    return {first, last};
  }
  const std::uint32_t at = address(text);
  return {at, at};
}

std::int64_t Reader::cycles(std::string_view text) const {
  constexpr std::uint64_t most = std::uint64_t{1} << 40;
  return static_cast<std::int64_t>(std::min(text.empty() ? 1 : count(text), most)) * debugger_.description().ticks_per_cycle;
}

std::optional<std::int64_t> Reader::time(std::string_view text) const {
  double unit = 0;
  for (const auto& [name, seconds] :
       {std::pair<std::string_view, double>{"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}, {"s", 1.0}}) {
    if (unit == 0 && text.ends_with(name)) {
      unit = seconds;
      text.remove_suffix(name.size());
    }
  }
  const auto number = base::fixed_number(text, 0, 1e12);
  if (unit == 0 || !number) return std::nullopt;
  return static_cast<std::int64_t>(std::llround(
      std::min(*number * unit * static_cast<double>(debugger_.machine().ticks_per_second()), 4e18)));
}

std::optional<std::int64_t> Reader::limit(std::string_view arguments) const {
  if (arguments.empty()) return std::nullopt;
  std::string_view rest = arguments;
  const std::string word = base::lower_case(take_part(rest));
  const auto limit = time(rest);
  if (word != "within" || !limit) throw base::usage_error(fmt::format("found \"{}\", expected within TIME, such as within 90s", arguments));
  return limit;
}

Goal Reader::goal(std::string_view arguments) const {
  if (arguments.empty()) return {};
  std::string_view rest = arguments;
  const std::string word = base::lower_case(take_part(rest));
  if ((word != "until" && word != "for") || rest.empty())
    throw base::usage_error(fmt::format("found \"{}\", expected until or for with a time, an expression or a count", arguments));
  if (const auto ticks = time(rest)) return {.until = word == "for" ? debugger_.machine().ticks() + *ticks : *ticks};
  if (word == "until") {
    static_cast<void>(value(rest));
    return {.condition = std::string(rest)};
  }
  std::string_view unit = rest;
  const std::string_view number = take_part(unit);
  if (unit == "cycles" || unit == "cycle") return {.until = debugger_.machine().ticks() + cycles(number)};
  if (unit == "instructions" || unit == "instruction") return {.instructions = count(number)};
  throw base::usage_error(fmt::format("found \"{}\", expected a time such as 20ms, N cycles or N instructions", rest));
}

Breakpoint Reader::parse_options(std::string_view arguments, Breakpoint breakpoint) const {
  breakpoint.text = std::string(arguments);
  std::string rest(arguments);
  const auto take_tail = [&rest](std::string_view name) -> std::optional<std::string> {
    const std::size_t at = find_word(rest, name);
    if (at == std::string::npos) return std::nullopt;
    std::string tail(without_blanks(std::string_view(rest).substr(at + name.size())));
    rest.erase(at);
    return tail;
  };
  // A text may contain the other words: it is removed first.
  if (const std::size_t quote = rest.find('"'); quote != std::string::npos) {
    constexpr std::string_view word = "log";
    const std::string before(without_blanks(std::string_view(rest).substr(0, quote)));
    const std::string place(without_blanks(std::string_view(before).substr(0, before.size() - std::min(word.size(), before.size()))));
    if (!before.ends_with(word) || (before.size() > word.size() && before[before.size() - word.size() - 1] != ' '))
      throw base::usage_error(fmt::format("found {}, expected log before a text in quotes", rest.substr(quote)));
    std::string_view tail = std::string_view(rest).substr(quote);
    breakpoint.log = take_part(tail);
    if (breakpoint.log.empty()) throw base::usage_error("expected log \"TEXT\" with a text");
    static_cast<void>(base::value_of(debugger_.log_text(breakpoint.log)));
    rest = place + " " + std::string(tail);
  }
  if (const auto number = take_tail("count")) breakpoint.count = base::value_of(read_hit_count(*number));
  if (const auto condition = take_tail("if")) {
    breakpoint.condition = *condition;
    if (breakpoint.condition.empty()) throw base::usage_error("expected an expression behind `if`");
  }
  if (const auto word = take_tail("value")) breakpoint.value = static_cast<std::uint32_t>(value(*word));
  if (!breakpoint.condition.empty()) static_cast<void>(value(breakpoint.condition));
  std::string_view what = rest;
  const std::string first = base::lower_case(take_part(what));
  if (breakpoint.kind == Breakpoint::Kind::memory) {
    if (first.empty()) throw base::usage_error("expected an address, FIRST-LAST or port N");
    std::string place = first;
    if (first == "port" || first == "iot") {
      breakpoint.kind = Breakpoint::Kind::port;
      breakpoint.access = debugger_.description().radix == 8 ? Probe::executed : Probe::is_read | Probe::is_written;
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
      throw base::usage_error(fmt::format("found \"{}\", expected r, w, rw, value, if, count or log", how));
    }
    if (!what.empty()) throw base::usage_error(fmt::format("found \"{}\", expected value, if, count or log \"TEXT\"", what));
    if (breakpoint.kind == Breakpoint::Kind::port) {
      const std::int64_t number = value(place);
      if (number < 0 || number >= static_cast<std::int64_t>(debugger_.machine().probe()->ports()))
        throw base::usage_error(fmt::format("found {} {}, expected 0 to {}", debugger_.description().radix == 8 ? "device" : "port", place,
                                debugger_.word(static_cast<std::uint32_t>(debugger_.machine().probe()->ports()) - 1)));
      breakpoint.first = breakpoint.last = static_cast<std::uint32_t>(number);
      if (debugger_.description().radix == 8) breakpoint.access = Probe::executed;
    } else {
      std::tie(breakpoint.first, breakpoint.last) = range(place);
    }
    return breakpoint;
  }
  if (first == "interrupt") {
    if (!what.empty()) throw base::usage_error(fmt::format("found \"{}\" behind interrupt, expected if, count or nothing", what));
    breakpoint.kind = Breakpoint::Kind::interrupt;
  } else if (first == "when") {
    breakpoint.kind = Breakpoint::Kind::condition;
    breakpoint.condition = std::string(what);
    if (breakpoint.condition.empty()) throw base::usage_error("expected an expression behind `when`");
    breakpoint.was_true = value(breakpoint.condition) != 0;
  } else if (first == "iot" || first == "port") {
    return parse_options("port " + std::string(what), [&] {
      Breakpoint port = breakpoint;
      port.kind = Breakpoint::Kind::memory;
      return port;
    }());
  } else {
    const auto conditions = debugger_.machine().conditions();
    const bool is_condition = std::any_of(conditions.begin(), conditions.end(),
                                          [&first](const auto& each) { return each.first == first; });
    if (is_condition) return parse_options("when " + rest, breakpoint);
    if (!what.empty()) throw base::usage_error(fmt::format("found \"{}\" behind {}, expected if, count or log \"TEXT\"", what, first));
    breakpoint.first = breakpoint.last = first.empty() ? debugger_.pc() : address(first);
  }
  return breakpoint;
}

Breakpoint Reader::breakpoint(std::string_view arguments) const {
  Breakpoint breakpoint = parse_options(arguments, {});
  breakpoint.text = std::string(arguments);
  return breakpoint;
}

Breakpoint Reader::watchpoint(std::string_view arguments) const {
  Breakpoint of_memory;
  of_memory.kind = Breakpoint::Kind::memory;
  of_memory.access = Probe::is_written;
  Breakpoint breakpoint = parse_options(arguments, of_memory);
  breakpoint.text = "watch " + std::string(arguments);
  return breakpoint;
}

}  // namespace sightline::live::monitor
