// Signed integers of more than 128 bits whose overflow is excluded at compile time, for exact predicates whose products
// exceed 128 bits.
//
// The type states a bound: |n| < 2^bits for every value n of WideInteger<bits>. The type of each result has the bound
// that follows from those of the operands:
//   a + b, a - b   max(bits of a, bits of b) + 1      -a   bits of a
//   a * b          bits of a + bits of b               a.shifted<k>()   bits of a + k
// so a formula is a derivation of its own bound, and no result can wrap. A value converts implicitly to a wider type. It
// converts to a narrower type by narrow<bits>(), and from a built-in integer by the explicit constructor: in both cases
// the caller states why the bound holds, and an assertion checks it.
//
// Two's complement, least limb first, in as few limbs as hold the bits and the sign. No memory is allocated. Limbs of 8
// and 32 bits exist for tests and for machines without 128-bit products.
//
// Laws: those of the ring of integers; sign(a - b) is the order; divide(a, b) gives q and r with a = q b + r, |r| < |b|,
// r 0 or with the sign of a; square_root(a) is the greatest r with r r <= a; common_divisor divides both and is a
// multiple of every common divisor.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "host/geometry/integer.hpp"

namespace sightline::geometry {

// Twice can hold a product of two limbs plus two limbs.
template <class Limb>
struct LimbTraits;
template <>
struct LimbTraits<std::uint8_t> {
  using Signed = std::int8_t;
  using Twice = std::uint32_t;
  using SignedTwice = std::int32_t;
};
template <>
struct LimbTraits<std::uint32_t> {
  using Signed = std::int32_t;
  using Twice = std::uint64_t;
  using SignedTwice = std::int64_t;
};
template <>
struct LimbTraits<std::uint64_t> {
  using Signed = std::int64_t;
  using Twice = Unsigned128;
  using SignedTwice = Int128;
};

// The number of bits of the limb; 0 for 0.
template <class Limb>
[[nodiscard]] constexpr unsigned limb_length(Limb limb) {
  unsigned length = 0;
  for (unsigned step = 4 * sizeof(Limb); step > 0; step /= 2) {
    if (limb >> step != 0) {
      length += step;
      limb = static_cast<Limb>(limb >> step);
    }
  }
  return length + (limb != 0 ? 1 : 0);
}

template <unsigned bits, class Limb = std::uint64_t>
class WideInteger {
  static_assert(bits > 0);

 public:
  static constexpr unsigned most_bits = bits;
  static constexpr unsigned limb_bits = 8 * sizeof(Limb);
  static constexpr std::size_t limbs = bits / limb_bits + 1;
  using Limbs = std::array<Limb, limbs>;

  constexpr WideInteger() = default;
  // Precondition: |value| < 2^bits.
  constexpr explicit WideInteger(Int128 value) {
    assert(bits > 127 || (magnitude(value) >> (bits & 127U)) == 0);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < limbs; ++i) {
      limb_[i] = static_cast<Limb>(value >> (i * limb_bits < 128 ? i * limb_bits : 127));
    }
  }
  // Implicit, because widening loses nothing.
  template <unsigned fewer>
  constexpr WideInteger(const WideInteger<fewer, Limb>& value)  // NOLINT(google-explicit-constructor)
      requires(fewer < bits) {
    copy(value);
  }
  // From two's complement. Precondition: |value| < 2^bits.
  [[nodiscard]] static constexpr WideInteger of_limbs(const Limbs& limbs_of_value) {
    WideInteger value;
    value.limb_ = limbs_of_value;
    assert(value.length() <= bits);
    return value;
  }

