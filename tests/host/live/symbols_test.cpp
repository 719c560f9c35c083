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

// The bytes that MAC 2.0 writes: pairs separated by tabs and line ends, padded with 1A to a record.
TEST(Symbols, ASymFileOfMac) {
  Symbols symbols(16);
  ASSERT_TRUE(symbols.add_table("0005 BDOS\t005C FCB\t0100 START\r\nFFFE TOP\t0200 A.LONG$NAME@123?\r\n\x1a\x1a\x1a"));
  EXPECT_EQ(symbols.value("bdos"), 5U);
  EXPECT_EQ(symbols.value("FCB"), 0x5CU);
  EXPECT_EQ(symbols.value("START"), 0x100U);
  EXPECT_EQ(symbols.value("top"), 0xFFFEU);
  EXPECT_EQ(symbols.value("a.long$name@123?"), 0x200U);
  EXPECT_EQ(symbols.all().size(), 5U);
  EXPECT_EQ(symbols.near(0x105), "START+5");
}

// LINK-80 and others write blanks between the columns, and one may begin with an address that could be a name.
TEST(Symbols, OtherShapesOfSymFiles) {
  const auto symbols_of = [](std::string_view text) {
    Symbols symbols(16);
    const auto done = symbols.add_table(text);
    EXPECT_TRUE(done) << text;
    std::string all;
    for (const auto& [name, value] : symbols.all()) all += name + "=" + std::to_string(value) + " ";
    return all;
  };
  EXPECT_EQ(symbols_of("0103 ADD   0105  BEEF\n"), "ADD=259 BEEF=261 ");
  EXPECT_EQ(symbols_of("\r\n  \tFE00 BOOT\r\n"), "BOOT=65024 ");
  EXPECT_EQ(symbols_of("FACE ADD\tFE00 BOOT\r\n"), "ADD=64206 BOOT=65024 ");
  EXPECT_EQ(symbols_of("0100 START\x1A" "0200 GARBAGE"), "START=256 ");
  EXPECT_EQ(symbols_of("\x1A\x1A"), "");
  // Not one of them: as `sightline asm --symbols` writes.
  EXPECT_EQ(symbols_of("BEEF 0100\nFACE FFFE\n"), "BEEF=256 FACE=65534 ");
}

TEST(Symbols, ADamagedFileNamesItsLine) {
  const auto error = [](int radix, std::string_view text) {
    Symbols symbols(radix);
    const auto done = symbols.add_table(text);
    return done ? std::string("none") : done.error().message();
  };
  const std::string sym = ", expected an address of four hexadecimal digits and a name, as MAC and LINK write them in a .SYM file";
  EXPECT_EQ(error(16, "0100 START\t0105\r\n"), "line 1: found \"0105\"" + sym);
  EXPECT_EQ(error(16, "0100 \x1B[2J\x80"), "line 1: found \"0100 ?[2J?\"" + sym);
  EXPECT_EQ(error(16, "0100 START\r\n\r\n10X LOOP\r\n"), "line 3: found \"10X LOOP\"" + sym);
  EXPECT_EQ(error(16, "0100 START 00105 LOOP"), "line 1: found \"00105 LOOP\"" + sym);
  EXPECT_EQ(error(16, "0100 0105 LOOP"), "line 1: found \"0100 0105\"" + sym);
  EXPECT_EQ(error(16, "0100 ST\x01RT"), "line 1: found \"0100 ST?RT\"" + sym);
  EXPECT_EQ(error(16, "START 0100\nLOOP\n"), "line 2: found \"\", expected NAME VALUE, as `sightline asm --symbols` writes them, or ADDRESS NAME of a .SYM file");
  EXPECT_EQ(error(8, "0100 START\n"), "line 1: found \"START\", expected NAME VALUE, as `sightline asm --symbols` writes them");
}

}  // namespace
}  // namespace sightline::live
