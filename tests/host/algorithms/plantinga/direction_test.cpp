// Directions with the longest possible coefficients: their order, and directions between them, compared with GMP with floating
// point
// of 4096 bits; their angles, bit for bit, compared with the same formula in GMP's integers.
#include "host/algorithms/plantinga/direction.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/host/geometry/gmp_integer.hpp"

namespace sightline::algorithms::plantinga {
namespace {

constexpr unsigned precision = 4096;

mpz_class to_gmp(Int128 n) {
  return geometry::to_gmp(geometry::WideInteger<128>(n));
}

mpz_class discriminant(const QuadraticForm& form) {
  return to_gmp(form.xz) * to_gmp(form.xz) - 4 * to_gmp(form.xx) * to_gmp(form.zz);
}

// X and Z of a direction, much more precise than two directions can be close.
std::array<mpf_class, 2> near(const Direction& direction) {
  const QuadraticForm& form = direction.form;
  if (direction.rational)
    return {mpf_class(to_gmp(form.xx), precision), mpf_class(to_gmp(form.zz), precision)};
  const mpf_class root = sqrt(mpf_class(discriminant(form), precision));
  const mpf_class x = direction.root * root - mpf_class(to_gmp(form.xz), precision);
  return {direction.side * x, mpf_class(direction.side * 2 * to_gmp(form.xx), precision)};
}

// The sign of the turn from one to the other; they are less than pi apart.
int turn(const std::array<mpf_class, 2>& a, const std::array<mpf_class, 2>& b) {
  const mpf_class value = b[0] * a[1] - a[0] * b[1];
  const mpf_class size = abs(b[0] * a[1]) + abs(a[0] * b[1]);
  mpf_class floor;
  mpf_div_2exp(floor.get_mpf_t(), size.get_mpf_t(), precision / 2);
  return abs(value) <= floor ? 0 : sgn(value);
}

// The algorithm of direction.cpp, in integers of any length.
double expected_angle(const Direction& direction) {
  const QuadraticForm& form = direction.form;
  mpz_class x = to_gmp(form.xx);
  mpz_class z = to_gmp(form.zz);
  if (!direction.rational) {
    constexpr unsigned bits = 192;
    const mpz_class d = discriminant(form) << (2 * bits);
    x = direction.root * mpz_class(sqrt(d)) - (to_gmp(form.xz) << bits);
    z = mpz_class(2 * to_gmp(form.xx)) << bits;
  }
  std::array<long, 2> exponents{};
  const double fx = mpz_get_d_2exp(&exponents[0], x.get_mpz_t());
  const double fz = mpz_get_d_2exp(&exponents[1], z.get_mpz_t());
  const long largest = fx == 0 ? exponents[1] : fz == 0 ? exponents[0] : std::max(exponents[0], exponents[1]);
  const auto scaled = [largest](double f, long exponent) {
    return std::ldexp(f, static_cast<int>(std::max(exponent - largest, -1000L)));
  };
  return std::atan2(scaled(fx, exponents[0]), scaled(fz, exponents[1]));
}

class Forms {
 public:
  // Of either sign, below 2^bits.
  Int128 coefficient(unsigned bits) {
    const Int128 any =
        (Int128{static_cast<std::int64_t>(dice_() >> 2)} << 62) + static_cast<std::int64_t>(dice_() >> 2);
    const Int128 value = dice_() % 8 == 0 ? (Int128{1} << bits) - 1 : any & ((Int128{1} << bits) - 1);
    return dice_() % 2 == 0 ? value : -value;
  }
  QuadraticForm form(unsigned bits) { return {coefficient(bits), coefficient(bits), coefficient(bits)}; }
  unsigned bits() { return 2 + static_cast<unsigned>(dice_() % 103); }

