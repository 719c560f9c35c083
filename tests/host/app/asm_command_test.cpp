// `sightline asm pdp7`: outputs, options, and no output after an error.
#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::has;

class AsmCommand : public sightline::test::CommandLine {
 protected:
  // LAC 102, HLT, 000007 at 100; START 100. The words are those of the PDP-4 manual's instruction list.
  static constexpr const char* source = "100/\ngo,\tlac x\n\thlt\nx,\t7\n\tSTART go\n";

  // The three lines of a word on binary tape, hole 8 in each.
  static std::string on_tape(std::uint32_t word, bool last = false) {
    std::string lines;
    for (const unsigned shift : {12U, 6U, 0U}) {
      const std::uint32_t hole7 = last && shift == 0 ? 0100U : 0U;
      lines += static_cast<char>(0200U | hole7 | ((word >> shift) & 077U));
    }
    return lines;
  }
};

TEST_F(AsmCommand, OctalImageOnStandardOutput) {
  write("a.s", source);
  const auto ran = sightline({"asm", "pdp7", "a.s", "--format", "octal", "-o", "-"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(has(ran.out, "00100:")) << ran.out;
  EXPECT_TRUE(has(ran.out, "200102 740040 000007")) << ran.out;
  EXPECT_TRUE(has(ran.err, "3 words in 00100-00102, start 00100")) << ran.err;
}

TEST_F(AsmCommand, ASourceOfTheOtherMachineIsNamed) {
  write("a.asm", "\tORG 100H\n\tLXI H,1234H\n\tHLT\n\tEND\n");
  write("a.s", source);
  write("wrong.s", "100/\n  lac nobody\n");
  const auto err = [&](std::string command, std::string machine, std::string file) {
    const auto ran = sightline({command, machine, file});
    EXPECT_EQ(ran.exit_code, 4) << ran.err;
    return ran.err;
  };
  for (const std::string command : {"asm", "run", "monitor"}) {
    EXPECT_TRUE(has(err(command, "pdp7", "a.asm"), "sightline: this looks like i8080 source: sightline " + command + " i8080 a.asm\n"));
    EXPECT_TRUE(has(err(command, "i8080", "a.s"), "sightline: this looks like pdp7 source: sightline " + command + " pdp7 a.s\n"));
    EXPECT_FALSE(has(err(command, "pdp7", "wrong.s"), "looks like"));
  }
}

TEST_F(AsmCommand, RimTapeIsTheDefault) {
  write("a.s", source);
  ASSERT_EQ(sightline({"asm", "pdp7", "a.s", "-o", "a.rim"}).exit_code, 0);
  ASSERT_EQ(sightline({"asm", "pdp7", "a.s", "-o", "b.rim", "--format", "rim"}).exit_code, 0);
  EXPECT_EQ(read("a.rim"), read("b.rim"));
  const std::string pairs = on_tape(0040100) + on_tape(0200102) + on_tape(0040101) + on_tape(0740040) +
                            on_tape(0040102) + on_tape(0000007) + on_tape(0600100);
  EXPECT_TRUE(has(read("a.rim"), pairs));
}

TEST_F(AsmCommand, HriTape) {
  write("a.s", source);
  const auto ran = sightline({"asm", "pdp7", "a.s", "--format", "hri", "-o", "a.hri"});
  ASSERT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(
      has(read("a.hri"), on_tape(0200102) + on_tape(0740040) + on_tape(0000007) + on_tape(0600100, true)));
  EXPECT_TRUE(has(ran.err, "load it @100")) << ran.err;
}

TEST_F(AsmCommand, ListingAndSymbols) {
  write("a.s", source);
  ASSERT_EQ(sightline({"asm", "pdp7", "a.s", "--listing", "a.lst", "--symbols", "a.sym"}).exit_code, 0);
  EXPECT_EQ(read("a.sym"), "go 000100\nx 000102\n");
  EXPECT_TRUE(has(read("a.lst"), "00100 200102  go,\tlac x\n")) << read("a.lst");
  EXPECT_TRUE(has(sightline({"asm", "pdp7", "a.s", "--symbols", "-"}).out, "go 000100\n"));
}

// The words by hand: lac 102 of the next source, sys 3 is cal i 3, -1 in two's complement; <ab> is 141 and 142.
TEST_F(AsmCommand, TheDialectOfBell) {
  write("a.s", ".. = 0100\nopen = 3\n   lac 1f\" next\n   sys open; -1\n");
  write("b.s", "1: <ab>; 10; 010\n");
  const auto ran = sightline({"asm", "pdp7", "--dialect", "bell", "a.s", "b.s", "--format", "octal", "-o", "-"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "00100:")) << ran.out;
  EXPECT_TRUE(has(ran.out, "200103 020003 777777 141142 000012 000010")) << ran.out;
}

TEST_F(AsmCommand, EachDialectRejectsTheOtherByName) {
  write("a.s", source);
  write("b.s", "a: lac 1f \" five\n1: 5\n");
  const auto bell = sightline({"asm", "pdp7", "--dialect", "bell", "a.s", "-o", "a.rim"});
  EXPECT_EQ(bell.exit_code, 4);
  EXPECT_TRUE(has(bell.err, "a.s:1:4: error: found '/', an origin or a comment of --dialect dec")) << bell.err;
  EXPECT_FALSE(exists("a.rim"));
  const auto dec = sightline({"asm", "pdp7", "b.s"});
  EXPECT_EQ(dec.exit_code, 4);
  EXPECT_TRUE(has(dec.err, "b.s:1:2: error: found ':', which ends a label in --dialect bell")) << dec.err;
  const auto clash = sightline({"asm", "pdp7", "--dialect", "bell", "--twos-complement", "b.s"});
  EXPECT_EQ(clash.exit_code, 2);
  EXPECT_TRUE(has(clash.err, "--twos-complement: found --dialect bell")) << clash.err;
  EXPECT_EQ(sightline({"asm", "pdp7", "--dialect", "unix", "b.s"}).exit_code, 2);
}

TEST_F(AsmCommand, TheMonitorReadsBothDialects) {
  write("b.s", ".. = 0100\na: lac five\n   hlt\nfive: 5\n");
  const auto ran = sightline({"monitor", "pdp7", "b.s", "--dialect", "bell", "--start", "100"}, "continue\nassert ac==5\n");
  EXPECT_EQ(ran.exit_code, 0) << ran.err << ran.out;
  EXPECT_EQ(sightline({"monitor", "pdp7", "b.s"}, "quit\n").exit_code, 4);
  // Several sources are one program, and typed instructions are in their dialect; the keys are those of the console's mode.
  write("one.s", "..=0\n.=0100\nbegin: jms put\n hlt\n");
  write("two.s", "put: 0\n lac d9\n jmp put i\nd9: 9\n");
  const auto two = sightline({"monitor", "pdp7", "one.s", "two.s", "--dialect", "bell", "--start", "100"},
                             "break put+1\ncontinue\nshow stack\nd 200 \"lac d9+010 i\"\ne 200\ncontinue\nassert ac==11\n");
  EXPECT_EQ(two.exit_code, 0) << two.out << two.err;
  EXPECT_NE(two.out.find("00103 called from 00100  begin: jms 102  ; begin: jms put"), std::string::npos) << two.out;
  EXPECT_NE(two.out.find("00200 220115"), std::string::npos) << two.out;
  write("keys.s", "..=0\n.=0100\n1: 0700301\n jmp 1b\n 0700312\n hlt\n");
  for (const auto& [mode, code] : {std::pair<std::string, std::string>{"unix", "212"}, {"parity", "215"}, {"ascii", "15"}}) {
    const auto key = sightline({"monitor", "pdp7", "keys.s", "--dialect", "bell", "--start", "100", "--console", mode},
                               "send \"\\r\"\ncontinue\nassert ac==" + code + "\n");
    EXPECT_EQ(key.exit_code, 0) << mode << key.out << key.err;
  }
}

TEST_F(AsmCommand, WithoutOutputOnlyChecks) {
  write("a.s", source);
  const auto ran = sightline({"asm", "pdp7", "a.s"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(files(), std::vector<std::string>{"a.s"});
}

TEST_F(AsmCommand, SeveralSourcesStandardInputAndDefinitions) {
  write("a.s", "100/\n\tlac eae\n");
  for (const auto& define :
       {sightline::test::Arguments{"-D", "EAE=17"}, sightline::test::Arguments{"-DEAE=17"}}) {
    sightline::test::Arguments arguments{"asm", "pdp7"};
    arguments.insert(arguments.end(), define.begin(), define.end());
    arguments.insert(arguments.end(), {"a.s", "-", "--format", "octal", "-o", "-"});
    const auto ran = sightline(arguments, "\tdac eae\n");
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(has(ran.out, "200017 040017")) << ran.out;
  }
}

TEST_F(AsmCommand, DialectOptions) {
  write("minus.s", "100/\n\t-1\n");
  EXPECT_TRUE(has(sightline({"asm", "pdp7", "minus.s", "--format", "octal", "-o", "-"}).out, "777776"));
  EXPECT_TRUE(
      has(sightline({"asm", "pdp7", "minus.s", "--twos-complement", "--format", "octal", "-o", "-"}).out,
          "777777"));
  write("free.s", "100/\n\tlac nobody\n");
  EXPECT_EQ(sightline({"asm", "pdp7", "free.s"}).exit_code, 4);
  EXPECT_EQ(sightline({"asm", "pdp7", "free.s", "--undefined-are-variables"}).exit_code, 0);
  write("title.s", "my ) program\n100/\n\thlt\n");
  EXPECT_EQ(sightline({"asm", "pdp7", "title.s"}).exit_code, 4);
  EXPECT_EQ(sightline({"asm", "pdp7", "title.s", "--title"}).exit_code, 0);
}

TEST_F(AsmCommand, AllErrorsOfARunAndNothingWritten) {
  write("bad.s", "100/\n\tlac nowhere\n\tjmp elsewhere\n");
  write("bad.rim", "as it was");
  const auto ran =
      sightline({"asm", "pdp7", "bad.s", "-o", "bad.rim", "--listing", "bad.lst", "--symbols", "bad.sym"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "bad.s:2:")) << ran.err;
  EXPECT_TRUE(has(ran.err, "bad.s:3:")) << ran.err;
  EXPECT_TRUE(has(ran.err, "expected")) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(files(), (std::vector<std::string>{"bad.rim", "bad.s"}));
  EXPECT_EQ(read("bad.rim"), "as it was");
}

TEST_F(AsmCommand, TapesThatCannotBePunched) {
  write("high.s", "17762/\n\thlt\n");
  const auto ran = sightline({"asm", "pdp7", "high.s", "-o", "high.rim"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "high.rim")) << ran.err;
  EXPECT_FALSE(exists("high.rim"));
}

TEST_F(AsmCommand, FilesThatCannotBeReadOrWritten) {
  write("a.s", source);
  EXPECT_EQ(sightline({"asm", "pdp7", "none.s"}).exit_code, 5);
  const auto ran = sightline({"asm", "pdp7", "a.s", "-o", "no/such/place.rim", "--listing", "a.lst"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_TRUE(has(ran.err, "no/such/place.rim")) << ran.err;
  EXPECT_FALSE(exists("a.lst"));
  send_stdout_to("/dev/full");
  EXPECT_EQ(sightline({"asm", "pdp7", "a.s", "-o", "-"}).exit_code, 5);
}

TEST_F(AsmCommand, WrongUsage) {
  write("a.s", source);
  for (const sightline::test::Arguments& wrong :
       std::vector<sightline::test::Arguments>{{"asm"},
                                               {"asm", "pdp7"},
                                               {"asm", "6502", "a.s"},
                                               {"asm", "pdp7", "a.s", "--format", "hex"},
                                               {"asm", "pdp7", "a.s", "-D", "EAE"},
                                               {"asm", "pdp7", "a.s", "-D", "EAE=8"},
                                               {"asm", "pdp7", "a.s", "-o", "-", "--listing", "-"},
                                               {"asm", "pdp7", "a.s", "-o", "x", "--symbols", "./x"},
                                               {"asm", "pdp7", "a.s", "--listing", "./a.s"},
                                               {"asm", "pdp7", "a.s", "--nonsense"}}) {
    const auto ran = sightline(wrong);
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_TRUE(ran.err.starts_with("sightline: ")) << ran.err;
    EXPECT_EQ(ran.out, "");
  }
}

TEST_F(AsmCommand, SameBytesEveryTime) {
  write("a.s", source);
  for (const char* format : {"rim", "hri", "octal"}) {
    ASSERT_EQ(sightline({"asm", "pdp7", "a.s", "--format", format, "-o", "1", "--listing", "1l"}).exit_code,
              0);
    ASSERT_EQ(sightline({"asm", "pdp7", "a.s", "--format", format, "-o", "2", "--listing", "2l"}).exit_code,
              0);
    EXPECT_EQ(read("1"), read("2"));
    EXPECT_EQ(read("1l"), read("2l"));
  }
}

}  // namespace