  [[nodiscard]] constexpr const Limbs& limbs_of_value() const {
    return limb_;
  }
  // The limbs of |this|, unsigned.
  [[nodiscard]] constexpr Limbs limbs_of_magnitude() const {
    return negative() ? negative_of(limb_) : limb_;
  }
  [[nodiscard]] constexpr bool negative() const {
    return limb_[limbs - 1] >> (limb_bits - 1) != 0;
  }
  [[nodiscard]] constexpr int sign() const {
    if (negative()) return -1;
    Limb any = 0;
    for (const Limb limb : limb_) any = static_cast<Limb>(any | limb);
    return any != 0 ? 1 : 0;
  }
  // The number of bits of the magnitude; 0 for 0.
  [[nodiscard]] constexpr unsigned length() const {
    const Limbs parts = limbs_of_magnitude();
    for (std::size_t i = limbs; i-- > 0;) {
      if (parts[i] != 0) return static_cast<unsigned>(i) * limb_bits + limb_length(parts[i]);
    }
    return 0;
  }
  // The number of zeros below the lowest 1. Precondition: the number is not 0.
  [[nodiscard]] constexpr unsigned trailing_zeros() const {
    std::size_t i = 0;
    while (limb_[i] == 0) ++i;
    const auto lowest = static_cast<Limb>(limb_[i] & (~limb_[i] + 1U));
    return static_cast<unsigned>(i) * limb_bits + limb_length(lowest) - 1;
  }
  // Precondition: |this| < 2^fewer.
  template <unsigned fewer>
  [[nodiscard]] constexpr WideInteger<fewer, Limb> narrow() const {
    static_assert(fewer <= bits);
    assert(length() <= fewer);
    WideInteger<fewer, Limb> value;
    for (std::size_t i = 0; i < value.limbs; ++i) value.limb_[i] = limb_[i];
    return value;
  }
  [[nodiscard]] constexpr Int128 to_int128() const {
    static_assert(bits <= 127);
    Unsigned128 value = 0;
    for (std::size_t i = 0; i < limbs; ++i) value |= static_cast<Unsigned128>(limb_[i]) << (i * limb_bits);
    if constexpr (limbs * limb_bits < 128) {
      if (negative()) value |= ~Unsigned128{0} << (limbs * limb_bits);
    }
    return static_cast<Int128>(value);
  }
  // The relative error is at most 2^-52.
  [[nodiscard]] double to_double() const {
    static_assert(bits < 1023);
    if constexpr (limbs == 1 && limb_bits == 64) {
      return static_cast<double>(static_cast<std::int64_t>(limb_[0]));
    } else {
      const Limbs parts = limbs_of_magnitude();
      constexpr double next_limb = 2.0 * static_cast<double>(Limb{1} << (limb_bits - 1));
      double value = 0;
      for (std::size_t i = limbs; i-- > 0;) value = value * next_limb + static_cast<double>(parts[i]);
      return negative() ? -value : value;
    }
  }