 private:
  std::mt19937_64 dice_{1990};
};

// Roots of a form and of similar forms, and the rational directions nearest to them.
std::vector<Direction> crowd(Forms& forms) {
  const QuadraticForm form = forms.form(forms.bits());
  std::vector<Direction> directions;
  for (const Int128 more : {0, 1}) {
    for (const Direction& root : roots_of(QuadraticForm{form.xx, form.xz, form.zz - more}))
      directions.push_back(root);
  }
  const std::vector<Direction> exact = directions;
  for (const Direction& direction : exact) {
    // Two convergents of X / Z, with the longest possible coefficients.
    const auto [x, z] = near(direction);
    if (x == 0 || z == 0) continue;
    mpf_class rest = abs(x / z);
    std::array<mpz_class, 2> p{0, 1};
    std::array<mpz_class, 2> q{1, 0};
    for (;;) {
      const mpz_class whole(rest);
      const mpz_class next_p = whole * p[1] + p[0];
      const mpz_class next_q = whole * q[1] + q[0];
      if (mpz_sizeinbase(next_p.get_mpz_t(), 2) > 104 || mpz_sizeinbase(next_q.get_mpz_t(), 2) > 104) break;
      p = {p[1], next_p};
      q = {q[1], next_q};
      rest -= whole;
      if (rest < 1e-300) break;
      rest = 1 / rest;
    }
    for (const std::size_t i : {0U, 1U}) {
      const auto wide_p = geometry::from_gmp<geometry::WideInteger<104>>(sgn(x) * p[i]);
      const auto wide_q = geometry::from_gmp<geometry::WideInteger<104>>(sgn(z) * q[i]);
      directions.push_back(rational_direction(wide_p.to_int128(), wide_q.to_int128()));
    }
  }
  return directions;
}

TEST(Direction, RootsHaveTheAngleThatGmpGivesThem) {
  Forms forms;
  for (int i = 0; i < 3000; ++i) {
    const QuadraticForm form = forms.form(forms.bits());
    const auto roots = roots_of(form);
    if (roots.empty()) {
      EXPECT_TRUE(discriminant(form) <= 0 || (form.xx == 0 && form.xz == 0));
      continue;
    }
    ASSERT_EQ(roots.size(), 4U);
    for (const std::size_t k : {0U, 2U}) {
      if (!roots[k].rational || form.xx != 0) {
        EXPECT_EQ(roots[k].angle, expected_angle(roots[k]));
      }
      const auto [x, z] = near(roots[k]);
      const mpf_class value = to_gmp(form.xx) * x * x + to_gmp(form.xz) * x * z + to_gmp(form.zz) * z * z;
      EXPECT_LT(abs(value), 1e-300);
      EXPECT_TRUE(turn(near(roots[k]), near(roots[k + 1])) == 0);
    }
  }
}

// Products of two linear forms with the longest possible factors: rational roots in lowest terms.
TEST(Direction, RootsOfReducibleFormsAreRational) {
  Forms forms;
  for (int i = 0; i < 1000; ++i) {
    const Int128 a = forms.coefficient(51);
    const Int128 b = forms.coefficient(51);
    const Int128 c = forms.coefficient(51);
    const Int128 d = forms.coefficient(51);
    for (const Direction& root : roots_of(QuadraticForm{a * c, a * d + b * c, b * d})) {
      EXPECT_TRUE(root.rational);
      EXPECT_TRUE(a * root.form.xx + b * root.form.zz == 0 || c * root.form.xx + d * root.form.zz == 0);
    }
  }
}

TEST(Direction, OrderIsExactForAnyDistance) {
  Forms forms;
  int near_ones = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<Direction> directions = crowd(forms);
    for (const Direction& a : directions) {
      for (const Direction& b : directions) {
        if (std::abs(a.angle - b.angle) > 1) continue;
        const int expected = turn(near(b), near(a));
        ASSERT_EQ(compare(a, b), expected);
        ASSERT_EQ(expected == 0, a == b);
        near_ones += std::abs(a.angle - b.angle) < 2 * angle_error;
      }
    }
  }
  EXPECT_GT(near_ones, 1000);
}

TEST(Direction, ThereIsOneBetweenAnyTwo) {
  Forms forms;
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    const std::vector<Direction> directions = crowd(forms);
    for (const Direction& a : directions) {
      for (const Direction& b : directions) {
        if (turn(near(a), near(b)) <= 0) continue;
        const WideSight sight = wide_sight_between(a, b);
        const std::array<mpf_class, 2> between{mpf_class(geometry::to_gmp(sight.x), precision),
                                               mpf_class(geometry::to_gmp(sight.z), precision)};
        ASSERT_EQ(turn(near(a), between), 1);
        ASSERT_EQ(turn(between, near(b)), 1);
        ++found;
      }
    }
  }
  EXPECT_GT(found, 1000);
}

TEST(Direction, TheSignOfALinearFormIsExact) {
  Forms forms;
  int zeros = 0;
  for (int i = 0; i < 300; ++i) {
    for (const Direction& direction : crowd(forms)) {
      // A form that almost vanishes there, and its neighbours.
      const auto [x, z] = near(direction);
      const mpf_class larger = std::max(mpf_class(abs(x)), mpf_class(abs(z)));
      const mpf_class scale = ((std::int64_t{1} << 51) - 4) / larger;
      const mpz_class a(z * scale);
      const mpz_class b(-x * scale);
      for (const std::int64_t more : {-1, 0, 1}) {
        const LinearForm form{a.get_si() + more, b.get_si()};
        const mpf_class value = form.x * x + form.z * z;
        const mpf_class floor = larger / 1e300;
        const int expected = abs(value) <= floor ? 0 : sgn(value);
        ASSERT_EQ(sign_at(direction, form), expected);
        zeros += expected == 0;
      }
    }
  }
  EXPECT_GT(zeros, 10);
}

}  // namespace
}  // namespace sightline::algorithms::plantinga
