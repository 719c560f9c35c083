// Laws of the EAE for seeded random operands, computed in plain host arithmetic.
#include "emulators/pdp7/eae.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace sightline {
namespace {

constexpr std::uint32_t mask = 0777777;
constexpr std::uint64_t mask36 = (std::uint64_t{1} << 36) - 1;

pdp7::EaeRegisters registers(std::uint32_t ac, std::uint32_t mq, bool link) {
  return {core::Word18(ac), core::Word18(mq), core::Word<6>(025), link};
}
std::uint64_t both(const pdp7::EaeRegisters& r) {
  return (std::uint64_t{r.ac.value()} << 18) | r.mq.value();
}
std::int64_t ones(std::uint32_t word) {
  return (word & 0400000U) != 0 ? -static_cast<std::int64_t>(~word & mask) : static_cast<std::int64_t>(word);
}

class EaeLaws : public testing::Test {
 protected:
  std::uint32_t word() { return static_cast<std::uint32_t>(generator_()) & mask; }
  std::mt19937 generator_{1971};
};

TEST_F(EaeLaws, MulIsTheProductAndAComplementForLinkOne) {
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t a = word();
    const std::uint32_t b = word();
    const auto plain = pdp7::execute_eae(0653122, registers(a, word(), false), core::Word18(b));
    ASSERT_EQ(both(plain.registers), std::uint64_t{a} * b);
    ASSERT_EQ(plain.steps, 18);
    ASSERT_FALSE(plain.registers.link);
    const auto negative = pdp7::execute_eae(0653122, registers(a, word(), true), core::Word18(b));
    ASSERT_EQ(both(negative.registers), ~(std::uint64_t{a} * b) & mask36);
  }
}

// GSM gives |multiplicand| and its sign in L; MULS then multiplies one's complement numbers.
TEST_F(EaeLaws, GsmAndMulsMultiplySigned) {
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t a = word();
    const std::uint32_t b = word();
    const auto multiplicand = pdp7::execute_eae(0664000, registers(a, 0, false), {}).registers;
    const auto product =
        pdp7::execute_eae(0657122, registers(b, 0, multiplicand.link), multiplicand.ac).registers;
    const bool negative = ((a ^ b) & 0400000U) != 0;
    const std::int64_t expected = ones(a) * ones(b);
    const auto magnitude = static_cast<std::uint64_t>(expected < 0 ? -expected : expected);
    ASSERT_EQ(both(product), negative ? ~magnitude & mask36 : magnitude) << std::oct << a << " * " << b;
  }
}

TEST_F(EaeLaws, DividendIsQuotientTimesDivisorPlusRemainder) {
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t divisor = (word() >> (word() % 17)) | 1U;
    const std::uint32_t high = word() % divisor;
    const std::uint32_t low = word();
    const auto result = pdp7::execute_eae(0640323, registers(high, low, false), core::Word18(divisor));
    const std::uint64_t dividend = (std::uint64_t{high} << 18) | low;
    ASSERT_EQ(result.registers.mq.value(), dividend / divisor);
    ASSERT_EQ(result.registers.ac.value(), dividend % divisor);
    ASSERT_FALSE(result.registers.link);
    ASSERT_EQ(result.steps, 19);
  }
}

TEST_F(EaeLaws, DivisionOverflowIsRejected) {
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t divisor = word();
    const std::uint32_t high = divisor + word() % (mask - divisor + 1);
    const std::uint32_t low = word();
    const auto result = pdp7::execute_eae(0640323, registers(high, low, false), core::Word18(divisor));
    ASSERT_TRUE(result.registers.link);
    ASSERT_EQ(result.registers.ac.value(), high - divisor);
    ASSERT_EQ(result.registers.mq.value(), low);
    ASSERT_EQ(result.registers.sc.value(), 025U);
    ASSERT_EQ(result.steps, 1);
  }
}

