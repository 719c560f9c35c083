// Parses and writes numbers. The whole text must be the number; blanks, a leading '+' (except in decimal_number) and radix
// prefixes are not accepted. The functions return nullopt and the caller words the error, because only the caller knows
// what the number means.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace sightline::base {

// Digits of radix 2 to 36, letters in either case. Signed numbers may begin with '-'.
[[nodiscard]] std::optional<std::int64_t> signed_number(std::string_view text, int radix = 10);
[[nodiscard]] std::optional<std::uint64_t> unsigned_number(std::string_view text, int radix = 10);

// A whole number from `least` to `most`, both included.
template <std::integral Number>
[[nodiscard]] std::optional<Number> whole_number(std::string_view text, int radix = 10,
                                                 Number least = std::numeric_limits<Number>::min(),
                                                 Number most = std::numeric_limits<Number>::max()) {
  const auto value = [&] {
    if constexpr (std::signed_integral<Number>)
      return signed_number(text, radix);
    else
      return unsigned_number(text, radix);
  }();
  if (!value || *value < least || *value > most) return std::nullopt;
  return static_cast<Number>(*value);
}

// A count: decimal digits, or a number with point and exponent whose value is whole: 1000000, 1e6, 2.5e3. Not 1.5, not
// 1e-3, not more than 2^64 - 1.
[[nodiscard]] std::optional<std::uint64_t> count_number(std::string_view text);

// Decimal whole numbers between separators: "3,-4,5", "640x480", "2/7".
template <std::integral Number, std::size_t count>
[[nodiscard]] std::optional<std::array<Number, count>> whole_numbers(
    std::string_view text, char separator, Number least = std::numeric_limits<Number>::min(),
    Number most = std::numeric_limits<Number>::max()) {
  std::array<Number, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    const std::size_t length = last ? text.size() : text.find(separator);
    if (length == std::string_view::npos) return std::nullopt;
    const auto number = whole_number<Number>(text.substr(0, length), 10, least, most);
    if (!number) return std::nullopt;
    numbers[i] = *number;
    if (!last) text.remove_prefix(length + 1);
  }
  return numbers;
}

// A finite decimal number: 1, -2.5, +1e-3. Numbers too near 0 for a double become 0. Infinity and NaN are not accepted.
[[nodiscard]] std::optional<double> decimal_number(std::string_view text);

// A decimal number as most files have them: at most 15 digits, perhaps with a point, without an exponent or a leading '+'.
struct ShortDecimal {
  double value = 0;
  int digits = 0;    // from the first that is not 0 to the last
  int decimals = 0;  // behind the point
};
[[nodiscard]] std::optional<ShortDecimal> short_decimal(std::string_view text);

// Like decimal_number without a leading '+' and without an exponent, from `least` to `most`.
[[nodiscard]] std::optional<double> fixed_number(std::string_view text, double least, double most);

// The shortest text that reads as the same number, equal to the output of std::to_chars: fixed or with an exponent,
// whichever is shorter, fixed if both are equally short. std::to_chars is not used because its tables would make the
// WebAssembly module a fourteenth larger.
[[nodiscard]] std::string shortest_number(double value);

// A time in seconds, written with three digits in s, ms or us: "1.5 s", "12.3 ms", "7 us".
[[nodiscard]] std::string time_text(double seconds);

// Octal with leading zeros: the lowest `digits` digits.
[[nodiscard]] std::string octal(std::uint32_t value, unsigned digits);

}  // namespace sightline::base
