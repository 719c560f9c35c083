// Wide integers: all pairs of small ones in limbs of 8 bits, and every width in use compared with GMP, at random and at the ends
// of the
// range.
#include "host/geometry/wide_integer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <type_traits>
#include <vector>

#include "tests/host/geometry/gmp_integer.hpp"

namespace sightline::geometry {
namespace {

using Small = WideInteger<8, std::uint8_t>;  // two limbs
constexpr int most_small = (1 << 8) - 1;

static_assert(WideInteger<63>::limbs == 1 && WideInteger<64>::limbs == 2 && WideInteger<127>::limbs == 2);
static_assert(WideInteger<128>::limbs == 3 && sizeof(WideInteger<255>) == 32);
// The type of a result has the number of bits that follows from its operands.
static_assert(
    std::is_same_v<decltype(WideInteger<75>() * WideInteger<75>() - WideInteger<150>()), WideInteger<151>>);
static_assert(std::is_same_v<decltype(WideInteger<75>() + WideInteger<37>()), WideInteger<76>>);
static_assert(std::is_same_v<decltype(WideInteger<75>().shifted<3>()), WideInteger<78>>);
// No bits are lost implicitly.
static_assert(std::is_convertible_v<WideInteger<75>, WideInteger<76>>);
static_assert(!std::is_constructible_v<WideInteger<75>, WideInteger<76>>);
static_assert(!std::is_convertible_v<int, WideInteger<75>>);
// Usable at compile time.
static_assert(WideInteger<200>(-7) * WideInteger<9>(6) == WideInteger<209>(-42));
static_assert(square_root(WideInteger<200>(1000001)) == WideInteger<101>(1000));

template <unsigned bits, class Limb>
int value_of(const WideInteger<bits, Limb>& n) {
  return static_cast<int>(n.to_int128());
}

TEST(WideInteger, AllPairsOfSmallOnes) {
  for (int a = -most_small; a <= most_small; ++a) {
    const Small x(a);
    ASSERT_EQ(value_of(x), a);
    ASSERT_EQ(value_of(-x), -a);
    ASSERT_EQ(x.sign(), sign(a));
    ASSERT_EQ(x.to_double(), a);
    ASSERT_EQ(value_of(x.shifted<9>()), a * 512);
    ASSERT_EQ(value_of(x.shifted_down(3)), a >> 3);
    ASSERT_EQ(value_of(x.shifted_down(11)), a >> 11);
    for (int b = -most_small; b <= most_small; ++b) {
      const Small y(b);
      ASSERT_EQ(value_of(x + y), a + b) << a << ' ' << b;
      ASSERT_EQ(value_of(x - y), a - b) << a << ' ' << b;
      ASSERT_EQ(value_of(x * y), a * b) << a << ' ' << b;
      ASSERT_EQ(x < y, a < b);
      ASSERT_EQ(x == y, a == b);
      ASSERT_EQ(value_of(common_divisor(x, y)), std::gcd(a, b)) << a << ' ' << b;
      if (b == 0) continue;
      const auto division = divide(x, y);
      ASSERT_EQ(value_of(division.quotient), a / b) << a << ' ' << b;
      ASSERT_EQ(value_of(division.remainder), a % b) << a << ' ' << b;
    }
  }
}

TEST(WideInteger, SmallRootsAndDivisionsOfThreeLimbsByTwo) {
  using Long = WideInteger<17, std::uint8_t>;
  for (int n = 0; n < 1 << 17; n += n < 1 << 14 ? 1 : 13) {
    const int root = value_of(square_root(Long(n)));
    ASSERT_TRUE(root * root <= n && n < (root + 1) * (root + 1)) << n;
    ASSERT_EQ(static_cast<int>(Long(n).length()), n == 0 ? 0 : std::ilogb(n) + 1);
    for (const int by : {1, 127, 128, 129, 255, n / 257 % 256 + 1}) {
      const auto division = divide(Long(n), WideInteger<9, std::uint8_t>(by));
      ASSERT_EQ(value_of(division.quotient), n / by) << n << ' ' << by;
      ASSERT_EQ(value_of(division.remainder), n % by) << n << ' ' << by;
    }
  }
}

// Integers of up to `bits` bits: ends of the range, neighbours of powers of two, long runs of equal digits, random ones.
class Numbers {
 public:
  mpz_class next(unsigned bits) {
    const auto length = static_cast<unsigned>(dice_() % (bits + 1));
    mpz_class value;
    switch (dice_() % 6) {
      case 0: value = (mpz_class(1) << bits) - 1; break;
      case 1: value = mpz_class(1) << (length == bits ? bits - 1 : length); break;
      case 2: value = (mpz_class(1) << length) - 1; break;
      case 3: mpz_rrandomb(value.get_mpz_t(), state_, length); break;
      default: value = random_.get_z_bits(length); break;
    }
    return dice_() % 2 == 0 ? mpz_class(-value) : value;
  }

