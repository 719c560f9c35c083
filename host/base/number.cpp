#include "host/base/number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "host/base/text.hpp"

namespace sightline::base {

namespace {

// All decimal digits of a whole number >= 0.
std::string exact_digits(double value) {
  int doublings = 0;
  for (; value >= 0x1p63; value /= 2) ++doublings;
  std::string digits = std::to_string(static_cast<std::uint64_t>(value));
  for (; doublings > 0; --doublings) {
    int carry = 0;
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
      const int twice = 2 * (*digit - '0') + carry;
      *digit = static_cast<char>('0' + twice % 10);
      carry = twice / 10;
    }
    if (carry != 0) digits.insert(digits.begin(), static_cast<char>('0' + carry));
  }
  return digits;
}

template <class Number>
std::optional<Number> whole_text(std::string_view text, int radix) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, value, radix);
  if (text.empty() || error != std::errc{} || after != end) return std::nullopt;
  return value;
}

// std::from_chars for a double, which libc++ 14 lacks: the whole text is a number in the C locale, without a plus sign,
// blanks or hexadecimal digits. Numbers out of range are returned as strtod returns them.
std::optional<double> whole_double(std::string_view text, bool exponent) {
#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 20000
  constexpr std::string_view characters = "0123456789.-";
  bool digits = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool of_exponent = exponent && (text[i] == 'e' || text[i] == 'E' || text[i] == '+');
    if (characters.find(text[i]) == std::string_view::npos && !of_exponent) return std::nullopt;
    if (text[i] == '+' && (i == 0 || (text[i - 1] != 'e' && text[i - 1] != 'E'))) return std::nullopt;
    digits = digits || (text[i] >= '0' && text[i] <= '9');
  }
  if (!digits) return std::nullopt;
  const std::string copy(text);
  char* after = nullptr;
  const double value = std::strtod(copy.c_str(), &after);
  if (after != copy.c_str() + copy.size()) return std::nullopt;
  return value;
#else
  double value = 0;
  const auto format = exponent ? std::chars_format::general : std::chars_format::fixed;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, format);
  if (end != text.data() + text.size()) return std::nullopt;
  // from_chars reports "out of range" for numbers too near 0 and for numbers too large.
  if (error == std::errc::result_out_of_range && exponent) return std::strtod(std::string(text).c_str(), nullptr);
  if (error != std::errc{}) return std::nullopt;
  return value;
#endif
}

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::optional<std::int64_t> signed_number(std::string_view text, int radix) {
  constexpr std::size_t surely_fits = 18;
  if (radix == 10 && !text.empty() && text.size() <= surely_fits && is_digit(text[0])) {
    std::uint64_t value = 0;
    for (const char c : text) {
      const unsigned digit = static_cast<unsigned char>(c) - unsigned{'0'};
      if (digit >= 10) return std::nullopt;
      value = 10 * value + digit;
    }
    return static_cast<std::int64_t>(value);
  }
  return whole_text<std::int64_t>(text, radix);
}

std::optional<std::uint64_t> unsigned_number(std::string_view text, int radix) {
  return whole_text<std::uint64_t>(text, radix);
}