  [[nodiscard]] constexpr WideInteger operator-() const {
    WideInteger result;
    result.limb_ = negative_of(limb_);
    return result;
  }
  template <unsigned more>
  [[nodiscard]] constexpr auto operator+(const WideInteger<more, Limb>& other) const {
    using Sum = WideInteger<(bits > more ? bits : more) + 1, Limb>;
    Sum sum;
    if constexpr (small<Sum>) {
      sum.take(two_limbs() + other.two_limbs());
    } else {
      const Sum a = *this;
      const Sum b = other;
      Limb carry = 0;
#pragma GCC unroll 8
      for (std::size_t i = 0; i < Sum::limbs; ++i) {
        const auto part = static_cast<Limb>(a.limb_[i] + carry);
        const Limb first = part < carry ? 1 : 0;
        sum.limb_[i] = static_cast<Limb>(part + b.limb_[i]);
        carry = static_cast<Limb>(first + (sum.limb_[i] < part ? 1 : 0));
      }
    }
    return sum;
  }
  template <unsigned more>
  [[nodiscard]] constexpr auto operator-(const WideInteger<more, Limb>& other) const {
    using Difference = WideInteger<(bits > more ? bits : more) + 1, Limb>;
    Difference difference;
    if constexpr (small<Difference>) {
      difference.take(two_limbs() - other.two_limbs());
    } else {
      const Difference a = *this;
      const Difference b = other;
      Limb borrow = 0;
#pragma GCC unroll 8
      for (std::size_t i = 0; i < Difference::limbs; ++i) {
        const auto part = static_cast<Limb>(a.limb_[i] - borrow);
        const Limb first = part > a.limb_[i] ? 1 : 0;
        difference.limb_[i] = static_cast<Limb>(part - b.limb_[i]);
        borrow = static_cast<Limb>(first + (difference.limb_[i] > part ? 1 : 0));
      }
    }
    return difference;
  }
  template <unsigned more>
  [[nodiscard]] constexpr auto operator*(const WideInteger<more, Limb>& other) const {
    using Product = WideInteger<bits + more, Limb>;
    Product product;
    if constexpr (small<Product>) {
      product.take(two_limbs() * other.two_limbs());
    } else {
      // The product of the limbs as unsigned numbers, in which a negative factor counts as greater by 2^(bits of its
      // limbs). The product has as many limbs as the factors together, or one less.
      constexpr std::size_t other_limbs = WideInteger<more, Limb>::limbs;
#pragma GCC unroll 4
      for (std::size_t i = 0; i < limbs; ++i) {
        Limb carry = 0;
#pragma GCC unroll 8
        for (std::size_t j = 0; j < other_limbs; ++j) {
          const Twice part = Twice{limb_[i]} * other.limb_[j] + product.limb_[i + j] + carry;
          product.limb_[i + j] = static_cast<Limb>(part);
          carry = static_cast<Limb>(part >> limb_bits);
        }
        if (i + other_limbs < Product::limbs) product.limb_[i + other_limbs] = carry;
      }
      product.template subtract_above<limbs>(other.limb_, sign_fill());
      product.template subtract_above<other_limbs>(limb_, other.sign_fill());
    }
    return product;
  }
  template <unsigned by>
  [[nodiscard]] constexpr WideInteger<bits + by, Limb> shifted() const {
    return WideInteger<bits + by, Limb>(*this).shifted_within(by);
  }
  // this / 2^by, rounded down.
  [[nodiscard]] constexpr WideInteger shifted_down(unsigned by) const {
    WideInteger result;
    const std::size_t whole = by / limb_bits;
    const unsigned rest = by % limb_bits;
    for (std::size_t i = 0; i < limbs; ++i) {
      const Limb low = i + whole < limbs ? limb_[i + whole] : sign_fill();
      const Limb high = i + whole + 1 < limbs ? limb_[i + whole + 1] : sign_fill();
      result.limb_[i] = static_cast<Limb>((Twice{high} << limb_bits | low) >> rest);
    }
    return result;
  }
  // this 2^by. Precondition: the result is below 2^bits.
  [[nodiscard]] constexpr WideInteger shifted_within(unsigned by) const {
    assert(length() == 0 || length() + by <= bits);
    WideInteger result;
    const std::size_t whole = by / limb_bits;
    const unsigned rest = by % limb_bits;
    for (std::size_t i = limbs; i-- > whole;) {
      Limb part = static_cast<Limb>(limb_[i - whole] << rest);
      if (rest != 0 && i > whole) part = static_cast<Limb>(part | limb_[i - whole - 1] >> (limb_bits - rest));
      result.limb_[i] = part;
    }
    return result;
  }

  friend constexpr bool operator==(const WideInteger&, const WideInteger&) = default;

 private:
  template <unsigned, class>
  friend class WideInteger;
  using Twice = typename LimbTraits<Limb>::Twice;

  // Results of at most two limbs are computed with built-in integers, which take the fewest instructions. Only bits of a
  // Twice above two limbs are wrong.
  template <class Result>
  static constexpr bool small = Result::limbs <= 2;
  [[nodiscard]] constexpr Twice two_limbs() const {
    static_assert(limbs <= 2);
    if constexpr (limbs == 2) {
      return Twice{limb_[1]} << limb_bits | limb_[0];
    } else {
      using Traits = LimbTraits<Limb>;
      return static_cast<Twice>(typename Traits::SignedTwice{static_cast<typename Traits::Signed>(limb_[0])});
    }
  }
  constexpr void take(Twice value) {
    limb_[0] = static_cast<Limb>(value);
    if constexpr (limbs == 2) limb_[1] = static_cast<Limb>(value >> limb_bits);
  }

  // The value of all limbs above the highest.
  [[nodiscard]] constexpr Limb sign_fill() const {
    return negative() ? static_cast<Limb>(~Limb{0}) : Limb{0};
  }

  [[nodiscard]] static constexpr Limbs negative_of(const Limbs& value) {
    Limbs result{};
    Limb carry = 1;
    for (std::size_t i = 0; i < limbs; ++i) {
      result[i] = static_cast<Limb>(static_cast<Limb>(~value[i]) + carry);
      carry = carry != 0 && result[i] == 0 ? 1 : 0;
    }
    return result;
  }

