#include "host/base/number.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace sightline::base {
namespace {

TEST(WholeNumber, IsTheWholeText) {
  EXPECT_EQ(whole_number<int>("0"), 0);
  EXPECT_EQ(whole_number<int>("-17"), -17);
  EXPECT_EQ(whole_number<int>("007"), 7);
  for (const char* const wrong : {"", " 1", "1 ", "+1", "1x", "0x10", "1.0", "--1", "-", "1e3"})
    EXPECT_FALSE(whole_number<int>(wrong)) << wrong;
}

TEST(CountNumber, IsWholeHoweverItIsWritten) {
  EXPECT_EQ(count_number("0"), 0U);
  EXPECT_EQ(count_number("1000000"), 1'000'000U);
  EXPECT_EQ(count_number("1e6"), 1'000'000U);
  EXPECT_EQ(count_number("1E+6"), 1'000'000U);
  EXPECT_EQ(count_number("2.5e3"), 2500U);
  EXPECT_EQ(count_number("0e19"), 0U);
  EXPECT_EQ(count_number("1.8446744073709551615e19"), std::numeric_limits<std::uint64_t>::max());
  for (const char* const wrong : {"", "e", "e3", "1e", "1.5", "1.25e1", "1e-3", "-1e3", "1e20", "1e255", "1e256", "1e6e6",
                                  " 1e3", "1e3 ", ".5e1", "1.e", "1..5e3", "0x1e3", "inf", "nan"})
    EXPECT_FALSE(count_number(wrong)) << wrong;
}

TEST(WholeNumber, IsOfTheRadix) {
  EXPECT_EQ(whole_number<std::uint32_t>("777777", 8), 0777777U);
  EXPECT_EQ(whole_number<std::uint32_t>("fF", 16), 0xFFU);
  EXPECT_FALSE(whole_number<std::uint32_t>("8", 8));
  EXPECT_FALSE(whole_number<std::uint32_t>("G", 16));
}

TEST(WholeNumber, IsInTheRange) {
  EXPECT_EQ(whole_number<int>("1", 10, 1, 9), 1);
  EXPECT_EQ(whole_number<int>("9", 10, 1, 9), 9);
  EXPECT_FALSE(whole_number<int>("0", 10, 1, 9));
  EXPECT_FALSE(whole_number<int>("10", 10, 1, 9));
}

TEST(WholeNumber, FitsItsType) {
  EXPECT_EQ(whole_number<std::uint8_t>("255"), 255);
  EXPECT_FALSE(whole_number<std::uint8_t>("256"));
  EXPECT_FALSE(whole_number<std::uint8_t>("-1"));
  EXPECT_EQ(whole_number<std::uint64_t>("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  EXPECT_FALSE(whole_number<std::uint64_t>("18446744073709551616"));
  EXPECT_EQ(whole_number<std::int64_t>("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_FALSE(whole_number<std::int64_t>("9223372036854775808"));
}

TEST(WholeNumbers, AreAllPresentBetweenSeparators) {
  using Three = std::array<int, 3>;
  EXPECT_EQ((whole_numbers<int, 3>("3,-4,5", ',')), (Three{3, -4, 5}));
  for (const char* const wrong : {"", "3,-4", "3,-4,", "3,-4,5,6", ",4,5", "3, 4,5", "3x4x5"})
    EXPECT_FALSE((whole_numbers<int, 3>(wrong, ','))) << wrong;
  EXPECT_EQ((whole_numbers<int, 2>("640x480", 'x', 1, 1024)), (std::array{640, 480}));
  EXPECT_FALSE((whole_numbers<int, 2>("640x0", 'x', 1, 1024)));
  EXPECT_FALSE((whole_numbers<int, 2>("2048x480", 'x', 1, 1024)));
}

TEST(DecimalNumber, IsFinite) {
  EXPECT_EQ(decimal_number("1"), 1.0);
  EXPECT_EQ(decimal_number("-2.5"), -2.5);
  EXPECT_EQ(decimal_number("+1e-3"), 1e-3);
  EXPECT_EQ(decimal_number("1e-400"), 0.0);
  for (const char* const wrong : {"", "+", "+-1", "1e400", "inf", "nan", "0x1p3", "1,5", " 1", "1 "})
    EXPECT_FALSE(decimal_number(wrong)) << wrong;
}

// Numbers of as many digits as are read without strtod, and of more: what strtod reads.
TEST(DecimalNumber, IsTheNearestDouble) {
  std::mt19937 random(3);
  for (int i = 0; i < 200'000; ++i) {
    std::string text(random() % 3 == 0 ? "-" : "");
    const std::size_t digits = 1 + random() % 18;
    const std::size_t point = random() % (digits + 2);
    for (std::size_t d = 0; d < digits; ++d) {
      if (d == point) text += '.';
      text += static_cast<char>('0' + random() % 10);
    }
    const auto number = decimal_number(text);
    ASSERT_TRUE(number) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*number), std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr))) << text;
  }
  for (const char* const wrong : {".", "-", "-.", "1.2.3", "--1", "1-", "1e", "12a"}) EXPECT_FALSE(decimal_number(wrong)) << wrong;
}

TEST(ShortDecimal, SaysHowTheNumberIsWritten) {
  struct Case {
    const char* text;
    double value;
    int digits;
    int decimals;
  };
  for (const auto& [text, value, digits, decimals] :
       {Case{"0", 0, 0, 0}, Case{"-7", -7, 1, 0}, Case{"1200", 1200, 4, 0}, Case{"007", 7, 1, 0}, Case{"0.0012", 0.0012, 2, 4},
        Case{"0.50", 0.5, 2, 2}, Case{"12.", 12, 2, 0}, Case{".5", 0.5, 1, 1}, Case{"10.01", 10.01, 4, 2}, Case{"0.000", 0, 0, 3},
        Case{"999999999999999", 999999999999999.0, 15, 0}}) {
    const auto number = short_decimal(text);
    ASSERT_TRUE(number) << text;
    EXPECT_EQ(number->value, value) << text;
    EXPECT_EQ(number->digits, digits) << text;
    EXPECT_EQ(number->decimals, decimals) << text;
  }
  for (const char* const other : {"", "-", ".", "-.", "+1", "1e3", "1.2.3", "1 ", "1234567890123456", "nan", "1/2", "1:2"})
    EXPECT_FALSE(short_decimal(other)) << other;
}

TEST(FixedNumber, HasNoExponentAndIsInTheRange) {
  EXPECT_EQ(fixed_number("0.25", 0, 1), 0.25);
  EXPECT_EQ(fixed_number("1", 0, 1), 1.0);
  for (const char* const wrong : {"", "1.5", "-0.5", "1e-3", "+1", "nan", "inf"})
    EXPECT_FALSE(fixed_number(wrong, 0, 1)) << wrong;
}

// The reference is std::to_chars of g++'s library.
TEST(ShortestNumber, EqualsTheStandardLibrary) {
  const auto expected = [](double value) {
    std::array<char, 64> digits{};
    return std::string(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  };
  for (const double value : {0.0, -0.0, 1.0, -1.5, 0.1, 1e5, 1e-5, 123456.0, 100000.0, 1e22, 0x1p53, 0x1p63, 0x1p64, 0x1p70, 5e-324, 1.7976931348623157e308,
                             12345678901234567890.0, 1234567890123456789012.0, 0.00012, 0.000123, 99999999999999990.0,
                             std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
    EXPECT_EQ(shortest_number(value), expected(value));
  std::uint64_t seed = 1;
  for (int n = 0; n < 300000; ++n) {
    seed = seed * 6364136223846793005U + 1442695040888963407U;
    const double any = std::bit_cast<double>(seed);
    if (std::isnan(any)) continue;
    ASSERT_EQ(shortest_number(any), expected(any)) << seed;
    // Common numbers, and integers around 2^64.
    const double common = static_cast<double>(static_cast<std::int64_t>(seed) >> (seed & 63U)) / std::pow(10.0, static_cast<double>(seed >> 6 & 15U));
    ASSERT_EQ(shortest_number(common), expected(common)) << seed;
    const double large = std::ldexp(static_cast<double>(seed >> 11), static_cast<int>(seed & 31U));
    ASSERT_EQ(shortest_number(large), expected(large)) << seed;
  }
}

TEST(TimeText, HasThreeDigitsAndTheUnitThatSuits) {
  EXPECT_EQ(time_text(1234), "1234 s");
  EXPECT_EQ(time_text(999.6), "1000 s");
  EXPECT_EQ(time_text(116.23), "116 s");
  EXPECT_EQ(time_text(1.5), "1.5 s");
  EXPECT_EQ(time_text(0.9996), "1 s");
  EXPECT_EQ(time_text(0.9994), "999 ms");
  EXPECT_EQ(time_text(0.0123456), "12.3 ms");
  EXPECT_EQ(time_text(0.00099951), "1 ms");
  EXPECT_EQ(time_text(7e-6), "7 us");
}

TEST(Octal, HasLeadingZeros) {
  EXPECT_EQ(octal(0, 5), "00000");
  EXPECT_EQ(octal(0777776, 6), "777776");
  EXPECT_EQ(octal(7, 2), "07");
}

}  // namespace
}  // namespace sightline::base
