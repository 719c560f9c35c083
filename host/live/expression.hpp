// Expressions of the monitor: numbers, registers, symbols and words of memory.
//
//   || && | ^ & == != < <= > >= << >> + - * / % and the prefixes - ~ !, as in C (= is ==), ( ), and [ADDRESS] for the word
//   in memory. A number is in the radix of the machine, 10. is decimal, 0x10 and 0o10 are what they are in other languages;
//   in hexadecimal it begins with a digit, since names come first: registers, conditions, then symbols.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::live {

struct Names {
  int radix = 8;
  std::function<std::optional<std::int64_t>(std::string_view name)> value;
  // nullopt: there is no such address.
  std::function<std::optional<std::int64_t>(std::int64_t address)> memory;
  // How to read a name whose value changes, for expressions that are evaluated often; empty: its value is always what it is now.
  std::function<std::function<std::int64_t()>(std::string_view name)> reader = {};
};

// A binary operator.
enum class Sign : std::uint8_t {
  either, both, equal, unequal, shift_left, shift_right, at_most, at_least, bit_or, bit_xor, bit_and, less, more, plus, minus, times, divide, remainder
};

// An expression that has been read once, to be evaluated again and again.
class Expression {
 public:
  // An error has the place in the text. The names outlive the expression.
  [[nodiscard]] static base::Result<Expression> read(std::string_view text, const Names& names);

  // Arithmetic is that of 64 bits, without overflow (it wraps around).
  [[nodiscard]] base::Result<std::int64_t> value() const;
  // Its value is not 0. One that has no value counts as true.
  [[nodiscard]] bool holds() const;
  // The names that are read again each time.
  [[nodiscard]] const std::vector<std::string>& names() const { return read_names_; }
  // If all of it is comparisons of names with constants, joined by && || and !: the numbers at which, when a name comes to them, its truth
  // can change.
  [[nodiscard]] std::optional<std::vector<std::int64_t>> turns() const;

 private:
  friend class ExpressionReader;
  // Of a program for a stack: operands come before their operator.
  struct Step {
    enum class Kind : std::uint8_t {
      number,
      name,  // by its place in readers_
      word,  // of memory, whose address is on the stack
      negative,
      complement,
      no,
      binary
    };
    Kind kind = Kind::number;
    Sign sign = Sign::either;
    std::int64_t number = 0;
  };
  struct Calculated {
    enum class End : std::uint8_t { value, no_word, division_by_0 };
    End end = End::value;
    std::int64_t number = 0;  // the value, or the address where there is no word
  };
  [[nodiscard]] Calculated calculated() const;

  const Names* names_ = nullptr;
  std::vector<Step> steps_;
  std::vector<std::function<std::int64_t()>> readers_;
  std::vector<std::string> read_names_;  // of them
};

// Of an expression that is evaluated once.
[[nodiscard]] base::Result<std::int64_t> evaluate(std::string_view text, const Names& names);

// A number as an expression may begin with one, all of `text`.
[[nodiscard]] std::optional<std::int64_t> number(std::string_view text, int radix);

}  // namespace sightline::live
