// Macros of the 8080 assembler as texts: bodies, arguments, and the replacing of names by texts.
//
// A name is replaced wherever it is a whole name outside strings and comments, inside a string only
// next to `&`. One `&` on either side of it goes away: that joins the text to its neighbour.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/asm/i8080/dialect.hpp"
#include "tools/asm/source.hpp"

namespace sightline::assembler {

// Of a file or an expansion, in characters.
inline constexpr std::size_t longest_line = 16384;

struct BodyLine {
  std::string text;
  Position at;  // of its first character
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
  std::size_t bang = std::string_view::npos;      // offset of a `!` that is no such sign
};

// The arguments in text[from...], separated by commas, up to a comment. Blanks around them fall away, `<...>`
// makes one argument of what it holds and is taken off, the dialect's sign takes the next character as it is. An empty text
// has no arguments.
[[nodiscard]] Arguments split_arguments(std::string_view text, std::size_t from, const I8080Rules& rules);

// A text made of another one, and where its parts come from: pairs of offsets here and there.
struct Expansion {
  std::string text;
  std::vector<std::pair<std::size_t, std::size_t>> origins;

  [[nodiscard]] std::size_t origin_of(std::size_t offset) const;
};

// `names` folded, each replaced by the text of the same index. Ends with the replacement that makes the text
// longer than longest_line.
[[nodiscard]] Expansion replace_names(std::string_view line, const std::vector<std::string>& names,
                                      const std::vector<std::string>& texts, const I8080Rules& rules);

}  // namespace sightline::assembler
