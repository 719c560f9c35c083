// Expressions of the monitor: numbers, registers, symbols and words of memory.
//
//   || && | ^ & == != < <= > >= << >> + - * / % and the prefixes - ~ ! as in C (= means ==), ( ), and [ADDRESS] for a word of
//   memory. Numbers are in the radix of the machine; 10. is decimal, 0x10 hexadecimal, 0o10 octal. In radix 16 a number begins
//   with a digit, because names have precedence: registers, conditions, then symbols.
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
  // nullopt: the address is outside memory.
  std::function<std::optional<std::int64_t>(std::int64_t address)> memory;
  // Returns a function that reads the value of a name, for expressions that are evaluated often; empty: the value is constant.
  std::function<std::function<std::int64_t()>(std::string_view name)> reader = {};
};

// A binary operator.
enum class Sign : std::uint8_t {
  either, both, equal, unequal, shift_left, shift_right, at_most, at_least, bit_or, bit_xor, bit_and, less, more, plus, minus, times, divide, remainder
};

// A parsed expression, which can be evaluated repeatedly.
class Expression {
 public:
  // Parses an expression. An error has the place in the text. The names must outlive the expression.
  [[nodiscard]] static base::Result<Expression> read(std::string_view text, const Names& names);

  // The arithmetic has 64 bits and wraps around.
  [[nodiscard]] base::Result<std::int64_t> value() const;
  // Whether its value is not 0. An expression without a value counts as true.
  [[nodiscard]] bool holds() const;
  // The names whose values are read at each evaluation.
  [[nodiscard]] const std::vector<std::string>& names() const { return read_names_; }
  // For an expression that consists of comparisons of names with constants, joined by && || and !: the values of a name at which its
  // truth can change. nullopt for all others.
  [[nodiscard]] std::optional<std::vector<std::int64_t>> change_points() const;

 private:
  friend class ExpressionReader;
  // A step of the stack machine: operands come before their operator.
  struct Step {
    enum class Kind : std::uint8_t {
      number,
      name,  // by its index in readers_
      word,  // of memory; its address is on the stack
      negative,
      complement,
      no,
      binary
    };
    Kind kind = Kind::number;
    Sign sign = Sign::either;
    std::int64_t number = 0;
  };
  struct Outcome {
    enum class End : std::uint8_t { value, no_word, division_by_0 };
    End end = End::value;
    std::int64_t number = 0;  // the value, or the address that is outside memory
  };
  [[nodiscard]] Outcome calculate() const;

  const Names* names_ = nullptr;
  std::vector<Step> steps_;
  std::vector<std::function<std::int64_t()>> readers_;
  std::vector<std::string> read_names_;  // the names of readers_
};

// Evaluates an expression once.
[[nodiscard]] base::Result<std::int64_t> evaluate(std::string_view text, const Names& names);

// Parses `text` as a number of an expression; nullopt: it is none.
[[nodiscard]] std::optional<std::int64_t> number(std::string_view text, int radix);

}  // namespace sightline::live
