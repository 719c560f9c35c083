// Builds and splits texts. append() and joined() replace fmt::format_to and fmt::join, because each source that calls
// those compiles all of fmt's formatting again (g++ 12: five seconds); here it is compiled once.
#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>

namespace sightline::base {

void append_formatted(std::string& text, fmt::string_view format, fmt::format_args arguments);

// Appends what fmt::format would return.
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

// The text without a UTF-8 byte-order mark (EF BB BF), which some editors write first.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);
// Whether it begins with the byte-order mark of UTF-16 or UTF-32, which no reader accepts.
[[nodiscard]] bool begins_as_utf_16(std::string_view text);
// The text without blanks, tabs and line ends at both ends.
[[nodiscard]] std::string_view without_blanks(std::string_view text);
// Removes the first line and its line end from `text` and returns the line.
std::string_view take_line(std::string_view& text);
// Removes the first word and the blanks after it from `text` and returns the word.
std::string_view take_word(std::string_view& text);
// ASCII only.
[[nodiscard]] std::string lower_case(std::string_view text);
// The text as one word of a shell command, in single quotes if necessary.
[[nodiscard]] std::string shell_word(std::string_view text);

}  // namespace sightline::base
