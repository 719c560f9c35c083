// The arithmetic of the 8080 for every operand, carry and flag, compared with its definition by digits and counts of ones.
#include "emulators/i8080/alu.hpp"

#include <gtest/gtest.h>

#include <bitset>

namespace sightline {
namespace {

using i8080::Byte;

struct Flags {
  bool auxiliary;
  bool carry;
};

// F for a result, composed bit by bit.
Byte flags_for(unsigned result, Flags carries) {
  unsigned f = 1U << 1;
  if (result >= 128) f |= 1U << 7;
  if (result == 0) f |= 1U << 6;
  if (carries.auxiliary) f |= 1U << 4;
  if (std::bitset<8>(result).count() % 2 == 0) f |= 1U << 2;
  if (carries.carry) f |= 1U;
  return static_cast<Byte>(f);
}

void expect(i8080::Result found, unsigned value, Flags carries, const char* what, unsigned a, unsigned b) {
  ASSERT_EQ(found.value, value) << what << ' ' << a << ' ' << b;
  ASSERT_EQ(found.flags, flags_for(value, carries)) << what << ' ' << a << ' ' << b;
}

template <class Check>
void for_all_operands(Check check) {
  for (unsigned a = 0; a < 256; ++a) {
    for (unsigned b = 0; b < 256; ++b) check(a, b);
  }
}

TEST(I8080Alu, AdditionCarriesOutOfBothDigits) {
  for (unsigned carry = 0; carry < 2; ++carry) {
    for_all_operands([&](unsigned a, unsigned b) {
      const unsigned sum = a + b + carry;
      expect(i8080::add(static_cast<Byte>(a), static_cast<Byte>(b), carry), sum % 256,
             {a % 16 + b % 16 + carry > 15, sum > 255}, "add", a, b);
    });
  }
}

TEST(I8080Alu, SubtractionSetsAuxiliaryCarryWhenTheLowDigitDoesNotBorrow) {
  for (unsigned borrow = 0; borrow < 2; ++borrow) {
    for_all_operands([&](unsigned a, unsigned b) {
      const bool low_digit_borrows = a % 16 < b % 16 + borrow;
      expect(i8080::subtract(static_cast<Byte>(a), static_cast<Byte>(b), borrow), (a + 512 - b - borrow) % 256,
             {!low_digit_borrows, a < b + borrow}, "subtract", a, b);
    });
  }
}

TEST(I8080Alu, LogicalOperationsClearCarryAndOnlyAndSetsAuxiliary) {
  for_all_operands([&](unsigned a, unsigned b) {
    const Byte x = static_cast<Byte>(a);
    const Byte y = static_cast<Byte>(b);
    expect(i8080::and_(x, y), a & b, {a / 8 % 2 + b / 8 % 2 > 0, false}, "and", a, b);
    expect(i8080::or_(x, y), a | b, {false, false}, "or", a, b);
    expect(i8080::exclusive_or(x, y), (a | b) - (a & b), {false, false}, "exclusive or", a, b);
  });
}

TEST(I8080Alu, CountingLeavesCarryAlone) {
  for (unsigned value = 0; value < 256; ++value) {
    for (unsigned carry = 0; carry < 2; ++carry) {
      const Byte before = static_cast<Byte>(0xD6 | carry);
      expect(i8080::increment(static_cast<Byte>(value), before), (value + 1) % 256,
             {value % 16 == 15, carry == 1}, "increment", value, carry);
      expect(i8080::decrement(static_cast<Byte>(value), before), (value + 255) % 256,
             {value % 16 != 0, carry == 1}, "decrement", value, carry);
    }
  }
}

// DAA makes packed decimal sums: every sum of two two-digit numbers and a carry.
TEST(I8080Alu, DecimalAdjustMakesDecimalSums) {
  const auto packed = [](unsigned n) { return static_cast<Byte>(n / 10 * 16 + n % 10); };
  for (unsigned m = 0; m < 100; ++m) {
    for (unsigned n = 0; n < 100; ++n) {
      for (unsigned carry = 0; carry < 2; ++carry) {
        const i8080::Result binary = i8080::add(packed(m), packed(n), carry);
        const i8080::Result decimal = i8080::decimal_adjust(binary.value, binary.flags);
        ASSERT_EQ(decimal.value, packed((m + n + carry) % 100)) << m << '+' << n;
        ASSERT_EQ(decimal.flags & 1U, m + n + carry > 99 ? 1U : 0U) << m << '+' << n;
      }
    }
  }
}

// Other operands: 6 is added for a low digit above 9 or AC, 60h for a value above 99h or CY; CY is never cleared.
TEST(I8080Alu, DecimalAdjustOfAnything) {
  for (unsigned a = 0; a < 256; ++a) {
    for (unsigned f = 0; f < 256; ++f) {
      const bool low_digit = (f & 0x10) != 0 || a % 16 >= 10;
      const bool high_digit = (f & 0x01) != 0 || a >= 0x9A;
      const unsigned sum = a + (low_digit ? 6 : 0) + (high_digit ? 96 : 0);
      expect(i8080::decimal_adjust(static_cast<Byte>(a), static_cast<Byte>(f)), sum % 256,
             {low_digit && a % 16 + 6 > 15, high_digit}, "daa", a, f);
    }
  }
}

TEST(I8080Alu, RotationsChangeCarryOnly) {
  for (unsigned a = 0; a < 256; ++a) {
    for (unsigned bit = 0; bit < 2; ++bit) {
      const i8080::Result left = i8080::rotate_left(static_cast<Byte>(a), 0xD7, bit);
      EXPECT_EQ(left.value, a * 2 % 256 + bit);
      EXPECT_EQ(left.flags, 0xD6 + a / 128);
      const i8080::Result right = i8080::rotate_right(static_cast<Byte>(a), 0xD7, bit);
      EXPECT_EQ(right.value, a / 2 + bit * 128);
      EXPECT_EQ(right.flags, 0xD6 + a % 2);
    }
  }
}

}  // namespace
}  // namespace sightline