std::optional<std::uint64_t> count_number(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  if (e == std::string_view::npos) return unsigned_number(text);
  std::string_view exponent = text.substr(e + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  const auto power = whole_number<std::uint8_t>(exponent);
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t point = mantissa.find('.');
  std::string digits(mantissa.substr(0, point));
  if (!power || digits.empty()) return std::nullopt;
  if (point != std::string_view::npos) digits += mantissa.substr(point + 1);
  const std::size_t fraction = point == std::string_view::npos ? 0 : mantissa.size() - point - 1;
  if (*power < fraction) return std::nullopt;
  return unsigned_number(digits.append(*power - fraction, '0'));
}

// The digits as a whole number and the power of ten are exact doubles, so their quotient is rounded once.
std::optional<ShortDecimal> short_decimal(std::string_view text) {
  constexpr std::size_t most_digits = 15;
  constexpr std::array<double, most_digits + 1> powers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  if (text.empty() || text.size() > most_digits + 1) return std::nullopt;
  std::uint64_t whole = 0;
  std::size_t point = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned digit = static_cast<unsigned char>(text[i]) - unsigned{'0'};
    if (digit < 10) {
      whole = 10 * whole + digit;
    } else if (text[i] == '.' && point == text.size()) {
      point = i;
    } else {
      return std::nullopt;
    }
  }
  const std::size_t decimals = point < text.size() ? text.size() - 1 - point : 0;
  std::size_t digits = point < text.size() ? text.size() - 1 : text.size();
  if (digits == 0 || digits > most_digits) return std::nullopt;
  const auto magnitude = static_cast<double>(whole);
  const double value = decimals > 0 ? magnitude / powers[decimals] : magnitude;
  while (digits > 0 && magnitude < powers[digits - 1]) --digits;  // leading zeros
  return ShortDecimal{negative ? -value : value, static_cast<int>(digits), static_cast<int>(decimals)};
}

std::optional<double> decimal_number(std::string_view text) {
  if (const auto number = short_decimal(text)) return number->value;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto value = whole_double(text, true);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return value;
}

std::optional<double> fixed_number(std::string_view text, double least, double most) {
  const auto value = whole_double(text, false);
  if (!value || !(*value >= least && *value <= most)) return std::nullopt;
  return value;
}

std::string time_text(double seconds) {
  const auto with = [](double value, std::string_view unit) {
    // From 1000 on, `g` would write an exponent.
    std::string text;
    if (value >= 999.5)
      append(text, "{:.0f} {}", value, unit);
    else
      append(text, "{:.3g} {}", value, unit);
    return text;
  };
  if (seconds >= 0.9995) return with(seconds, "s");
  return seconds >= 0.9995e-3 ? with(seconds * 1e3, "ms") : with(seconds * 1e6, "us");
}

std::string shortest_number(double value) {
  std::string general;
  append(general, "{}", std::abs(value));  // fmt writes the shortest digits, but in its own choice of notation
  const bool negative = std::signbit(value);
  const auto with_sign = [negative](std::string text) { return negative ? "-" + std::move(text) : text; };
  if (!std::isfinite(value) || value == 0) return with_sign(std::move(general));
  const std::size_t e = general.find('e');
  int exponent = e == std::string::npos ? 0 : std::atoi(general.c_str() + e + 1);
  std::string digits = general.substr(0, e);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  exponent += static_cast<int>(point) - 1;
  if (point < digits.size()) digits.erase(point, 1);
  const std::size_t zeros = digits.find_first_not_of('0');
  digits.erase(0, zeros);
  exponent -= static_cast<int>(zeros);  // now the exponent of the first digit
  digits.erase(digits.find_last_not_of('0') + 1);

  std::string scientific = digits;
  if (digits.size() > 1) scientific.insert(1, ".");
  append(scientific, "e{}{:02}", exponent < 0 ? '-' : '+', std::abs(exponent));
  const int count = static_cast<int>(digits.size());
  const int fixed_size = exponent < 0 ? 1 + count - exponent : std::max(count + (count > exponent + 1 ? 1 : 0), exponent + 1);
  if (fixed_size > static_cast<int>(scientific.size())) return with_sign(std::move(scientific));
  if (exponent < 0) return with_sign("0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits);
  if (count > exponent + 1) return with_sign(digits.insert(static_cast<std::size_t>(exponent) + 1, "."));
  return with_sign(exact_digits(std::abs(value)));
}

std::string octal(std::uint32_t value, unsigned digits) {
  std::string text(digits, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, value >>= 3) {
    *digit = static_cast<char>('0' + (value & 07U));
  }
  return text;
}

}  // namespace sightline::base
