#include "host/scene/heights/round_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>


namespace sightline::scene {
namespace {

// 10^n, correctly rounded: dividing by it gives the double nearest to a decimal fraction.
double power_of_ten(int n) {
  double power = 1;
  for (int i = 0; i < n; ++i) power *= 10;
  return power;
}

// k * digit * 10^exponent
double multiple(double k, int digit, int exponent) {
  return exponent < 0 ? k * digit / power_of_ten(-exponent) : k * digit * power_of_ten(exponent);
}

std::string text_of(double value) {
  constexpr double largest_plain = 1e7;
  if (value == std::floor(value) && std::abs(value) < largest_plain) return std::to_string(static_cast<std::int64_t>(value));
  return shortest_text(value);
}

}  // namespace

std::vector<RoundValue> round_values(Interval interval, int most) {
  const double extent = interval.high / 2 - interval.low / 2;
  // Powers of ten are exact that far.
  if (!(extent > 1e-20) || !(std::max(std::abs(interval.low), std::abs(interval.high)) < 1e20) || most < 1) return {};
  int exponent = static_cast<int>(std::floor(std::log10(extent))) - 3;
  for (;; ++exponent)
    for (const int digit : {1, 2, 5}) {
      const double step = multiple(1, digit, exponent);
      const double slack = 1e-9 * extent / step;
      const double first = std::ceil(interval.low / step - slack);
      const double last = std::floor(interval.high / step + slack);
      if (last - first + 1 > most) continue;
      std::vector<RoundValue> values;
      for (double k = first; k <= last; ++k) {
        const double value = k == 0 ? 0 : multiple(k, digit, exponent);
        values.push_back({value, text_of(value)});
      }
      return values;
    }
}

std::vector<double> multiples_within(Interval interval, double step, int most) {
  std::vector<double> values;
  const double first = std::floor(interval.low / step) + 1;
  const double last = std::ceil(interval.high / step) - 1;
  if (!(last - first + 1 <= most)) return values;
  for (double k = first; k <= last; ++k) values.push_back(k == 0 ? 0 : k * step);
  return values;
}

}  // namespace sightline::scene
