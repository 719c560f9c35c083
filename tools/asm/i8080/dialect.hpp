// How the assemblers of the time differ in reading the same 8080 source: one row for each difference. The assembler decides by
// the rules, and the manual's table is made from the rows.
//
// Without a dialect the common language is read: what means the same in all of them. What does not is taken as stated there, with a
// warning where another dialect would make other bytes of it.
//
// Sources: Digital Research, "CP/M Operating System Manual", chapter 3 on ASM, and "CP/M MAC Macro Assembler: Language Manual and
// Applications Guide" (1980), whose listings are those of MAC 2.0; Microsoft, "Utility Software Manual", chapter 2 on MACRO-80;
// Intel, "8080/8085 Assembly Language Programming Manual" (9800301). MAC 2.0 ("CP/M MACRO ASSEM 2.0") and MACRO-80 3.44 themselves
// were run by this repository's 8080: where one differs from its manual, the program counts. What ASM80 4.1 does
// is read from its port to C by Mark Ogden (c-ports, asm80: asm1m.c, asm3m.c, asm5m.c). Rows that name no section and no
// program rest on how programs of the time were written.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sightline::assembler {

enum class I8080Dialect : std::uint8_t { common, mac, m80, intel };

struct I8080Rules {
  I8080Dialect dialect = I8080Dialect::common;
  bool bang_ends_comment = false;      // a statement begins behind `!` in a comment
  bool bang_separates = true;          // statements of a line
  bool location_moves = true;          // `$` behind the first item of DB or DW is where that item goes
  char literal = '^';                  // in macro arguments: the next character is taken as it is
  bool dollar_in_names = false;        // `$` is a character of a name like any other
  bool if_takes_bit_zero = false;      // of the value of IF, not whether it is 0
  bool high_is_loosest = false;        // HIGH and LOW take all of the expression behind them, else the next operand
  bool arguments_are_scanned = false;  // what stands for a parameter may have names of others in it, and `^NAME` is none; in a
                                       // string of an argument two apostrophes become one
  // Letters of an argument outside strings; in a string `&x` is not the parameter X.
  bool arguments_are_capitals = false;
  // As commas do, and a string in an argument is passed as it is, with the sign for literal characters in it.
  bool blanks_separate_arguments = false;
  bool empty_irpc_is_one = true;        // IRPC without characters is expanded once, else not at all
  bool first_character_is_low = false;  // of a string of two characters that is a value; else it is the high byte
  bool divides_signed = false;          // `/` and MOD of two's complement; MOD has the sign of the quotient
  bool garbles_prefixes = false;        // makes nothing of use of HIGH, LOW, NOT or `-` behind an operator that is stronger
  bool minus_is_tightest = false;       // of the next operand, else of the product behind it
  std::size_t significant = 0;          // characters of a name; 0: all
};

[[nodiscard]] const I8080Rules& rules_of(I8080Dialect dialect);
// "mac", "m80", "intel"; none for others.
[[nodiscard]] std::optional<I8080Dialect> i8080_dialect_named(std::string_view name);
inline constexpr std::array<std::string_view, 4> i8080_dialect_names{"common", "mac", "m80", "intel"};

struct I8080DialectRow {
  std::string_view what;
  std::string (*says)(const I8080Rules& rules);
  std::string_view source;
};
[[nodiscard]] std::span<const I8080DialectRow> i8080_dialect_rows();

}  // namespace sightline::assembler