  template <unsigned fewer>
  constexpr void copy(const WideInteger<fewer, Limb>& value) {
    constexpr std::size_t given = WideInteger<fewer, Limb>::limbs;
    for (std::size_t i = 0; i < given; ++i) limb_[i] = value.limb_[i];
    if constexpr (given < limbs) {
      for (std::size_t i = given; i < limbs; ++i) limb_[i] = value.sign_fill();
    }
  }
  // Subtracts `value` & mask from the limbs from index `from` on, modulo their range.
  template <std::size_t from, std::size_t count>
  constexpr void subtract_above(const std::array<Limb, count>& value, Limb mask) {
    Limb borrow = 0;
#pragma GCC unroll 8
    for (std::size_t i = 0; from + i < limbs; ++i) {
      const auto part = static_cast<Limb>(limb_[from + i] - borrow);
      const Limb first = part > limb_[from + i] ? 1 : 0;
      limb_[from + i] = static_cast<Limb>(part - (value[i] & mask));
      borrow = static_cast<Limb>(first + (limb_[from + i] > part ? 1 : 0));
    }
  }

  Limbs limb_{};
};

template <unsigned bits, class Limb>
[[nodiscard]] constexpr int sign(const WideInteger<bits, Limb>& n) {
  return n.sign();
}
template <unsigned a, unsigned b, class Limb>
[[nodiscard]] constexpr bool operator<(const WideInteger<a, Limb>& x, const WideInteger<b, Limb>& y) {
  return (x - y).negative();
}
template <unsigned a, unsigned b, class Limb>
[[nodiscard]] constexpr bool operator>(const WideInteger<a, Limb>& x, const WideInteger<b, Limb>& y) {
  return y < x;
}
template <unsigned a, unsigned b, class Limb>
[[nodiscard]] constexpr bool operator<=(const WideInteger<a, Limb>& x, const WideInteger<b, Limb>& y) {
  return !(y < x);
}
template <unsigned a, unsigned b, class Limb>
[[nodiscard]] constexpr bool operator>=(const WideInteger<a, Limb>& x, const WideInteger<b, Limb>& y) {
  return !(x < y);
}

// --- division and roots, for the few places that need them: by the schoolbook methods, in quadratic time

template <unsigned a, unsigned b, class Limb>
struct Division {
  WideInteger<a, Limb> quotient;
  WideInteger<b, Limb> remainder;
};

