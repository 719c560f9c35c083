// Integers of several limbs against 128-bit ones, and by the laws of arithmetic where those end.
#include "host/algorithms/jones/fixed_integer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host/algorithms/jones/arithmetic.hpp"
#include "host/geometry/predicates.hpp"

namespace sightline::algorithms::jones {
namespace {

using geometry::Int128;

class Numbers {
 public:
  // Of any length up to `bits`, either sign; often 0 and powers of two, and one less.
  Int128 next(unsigned bits) {
    const auto length = static_cast<unsigned>(dice_() % (bits + 1));
    Int128 value = dice_() % 4 == 0 ? Int128{0}
                                    : (Int128{static_cast<std::int64_t>(dice_() >> 1)} << 62) +
                                          static_cast<std::int64_t>(dice_() >> 2);
    value &= (Int128{1} << length) - 1;
    if (dice_() % 8 == 0) value = Int128{1} << (length == bits ? bits - 1 : length);
    return dice_() % 2 == 0 ? value : -value;
  }

 private:
  std::mt19937_64 dice_{3};
};

template <std::size_t limbs>
bool equal(const FixedInteger<limbs>& a, const FixedInteger<limbs>& b) {
  return (a - b).sign() == 0;
}

TEST(FixedInteger, AgreesWith128Bits) {
  Numbers numbers;
  for (int i = 0; i < 20000; ++i) {
    const Int128 a = numbers.next(62);
    const Int128 b = numbers.next(62);
    using Fixed = FixedInteger<4>;
    EXPECT_TRUE(equal(Fixed(a) * Fixed(b), Fixed(a * b)));
    EXPECT_TRUE(equal(Fixed(a) + Fixed(b), Fixed(a + b)));
    EXPECT_TRUE(equal(Fixed(a) - Fixed(b), Fixed(a - b)));
    EXPECT_EQ(Fixed(a).sign(), geometry::sign(a));
    EXPECT_EQ((Fixed(a) - Fixed(b)).sign(), geometry::sign(a - b));
  }
}

TEST(FixedInteger, KeepsTheLawsBeyond128Bits) {
  Numbers numbers;
  for (int i = 0; i < 20000; ++i) {
    using Fixed = FixedInteger<6>;
    const Fixed a(numbers.next(120));
    const Fixed b(numbers.next(120));
    const Fixed c(numbers.next(120));
    EXPECT_TRUE(equal(a * b * c, c * b * a));
    EXPECT_TRUE(equal((a + b) * (a - b), a * a - b * b));
    EXPECT_TRUE(equal((a + b) * c * c, a * c * c + b * c * c));
    EXPECT_EQ((a * b * c).sign(), a.sign() * b.sign() * c.sign());
    const double product = (a * b * c).to_double();
    const double expected = a.to_double() * b.to_double() * c.to_double();
    EXPECT_LE(std::fabs(product - expected), std::fabs(expected) * 0x1p-48);
    EXPECT_TRUE(equal(FixedInteger<6>(FixedInteger<2>(Int128{-5})), Fixed(Int128{-5})));
  }
}

// The sign tried in doubles first is the sign: also where a ray all but lies on the line.
TEST(WideArithmetic, SignsAreExactWhereDoublesAreNot) {
  Numbers numbers;
  for (int i = 0; i < 5000; ++i) {
    const auto triple = [&] {
      return WideArithmetic::line({numbers.next(100), numbers.next(100), numbers.next(100)});
    };
    const WideArithmetic::Line u = triple();
    const WideArithmetic::Line v = triple();
    const WideArithmetic::Ray ray = WideArithmetic::meet(u, v);
    EXPECT_EQ(WideArithmetic::side(u, ray), 0);
    EXPECT_EQ(WideArithmetic::side(v, ray), 0);
    const auto nudged =
        WideArithmetic::line({u.part[0] + v.part[0] + 1, u.part[1] + v.part[1], u.part[2] + v.part[2]});
    EXPECT_EQ(WideArithmetic::side(nudged, ray), ray.part[0].sign());
  }
}

}  // namespace
}  // namespace sightline::algorithms::jones