 private:
  struct State {
    gmp_randstate_t state;
    State() { gmp_randinit_default(state); }
    ~State() { gmp_randclear(state); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    operator __gmp_randstate_struct*() { return state; }  // NOLINT: what GMP takes
  };
  std::mt19937_64 dice_{1971};
  State state_;
  gmp_randclass random_{gmp_randinit_default};
};

// Within the error that the header states.
void expect_near(double value, const mpz_class& n) {
  if (n == 0) {
    EXPECT_EQ(value, 0);
    return;
  }
  const double expected = n.get_d();
  EXPECT_LE(std::fabs(value - expected), std::fabs(expected) * 0x1p-52) << n;
}

template <unsigned a, unsigned b, class Limb = std::uint64_t>
void expect_as_gmp(int rounds) {
  Numbers numbers;
  for (int i = 0; i < rounds; ++i) {
    const mpz_class m = numbers.next(a);
    const mpz_class n = numbers.next(b);
    const auto x = from_gmp<WideInteger<a, Limb>>(m);
    const auto y = from_gmp<WideInteger<b, Limb>>(n);
    ASSERT_EQ(to_gmp(x), m);
    ASSERT_EQ(to_gmp(x + y), mpz_class(m + n));
    ASSERT_EQ(to_gmp(x - y), mpz_class(m - n));
    ASSERT_EQ(to_gmp(y - x), mpz_class(n - m));
    ASSERT_EQ(to_gmp(x * y), mpz_class(m * n));
    ASSERT_EQ(to_gmp(-x), mpz_class(-m));
    ASSERT_EQ(to_gmp(x.template shifted<70>()), mpz_class(m << 70));
    mpz_class down;
    mpz_fdiv_q_2exp(down.get_mpz_t(), m.get_mpz_t(), static_cast<unsigned>(i) % (a + 3));
    ASSERT_EQ(to_gmp(x.shifted_down(static_cast<unsigned>(i) % (a + 3))), down);
    ASSERT_EQ(x.sign(), sgn(m));
    ASSERT_EQ(x < y, m < n);
    ASSERT_EQ(x <= y, m <= n);
    ASSERT_EQ(x.length(), m == 0 ? 0 : mpz_sizeinbase(m.get_mpz_t(), 2));
    if constexpr (a < 1023) expect_near(x.to_double(), m);
    ASSERT_EQ(to_gmp(common_divisor(x, y)), mpz_class(gcd(m, n)));
    if (n != 0) {
      const auto division = divide(x, y);
      ASSERT_EQ(to_gmp(division.quotient), mpz_class(m / n)) << m << ' ' << n;
      ASSERT_EQ(to_gmp(division.remainder), mpz_class(m % n)) << m << ' ' << n;
      const auto whole = divide(x * y, y);
      ASSERT_EQ(to_gmp(whole.quotient), m);
      ASSERT_EQ(whole.remainder.sign(), 0);
    }
    const auto square = x * x;
    ASSERT_EQ(to_gmp(square_root(square)), mpz_class(abs(m)));
    if (m > 0) {
      ASSERT_EQ(to_gmp(square_root(x)), mpz_class(sqrt(m)));
    }
    if (m != 0) {
      ASSERT_EQ(to_gmp(square_root(-(WideInteger<1, Limb>(1) - square))), mpz_class(abs(m) - 1));
    }
  }
}

TEST(WideInteger, AgreesWithGmpInTheWidthsOfMontaniAndRe) {
  expect_as_gmp<75, 75>(1000);
  expect_as_gmp<119, 80>(1000);
  expect_as_gmp<151, 37>(1000);
  expect_as_gmp<151, 151>(1000);
  expect_as_gmp<190, 189>(1000);
  expect_as_gmp<276, 151>(1000);
}

TEST(WideInteger, AgreesWithGmpInTheWidthsOfJones) {
  expect_as_gmp<126, 126>(1000);
  expect_as_gmp<253, 126>(1000);
}

TEST(WideInteger, AgreesWithGmpInTheWidthsOfWillisAndOfCuttingSpace) {
  expect_as_gmp<31, 64>(1000);
  expect_as_gmp<74, 64>(1000);
  expect_as_gmp<123, 61>(1000);
  expect_as_gmp<128, 64>(1000);
}

TEST(WideInteger, AgreesWithGmpInTheWidthsOfPlantinga) {
  expect_as_gmp<104, 104>(1000);
  expect_as_gmp<210, 211>(1000);
  expect_as_gmp<425, 211>(500);
  expect_as_gmp<595, 298>(500);
  expect_as_gmp<1024, 39>(200);
  expect_as_gmp<1024, 1024>(100);
}

TEST(WideInteger, AgreesWithGmpInLimbsOf8And32Bits) {
  expect_as_gmp<75, 37, std::uint32_t>(1000);
  expect_as_gmp<151, 151, std::uint32_t>(1000);
  expect_as_gmp<31, 40, std::uint8_t>(1000);
  expect_as_gmp<64, 63, std::uint8_t>(1000);
}

// For each number of limbs the largest and smallest value, and those of one bit less.
template <unsigned bits>
void expect_ends() {
  using Wide = WideInteger<bits>;
  const mpz_class end = (mpz_class(1) << bits) - 1;
  for (const mpz_class& m :
       {end, mpz_class(-end), mpz_class(end >> 1), mpz_class(-(end >> 1)), mpz_class(0)}) {
    for (const mpz_class& n : {end, mpz_class(-end), mpz_class(end >> 1), mpz_class(1), mpz_class(-1)}) {
      const auto x = from_gmp<Wide>(m);
      const auto y = from_gmp<Wide>(n);
      EXPECT_EQ(to_gmp(x + y), mpz_class(m + n));
      EXPECT_EQ(to_gmp(x - y), mpz_class(m - n));
      EXPECT_EQ(to_gmp(x * y), mpz_class(m * n));
      if (n != 0) {
        EXPECT_EQ(to_gmp(divide(x, y).quotient), mpz_class(m / n));
      }
      EXPECT_EQ(to_gmp(x.template narrow<bits>()), m);
      EXPECT_EQ(to_gmp(WideInteger<bits + 65>(x)), m);
    }
  }
}

TEST(WideInteger, EndsOfTheRange) {
  expect_ends<1>();
  expect_ends<62>();
  expect_ends<63>();
  expect_ends<64>();
  expect_ends<65>();
  expect_ends<126>();
  expect_ends<127>();
  expect_ends<128>();
  expect_ends<191>();
  expect_ends<192>();
  expect_ends<193>();
  expect_ends<255>();
  expect_ends<256>();
  expect_ends<1023>();
}

TEST(WideInteger, TakesAndGivesBuiltInIntegers) {
  const Int128 least = -(Int128{1} << 126) * 2;
  for (const Int128 n :
       {least, least + 1, -(least + 1), Int128{0}, Int128{-1}, Int128{1} << 64, -(Int128{1} << 64)}) {
    if (n != least) {
      EXPECT_TRUE(WideInteger<127>(n).to_int128() == n);
    }
    const WideInteger<128> wide(n);
    EXPECT_EQ(wide.sign(), sign(n));
    const mpz_class high = static_cast<long>(n >> 64);
    EXPECT_EQ(to_gmp(wide), mpz_class((high << 64) + mpz_class(static_cast<unsigned long>(n))));
    EXPECT_EQ(to_gmp(WideInteger<400>(n)), to_gmp(wide));
  }
  EXPECT_EQ(WideInteger<63>(std::int64_t{-5}).to_double(), -5);
}

#if !defined(NDEBUG) && GTEST_HAS_DEATH_TEST
TEST(WideIntegerDeathTest, ABoundThatDoesNotHoldStopsTheProgram) {
  EXPECT_DEATH(WideInteger<63>(Int128{1} << 63), "");
  EXPECT_DEATH((void)WideInteger<75>(16).narrow<4>(), "");
}
#endif

TEST(CommonDivisor, OfWordsIsThatOfTheStandardLibrary) {
  std::mt19937_64 dice(11);
  const auto number = [&dice] { return dice() >> (dice() % 64); };
  for (int round = 0; round < 20000; ++round) {
    const std::uint64_t common = number();
    for (const std::uint64_t factor : {std::uint64_t{1}, common | 1U, common}) {
      const std::uint64_t m = number() * factor;
      const std::uint64_t n = round % 50 == 0 ? 0 : number() * factor;
      ASSERT_EQ(common_divisor(m, n), std::gcd(m, n)) << m << ' ' << n;
      ASSERT_EQ(common_divisor(n, m), std::gcd(m, n)) << m << ' ' << n;
    }
  }
  static_assert(common_divisor(std::uint64_t{0}, std::uint64_t{0}) == 0);
  static_assert(common_divisor(~std::uint64_t{0}, ~std::uint64_t{0}) == ~std::uint64_t{0});
}

TEST(CommonDivisor, Of128Bits) {
  const Int128 p = (Int128{1} << 89) - 1;
  EXPECT_TRUE(common_divisor(p * 6, -p * 4) == p * 2);
  EXPECT_TRUE(common_divisor(Int128{0}, Int128{-7}) == 7);
  EXPECT_TRUE(common_divisor(Int128{-7}, Int128{0}) == 7);
  EXPECT_TRUE(common_divisor(Int128{0}, Int128{0}) == 0);
  EXPECT_TRUE(common_divisor(-p, Int128{12}) == 1);
  EXPECT_TRUE(common_divisor(Int128{1} << 100, Int128{1} << 64) == Int128{1} << 64);
}

}  // namespace
}  // namespace sightline::geometry
