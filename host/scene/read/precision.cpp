// See precision.hpp.
#include "host/scene/read/precision.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host/base/number.hpp"
#include "host/scene/read/poly_text.hpp"

namespace sightline::scene {
namespace {

double largest_of(std::span<const std::array<double, 3>> vertices) {
  double largest = 0;
  for (const auto& vertex : vertices)
    for (const double c : vertex)
      if (std::abs(c) > largest && std::isfinite(c)) largest = std::abs(c);
  return largest;
}

// The largest side of the vertices' bounds.
double size_of(std::span<const std::array<double, 3>> vertices) {
  double size = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const auto& vertex : vertices) {
      if (!std::isfinite(vertex[a])) continue;
      low = std::min(low, vertex[a]);
      high = std::max(high, vertex[a]);
    }
    size = std::max(size, high - low);
  }
  return size;
}

// That of std::ilogb.
int binary_exponent(double value) {
  const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52U & 0x7ffU);
  return biased == 0 ? std::ilogb(value) : biased - 1023;
}

double spacing_at(double largest, int mantissa_bits) {
  return largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - mantissa_bits) : 0;
}

}  // namespace

double float32_precision(std::span<const std::array<double, 3>> vertices) {
  return spacing_at(largest_of(vertices), 23);
}

double float64_precision(std::span<const std::array<double, 3>> vertices) {
  return spacing_at(largest_of(vertices), 52);
}

std::optional<double> TextPrecision::read(std::string_view field) {
  if (const auto number = base::short_decimal(field)) {
    if (number->value != 0) add(number->value, {-number->decimals, number->digits});
    return number->value;
  }
  const auto value = coordinate_of(field);
  if (value) add(field, *value);
  return value;
}

void TextPrecision::add(std::string_view written, double value) {
  if (value == 0 || !std::isfinite(value)) return;
  // A sign, digits, a point and digits, and an exponent.
  const std::size_t size = written.size();
  const auto skip_digits = [&](std::size_t i) {
    while (i < size && written[i] >= '0' && written[i] <= '9') ++i;
    return i;
  };
  const auto skip_zeros = [&](std::size_t i) {
    while (i < size && written[i] == '0') ++i;
    return i;
  };
  std::size_t first = skip_zeros(written[0] == '-' || written[0] == '+' ? 1 : 0);
  std::size_t end = skip_digits(first);
  int digits = static_cast<int>(end - first);
  int decimals = 0;
  if (end < size && written[end] == '.') {
    const std::size_t point = end;
    if (digits == 0) first = skip_zeros(point + 1);
    end = skip_digits(digits == 0 ? first : point + 1);
    decimals = static_cast<int>(end - point - 1);
    digits = digits == 0 ? static_cast<int>(end - first) : digits + decimals;
  }
  int exponent = 0;
  if (end < size && (written[end] == 'e' || written[end] == 'E')) {
    const std::string_view power = written.substr(end + 1);
    for (const char d : power)
      if (d >= '0' && d <= '9' && exponent < 10'000) exponent = 10 * exponent + (d - '0');
    if (power.starts_with('-')) exponent = -exponent;
  }
  add(value, {std::max(exponent - decimals, -400), digits});
}

void TextPrecision::add(double value, const Seen& seen) {
  seen_[static_cast<std::size_t>(binary_exponent(value) - lowest)].add(seen);
  add_top(seen, seen.last_decimal + seen.digits);
}

void TextPrecision::add(const TextPrecision& other) {
  for (std::size_t e = 0; e < seen_.size(); ++e) seen_[e].add(other.seen_[e]);
  add_top(other.top_, other.top_decade_);
}

void TextPrecision::add_top(const Seen& seen, int decade) {
  if (decade < top_decade_) return;
  if (decade > top_decade_) top_ = seen;
  top_decade_ = decade;
  top_.add(seen);
}

void TextPrecision::Seen::add(const Seen& other) {
  last_decimal = std::min(last_decimal, other.last_decimal);
  digits = std::max(digits, other.digits);
}

double TextPrecision::result(std::span<const std::array<double, 3>> vertices) const {
  const double largest = largest_of(vertices);
  if (largest == 0) return 0;
  Seen all;
  for (std::size_t e = 0; e < seen_.size(); ++e) {
    if (std::ldexp(1.0, static_cast<int>(e) + lowest + 1) <= largest / 10) continue;
    all.add(seen_[e]);
  }
  constexpr int least_of_floating = 6;
  if (top_.digits == all.digits && all.digits >= least_of_floating) all.last_decimal = top_.last_decimal;
  constexpr double least_rounded = 0x1p18;
  if (all.last_decimal == 0 && size_of(vertices) < least_rounded) return 0;
  constexpr int most_of_float32 = 9;
  return std::max(std::pow(10.0, all.last_decimal), spacing_at(largest, all.digits <= most_of_float32 ? 23 : 52));
}

}  // namespace sightline::scene
