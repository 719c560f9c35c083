// Signed integers of a fixed number of 64-bit limbs, for the determinants of planes of sight that outgrow 128
// bits: product, sum, difference, sign, and the nearest double but for the last places.
//
// Two's complement, least limb first. Results are taken modulo 2^(64 limbs); whoever computes knows the sizes
// and leaves room for the sign (arithmetic.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "host/geometry/integer.hpp"

namespace sightline::algorithms::jones {

__extension__ typedef unsigned __int128 UnsignedInt128;  // NOLINT(modernize-use-using): see integer.hpp

template <std::size_t limbs>
class FixedInteger {
 public:
  FixedInteger() = default;
  explicit FixedInteger(geometry::Int128 value) {
    const std::uint64_t sign = value < 0 ? ~std::uint64_t{0} : 0;
    limbs_.fill(sign);
    limbs_[0] = static_cast<std::uint64_t>(value);
    limbs_[1] = static_cast<std::uint64_t>(value >> 64);
  }
  template <std::size_t fewer>
  explicit FixedInteger(const FixedInteger<fewer>& value) {
    static_assert(fewer < limbs);
    limbs_.fill(value.sign() < 0 ? ~std::uint64_t{0} : 0);
    for (std::size_t i = 0; i < fewer; ++i) limbs_[i] = value.limb(i);
  }

  [[nodiscard]] std::uint64_t limb(std::size_t i) const { return limbs_[i]; }

  [[nodiscard]] int sign() const {
    if ((limbs_[limbs - 1] >> 63) != 0) return -1;
    std::uint64_t any = 0;
    for (const std::uint64_t limb : limbs_) any |= limb;
    return any != 0 ? 1 : 0;
  }

  // Within three units of the last place of the magnitude.
  [[nodiscard]] double to_double() const {
    if (sign() < 0) return -(FixedInteger{} - *this).to_double();
    double value = 0;
    for (std::size_t i = limbs; i-- > 0;)
      value = value * 18446744073709551616.0 + static_cast<double>(limbs_[i]);
    return value;
  }

  friend FixedInteger operator+(const FixedInteger& a, const FixedInteger& b) {
    FixedInteger sum;
    UnsignedInt128 carry = 0;
    for (std::size_t i = 0; i < limbs; ++i) {
      carry += UnsignedInt128{a.limbs_[i]} + b.limbs_[i];
      sum.limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return sum;
  }

  friend FixedInteger operator-(const FixedInteger& a, const FixedInteger& b) {
    FixedInteger difference;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < limbs; ++i) {
      const UnsignedInt128 part = UnsignedInt128{a.limbs_[i]} - b.limbs_[i] - borrow;
      difference.limbs_[i] = static_cast<std::uint64_t>(part);
      borrow = static_cast<std::uint64_t>(part >> 64) & 1;
    }
    return difference;
  }

  friend FixedInteger operator*(const FixedInteger& a, const FixedInteger& b) {
    FixedInteger product;
    for (std::size_t i = 0; i < limbs; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; i + j < limbs; ++j) {
        const UnsignedInt128 part = UnsignedInt128{a.limbs_[i]} * b.limbs_[j] + product.limbs_[i + j] + carry;
        product.limbs_[i + j] = static_cast<std::uint64_t>(part);
        carry = static_cast<std::uint64_t>(part >> 64);
      }
    }
    return product;
  }

 private:
  std::array<std::uint64_t, limbs> limbs_{};
};

}  // namespace sightline::algorithms::jones
