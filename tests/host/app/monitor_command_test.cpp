// `sightline monitor` in a pipe: exit codes, and the limit for a program that waits for a key.
#include <gtest/gtest.h>

#include <string>

#include "tests/host/app/command_line.hpp"

namespace sightline::test {
namespace {

class MonitorCommand : public CommandLine {
 protected:
  // A program that waits for a key that is never typed.
  void SetUp() override { write("waits.s", "100/\nbegin, 700301\n  jmp begin\n  700312\n  hlt\n  start begin\n"); }
  Ran monitor(std::string_view commands, Arguments words = {"waits.s"}) {
    words.insert(words.begin(), {"monitor", "pdp7"});
    return sightline(words, commands);
  }
};

TEST_F(MonitorCommand, ExitCodesAreThoseOfTheHelp) {
  EXPECT_EQ(monitor("step\n").exit_code, 0);
  EXPECT_EQ(monitor("").exit_code, 0);
  EXPECT_EQ(monitor("assert ac==5\nev 1\n").exit_code, 1);
  EXPECT_EQ(monitor("expect \"x\"\n").exit_code, 1);
  EXPECT_EQ(monitor("nonsense\n").exit_code, 2);
  EXPECT_EQ(monitor("do nowhere\n").exit_code, 2);
  EXPECT_EQ(monitor("", {"nowhere.s"}).exit_code, 5);
  write("wrong.s", "100/\n  lac nobody\n");
  EXPECT_EQ(monitor("", {"wrong.s"}).exit_code, 4);
  EXPECT_EQ(monitor("", {"waits.s", "--radix", "7"}).exit_code, 2);
  // The first error ends it.
  const Ran ran = monitor("ev 1\nnonsense\nev 2\n");
  EXPECT_EQ(ran.out, "1 = 1.\nunknown command \"nonsense\"; help lists them\n");
}

TEST_F(MonitorCommand, ATraceThatCannotBeWrittenIsReportedAtOnce) {
  const Ran ran = monitor("trace nowhere/t\nev 1\n");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.out.find("1 = 1."), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("nowhere/t"), std::string::npos) << ran.out;
}

// Empty memory follows the HLT: 0 is CAL, which continues at 21.
TEST_F(MonitorCommand, AProgramThatRunsIntoEmptyMemoryIsReportedOnce) {
  write("ends.s", "100/\nbegin, hlt\n  start begin\n");
  const Ran ran = monitor("continue\nrun for 1s\nrun for 1s\n", {"ends.s"});
  EXPECT_EQ(ran.exit_code, 0) << ran.out;
  EXPECT_EQ(ran.err, "sightline: warning: PC 00021: executes memory that is empty: nothing was loaded there\n");
}

TEST_F(MonitorCommand, AProgramThatOnlyWaitsForAKeyIsEnded) {
  for (const char* const command : {"go", "run"}) {
    const Ran ran = monitor(std::string(command) + "\nassert time<5000000000.\n");
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("the program waits for a key, and there is none: `send` types keys"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("stopped by end of input"), std::string::npos) << ran.out;
  }
  EXPECT_NE(monitor("send \"x\"\ngo\n").out.find("stopped by halt"), std::string::npos);
  // CP/M's console waits in no emulated time: the program is ended at once, with a message.
  write("key.asm", "\tORG 100H\n\tMVI C,1\n\tCALL 5\n\tRET\n\tEND\n");
  const Ran cpm = sightline({"monitor", "i8080", "key.asm", "--cpm", "--console", "ascii"}, "continue\n");
  EXPECT_EQ(cpm.exit_code, 0);
  EXPECT_NE(cpm.out.find("the program waits for a key, and there is none: `send` types keys"), std::string::npos) << cpm.out;
}

// It counts for 67 emulated seconds, 48 times 2^18 rounds of three cycles, without asking for a key, and halts; so does a program
// that has read a key before.
TEST_F(MonitorCommand, AProgramThatWorksLongIsNeverEnded) {
  constexpr const char* count = "  lac (-60\n  dac outer\nloop, isz inner\n  jmp loop\n  isz outer\n  jmp loop\n  hlt\ninner, 0\nouter, 0\n  start begin\n";
  write("works.s", std::string("100/\nbegin, cla\n") + count);
  write("reads.s", std::string("100/\nbegin, 700301\n  jmp begin\n  700312\n") + count);
  for (const Arguments& words : {Arguments{"works.s"}, Arguments{"reads.s"}}) {
    const Ran ran = monitor((words.front() == "reads.s" ? std::string("send \"x\"\n") : std::string()) + "go\nassert time>64000000000.\n", words);
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("stopped by halt"), std::string::npos) << ran.out;
  }
}

}  // namespace
}  // namespace sightline::test
