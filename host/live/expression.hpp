// Expressions of the monitor: numbers, registers, symbols and words of memory.
//
//   || && | ^ & == != < <= > >= << >> + - * / % and the prefixes - ~ !, as in C (= is ==), ( ), and [ADDRESS] for the word
//   in memory. A number is in the radix of the machine, 10. is decimal, 0x10 and 0o10 are what they are in other languages;
//   in hexadecimal it begins with a digit, since names come first: registers, conditions, then symbols.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "host/base/result.hpp"

namespace sightline::live {

struct Names {
  int radix = 8;
  std::function<std::optional<std::int64_t>(std::string_view name)> value;
  // nullopt: there is no such address.
  std::function<std::optional<std::int64_t>(std::int64_t address)> memory;
};

// Arithmetic is that of 64 bits, without overflow (it wraps around). An error has the place in the text.
[[nodiscard]] base::Result<std::int64_t> evaluate(std::string_view text, const Names& names);

// A number as an expression may begin with one, all of `text`.
[[nodiscard]] std::optional<std::int64_t> number(std::string_view text, int radix);

}  // namespace sightline::live
