// The laws stated in host/geometry/rational.hpp.
#include "host/geometry/rational.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>

namespace sightline::geometry {
namespace {

TEST(Rational, IsKeptInLowestTermsWithAPositiveDenominator) {
  EXPECT_EQ(Rational(6, -4), Rational(-3, 2));
  EXPECT_EQ(Rational(6, -4).numerator(), -3);
  EXPECT_EQ(Rational(6, -4).denominator(), 2);
  EXPECT_EQ(Rational(0, -7), Rational(0));
}

TEST(Rational, ComparesExactlyWhereDoublesCannot) {
  constexpr std::int64_t big = std::numeric_limits<std::int64_t>::max();
  const Rational smaller(big - 1, big);
  const Rational larger(big - 2, big - 1);  // (n-1)/n grows with n
  EXPECT_EQ(smaller.to_double(), larger.to_double());
  EXPECT_LT(larger, smaller);
  EXPECT_LT(Rational(-big, 1), Rational(big, 1));
}

TEST(Rational, MediantLiesStrictlyBetween) {
  std::mt19937 random(1971);
  const auto draw = [&] {
    return Rational(static_cast<std::int64_t>(random() % 131071) - 65535,
                    static_cast<std::int64_t>(random() % 65535) + 1);
  };
  for (int i = 0; i < 10000; ++i) {
    Rational a = draw();
    Rational b = draw();
    if (a == b) continue;
    if (b < a) std::swap(a, b);
    EXPECT_LT(a, mediant(a, b));
    EXPECT_LT(mediant(a, b), b);
  }
}

}  // namespace
}  // namespace sightline::geometry
