// See dialect.hpp.
#include "tools/asm/i8080/dialect.hpp"

#include <algorithm>

namespace sightline::assembler {
namespace {

constexpr I8080Rules common{};
constexpr I8080Rules mac{.dialect = I8080Dialect::mac,
                         .bang_ends_comment = true,
                         .if_takes_bit_zero = true,
                         .high_is_loosest = true,
                         .arguments_are_scanned = true,
                         .arguments_are_capitals = true,
                         .first_character_is_low = true,
                         .fails_on_weak_prefixes = true,
                         .significant = 16};
constexpr I8080Rules m80{.dialect = I8080Dialect::m80,
                         .bang_separates = false,
                         .literal = '!',
                         .dollar_in_names = true,
                         .blanks_separate_arguments = true,
                         .empty_irpc_is_one = false,
                         .divides_signed = true,
                         .minus_is_tightest = true,
                         .significant = 16};
constexpr I8080Rules intel{.dialect = I8080Dialect::intel,
                           .bang_separates = false,
                           .location_moves = false,
                           .literal = '!',
                           .if_takes_bit_zero = true,
                           .significant = 6};

bool is_common(const I8080Rules& rules) {
  return rules.dialect == I8080Dialect::common;
}

constexpr std::array rows{
    I8080DialectRow{"`!` outside strings and comments",
                    [](const I8080Rules& rules) -> std::string {
                      return rules.bang_separates ? "separates statements" : "an error";
                    },
                    "ASM, section 3.2"},
    I8080DialectRow{"`!` in a comment",
                    [](const I8080Rules& rules) -> std::string {
                      if (is_common(rules)) return "part of the comment; a warning if a statement could begin there";
                      return rules.bang_ends_comment ? "ends the comment" : "part of the comment";
                    },
                    "ASM, section 3.2: a comment lasts to the next real or logical end of line; MACRO-80, 2.3.1"},
    I8080DialectRow{"`$` after the first item of DB and DW",
                    [](const I8080Rules& rules) -> std::string {
                      if (is_common(rules)) return "the address of the item; a warning";
                      return rules.location_moves ? "the address of the item" : "the address of the statement";
                    },
                    "MAC 2.0 and MACRO-80 3.44 themselves, though MACRO-80, 2.11, says: at the start of the statement; ASM80 4.1 itself"},
    I8080DialectRow{"sign that makes the next character of a macro argument literal",
                    [](const I8080Rules& rules) -> std::string {
                      const std::string sign = std::string("`") + rules.literal + "`";
                      return is_common(rules) ? sign + "; a warning at `!`" : sign;
                    },
                    "MAC, 8.7; MACRO-80, 2.7.9; Intel, chapter 5, \"Special Macro Operators\""},
    I8080DialectRow{"`$` in a name",
                    [](const I8080Rules& rules) -> std::string {
                      return rules.dollar_in_names ? "significant, also as the first character" : "ignored; never the first character";
                    },
                    "MAC, 2; MACRO-80, 2.3.2"},
    I8080DialectRow{"`$` before a digit",
                    [](const I8080Rules& rules) -> std::string {
                      return rules.dollar_in_names ? "begins a name" : "a hexadecimal number";
                    },
                    "of this assembler; MACRO-80, 2.3.2"},
    I8080DialectRow{"`IF` is true",
                    [](const I8080Rules& rules) -> std::string {
                      const std::string warned = "; a warning if that differs from: ";
                      if (is_common(rules)) return "if not 0" + warned + "bit 0 is 1";
                      return rules.if_takes_bit_zero ? "if bit 0 is 1" + warned + "not 0" : "if not 0";
                    },
                    "MAC, 4.5, and MAC 2.0 itself; MACRO-80, 2.6.26; ASM80 4.1 itself"},
    I8080DialectRow{"`HIGH` and `LOW`",
                    [](const I8080Rules& rules) -> std::string {
                      if (is_common(rules)) return "apply to the next operand; a warning if an operator follows it";
                      return rules.high_is_loosest ? "apply to all that follows: `HIGH A+1` is `HIGH (A+1)`" : "apply to the next operand";
                    },
                    "MAC, 3.6; MACRO-80, 2.4.1; Intel, chapter 2, on precedence"},
    I8080DialectRow{"parameters of a macro in the text of an argument",
                    [](const I8080Rules& rules) -> std::string {
                      return rules.arguments_are_scanned ? "are replaced, too; `^NAME` is not" : "are not replaced";
                    },
                    "MAC, 8.7, figures 23 and 25; MACRO-80, 2.7.5"},
    I8080DialectRow{"`''` in a string of an argument",
                    [](const I8080Rules& rules) -> std::string {
                      return rules.arguments_are_scanned ? "`'` is passed" : "is passed as it is";
                    },
                    "MAC, 8.7, figure 25; MACRO-80, 2.7.5"},
    I8080DialectRow{"letters of a macro argument, outside strings",
                    [](const I8080Rules& rules) -> std::string {
                      return rules.arguments_are_capitals ? "become capitals; in a string `&x` is not the parameter X" : "stay as they are";
                    },
                    "MAC 2.0 itself"},
    I8080DialectRow{"`'AB'` as a value, as in `DW 'AB'`",
                    [](const I8080Rules& rules) -> std::string {
                      if (is_common(rules)) return "4142; a warning";
                      return rules.first_character_is_low ? "4241" : "4142";
                    },
                    "MAC 2.0 itself, though ASM, 3.3.4, says 4142; MACRO-80 3.44 itself"},
    I8080DialectRow{"a blank in a macro argument, outside strings and `< >`",
                    [](const I8080Rules& rules) -> std::string {
                      return rules.blanks_separate_arguments ? "ends the argument as a comma does: `1 , 2` are three" : "part of the argument";
                    },
                    "MACRO-80 3.44 itself; an error in MAC 2.0"},
    I8080DialectRow{"`IRPC` without characters",
                    [](const I8080Rules& rules) -> std::string {
                      return rules.empty_irpc_is_one ? "is expanded once" : "is not expanded";
                    },
                    "MAC 2.0 and MACRO-80 3.44 themselves"},
    I8080DialectRow{"`/` and `MOD` of values above 7FFF",
                    [](const I8080Rules& rules) -> std::string {
                      if (is_common(rules)) return "unsigned; a warning";
                      return rules.divides_signed ? "signed: `-7/2` is -3, `7 MOD -4` is -3" : "unsigned";
                    },
                    "MACRO-80 3.44 and MAC 2.0 themselves; Intel not confirmed"},
    I8080DialectRow{"`HIGH`, `LOW`, `NOT`, `-` after an operator of higher precedence, as in `A-HIGH B`, `1 EQ NOT B`",
                    [](const I8080Rules& rules) -> std::string {
                      const std::string all = "apply to their operand";
                      return rules.fails_on_weak_prefixes ? all + "; a warning: MAC reports an error or makes other bytes" : all;
                    },
                    "MAC 2.0 itself"},
    I8080DialectRow{"`-1 SHR 4`",
                    [](const I8080Rules& rules) -> std::string {
                      return rules.minus_is_tightest ? "0FFF: `-` applies to the next operand" : "0: `-` applies to the product after it";
                    },
                    "MACRO-80 3.44 itself, though 2.4.1 has `-` below SHR; MAC, 3.6; Intel, chapter 2"},
    I8080DialectRow{"characters of a name that count",
                    [](const I8080Rules& rules) -> std::string {
                      if (rules.significant == 0) return "all";
                      return std::to_string(rules.significant) + "; all count here, with a warning";
                    },
                    "MAC, 2; MACRO-80 3.44 itself, though 2.3.2 says 6, which holds for PUBLIC and EXTRN; Intel, chapter 2, on labels, and ASM80 4.1 itself"},
};

}  // namespace

const I8080Rules& rules_of(I8080Dialect dialect) {
  switch (dialect) {
    case I8080Dialect::mac: return mac;
    case I8080Dialect::m80: return m80;
    case I8080Dialect::intel: return intel;
    case I8080Dialect::common: break;
  }
  return common;
}

std::optional<I8080Dialect> i8080_dialect_named(std::string_view name) {
  const auto found = std::find(i8080_dialect_names.begin(), i8080_dialect_names.end(), name);
  if (found == i8080_dialect_names.end()) return std::nullopt;
  return static_cast<I8080Dialect>(found - i8080_dialect_names.begin());
}

std::span<const I8080DialectRow> i8080_dialect_rows() {
  return rows;
}

}  // namespace sightline::assembler
