// One pass over all sources in the dialect of Bell Laboratories' assembler `as` of 1970.
//
//   label:   1: jmp 1b; jmp 2f     name = expression     . = . + 10      " comment to the end of the line
//   lac x    dac x i    dac i 8    spa cla    -1    sys open; name; 0    <ab>    <a 012    a>
//
// Source: as.s, the assembler's own source (pdp7-unix, scans/as.s); the names in parentheses are its labels.
// - The classes of characters (lactab): letters, `.` and `*` begin a name, digits may follow; eight characters count
//   (gs2), and `a` is not `A`. `;` and the end of the line end a statement, `"` begins a comment (gchar).
// - Numbers are decimal, octal with a leading 0 (gs3). All arithmetic is two's complement in 18 bits (oper).
// - Blank is OR. `+` and `-` bind more tightly, and blanks next to them have no effect (gpair, expr).
// - `<a` is a character in the left half of a word, `a>` in the right half, so `<ab>` both (lqot, rqot).
// - `1:` can be defined often: 1b is the last definition before, 1f the next one after; there are ten, 0 to 9
//   (assm3, gs3). `1f:` and `1b:` set what 1f and 1b mean from there on to the next `1:` (assm4).
// - A label or variable may be set again; before the first place it has the last value (assm4, lookup). A label that is set
//   again draws a warning.
// - `.` and labels are relocatable: the value of `..`, 4096 unless the source sets it, is added to a word with one of
//   them (process). The difference of two is a number.
// - The last location is 017777 (assm2).
// The sources of 1970 define the names of instructions themselves (the file sop.s). Here the names of the instruction
// table are defined, and `sys`, which is `cal i`; a source may define them again. It must define the names of system
// calls.
//
// Stricter than as.s, where that would make other words without a message: an operand that changes the instruction, a number
// above 18 bits, 8 and 9 in an octal number, two operators in succession, a comma (as.s takes it for a blank), `..` set after
// the first word or label.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "tools/asm/pdp7/program.hpp"

namespace sightline::assembler {

inline constexpr std::uint32_t first_bell_base = 4096;  // `..` unless the source sets it (init, d4096)
inline constexpr Naming bell_naming{.significant = 8, .in_words = "eight", .any_case = false};

// Adds the value of `..` to the relocatable symbols, after the last pass.
void relocate_bell_symbols(Pdp7Program& program);

class BellPass {
 public:
  explicit BellPass(Pdp7Program& program) : program_(program), engine_(program.engine) { program_.base.reset(); }

  void run();

 private:
  struct Number {
    std::uint32_t value = 0;
    int relocatable = 0;  // 1: the value of `..` is added; other values than 0 and 1 are errors
    bool known = true;
  };

  // Characters. `peek` is '\0' at the end of the file. A comment is skipped like the end of its line.
  [[nodiscard]] char peek(std::size_t ahead = 0) const;
  [[nodiscard]] Position position() const { return {file_, line_, at_ - line_start_ + 1}; }
  [[nodiscard]] bool at_end_of_statement() const;
  void advance(std::size_t characters) { at_ += characters; }
  void skip_blanks();
  void skip_statement();
  [[nodiscard]] std::string_view take_name();
  [[nodiscard]] std::string found() const;

  // Statements
  void read_file(std::size_t index);
  void statement();
  [[nodiscard]] bool label_or_assignment();
  void define_label(std::string_view name, const Position& at);
  void set_again(Symbol& symbol, std::string_view name, const Position& at);
  void set_relative_label(std::size_t digit, bool forward, bool assigned);
  [[nodiscard]] std::optional<Number> assigned_value();
  [[nodiscard]] static std::uint32_t packed(const Number& value);
  [[nodiscard]] static Number unpacked(std::uint32_t packed);
  void assign(std::string_view name, const Position& at);
  void set_location(const Number& value, const Position& at);
  void set_base(const Number& value, const Position& at);
  void make_word();

  // Expressions. Each returns nothing after an error, which it has reported.
  [[nodiscard]] std::optional<Number> expression();
  [[nodiscard]] std::optional<Number> sum();
  [[nodiscard]] std::optional<Number> operand();
  [[nodiscard]] std::optional<Number> number();
  [[nodiscard]] std::optional<Number> character();
  [[nodiscard]] std::optional<Number> relative_label(const Position& at, std::size_t digit, bool forward);
  [[nodiscard]] std::optional<Number> symbol(std::string_view name, const Position& at);
  [[nodiscard]] std::optional<Number> check_relocation(Number value, const Position& at);
  void undefined(std::string_view name, const Position& at);

  [[nodiscard]] std::uint32_t relocated(const Number& value) const;
  [[nodiscard]] bool location_in_core(const Position& at);
  void emit(std::uint32_t word, const Position& at);
  void error(const Position& at, std::string found, std::string expected) {
    engine_.error(at, std::move(found), std::move(expected));
  }

  Pdp7Program& program_;
  Engine& engine_;
  std::string_view text_;
  std::size_t file_ = 0;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t line_start_ = 0;
  Number location_{0, 1, true};
  bool base_used_ = false;                    // a word or a label used `..`, which must not change any more
  bool after_left_character_ = false;         // the operand just read was <a
  bool in_location_ = false;                  // reading the new value of `.` or `..`
  std::optional<std::uint32_t> instruction_;  // the first name of a word, if it is one of the machine
};

}  // namespace sightline::assembler