// Rounds towards 0. Precondition: y is not 0. Knuth, The Art of Computer Programming 2, section 4.3.1, algorithm D.
template <unsigned a, unsigned b, class Limb>
[[nodiscard]] constexpr Division<a, b, Limb> divide(const WideInteger<a, Limb>& x,
                                                    const WideInteger<b, Limb>& y) {
  using Twice = typename LimbTraits<Limb>::Twice;
  using Dividend = WideInteger<a, Limb>;
  using Divisor = WideInteger<b, Limb>;
  constexpr unsigned limb_bits = Dividend::limb_bits;
  assert(y.sign() != 0);
  const auto dividend = x.limbs_of_magnitude();
  auto divisor = y.limbs_of_magnitude();
  std::size_t m = Dividend::limbs;
  while (m > 0 && dividend[m - 1] == 0) --m;
  std::size_t n = Divisor::limbs;
  while (divisor[n - 1] == 0) --n;
  // Both are shifted so that the divisor's highest limb has its top bit set.
  const unsigned shift = limb_bits - limb_length(divisor[n - 1]);
  const auto joined = [shift](Limb high, Limb low) {
    return static_cast<Limb>((Twice{high} << limb_bits | low) >> (limb_bits - shift));
  };
  std::array<Limb, Dividend::limbs + 1> rest{};
  if (m > 0) rest[m] = joined(0, dividend[m - 1]);
  for (std::size_t i = m; i-- > 0;) rest[i] = joined(dividend[i], i > 0 ? dividend[i - 1] : Limb{0});
  for (std::size_t i = n; i-- > 0;) divisor[i] = joined(divisor[i], i > 0 ? divisor[i - 1] : Limb{0});
  typename Dividend::Limbs quotient{};
  for (std::size_t j = m >= n ? m - n + 1 : 0; j-- > 0;) {
    // A digit estimated from the highest limbs is never too small and at most 2 too large (theorem B there).
    constexpr Twice most = static_cast<Limb>(~Limb{0});
    const Twice guess = (Twice{rest[j + n]} << limb_bits | rest[j + n - 1]) / divisor[n - 1];
    auto digit = static_cast<Limb>(guess < most ? guess : most);
    Twice borrow = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Twice product = Twice{digit} * divisor[i] + borrow;
      const auto low = static_cast<Limb>(product);
      borrow = (product >> limb_bits) + (rest[j + i] < low ? 1U : 0U);
      rest[j + i] = static_cast<Limb>(rest[j + i] - low);
    }
    bool negative = rest[j + n] < borrow;
    rest[j + n] = static_cast<Limb>(rest[j + n] - borrow);
    while (negative) {
      --digit;
      Twice carry = 0;
      for (std::size_t i = 0; i < n; ++i) {
        carry += Twice{rest[j + i]} + divisor[i];
        rest[j + i] = static_cast<Limb>(carry);
        carry >>= limb_bits;
      }
      carry += rest[j + n];
      rest[j + n] = static_cast<Limb>(carry);
      negative = carry >> limb_bits == 0;
    }
    quotient[j] = digit;
  }
  typename Divisor::Limbs remainder{};
  for (std::size_t i = 0; i < n && i <= m; ++i) {
    const Limb above = i + 1 <= m && i + 1 < n ? rest[i + 1] : Limb{0};
    remainder[i] = static_cast<Limb>((Twice{above} << limb_bits | rest[i]) >> shift);
  }
  Division<a, b, Limb> result{Dividend::of_limbs(quotient), Divisor::of_limbs(remainder)};
  if (x.negative() != y.negative()) result.quotient = -result.quotient;
  if (x.negative()) result.remainder = -result.remainder;
  return result;
}

// The greatest integer whose square is at most n. Precondition: n is not negative.
template <unsigned bits, class Limb>
[[nodiscard]] constexpr WideInteger<bits / 2 + 1, Limb> square_root(const WideInteger<bits, Limb>& n) {
  using Root = WideInteger<bits / 2 + 1, Limb>;
  assert(!n.negative());
  const unsigned length = n.length();
  if (length == 0) return {};
  // Newton's iteration from above: a start that is at least the root falls to it and then stops falling. The root of the
  // upper half of n, rounded up, has half of the root's digits right, and each step doubles them.
  Root root;
  if (length <= 6) {
    root = Root((Int128{1} << (length + 1) / 2) - 1);
  } else {
    const unsigned lower = length / 4;
    const auto upper = square_root(n.shifted_down(2 * lower)) + Root(1);
    root = upper.shifted_within(lower).template narrow<bits / 2 + 1>();
  }
  for (;;) {
    const auto next = (root + divide(n, root).quotient).shifted_down(1);
    if (!(next < root)) return root;
    root = next.template narrow<bits / 2 + 1>();
  }
}

// Not negative; the divisor of 0 and n is |n|. By subtraction and halving.
template <unsigned a, unsigned b, class Limb>
[[nodiscard]] constexpr auto common_divisor(const WideInteger<a, Limb>& x, const WideInteger<b, Limb>& y) {
  using Divisor = WideInteger<(a > b ? a : b), Limb>;
  Divisor m = x.negative() ? -x : x;
  Divisor n = y.negative() ? -y : y;
  if (m.sign() == 0) return n;
  if (n.sign() == 0) return m;
  const unsigned twos = m.trailing_zeros() < n.trailing_zeros() ? m.trailing_zeros() : n.trailing_zeros();
  m = m.shifted_down(m.trailing_zeros());
  for (;;) {
    n = n.shifted_down(n.trailing_zeros());
    const auto difference = n - m;
    if (difference.sign() == 0) return m.shifted_within(twos);
    if (difference.negative()) {
      m = n;
      n = (-difference).template narrow<Divisor::most_bits>();
    } else {
      n = difference.template narrow<Divisor::most_bits>();
    }
  }
}

}  // namespace sightline::geometry