// IDIVS: AC is the dividend, L the sign of the divisor, the operand its magnitude.
TEST_F(EaeLaws, IdivsTruncatesTowardsZeroAndTheRemainderHasTheSignOfTheDividend) {
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t dividend = word();
    const std::uint32_t divisor = (word() & 0377777U) | 1U;
    const bool divisor_negative = (word() & 1U) != 0;
    const auto r =
        pdp7::execute_eae(0657323, registers(dividend, 0, divisor_negative), core::Word18(divisor)).registers;
    const std::int64_t signed_divisor = divisor_negative ? -static_cast<std::int64_t>(divisor) : divisor;
    ASSERT_EQ(ones(r.mq.value()), ones(dividend) / signed_divisor);
    ASSERT_EQ(ones(r.ac.value()), ones(dividend) % signed_divisor);
  }
}

TEST_F(EaeLaws, LongShiftsMoveThirtySixBitsAndFillWithTheLink) {
  for (int i = 0; i < 20000; ++i) {
    const auto before = registers(word(), word(), (word() & 1U) != 0);
    const std::uint32_t count = word() & 077U;
    std::uint64_t right = both(before);
    std::uint64_t left = right;
    for (std::uint32_t n = 0; n < count; ++n) {
      right = (right >> 1) | (before.link ? std::uint64_t{1} << 35 : 0);
      left = ((left << 1) | (before.link ? 1U : 0U)) & mask36;
    }
    const auto after_right = pdp7::execute_eae(0640500 + count, before, {});
    const auto after_left = pdp7::execute_eae(0640600 + count, before, {});
    ASSERT_EQ(both(after_right.registers), right) << count;
    ASSERT_EQ(both(after_left.registers), left) << count;
    ASSERT_EQ(after_left.registers.link, before.link);
    ASSERT_EQ(after_left.steps, static_cast<int>(count));
    const auto short_left = pdp7::execute_eae(0640700 + count, before, {}).registers;
    ASSERT_EQ(short_left.mq, before.mq);
    ASSERT_EQ(short_left.ac.value(),
              pdp7::execute_eae(0640600 + count,
                                registers(before.ac.value(), before.link ? mask : 0, before.link), {})
                  .registers.ac.value());
  }
}

TEST_F(EaeLaws, NormalizeIsAShiftThatLacsCanUndo) {
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t ac = word() >> (word() % 18);
    const auto before = registers(ac, word(), false);
    const auto result = pdp7::execute_eae(0640444, before, {});
    const auto after = result.registers;
    if (result.steps < 36) {
      ASSERT_NE(after.ac.bit(0), after.ac.bit(1));
    }
    ASSERT_EQ(both(after), (both(before) << result.steps) & mask36);
    const auto shown = pdp7::execute_eae(0641001, after, {}).registers;
    ASSERT_EQ((shown.ac.value() + 044) & 077U, static_cast<std::uint32_t>(result.steps));
  }
}

TEST_F(EaeLaws, SignedNormalizeKeepsTheSignOfANegativeNumber) {
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t magnitude = (word() & 0377777U) >> (word() % 17);
    const auto positive = pdp7::execute_eae(0660444, registers(magnitude, 0, false), {});
    const auto negative = pdp7::execute_eae(0660444, registers(~magnitude & mask, mask, false), {});
    ASSERT_EQ(both(positive.registers), ~both(negative.registers) & mask36);
    ASSERT_EQ(positive.steps, negative.steps);
  }
}

// A count of 0 means 64 steps: the product is shifted by 46 more places.
TEST(Eae, CountZeroMeansSixtyFourSteps) {
  const auto product = pdp7::execute_eae(0653100, registers(3, 0, false), core::Word18(5));
  EXPECT_EQ(product.steps, 64);
  EXPECT_EQ(pdp7::execute_eae(0640400, registers(0, 0, false), {}).steps, 64);
}

}  // namespace
}  // namespace sightline
