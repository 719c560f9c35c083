// The widest arithmetic of Jones's search, for signs that are hard to determine.
#include "host/algorithms/jones/arithmetic.hpp"

#include <gtest/gtest.h>

#include <random>

#include "host/algorithms/jones/stretch.hpp"

namespace sightline::algorithms::jones {
namespace {

using geometry::Int128;

class Numbers {
 public:
  // A number of any length up to `bits`, of either sign; often 0, a power of two, or one less.
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

// The sign computed first in doubles is correct, also where a ray almost lies on the line.
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

// Fractions with the longest possible parts, one unit apart.
TEST(WideArithmetic, FractionsAreComparedExactly) {
  const Int128 most = (((Int128{1} << 126) - 1) << 1) + 1;
  const Fraction<Int128> larger{most - 1, most};
  const Fraction<Int128> smaller{most - 2, most - 1};
  EXPECT_TRUE(less(smaller, larger));
  EXPECT_FALSE(less(larger, smaller));
  EXPECT_FALSE(less(larger, larger));
  const Fraction<Int128> half{1, 2};
  EXPECT_FALSE(less({most / 3, most / 3 * 2}, half));
  EXPECT_FALSE(less(half, {most / 3, most / 3 * 2}));
  const Fraction<Int128> nothing{0, most};
  EXPECT_TRUE(less(nothing, {1, most}));
}

}  // namespace
}  // namespace sightline::algorithms::jones
