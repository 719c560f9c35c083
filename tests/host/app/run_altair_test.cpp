// `sightline run i8080` as an Altair: sense switches, less than 64K of RAM, and paper tape on a serial channel. The programs do
// what MITS's software does.
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include "tests/host/app/cpm_fixture.hpp"

namespace {

using sightline::test::Arguments;
using sightline::test::CpmCommand;
using sightline::test::has;
using sightline::test::Ran;

class AltairCommand : public CpmCommand {
 protected:
  Ran altair(std::string_view source, Arguments options = {}) {
    assemble(source, "p.hex");
    Arguments words{"run", "i8080", "p.hex", "--max-states", "100000000"};
    words.insert(words.end(), options.begin(), options.end());
    return sightline(words);
  }
};

TEST_F(AltairCommand, SenseSwitchesAreReadAtPortFF) {
  const std::string source = "\tORG 0\n\tIN 0FFH\n\tSTA 200H\n\tHLT\n";
  const Ran set = altair(source, {"--sense", "0a", "--dump", "d"});
  EXPECT_EQ(set.exit_code, 0) << set.err;
  EXPECT_EQ(memory_of("d", 0x200, 1), "0A");
  EXPECT_EQ(set.err.find("warning"), std::string::npos) << set.err;
  EXPECT_EQ(altair(source, {"--sense", "0", "--strict"}).exit_code, 0) << "a device is there";
  const Ran none = altair(source, {"--dump", "d"});
  EXPECT_EQ(memory_of("d", 0x200, 1), "FF");
  EXPECT_TRUE(has(none.err, "port FF: no device at this port")) << none.err;
  EXPECT_TRUE(has(altair(source, {"--sense", "100"}).err, "--sense: found \"100\", expected the switches A15 to A8, hexadecimal, 0 to FF"));
}

// BASIC finds the size of memory so: it stores each byte's complement until one does not hold it.
constexpr std::string_view sizes_memory =
    "\tORG 0\n\tLXI H,END\nNEXT:\tMOV A,M\n\tCMA\n\tMOV M,A\n\tCMP M\n\tCMA\n\tMOV M,A\n\tJNZ FOUND\n\tINX H\n\tMOV A,H\n\tORA L\n\tJNZ NEXT\nFOUND:\tSHLD SIZE\n\tHLT\nSIZE:\tDS 2\nEND:\tEND 0\n";

TEST_F(AltairCommand, MemoryEndsWhereTheRamEnds) {
  for (const auto& [size, found] : {std::pair{"1k", "00 04"}, {"4k", "00 10"}, {"16K", "00 40"}, {"63k", "00 FC"}, {"64k", "00 00"}}) {
    const Ran ran = altair(sizes_memory, {"--memory", size, "--save", "s"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    const Ran dumped = sightline({"run", "i8080", "--restore", "s", "--memory", size, "--max-states", "1", "--dump", "d"});
    EXPECT_EQ(dumped.exit_code, 0) << dumped.err;
    EXPECT_EQ(memory_of("d", 0x16, 2), found) << size;
  }
  // Pushes above the RAM are lost, so the RET goes to FFFF, where it meets FF, RST 7.
  const Ran lost = altair("\tORG 0\n\tLXI SP,8000H\n\tCALL SUB\n\tHLT\nSUB:\tRET\n\tORG 38H\n\tLXI SP,100H\n\tPOP H\n\tHLT\n", {"--memory", "8k"});
  EXPECT_EQ(lost.exit_code, 0);
  EXPECT_TRUE(has(lost.out, "PC 003D")) << lost.out;
}

TEST_F(AltairCommand, WhatDoesNotFitIsRefused) {
  const Ran above = altair("\tORG 1000H\n\tHLT\n", {"--memory", "4k"});
  EXPECT_EQ(above.exit_code, 4);
  EXPECT_TRUE(has(above.err, "found a word for address 1000, expected one in memory, 0000-0FFF (--memory 4k)")) << above.err;
  for (const char* size : {"0k", "65k", "16m", "4294967295"})
    EXPECT_TRUE(has(altair("\tHLT\n", {"--memory", size}).err, "expected 1k to 64k")) << size;
  EXPECT_TRUE(has(altair("\tHLT\n", {"--memory", "16k", "--cpm"}).err, "--memory 16k: found --cpm too, expected one of them"));
}

// Reads a tape to its end, which is when a second passes without a character, and punches it.
constexpr std::string_view copies_tape =
    "STATUS\tEQU 12H\n\tORG 0\nWAIT:\tLXI B,0\nPOLL:\tIN STATUS\n\tRRC\n\tJC GOT\n\tDCX B\n\tMOV A,B\n\tORA C\n\tJNZ POLL\n\tHLT\n"
    "GOT:\tIN STATUS+1\n\tMOV D,A\nSEND:\tIN STATUS\n\tANI 2\n\tJZ SEND\n\tMOV A,D\n\tOUT STATUS+1\n\tJMP WAIT\n";

TEST_F(AltairCommand, ATapeIsReadAndPunchedByteForByte) {
  std::string bytes(600, '\0');
  std::iota(bytes.begin(), bytes.end(), '\0');
  write("tape", bytes);
  const Ran ran = altair(copies_tape, {"--tape", "tape", "--tape-out", "punched"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "stopped by      halt")) << ran.out;
  EXPECT_EQ(read("punched"), bytes);
  std::string other(copies_tape);
  other.replace(other.find("12H"), 3, "10H");
  EXPECT_EQ(altair(other, {"--tape", "tape", "--tape-out", "punched", "--tape-channel", "2sio"}).exit_code, 0);
  EXPECT_EQ(read("punched"), bytes);
  EXPECT_TRUE(has(altair(other, {"--tape", "none"}).err, "none")) << "a file that does not exist";
  for (const char* const out : {"--tape-out", "--save"}) {
    const Ran same = altair(other, {"--tape", "tape", out, "./tape"});
    EXPECT_EQ(same.exit_code, 2);
    EXPECT_TRUE(has(same.err, std::string(out) + ": found ./tape, expected no file that is an input of this run")) << same.err;
    EXPECT_EQ(read("tape"), bytes);
  }
  EXPECT_TRUE(has(altair(other, {"--tape-out", "p"}).err, "--tape-out: needs --tape"));
  EXPECT_TRUE(has(altair(other, {"--tape-channel", "sio"}).err, "--tape-channel: needs --tape"));
}

// As on a Teletype: the tape in its reader comes before the keys, and what the program types is punched, too.
TEST_F(AltairCommand, ATerminalHasAReaderAndAPunch) {
  std::string echoes(copies_tape);
  echoes.replace(echoes.find("12H"), 3, "10H");
  echoes.replace(echoes.find("\tJNZ POLL\n"), 10, "\tJMP POLL\n");  // it waits for ever
  echoes.replace(echoes.find("\tMOV D,A\n"), 9, "\tMOV D,A\n\tCPI 1BH\n\tJZ DONE\n");
  echoes += "DONE:\tHLT\n";
  write("tape", "10 PRINT\r\x8D");
  const Ran ran = altair(echoes, {"--terminal", "2sio", "--console", "ascii", "--tape", "tape", "--tape-channel", "2sio", "--tape-out", "punched", "--console-out", "printed",
                                  "--send", "RUN\\r\\e"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(read("punched"), "10 PRINT\r\x8DRUN\r");
  EXPECT_EQ(read("printed"), "10 PRINT\r\x8DRUN\r");
}

}  // namespace
