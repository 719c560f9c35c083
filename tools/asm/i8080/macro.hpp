// Macros of the 8080 assembler as texts: bodies, arguments, and the replacement of names by texts.
//
// A name is replaced wherever it is a whole name outside strings and comments; inside a string only next to `&`. One `&` on
// either side is removed, which joins the text to what is next to it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/asm/i8080/dialect.hpp"
#include "tools/asm/assembly.hpp"

namespace sightline::assembler {

// Limit for a line of a file or an expansion, in characters.
inline constexpr std::size_t longest_line = 16384;

struct BodyLine {
  std::string text;
  Position at;  // position of its first character
};

// The lines between MACRO, REPT, IRP or IRPC and its ENDM.
struct Body {
  std::vector<BodyLine> lines;
  std::vector<std::string> locals;  // names, folded
};

struct Macro {
  std::string name;                     // as written
  std::vector<std::string> parameters;  // folded
  std::shared_ptr<const Body> body;
  Position defined;
};

struct Argument {
  std::string text;
  std::size_t column = 0;  // offset of its first character
  bool evaluate = false;   // written %expression: its value is passed, in decimal
};

struct Arguments {
  std::vector<Argument> list;
  std::size_t unclosed = std::string_view::npos;  // offset of a `<` without `>`
  std::size_t bang = std::string_view::npos;      // offset of a `!` that is not the dialect's literal sign
};

// The arguments in text[from...], separated by commas, up to a comment. Blanks around them are removed. `<...>` makes its
// contents one argument without the brackets. The character after the dialect's literal sign is taken literally. An empty
// text has no arguments.
[[nodiscard]] Arguments split_arguments(std::string_view text, std::size_t from, const I8080Rules& rules);

// A text made from another, with the origin of its parts: pairs of offsets in the new and the old text.
struct Expansion {
  std::string text;
  std::vector<std::pair<std::size_t, std::size_t>> origins;

  [[nodiscard]] std::size_t origin_of(std::size_t offset) const;
};

// Replaces each of `names` (folded) by the text of the same index. Stops after the replacement that makes the text
// longer than longest_line.
[[nodiscard]] Expansion replace_names(std::string_view line, const std::vector<std::string>& names,
                                      const std::vector<std::string>& texts, const I8080Rules& rules);

}  // namespace sightline::assembler
