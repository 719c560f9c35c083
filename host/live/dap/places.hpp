// The places of a client: addresses, offsets in bytes, and source lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/json.hpp"
#include "host/live/debugger.hpp"

namespace sightline::live::dap {

// The numbers that the client uses for the first line and column, as `initialize` specifies.
struct Numbering {
  std::int64_t first_line = 1;
  std::int64_t first_column = 1;

  // The client's number of a line that is counted from 1.
  [[nodiscard]] std::int64_t line(std::size_t number) const { return static_cast<std::int64_t>(number) - 1 + first_line; }
};

// "0x40"
[[nodiscard]] std::string reference(std::uint32_t at);
// Bytes per word, if memory is a sequence of bytes.
[[nodiscard]] std::uint32_t bytes_a_word(const Debugger& debugger);
// The byte at "0x40" plus an offset in bytes, counted from the beginning of memory. Throws base::Error if it is outside memory.
[[nodiscard]] std::int64_t byte_place_of(const Debugger& debugger, std::string_view text, std::int64_t offset);
// The address of the word with that byte.
[[nodiscard]] std::uint32_t place_of(const Debugger& debugger, std::string_view text, std::int64_t offset);
// The expression in the brackets of "[EXPRESSION]", which stands for a word of memory; empty: the text is another expression.
[[nodiscard]] std::string_view word_in_brackets(std::string_view text);

// A file as the protocol's Source.
[[nodiscard]] base::Json source_of(const std::string& file);
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);
// The files that the program was assembled from.
[[nodiscard]] std::vector<std::string> source_files(const Symbols& symbols);
// The lines of a file from `first` to `last` that assemble to a word, counted from 1, in order, with the address of the first word.
struct CodeLine {
  std::size_t line = 0;
  std::uint32_t at = 0;
};
[[nodiscard]] std::vector<CodeLine> code_lines(const Symbols& symbols, const std::string& file, std::int64_t first, std::int64_t last);

}  // namespace sightline::live::dap
