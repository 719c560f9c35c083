// How the assemblers of the time differ in reading the same 8080 source: one row per difference. The assembler uses the
// rules; the manual's table is made from the rows.
//
// Without a dialect the assembler reads the common language: what means the same in all of them. Where they differ it uses
// the meaning stated in the row, and warns if another dialect would make other bytes.
//
// Sources: Digital Research, "CP/M Operating System Manual", chapter 3 on ASM, and "CP/M MAC Macro Assembler: Language Manual and
// Applications Guide" (1980), whose listings are those of MAC 2.0; Microsoft, "Utility Software Manual", chapter 2 on MACRO-80;
// Intel, "8080/8085 Assembly Language Programming Manual" (9800301). MAC 2.0 ("CP/M MACRO ASSEM 2.0") and MACRO-80 3.44 themselves
// were run by this repository's 8080: where a program differs from its manual, the rows follow the program. The behaviour of ASM80 4.1
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
  bool bang_ends_comment = false;      // a statement begins after `!` in a comment
  bool bang_separates = true;          // `!` separates statements of a line
  bool location_moves = true;          // `$` after the first item of DB or DW is the address of that item
  char literal = '^';                  // in macro arguments: the next character is taken literally
  bool dollar_in_names = false;        // `$` is a character of a name like any other
  bool if_takes_bit_zero = false;      // IF tests bit 0 of its value, not whether it is 0
  bool high_is_loosest = false;        // HIGH and LOW apply to the rest of the expression, else to the next operand
  bool arguments_are_scanned = false;  // the text of an argument may contain other parameters, and `^NAME` is none; in a
                                       // string of an argument two apostrophes become one
  // Letters of an argument outside strings become capitals; in a string `&x` is not the parameter X.
  bool arguments_are_capitals = false;
  // Blanks separate arguments as commas do. A string in an argument is passed unchanged, including the literal sign.
  bool blanks_separate_arguments = false;
  bool empty_irpc_is_one = true;        // IRPC without characters is expanded once, else not at all
  bool first_character_is_low = false;  // of a string of two characters that is a value; else it is the high byte
  bool divides_signed = false;          // `/` and MOD in two's complement; MOD has the sign of the quotient
  bool fails_on_weak_prefixes = false;        // fails on HIGH, LOW, NOT or `-` after an operator of higher precedence
  bool minus_is_tightest = false;       // unary `-` applies to the next operand, else to the product after it
  std::size_t significant = 0;          // characters of a name; 0: all
};

[[nodiscard]] const I8080Rules& rules_of(I8080Dialect dialect);
// "mac", "m80" or "intel"; nothing for other names.
[[nodiscard]] std::optional<I8080Dialect> i8080_dialect_named(std::string_view name);
inline constexpr std::array<std::string_view, 4> i8080_dialect_names{"common", "mac", "m80", "intel"};

struct I8080DialectRow {
  std::string_view what;
  std::string (*says)(const I8080Rules& rules);
  std::string_view source;
};
[[nodiscard]] std::span<const I8080DialectRow> i8080_dialect_rows();

}  // namespace sightline::assembler
