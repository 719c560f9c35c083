// `sightline asm i8080` and `disasm i8080`: formats, options, and no output after an error.
#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::Arguments;
using sightline::test::has;

class AsmI8080Command : public sightline::test::CommandLine {
 protected:
  // MVI A,41H; RET at 0100.
  static constexpr const char* source = "\tORG 100H\nGO:\tMVI A,'A'\n\tRET\n\tEND GO\n";
  static constexpr const char* bytes = "\x3E\x41\xC9";
  static constexpr const char* hex = ":030100003E41C9B4\n:00010001FE\n";
};

TEST_F(AsmI8080Command, TheEndingOfTheOutputChoosesTheFormat) {
  write("a.asm", source);
  for (const auto& [file, content] :
       {std::pair{"a.com", bytes}, {"a.BIN", bytes}, {"a.hex", hex}, {"a.out", hex}}) {
    const auto ran = sightline({"asm", "i8080", "a.asm", "-o", file});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(read(file), content) << file;
    EXPECT_TRUE(has(ran.err, "3 bytes in 0100-0102, start 0100, 1 symbols")) << ran.err;
  }
  EXPECT_EQ(sightline({"asm", "i8080", "a.asm", "-o", "-"}).out, hex);
  EXPECT_EQ(sightline({"asm", "i8080", "a.asm", "-o", "-", "--format", "com"}).out, bytes);
}

TEST_F(AsmI8080Command, ListingSymbolsDefinesAndIncludes) {
  std::filesystem::create_directory(path("sub"));
  write("sub/main.asm", " INCLUDE part.asm\n DB SIZE\n");
  write("sub/part.asm", "SIZE EQU 1\n");
  const auto ran =
      sightline({"asm", "i8080", "-D", "SIZE=0AH", "sub/main.asm", "--listing", "a.prn", "--symbols", "-"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "SIZE 000A\n");
  EXPECT_TRUE(has(read("a.prn"), "0000 0A   DB SIZE\n")) << read("a.prn");
}

TEST_F(AsmI8080Command, AllErrorsAndNothingWritten) {
  write("bad.asm", " ORG 100H\n JMP NOWHERE\n DB 256\n");
  write("bad.com", "as it was");
  const auto ran = sightline({"asm", "i8080", "bad.asm", "-o", "bad.com", "--listing", "bad.prn"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "bad.asm:2:6: error: ")) << ran.err;
  EXPECT_TRUE(has(ran.err, "bad.asm:3:5: error: ")) << ran.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"bad.asm", "bad.com"}));
  EXPECT_EQ(read("bad.com"), "as it was");
}

TEST_F(AsmI8080Command, EveryOutputNeedsASeparateFile) {
  write("a.asm", source);
  write("b.asm", "\tNOP\n");
  for (const Arguments& outputs : std::vector<Arguments>{{"-o", "x", "--listing", "x"},
                                                         {"--listing", "./x", "--symbols", "x"},
                                                         {"-o", "b.asm"},
                                                         {"--symbols", "./a.asm"}}) {
    Arguments arguments{"asm", "i8080", "a.asm", "b.asm"};
    arguments.insert(arguments.end(), outputs.begin(), outputs.end());
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_TRUE(has(ran.err, outputs[outputs.size() - 2] + ": found " + outputs.back())) << ran.err;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"a.asm", "b.asm"}));
  EXPECT_EQ(read("a.asm"), source);
  const auto nowhere =
      sightline({"asm", "i8080", "a.asm", "b.asm", "-o", "/dev/null", "--listing", "/dev/null"});
  EXPECT_EQ(nowhere.exit_code, 0) << nowhere.err;
}

TEST_F(AsmI8080Command, ASourceCannotReadStandardInput) {
  write("a.asm", " INCLUDE -\n NOP\n");
  const auto ran = sightline({"asm", "i8080", "a.asm"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "a.asm:1:10: error: found '-', which cannot be read")) << ran.err;
}

TEST_F(AsmI8080Command, AComHasNothingBelow0100) {
  write("low.asm", " NOP\n");
  const auto ran = sightline({"asm", "i8080", "low.asm", "-o", "low.com"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "low.com: error: found a byte at 0000")) << ran.err;
  EXPECT_FALSE(exists("low.com"));
}

TEST_F(AsmI8080Command, DisassemblyRoundTrips) {
  write("a.asm", source);
  ASSERT_EQ(sightline({"asm", "i8080", "a.asm", "-o", "a.com"}).exit_code, 0);
  ASSERT_EQ(sightline({"asm", "i8080", "a.asm", "-o", "a.hex"}).exit_code, 0);
  write("raw", bytes);
  for (const Arguments& file :
       {Arguments{"a.com"}, {"a.hex"}, {"raw@100"}, {"raw@0100H"}, {"raw", "--format", "com"}}) {
    Arguments arguments{"disasm", "i8080", "-o", "again.asm"};
    arguments.insert(arguments.end(), file.begin(), file.end());
    const auto ran = sightline(arguments);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(has(read("again.asm"), "MVI     A,41H")) << read("again.asm");
    ASSERT_EQ(sightline({"asm", "i8080", "again.asm", "-o", "again.com"}).exit_code, 0);
    EXPECT_EQ(read("again.com"), bytes);
  }
}

TEST_F(AsmI8080Command, DamagedFilesAreNamedWithTheirPlace) {
  write("a.hex", ":030100003E41C9B5\n:00010001FE\n");
  const auto ran = sightline({"disasm", "i8080", "a.hex", "-o", "out.asm"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "a.hex:1:16: error: found checksum B5, expected B4")) << ran.err;
  EXPECT_FALSE(exists("out.asm"));
  write("big.com", std::string(65281, '\0'));
  EXPECT_EQ(sightline({"disasm", "i8080", "big.com"}).exit_code, 4);
  write("empty.bin", "");
  EXPECT_EQ(sightline({"disasm", "i8080", "empty.bin"}).exit_code, 4);
}

TEST_F(AsmI8080Command, WrongUsage) {
  write("a.asm", source);
  write("a.com", bytes);
  for (const Arguments& wrong : std::vector<Arguments>{{"asm", "i8080"},
                                                       {"asm", "i8080", "a.asm", "--format", "rim"},
                                                       {"asm", "i8080", "a.asm", "-D", "X"},
                                                       {"asm", "i8080", "a.asm", "-D", "X=Y"},
                                                       {"asm", "i8080", "a.asm", "-o", "-", "--listing", "-"},
                                                       {"disasm", "i8080"},
                                                       {"disasm", "i8080", "a.com@10000"},
                                                       {"disasm", "i8080", "a.com@200"},
                                                       {"disasm", "i8080", "a.com", "--format", "octal"}}) {
    EXPECT_EQ(sightline(wrong).exit_code, 2) << wrong.back();
  }
  EXPECT_EQ(sightline({"asm", "i8080", "none.asm"}).exit_code, 5);
  EXPECT_EQ(sightline({"disasm", "i8080", "none.com"}).exit_code, 5);
}

}  // namespace
