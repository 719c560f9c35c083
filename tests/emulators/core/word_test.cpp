// The types of all machines: words that wrap, DEC bit numbers, instants that do not mix with durations.
#include "emulators/core/word.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"

namespace sightline::core {
namespace {

static_assert(!std::is_convertible_v<std::uint32_t, Word18>);
static_assert(!std::is_convertible_v<Word18, std::uint32_t>);
static_assert(!std::is_convertible_v<Duration, Instant>);
static_assert(Word18(01000000).value() == 0);
static_assert((Word18(0777777) + Word18(1)).value() == 0);
static_assert((Word18(0) - Word18(1)).value() == 0777777);
static_assert((~Word18(0252525)).value() == 0525252);

TEST(Word, BitZeroIsTheMostSignificant) {
  EXPECT_TRUE(Word18(0400000).bit(0));
  EXPECT_TRUE(Word18(1).bit(17));
  EXPECT_FALSE(Word18(0377777).bit(0));
  for (unsigned n = 0; n < 18; ++n) EXPECT_EQ(Word18(std::uint32_t{1} << (17 - n)).bit(n), true) << n;
}

TEST(Word, FieldsAreRightJustified) {
  EXPECT_EQ(Word18(0123456).field(0, 5), 012U);
  EXPECT_EQ(Word18(0123456).field(6, 11), 034U);
  EXPECT_EQ(Word18(0123456).field(12, 17), 056U);
  EXPECT_EQ(Word18(0123456).field(5, 17), 003456U);
  EXPECT_EQ(Word18(0123456).field(0, 17), 0123456U);
}

TEST(Word, TwosComplementRangesOverBothSigns) {
  EXPECT_EQ(Word18(0377777).twos_complement(), 131071);
  EXPECT_EQ(Word18(0400000).twos_complement(), -131072);
  EXPECT_EQ(Word18(0777777).twos_complement(), -1);
  for (std::int32_t v = -131072; v <= 131071; ++v) {
    ASSERT_EQ(Word18(static_cast<std::uint32_t>(v)).twos_complement(), v);
  }
}

TEST(Time, AnInstantIsItsNanoseconds) {
  EXPECT_EQ(nanoseconds_of(at_nanoseconds(1750)), 1750);
  EXPECT_LT(at_nanoseconds(1'000'000'000'000'000), never);
}

}  // namespace
}  // namespace sightline::core
