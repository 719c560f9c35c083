// The words of a command, read as the verbs of the monitor want them: counts, addresses, values, goals of a run, breakpoints. What cannot
// be read throws base::Error.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "host/base/result.hpp"
#include "host/base/value_of.hpp"
#include "host/live/debugger.hpp"

namespace sightline::live::monitor {

// The line up to a comment: a # outside quotes, at the beginning or behind a blank.
[[nodiscard]] std::string_view without_comment(std::string_view line);
// Where the first command of a line ends: at a `;` outside quotes, or at the end.
[[nodiscard]] std::size_t end_of_command(std::string_view line);
// The next word; between quotes blanks belong to the word. `text` is left at what follows.
std::string_view take_part(std::string_view& text);
// A word in quotes that do not end.
void refuse_open_quotes(std::string_view text);

// Reads by the symbols, registers and radix of a machine.
class Reader {
 public:
  explicit Reader(Debugger& debugger) : debugger_(debugger) {}

  // A count is decimal, whatever the radix of words is.
  [[nodiscard]] static std::uint64_t count(std::string_view text);
  // An expression.
  [[nodiscard]] std::int64_t value(std::string_view text) const { return base::value_of(debugger_.evaluate(text)); }
  [[nodiscard]] std::uint32_t address(std::string_view text) const { return base::value_of(debugger_.address_of(text)); }
  // FIRST-LAST or one address; at a - that is followed by an expression of its own.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> range(std::string_view text) const;
  // So many cycles, in the machine's unit; 1 if the text is empty.
  [[nodiscard]] std::int64_t cycles(std::string_view text) const;
  // until TIME | until EXPRESSION | for TIME | for N cycles | for N instructions; nothing: no goal.
  [[nodiscard]] Goal goal(std::string_view arguments) const;
  // [ADDRESS | iot DEVICE | interrupt | when EXPRESSION | a condition of the machine] [if EXPRESSION] [count N]
  [[nodiscard]] Breakpoint breakpoint(std::string_view arguments) const;
  // ADDRESS[-ADDRESS] | port N [r|w|rw] [value V] [if EXPRESSION] [count N]
  [[nodiscard]] Breakpoint watchpoint(std::string_view arguments) const;

 private:
  [[nodiscard]] Breakpoint parsed(std::string_view arguments, Breakpoint breakpoint) const;

  Debugger& debugger_;
};

}  // namespace sightline::live::monitor
