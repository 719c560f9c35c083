// The integers of 128 bits in which most exact predicates are evaluated. What outgrows them is a WideInteger
// (wide_integer.hpp).
#pragma once

#include <cstdint>

namespace sightline::geometry {

// __extension__ because -Wpedantic is right that ISO C++ has no such types. g++ 12 and clang 14 have them,
// clang also for wasm32.
__extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): an alias-declaration cannot carry it
__extension__ typedef unsigned __int128 Unsigned128;  // NOLINT(modernize-use-using)

template <class Number>
[[nodiscard]] constexpr int sign(const Number& n) {
  return (n > 0 ? 1 : 0) - (n < 0 ? 1 : 0);
}

// -2^127 has one, too.
[[nodiscard]] constexpr Unsigned128 magnitude(Int128 n) {
  return n < 0 ? -static_cast<Unsigned128>(n) : static_cast<Unsigned128>(n);
}

// Not negative; that of 0 and n is |n|. Not both -2^127, nor one of them with 0: the result is below 2^127.
[[nodiscard]] constexpr Int128 common_divisor(Int128 a, Int128 b) {
  Unsigned128 m = magnitude(a);
  Unsigned128 n = magnitude(b);
  while (n != 0) {
    // One division of 128 bits takes as long as several of 64.
    if (((m | n) >> 64) == 0) {
      auto p = static_cast<std::uint64_t>(m);
      auto q = static_cast<std::uint64_t>(n);
      while (q != 0) {
        const std::uint64_t rest = p % q;
        p = q;
        q = rest;
      }
      return static_cast<Int128>(p);
    }
    const Unsigned128 rest = m % n;
    m = n;
    n = rest;
  }
  return static_cast<Int128>(m);
}

}  // namespace sightline::geometry
