// `sightline disasm`: its output assembles to the same words; errors name the position in damaged files.
#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::has;

class DisasmCommand : public sightline::test::CommandLine {};

TEST_F(DisasmCommand, RoundTripOfEveryFormat) {
  write("a.s", "100/\ngo,\tlac i 10\n\tspa cla\n\tisz 7777\n\tjmp go\n\t123456\n\t-7\n\tSTART go\n");
  for (const std::string format : {"rim", "octal", "hri"}) {
    ASSERT_EQ(sightline({"asm", "pdp7", "a.s", "--format", format, "-o", "a.image"}).exit_code, 0);
    const std::string file = format == "hri" ? "a.image@100" : "a.image";
    for (const std::string machine : {"pdp7", "type340"}) {
      const auto ran = sightline({"disasm", machine, file, "-o", "again.s"});
      ASSERT_EQ(ran.exit_code, 0) << ran.err;
      EXPECT_EQ(sightline({"disasm", machine, file}).out, read("again.s"));
      ASSERT_EQ(sightline({"asm", "pdp7", "again.s", "--format", format, "-o", "b.image"}).exit_code, 0);
      EXPECT_EQ(read("b.image"), read("a.image")) << machine << " " << format;
    }
  }
}

TEST_F(DisasmCommand, TheDialectOfBell) {
  write("a.oct", "00100: 220010 751100 777776 653111\n");
  const auto ran = sightline({"disasm", "pdp7", "a.oct", "--dialect", "bell", "-o", "a.s"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(read("a.s"), ". = 000100\n   lac i 010 ")) << read("a.s");
  ASSERT_EQ(sightline({"asm", "pdp7", "--dialect", "bell", "a.s", "--format", "octal", "-o", "b.oct"}).exit_code, 0);
  EXPECT_EQ(sightline({"disasm", "pdp7", "b.oct"}).out, sightline({"disasm", "pdp7", "a.oct"}).out);
  write("high.oct", "20000: 000001\n");
  const auto refused = sightline({"disasm", "pdp7", "high.oct", "--dialect", "bell"});
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_TRUE(has(refused.err, "high.oct: error: found a word at 20000") && has(refused.err, "--end 17777")) << refused.err;
  EXPECT_EQ(sightline({"disasm", "pdp7", "a.oct", "--dialect", "mac"}).exit_code, 2);
}

// Hole 7 of the last word is one line early, in a RIM tape and in an HRI tape: 5 at 100, start 100.
TEST_F(DisasmCommand, EarlyHole7IsReadWithAWarning) {
  write("early.rim", std::string("\0\0\x84\x81\x80\x80\x80\x85\xB0\xC1\x80\0", 12));
  write("early.hri", std::string("\0\x80\x80\x85\xB0\xC1\x80\0", 8));
  for (const auto& [file, byte] : {std::pair<std::string, std::string>{"early.rim", "9"}, {"early.hri@100", "5"}}) {
    const auto ran = sightline({"disasm", "pdp7", file});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(has(ran.out, "/ 00100 000005\n        start 00100\n")) << ran.out;
    EXPECT_TRUE(has(ran.err, file.substr(0, 9) + ": byte " + byte + ": hole 7 in line 2 of the last word")) << ran.err;
    const auto running = sightline({"run", "pdp7", file, "--max-instructions", "1"});
    EXPECT_TRUE(has(running.err, "warning: " + file.substr(0, 9) + ": byte " + byte + ": hole 7")) << running.err;
  }
}

TEST_F(DisasmCommand, APartOfAProgram) {
  write("a.oct", "00100: 200105 340106 740040 600100\n");
  const std::string part = sightline({"disasm", "pdp7", "a.oct", "--start", "101", "--end", "102"}).out;
  EXPECT_TRUE(has(part, "tad 106") && has(part, "hlt")) << part;
  EXPECT_FALSE(has(part, "lac 105") || has(part, "jmp 100")) << part;
  EXPECT_EQ(sightline({"disasm", "pdp7", "a.oct", "--start", "0", "--end", "77777"}).out,
            sightline({"disasm", "pdp7", "a.oct"}).out);
  // 1000: a CALL whose operand bytes are read as code if decoding starts in them.
  write("rom.bin", "\xCD\x3E\x05\x76");
  EXPECT_TRUE(has(sightline({"disasm", "i8080", "rom.bin@1000"}).out, "CALL    053EH"));
  EXPECT_TRUE(has(sightline({"disasm", "i8080", "rom.bin@1000", "--start", "1001"}).out, "MVI     A,05H"));
  EXPECT_TRUE(has(sightline({"disasm", "pdp7", "a.oct", "--start", "8"}).err, "--start: found \"8\""));
  EXPECT_EQ(sightline({"disasm", "pdp7", "a.oct", "--start", "200"}).exit_code, 4);
  EXPECT_EQ(sightline({"disasm", "pdp7", "a.oct", "--start", "102", "--end", "101"}).exit_code, 2);
}

TEST_F(DisasmCommand, NamesInstructionsAndDisplayWords) {
  const std::string image = "00100: 200105 740040";
  EXPECT_TRUE(has(sightline({"disasm", "pdp7", "-"}, image).out, "lac 105"));
  EXPECT_TRUE(has(sightline({"disasm", "pdp7", "-"}, image).out, "hlt"));
  write("stop.oct", "003000");
  const auto display = sightline({"disasm", "type340", "stop.oct@200"});
  EXPECT_TRUE(has(display.out, "003000")) << display.out;
  EXPECT_TRUE(has(display.out, "stop")) << display.out;
  EXPECT_TRUE(has(display.out, "200/")) << display.out;
}

TEST_F(DisasmCommand, DamagedFilesAreNamedWithTheirPlace) {
  write("a.s", "100/\n\tlac 105\n\thlt\n\tSTART 100\n");
  ASSERT_EQ(sightline({"asm", "pdp7", "a.s", "-o", "a.rim"}).exit_code, 0);
  const std::string tape = read("a.rim");
  const std::size_t first = tape.find_first_not_of('\0');
  write("cut.rim", tape.substr(0, first + 7));
  write("cut-in-word.rim", tape.substr(0, first + 5));
  std::string holes = tape;
  holes[first + 4] = '\1';
  write("hole8.rim", holes);
  write("text.oct", "000000 000009\n");
  write("far.oct", "77777: 000000 000000\n");
  write("empty", "");
  write("noise", std::string("\xff\xfe\x03", 3));
  for (const char* file :
       {"cut.rim", "cut-in-word.rim", "hole8.rim", "text.oct", "far.oct", "empty", "noise"}) {
    const auto ran = sightline({"disasm", "pdp7", file, "-o", "out.s"});
    EXPECT_EQ(ran.exit_code, 4) << file << ": " << ran.err;
    EXPECT_TRUE(has(ran.err, file)) << ran.err;
    EXPECT_TRUE(has(ran.err, "expected")) << ran.err;
    EXPECT_FALSE(exists("out.s"));
  }
  EXPECT_TRUE(has(sightline({"disasm", "pdp7", "text.oct"}).err, "text.oct:1:8"));
}

TEST_F(DisasmCommand, ExitCodes) {
  write("a.hri.s", "100/\n\thlt\n");
  ASSERT_EQ(sightline({"asm", "pdp7", "a.hri.s", "--format", "hri", "-o", "a.hri"}).exit_code, 0);
  EXPECT_EQ(sightline({"disasm", "pdp7", "a.hri"}).exit_code, 4);
  EXPECT_EQ(sightline({"disasm", "pdp7", "a.hri@100"}).exit_code, 0);
  EXPECT_EQ(sightline({"disasm", "pdp7", "a.hri@100000"}).exit_code, 2);
  EXPECT_EQ(sightline({"disasm", "pdp7", "a.hri@9"}).exit_code, 2);
  EXPECT_EQ(sightline({"disasm", "pdp7", "none"}).exit_code, 5);
  EXPECT_EQ(sightline({"disasm", "pdp7", "a.hri@100", "-o", "no/where"}).exit_code, 5);
  EXPECT_EQ(sightline({"disasm", "pdp7"}).exit_code, 2);
  EXPECT_EQ(sightline({"disasm", "pdp8", "a.hri"}).exit_code, 2);
}

}  // namespace
