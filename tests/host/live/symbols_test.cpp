// The symbol that a name means: the one by the rule of DEC's assembler, or, if that is ambiguous, the one with this exact
// spelling.
#include "host/live/symbols.hpp"

#include <gtest/gtest.h>

namespace sightline::live {
namespace {

TEST(Symbols, AnyCaseAndSixCharactersOnThePdp7) {
  Symbols symbols(8);
  ASSERT_TRUE(symbols.add_table("begin 000100\nVariable1 000200\n"));
  EXPECT_EQ(symbols.value("BEGIN"), 0100U);
  EXPECT_EQ(symbols.value("variab"), 0200U);
  EXPECT_EQ(symbols.value("vari"), std::nullopt);
}

// The dialect of Bell Laboratories has both names of each pair.
TEST(Symbols, ANameThatMeansTwoMustBeWrittenOut) {
  Symbols symbols(8);
  ASSERT_TRUE(
      symbols.add_table("a 000001\nA 000002\nu.ofiles 000003\nu.ofilex 000004\nb 000005\nB 000005\n"));
  EXPECT_EQ(symbols.value("a"), 1U);
  EXPECT_EQ(symbols.value("A"), 2U);
  EXPECT_EQ(symbols.value("u.ofilex"), 4U);
  EXPECT_EQ(symbols.value("u.ofil"), std::nullopt);
  EXPECT_EQ(symbols.value("U.OFILES"), std::nullopt);
  EXPECT_EQ(symbols.value("b"), 5U);
}

TEST(Symbols, ALaterTableWins) {
  Symbols symbols(8);
  ASSERT_TRUE(symbols.add_table("begin 000100\n"));
  ASSERT_TRUE(symbols.add_table("Begin 000200\n"));
  EXPECT_EQ(symbols.value("BEGIN"), 0200U);
}

}  // namespace
}  // namespace sightline::live
