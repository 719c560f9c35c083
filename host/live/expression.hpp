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
#include "host/guests/run/condition.hpp"

namespace sightline::live {

struct Names {
  int radix = 8;
  std::function<std::optional<std::int64_t>(std::string_view name)> value;
  // nullopt: there is no such address.
  std::function<std::optional<std::int64_t>(std::int64_t address)> memory;
  // How to read a name whose value changes, for expressions that are evaluated often; empty: its value is always what it is now.
  std::function<std::function<std::int64_t()>(std::string_view name)> reader = {};
};

// An expression that has been read once, to be evaluated again and again.
class Expression {
 public:
  // An error has the place in the text. The names outlive the expression.
  [[nodiscard]] static base::Result<Expression> read(std::string_view text, const Names& names);

  // Arithmetic is that of 64 bits, without overflow (it wraps around).
  [[nodiscard]] base::Result<std::int64_t> value() const;
  // If it has nothing in it that changes but words of memory at fixed addresses: these.
  [[nodiscard]] const std::optional<std::vector<std::int64_t>>& places() const { return places_; }

  // The names that are read again each time.
  [[nodiscard]] const std::vector<std::string>& names() const { return read_names_; }
  // While it is true, (name & mask) - first <= span, in 32 bits, for one of names(); `exact`: and only then.
  struct Range {
    std::size_t name = 0;
    bool exact = true;
    std::uint32_t mask = ~std::uint32_t{0};
    std::uint32_t first = 0;
    std::uint32_t span = 0;
  };
  // The narrowest that its comparisons with constants tell; nothing: they tell none.
  [[nodiscard]] std::optional<Range> range() const;
  // All of it is name sign other name + offset; the masks of the names count.
  struct Relation {
    Range name;
    guests::run::Sign sign;
    Range other;
    std::int64_t offset;
  };
  [[nodiscard]] std::optional<Relation> relation() const;
  [[nodiscard]] bool has_words() const;  // of memory
  // If all of it is comparisons of names with constants, joined by && || and !: where its truth can change, a name that has come to `at`.
  struct Turn {
    std::size_t name = 0;
    std::int64_t at = 0;
  };
  [[nodiscard]] std::optional<std::vector<Turn>> turns() const;
  // As a run evaluates it, once each name is one that the run knows.
  [[nodiscard]] const std::vector<guests::run::ConditionStep>& steps() const { return steps_; }

 private:
  friend class ExpressionReader;
  const Names* names_ = nullptr;
  std::vector<guests::run::ConditionStep> steps_;
  std::vector<std::function<std::int64_t()>> readers_;
  std::vector<std::string> read_names_;  // of them
  std::optional<std::vector<std::int64_t>> places_;
};

// Of an expression that is evaluated once.
[[nodiscard]] base::Result<std::int64_t> evaluate(std::string_view text, const Names& names);

// A number as an expression may begin with one, all of `text`.
[[nodiscard]] std::optional<std::int64_t> number(std::string_view text, int radix);

}  // namespace sightline::live
