// Conversion of wide integers to and from GMP's, the independent reference in tests.
#pragma once

#include <gmpxx.h>

#include "host/geometry/wide_integer.hpp"

namespace sightline::geometry {

template <unsigned bits, class Limb>
[[nodiscard]] mpz_class to_gmp(const WideInteger<bits, Limb>& n) {
  const auto limbs = n.limbs_of_magnitude();
  mpz_class value;
  mpz_import(value.get_mpz_t(), limbs.size(), -1, sizeof(Limb), 0, 0, limbs.data());
  return n.negative() ? mpz_class(-value) : value;
}

// |n| must be below 2^(bits of Wide).
template <class Wide>
[[nodiscard]] Wide from_gmp(const mpz_class& n) {
  typename Wide::Limbs limbs{};
  mpz_export(limbs.data(), nullptr, -1, sizeof limbs[0], 0, 0, n.get_mpz_t());
  const Wide magnitude = Wide::of_limbs(limbs);
  return n < 0 ? -magnitude : magnitude;
}

}  // namespace sightline::geometry
