// The laws stated in host/geometry/rational.hpp.
#include "host/geometry/rational.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
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

TEST(Rational, IsOrderedLikeFractionsOfGmp) {
  std::mt19937_64 random(7);
  const auto part = [&] {
    const auto value = static_cast<std::int64_t>(random() >> (1 + random() % 63));
    return random() % 8 == 0 ? std::numeric_limits<std::int64_t>::max() : value;
  };
  const auto draw = [&] {
    return Rational(random() % 2 == 0 ? part() : -part(), std::max<std::int64_t>(part(), 1));
  };
  const auto to_gmp = [](const Rational& r) {
    return mpq_class(mpz_class(r.numerator()), mpz_class(r.denominator()));
  };
  for (int i = 0; i < 20000; ++i) {
    const Rational a = draw();
    const Rational b = i % 3 == 0 ? Rational(a.numerator(), a.denominator()) : draw();
    const int expected = sign(cmp(to_gmp(a), to_gmp(b)));
    EXPECT_EQ(a < b, expected < 0);
    EXPECT_EQ(a == b, expected == 0);
    EXPECT_EQ(a > b, expected > 0);
    EXPECT_EQ(gcd(mpz_class(a.numerator()), mpz_class(a.denominator())), 1);
  }
}

}  // namespace
}  // namespace sightline::geometry
