// Texts put together piece by piece. fmt's own format_to and join do the same, but each source that calls
// them compiles all of fmt's formatting again (g++ 12: five seconds); here it is compiled once.
#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>

namespace sightline::base {

void append_formatted(std::string& text, fmt::string_view format, fmt::format_args arguments);

// Writes at the end of `text` what fmt::format would return.
template <class... Arguments>
void append(std::string& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  append_formatted(text, format, fmt::make_format_args(arguments...));
}

// The texts or numbers of a range, with `separator` between them.
template <class Range>
[[nodiscard]] std::string joined(const Range& range, std::string_view separator) {
  std::string text;
  bool first = true;
  for (const auto& each : range) {
    append(text, "{}{}", first ? std::string_view() : separator, each);
    first = false;
  }
  return text;
}

// Without the byte-order mark of UTF-8 (EF BB BF), which some editors write before a text.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);
// Whether it begins with the byte-order mark of UTF-16 or UTF-32: a text that no reader takes.
[[nodiscard]] bool begins_as_utf_16(std::string_view text);
// Without blanks, tabs and line ends at both ends.
[[nodiscard]] std::string_view without_blanks(std::string_view text);
// What comes before the next line end, or all; `text` goes on behind it.
std::string_view take_line(std::string_view& text);
// The first word, up to a blank; `text` goes on behind the blanks that follow it.
std::string_view take_word(std::string_view& text);
// Of ASCII.
[[nodiscard]] std::string lower_case(std::string_view text);
// As one word of a shell's command line: in single quotes if it has to be.
[[nodiscard]] std::string shell_word(std::string_view text);

}  // namespace sightline::base
