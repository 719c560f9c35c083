// Integers of a fixed number of 64-bit limbs in two's complement: what exact predicates fall back on when
// products outgrow 128 bits. Sums and products wrap; callers choose the width so that nothing does.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "host/geometry/integer.hpp"

namespace sightline::algorithms::montani_re {

template <std::size_t limbs>
class Wide {
 public:
  constexpr Wide() = default;
  constexpr Wide(geometry::Int128 value) {  // NOLINT: an integer is a wide integer
    limb_[0] = static_cast<std::uint64_t>(value);
    limb_[1] = static_cast<std::uint64_t>(value >> 64);
    for (std::size_t i = 2; i < limbs; ++i) limb_[i] = value < 0 ? ~std::uint64_t{0} : 0;
  }
  // A narrower one.
  template <std::size_t fewer>
  constexpr explicit Wide(const Wide<fewer>& value) {
    static_assert(fewer < limbs);
    for (std::size_t i = 0; i < limbs; ++i) {
      limb_[i] = i < fewer ? value.limb(i) : value.sign() < 0 ? ~std::uint64_t{0} : 0;
    }
  }

  [[nodiscard]] constexpr std::uint64_t limb(std::size_t i) const { return limb_[i]; }
  [[nodiscard]] constexpr int sign() const {
    if ((limb_[limbs - 1] >> 63) != 0) return -1;
    for (const std::uint64_t limb : limb_) {
      if (limb != 0) return 1;
    }
    return 0;
  }

  // Wrong by at most one part in 2^52.
  [[nodiscard]] double to_double() const {
    const bool negative = sign() < 0;
    const Wide magnitude = negative ? Wide{} - *this : *this;
    double value = 0;
    for (std::size_t i = limbs; i-- > 0;) value = value * 0x1p64 + static_cast<double>(magnitude.limb_[i]);
    return negative ? -value : value;
  }

  friend constexpr Wide operator+(const Wide& a, const Wide& b) {
    Wide sum;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < limbs; ++i) {
      const std::uint64_t part = a.limb_[i] + carry;
      carry = part < carry ? 1 : 0;
      sum.limb_[i] = part + b.limb_[i];
      carry += sum.limb_[i] < part ? 1 : 0;
    }
    return sum;
  }
  friend constexpr Wide operator-(const Wide& a, const Wide& b) {
    Wide difference;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < limbs; ++i) {
      const std::uint64_t part = a.limb_[i] - borrow;
      borrow = part > a.limb_[i] ? 1 : 0;
      difference.limb_[i] = part - b.limb_[i];
      borrow += difference.limb_[i] > part ? 1 : 0;
    }
    return difference;
  }
  friend constexpr Wide operator*(const Wide& a, const Wide& b) {
    Wide product;
    for (std::size_t i = 0; i < limbs; ++i) {
      Unsigned128 carry = 0;
      for (std::size_t j = 0; i + j < limbs; ++j) {
        carry += Unsigned128{a.limb_[i]} * b.limb_[j] + product.limb_[i + j];
        product.limb_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    return product;
  }

 private:
  __extension__ typedef unsigned __int128 Unsigned128;  // NOLINT(modernize-use-using)

  std::array<std::uint64_t, limbs> limb_{};
};

}  // namespace sightline::algorithms::montani_re
