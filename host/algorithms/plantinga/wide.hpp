// Integers without limits, for the two files of this folder that need them: direction.cpp, which orders
// events whose angles doubles cannot tell apart, and structure_wide.cpp, which looks between them.
#pragma once

#include <gmpxx.h>

#include <cstdint>

#include "host/geometry/integer.hpp"

namespace sightline::algorithms::plantinga {

__extension__ typedef unsigned __int128 Unsigned128;  // NOLINT(modernize-use-using): as Int128

[[nodiscard]] inline mpz_class wide(geometry::Int128 n) {
  const bool negative = n < 0;
  auto left = static_cast<Unsigned128>(n);
  if (negative) left = -left;
  mpz_class result(static_cast<unsigned long>(left >> 64U));
  result <<= 64U;
  result += mpz_class(static_cast<unsigned long>(left & ~std::uint64_t{0}));
  return negative ? mpz_class(-result) : result;
}

// n keeps below 2^126.
[[nodiscard]] inline geometry::Int128 narrow(const mpz_class& n) {
  const mpz_class magnitude = abs(n);
  const mpz_class high = magnitude >> 64U;
  const mpz_class low = magnitude - (high << 64U);
  const geometry::Int128 value = (geometry::Int128{static_cast<std::int64_t>(high.get_ui())} << 64U) +
                                 static_cast<geometry::Int128>(low.get_ui());
  return n < 0 ? -value : value;
}

// A direction of sight of any length.
struct WideSight {
  mpz_class x;
  mpz_class z;
};

}  // namespace sightline::algorithms::plantinga
