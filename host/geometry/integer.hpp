// The 128-bit integers in which most exact predicates are evaluated. For larger values there is WideInteger
// (wide_integer.hpp).
#pragma once

#include <bit>
#include <cstdint>

namespace sightline::geometry {

// __extension__ because ISO C++ has no such types (-Wpedantic). g++ 12 and clang 14 have them, clang also for wasm32.
__extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): an alias-declaration cannot carry it
__extension__ typedef unsigned __int128 Unsigned128;  // NOLINT(modernize-use-using)

template <class Number>
[[nodiscard]] constexpr int sign(const Number& n) {
  return (n > 0 ? 1 : 0) - (n < 0 ? 1 : 0);
}

// Correct for -2^127, too.
[[nodiscard]] constexpr Unsigned128 magnitude(Int128 n) {
  return n < 0 ? -static_cast<Unsigned128>(n) : static_cast<Unsigned128>(n);
}

// The divisor of 0 and n is n. Binary algorithm (Stein 1967) without a branch on which number is larger: twice as fast as
// std::gcd.
[[nodiscard]] constexpr std::uint64_t common_divisor(std::uint64_t m, std::uint64_t n) {
  if (m == 0 || n == 0) return m | n;
  const int twos = std::countr_zero(m | n);
  m >>= std::countr_zero(m);
  n >>= std::countr_zero(n);
  while (m != n) {
    const std::uint64_t difference = m - n;
    const std::uint64_t swapped = -static_cast<std::uint64_t>(m < n);  // all ones if true
    n += difference & swapped;                                         // the smaller
    m = ((difference ^ swapped) - swapped) >> std::countr_zero(difference);
  }
  return n << twos;
}

// Not negative; the divisor of 0 and n is |n|. Precondition: not both are -2^127, nor one of them with 0 the other; the
// result is below 2^127.
[[nodiscard]] constexpr Int128 common_divisor(Int128 a, Int128 b) {
  Unsigned128 m = magnitude(a);
  Unsigned128 n = magnitude(b);
  while (n != 0) {
    if (((m | n) >> 64) == 0)
      return static_cast<Int128>(common_divisor(static_cast<std::uint64_t>(m), static_cast<std::uint64_t>(n)));
    const Unsigned128 rest = m % n;
    m = n;
    n = rest;
  }
  return static_cast<Int128>(m);
}

}  // namespace sightline::geometry
