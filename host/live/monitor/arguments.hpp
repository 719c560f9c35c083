// Parses the arguments of the monitor's verbs: counts, addresses, values, goals of a run, breakpoints. Throws base::Error.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "host/base/result.hpp"
#include "host/base/value_of.hpp"
#include "host/live/debugger.hpp"

namespace sightline::live::monitor {

// The line without its comment, which begins with a # outside quotes, at the beginning or after a blank.
[[nodiscard]] std::string_view without_comment(std::string_view line);
// The end of the first command of a line: a `;` outside quotes, or the end of the line.
[[nodiscard]] std::size_t end_of_command(std::string_view line);
// Removes the next word from `text` and returns it; blanks in quotes belong to the word.
std::string_view take_part(std::string_view& text);
// Error usage if a quote is not closed.
void reject_open_quotes(std::string_view text);

// Parses arguments with the symbols, registers and radix of a machine.
class Reader {
 public:
  explicit Reader(Debugger& debugger) : debugger_(debugger) {}

  // A count is decimal, independent of the radix of words.
  [[nodiscard]] static std::uint64_t count(std::string_view text);
  // An expression.
  [[nodiscard]] std::int64_t value(std::string_view text) const { return base::value_of(debugger_.evaluate(text)); }
  [[nodiscard]] std::uint32_t address(std::string_view text) const { return base::value_of(debugger_.address_of(text)); }
  // FIRST-LAST or one address. Split at a - that is followed by a valid expression.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> range(std::string_view text) const;
  // A number of cycles, in the machine's unit; 1 if the text is empty.
  [[nodiscard]] std::int64_t cycles(std::string_view text) const;
  // [within TIME], in the machine's unit; nullopt: nothing.
  [[nodiscard]] std::optional<std::int64_t> limit(std::string_view arguments) const;
  // until TIME | until EXPRESSION | for TIME | for N cycles | for N instructions; empty: no goal.
  [[nodiscard]] Goal goal(std::string_view arguments) const;
  // [ADDRESS | iot DEVICE | interrupt | when EXPRESSION | a condition of the machine] [if EXPRESSION] [count N] [log "TEXT"]
  [[nodiscard]] Breakpoint breakpoint(std::string_view arguments) const;
  // ADDRESS[-ADDRESS] | port N [r|w|rw] [value V] [if EXPRESSION] [count N] [log "TEXT"]
  [[nodiscard]] Breakpoint watchpoint(std::string_view arguments) const;

 private:
  // "0.5s", "20ms", "100us", in the machine's unit; nullopt: no such time.
  [[nodiscard]] std::optional<std::int64_t> time(std::string_view text) const;
  [[nodiscard]] Breakpoint parse_options(std::string_view arguments, Breakpoint breakpoint) const;

  Debugger& debugger_;
};

}  // namespace sightline::live::monitor
