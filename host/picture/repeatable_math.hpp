// The functions that a photograph needs in addition to + - * / and sqrt, computed from these alone.
//
// The C library's exp and pow use different code on different processors, and their last bits may differ; IEEE basic
// operations do not. Loops have a fixed number of iterations, so equal arguments always give equal bits.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace sightline::picture {

namespace detail {

inline constexpr std::size_t taylor_terms = 16;  // (ln 2)^17 / 17! is 6e-18

// 1/n: a photograph of a second takes millions of exponentials, and division is slow.
inline constexpr auto reciprocals = [] {
  std::array<double, taylor_terms + 1> table{};
  for (std::size_t n = 1; n < table.size(); ++n) table[n] = 1.0 / static_cast<double>(n);
  return table;
}();

}  // namespace detail

// e^-x for x >= 0, relative error below 1e-14; 0 where the result would be below 1e-300.
[[nodiscard]] inline double decay(double x) {
  constexpr double ln2 = 0.693147180559945309417;
  if (!(x < 690.0)) return 0.0;
  const int halvings = static_cast<int>(x / ln2);
  const double rest = x - halvings * ln2;  // 0 .. ln 2
  double sum = 1.0;
  for (std::size_t n = detail::taylor_terms; n >= 1; --n) sum = 1.0 - rest * sum * detail::reciprocals[n];
  return std::ldexp(sum, -halvings);
}

// x^2.4 for 0 <= x <= 1, by Newton's iteration for the fifth root of x^2.
[[nodiscard]] inline double power_2_4(double x) {
  if (x <= 0.0) return 0.0;
  double root = 1.0;
  for (int turn = 0; turn < 80; ++turn) {
    const double fourth = root * root * root * root;
    root -= (fourth * root - x * x) / (5.0 * fourth);
  }
  return x * x * root;
}

// Linear light 0..1 of an sRGB value 0..1 (IEC 61966-2-1).
[[nodiscard]] inline double srgb_to_linear(double value) {
  return value <= 0.04045 ? value / 12.92 : power_2_4((value + 0.055) / 1.055);
}

}  // namespace sightline::picture
