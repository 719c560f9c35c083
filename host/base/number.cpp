#include "host/base/number.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>

namespace sightline::base {

namespace {

template <class Number>
std::optional<Number> whole_text(std::string_view text, int radix) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, value, radix);
  if (text.empty() || error != std::errc{} || after != end) return std::nullopt;
  return value;
}

// What std::from_chars does with a double, which libc++ 14 does not have: the whole text is a number in the C locale, without
// a plus sign, blanks or hexadecimal digits; out of range as strtod has it.
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
  // from_chars reports "out of range" for numbers too near 0 as for those too great.
  if (error == std::errc::result_out_of_range && exponent) return std::strtod(std::string(text).c_str(), nullptr);
  if (error != std::errc{}) return std::nullopt;
  return value;
#endif
}

}  // namespace

std::optional<std::int64_t> signed_number(std::string_view text, int radix) {
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

std::optional<double> decimal_number(std::string_view text) {
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

std::string octal(std::uint32_t value, unsigned digits) {
  std::string text(digits, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, value >>= 3) {
    *digit = static_cast<char>('0' + (value & 07U));
  }
  return text;
}

}  // namespace sightline::base
