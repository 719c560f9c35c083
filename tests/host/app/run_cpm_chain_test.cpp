// Commands of CP/M one after the other without a terminal, their return codes, user areas, the log of BDOS calls, the output to
// the console, and folders and names that CP/M does not expect. The programs are assembled by `sightline asm`.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tests/host/app/cpm_fixture.hpp"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::CpmCommand;
using sightline::test::has;
using sightline::test::Ran;

class CpmChain : public CpmCommand {
 protected:
  Ran chain(std::string_view commands, Arguments options = {}) {
    write("run.txt", commands);
    Arguments words{"run", "i8080", "--cpm", "--cpm-drive", "a=a", "--cpm-run", "run.txt"};
    words.insert(words.end(), options.begin(), options.end());
    if (std::find(words.begin(), words.end(), "--max-instructions") == words.end()) words.insert(words.end(), {"--max-instructions", "1000000"});
    return sightline(words);
  }
  // GEN NAME TEXT writes the command's tail to the file; UP A B copies A to B in capitals; CHECK A ends with the number of the
  // letters X in it as return code.
  void make_compiler() {
    assemble(
        "\tORG 100H\n\tLXI D,5CH\n\tMVI C,22\n\tCALL 5\n\tINR A\n\tJZ 0\n\tLXI H,80H\n\tLXI D,200H\n\tMOV A,M\n\tMOV B,A\nCOPY:\tINX H\n\tMOV A,M\n"
        "\tSTAX D\n\tINX D\n\tDCR B\n\tJNZ COPY\n\tMVI A,1AH\n\tSTAX D\n\tLXI D,200H\n\tMVI C,26\n\tCALL 5\n\tLXI D,5CH\n\tMVI C,21\n\tCALL 5\n"
        "\tLXI D,5CH\n\tMVI C,16\n\tCALL 5\n\tRET\n",
        "a/GEN.COM");
    assemble(
        "\tORG 100H\n\tLXI H,6CH\n\tLXI D,300H\n\tMVI B,16\nNAME:\tMOV A,M\n\tSTAX D\n\tINX H\n\tINX D\n\tDCR B\n\tJNZ NAME\n\tXRA A\n\tSTA 320H\n\tLXI D,5CH\n"
        "\tMVI C,15\n\tCALL 5\n\tINR A\n\tJZ BAD\n\tLXI D,300H\n\tMVI C,22\n\tCALL 5\n\tXRA A\n\tSTA 7CH\nNEXT:\tLXI D,5CH\n\tMVI C,20\n\tCALL 5\n\tORA A\n\tJNZ DONE\n"
        "\tLXI H,80H\n\tMVI B,128\nUP:\tMOV A,M\n\tCPI 'a'\n\tJC KEEP\n\tCPI 'z'+1\n\tJNC KEEP\n\tSUI 20H\n\tMOV M,A\nKEEP:\tINX H\n\tDCR B\n\tJNZ UP\n"
        "\tLXI D,300H\n\tMVI C,21\n\tCALL 5\n\tJMP NEXT\nDONE:\tLXI D,300H\n\tMVI C,16\n\tCALL 5\n\tRET\n"
        "BAD:\tLXI D,0FF02H\n\tMVI C,108\n\tCALL 5\n\tJMP 0\n",
        "a/UP.COM");
    assemble(
        "\tORG 100H\n\tLXI D,5CH\n\tMVI C,15\n\tCALL 5\n\tLXI D,5CH\n\tMVI C,20\n\tCALL 5\n\tLXI H,80H\n\tLXI B,8000H\nNEXT:\tMOV A,M\n\tCPI 'X'\n\tJNZ NO\n"
        "\tINR C\nNO:\tINX H\n\tDCR B\n\tJNZ NEXT\n\tMOV E,C\n\tMVI D,0\n\tMOV A,C\n\tORA A\n\tJZ OK\n\tMVI D,0FFH\nOK:\tMVI C,108\n\tCALL 5\n\tMVI C,9\n"
        "\tLXI D,TEXT\n\tCALL 5\n\tMVI C,0\n\tJMP 5\nTEXT:\tDB 'checked',13,10,'$'\n",
        "a/CHECK.COM");
  }
};

TEST_F(CpmChain, ThreeProgramsWorkOnOneFile) {
  make_compiler();
  const Ran ran = chain("gen one.dat and more\r\n; a comment\r\n\r\nUP one.dat two.dat\r\n  check two.dat\r\n");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "checked\r\n");
  EXPECT_TRUE(has(ran.err, "commands        3 of 3")) << ran.err;
  // CP/M types the tail in capitals; GEN wrote it from its first blank on.
  const std::string text = " ONE.DAT AND MORE\x1A";
  EXPECT_EQ(read("a/ONE.DAT").substr(0, text.size()), text);
  EXPECT_EQ(read("a/ONE.DAT").size(), 128U);
  EXPECT_EQ(read("a/TWO.DAT"), read("a/ONE.DAT"));
}

TEST_F(CpmChain, TheFirstFailureEndsTheChainWithItsExitCode) {
  make_compiler();
  const Ran failed = chain("gen one.txt xxxxx\ncheck one.txt\ngen never.txt\ngen too.txt\n");
  EXPECT_EQ(failed.exit_code, 6) << "five X's and that of TXT" << failed.err;
  EXPECT_EQ(failed.out, "checked\r\n");
  EXPECT_TRUE(has(failed.err, "command 2 of 4, \"check one.txt\": the program set the return code FF06 by BDOS function 108; the 2 commands after it "
                              "were not run"))
      << failed.err;
  EXPECT_FALSE(exists("a/NEVER.TXT"));
  const Ran missing = chain("up none.txt two.txt\n");
  EXPECT_EQ(missing.exit_code, 2) << missing.err;
  const Ran none = chain("gen a\nnone b\n");
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_TRUE(has(none.err, "command 2 of 2, \"none b\": found no A:NONE.COM of user 0")) << none.err;
  const Ran built_in = chain("dir *.*\ngen b\n");
  EXPECT_EQ(built_in.exit_code, 3);
  EXPECT_TRUE(has(built_in.err, "command 1 of 2, \"dir *.*\": found no A:DIR.COM of user 0; it is built into CP/M's CCP, which is not here; the command "
                                "after it was not run"))
      << built_in.err;
  const Ran drive = chain("c:gen a\n");
  EXPECT_TRUE(has(drive.err, "found C:GEN.COM, expected a drive given by --cpm-drive")) << drive.err;
  const json report = json::parse(chain("gen ten.txt x\ncheck ten.txt\n", {"--json"}).out);
  EXPECT_EQ(report.at("return_code"), "FF02");
  EXPECT_EQ(report.at("commands"), (json{{"begun", 2}, {"of", 2}}));
}

TEST_F(CpmChain, ReturnCodesBecomeExitCodes) {
  const auto ended = [this](const char* code) {
    assemble("\tORG 100H\n\tLXI D," + std::string(code) + "\n\tMVI C,108\n\tCALL 5\n\tLXI D,0FFFFH\n\tMVI C,108\n\tCALL 5\n\tSHLD 200H\n\tRET\n");
    const Ran ran = run({"--dump", "d", "--console-out", "c"});
    EXPECT_EQ(memory_of("d", 0x200, 2).size(), 5U);
    return ran.exit_code;
  };
  EXPECT_EQ(ended("0"), 0);
  EXPECT_EQ(ended("1"), 1);
  EXPECT_EQ(ended("0FF07H"), 7);
  EXPECT_EQ(memory_of("d", 0x200, 2), "07 FF") << "DE = FFFF asks for the code";
  EXPECT_EQ(ended("0FF00H"), 3) << "a failure without a number";
  EXPECT_EQ(ended("0100H"), 0) << "a success, in CP/M 3";
}

// As after a warm boot: memory above a program stays, page zero and the stack are new, the user and disk are those of 0004.
TEST_F(CpmChain, MemoryIsKeptBetweenPrograms) {
  assemble("\tORG 100H\n\tMVI A,'m'\n\tSTA 4000H\n\tSTA 80H\n\tLXI H,0\n\tSHLD 5\n\tLXI SP,0E000H\n\tPUSH H\n\tJMP 0\n", "a/FIRST.COM");
  assemble("\tORG 100H\n\tLDA 4000H\n\tMOV E,A\n\tMVI C,2\n\tCALL 5\n\tLDA 80H\n\tADI '0'\n\tMOV E,A\n\tMVI C,2\n\tCALL 5\n\tRET\n", "a/SECOND.COM");
  const Ran ran = chain("first with words\nsecond  b\n");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "m3") << "the tail has its two blanks";
}

TEST_F(CpmChain, DrivesAndUsersAreChosenByCommands) {
  make_compiler();
  fs::create_directories(path("b/3"));
  fs::copy_file(path("a/GEN.COM"), path("b/3/GEN.COM"));
  const Ran ran = chain("b:\nuser 3\ngen here.txt\na:up x y\n", {"--cpm-drive", "b=b"});
  EXPECT_EQ(ran.exit_code, 3) << ran.err;
  EXPECT_TRUE(exists("b/3/HERE.TXT"));
  EXPECT_TRUE(has(ran.err, "command 4 of 4, \"a:up x y\": found no A:UP.COM of user 3")) << ran.err;
  EXPECT_TRUE(has(chain("p:\n").err, "found drive P, expected one given by --cpm-drive"));
}

TEST_F(CpmChain, EachUserHasAnArea) {
  // Makes A:F, sets user 5, makes A:F again, and searches for A:F: the entry's first byte, the user, goes to 200.
  assemble(
      "\tORG 100H\n\tLXI D,F\n\tMVI C,22\n\tCALL 5\n\tMVI E,5\n\tMVI C,32\n\tCALL 5\n\tLXI D,F\n\tMVI C,22\n\tCALL 5\n\tSTA 201H\n\tLXI D,F\n\tMVI C,17\n"
      "\tCALL 5\n\tLDA 80H\n\tSTA 200H\n\tMVI E,0FFH\n\tMVI C,32\n\tCALL 5\n\tSTA 202H\n\tLDA 4\n\tSTA 203H\n\tJMP 0\nF:\tDB 0,'F       TXT'\n\tDS 24\n");
  ASSERT_EQ(run({"--cpm-drive", "a=a", "--dump", "d"}).exit_code, 0);
  EXPECT_TRUE(exists("a/F.TXT"));
  EXPECT_TRUE(exists("a/5/F.TXT"));
  EXPECT_EQ(memory_of("d", 0x200, 4), "05 00 05 00");
  ASSERT_EQ(run({"--cpm-drive", "a=a", "--cpm-user", "7", "--dump", "d"}).exit_code, 0);
  EXPECT_TRUE(exists("a/7/F.TXT"));
  EXPECT_EQ(memory_of("d", 0x203, 1), "70");
  EXPECT_TRUE(has(run({"--cpm-user", "16"}).err, "--cpm-user: found \"16\", expected 0 to 15"));
  fs::remove(path("a/7/F.TXT"));
  fs::remove(path("a/7"));
  fs::create_directory(path("outside"));
  fs::create_directory_symlink(path("outside"), path("a/7"));
  EXPECT_TRUE(has(run({"--cpm-drive", "a=a", "--cpm-user", "7"}).err, "A7:F.TXT: a program makes this file")) << "an area is no link";
  EXPECT_TRUE(fs::is_empty(path("outside")));
}

TEST_F(CpmChain, TheLogHasALineForEachCall) {
  make_compiler();
  ASSERT_EQ(chain("gen one.txt\n", {"--cpm-log", "log"}).exit_code, 0);
  const std::string log = read("log");
  EXPECT_TRUE(has(log, "30 command 1 gen one.txt\n")) << log;
  EXPECT_TRUE(has(log, "0105 22 Make File DE=005C A:ONE.TXT A=00 HL=0000\n")) << log;
  EXPECT_TRUE(has(log, "26 Set DMA Address DE=0200 A=00 HL=0000\n")) << log;
  EXPECT_TRUE(has(log, "21 Write Sequential DE=005C A:ONE.TXT A=00 HL=0000\n")) << log;
  assemble("\tORG 100H\n\tMVI C,1\n\tCALL 5\n\tMVI C,50\n\tCALL 5\n\tMVI C,0\n\tCALL 5\n");
  ASSERT_EQ(run({"--console", "ascii", "--send", "k", "--cpm-log", "log"}).exit_code, 0);
  EXPECT_EQ(read("log"), "44 0102 1 Console Input DE=0000 A=6B HL=006B\n98 0107 50 unknown DE=0000 A=00 HL=0000\n152 010C 0 System Reset DE=0000 A=00 HL=0000\n");
}

// Compilers ask now and then whether a key stops them.
TEST_F(CpmChain, AProgramMayAskForKeysWithoutAConsole) {
  assemble(
      "\tORG 100H\n\tMVI C,11\n\tCALL 5\n\tORA A\n\tJNZ 0\n\tMVI C,6\n\tMVI E,0FFH\n\tCALL 5\n\tORA A\n\tJNZ 0\n\tMVI C,6\n\tMVI E,'!'\n\tCALL 5\n\tJMP 0\n",
      "a/ASK.COM");
  const Ran ran = chain("ask\n");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "!");
}

TEST_F(CpmChain, CommandsThatCannotBe) {
  make_compiler();
  const auto refused = [&](std::string_view commands, std::string_view message, int code = 4) {
    const Ran ran = chain(commands);
    EXPECT_EQ(ran.exit_code, code) << ran.err;
    EXPECT_TRUE(has(ran.err, message)) << ran.err;
  };
  refused("gen a\ngen " + std::string(296, 'x') + "\n", "run.txt: line 2: found a command of 300 characters, expected 127 at most: CP/M's command line has no room for more");
  refused("gen *.x\n*\n", "run.txt: line 2: found program \"*\", expected PROGRAM ARGUMENTS, X: or USER N");
  refused("q:x\n", "line 1: found drive Q");
  refused("user 16\n", "line 1: found \"user 16\"");
  refused("user 3 junk\n", "line 1: found \"user 3 junk\"");
  refused("\n; nothing\n", "run.txt: found no command, expected one on each line");
  EXPECT_FALSE(exists("a/A"));
  assemble("\tORG 100H\n\tRET\n");
  const Ran long_words = run({"--cpm-args", std::string(300, 'x')});
  EXPECT_EQ(long_words.exit_code, 2);
  EXPECT_TRUE(has(long_words.err, "--cpm-args: found 300 characters, expected 125 at most: CP/M's command line has no room for more")) << long_words.err;
  EXPECT_EQ(run({"--cpm-args", std::string(125, 'x')}).exit_code, 0);
  EXPECT_TRUE(has(run({"--cpm-drive", "a=a", "--cpm-run", "run.txt"}).err, "--cpm-run: found a PROGRAM too, expected one of them"));
  EXPECT_TRUE(has(sightline({"run", "i8080", "--cpm", "--cpm-drive", "a=a", "--cpm-run", "run.txt", "--cpm-args", "x"}).err, "--cpm-args: found --cpm-run too"));
  EXPECT_TRUE(has(sightline({"run", "i8080", "--cpm", "--cpm-run", "run.txt"}).err, "--cpm-run: needs --cpm-drive X=FOLDER"));
}

TEST_F(CpmChain, AProgramThatIsTooLargeIsNotLoaded) {
  write("a/BIG.COM", std::string(0xEC00 - 0x100 + 1, '\xC9'));
  const Ran ran = chain("big\n");
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_TRUE(has(ran.err, "A:BIG.COM is too large, expected 60160 bytes at most")) << ran.err;
  write("a/FULL.COM", std::string(0xEC00 - 0x100, '\xC9'));
  EXPECT_EQ(chain("full\n").exit_code, 0);
}

TEST_F(CpmChain, ASnapshotContinuesTheCommands) {
  make_compiler();
  ASSERT_EQ(chain("gen one.txt\ngen two.txt\n", {"--save", "s", "--max-instructions", "20"}).exit_code, 0);
  EXPECT_FALSE(exists("a/TWO.TXT"));
  write("run.txt", "gen one.txt\ngen two.txt\n");
  const Ran ran = sightline({"run", "i8080", "--restore", "s", "--cpm", "--cpm-drive", "a=a", "--cpm-run", "run.txt"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(exists("a/TWO.TXT"));
  write("run.txt", "gen one.txt\n");
  EXPECT_EQ(sightline({"run", "i8080", "--restore", "s", "--cpm", "--cpm-drive", "a=a", "--cpm-run", "run.txt"}).exit_code, 4) << "other commands";
}

// --- The console ---

TEST_F(CpmChain, TabsBecomeBlanks) {
  assemble(
      "\tORG 100H\n\tLXI D,T\n\tMVI C,9\n\tCALL 5\n\tMVI E,'X'\n\tMVI C,2\n\tCALL 5\n\tMVI E,9\n\tMVI C,2\n\tCALL 5\n\tMVI E,'Y'\n\tMVI C,2\n\tCALL 5\n\tRST 0\n"
      "T:\tDB 'A',9,'B',13,10,'12345678',9,8,8,9,'C',7,0,7FH,9,'D',13,10,'$'\n");
  EXPECT_EQ(run({}).out, "A       B\r\n12345678        \b\b  C\a" + std::string(1, '\0') + "\x7F       D\r\nX       Y");
}

TEST_F(CpmChain, ControlSPausesAndControlCThenEnds) {
  assemble("\tORG 100H\nL:\tMVI E,'A'\n\tMVI C,2\n\tCALL 5\n\tJMP L\n");
  const Ran ended = run({"--console", "ascii", "--expect", "AAA", "--send", "\\x13\\x03", "--max-instructions", "100000000"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(has(ended.err, "stopped by      exit")) << ended.err;
  EXPECT_EQ(ended.out.find_first_not_of('A'), std::string::npos);
  const Ran paused = run({"--console", "ascii", "--expect", "AAA", "--send", "\\x13", "--max-instructions", "100000000"});
  EXPECT_TRUE(has(paused.err, "stopped by      end of input")) << "it waits for the key that continues: " << paused.err;
  const Ran resumed = run({"--console", "ascii", "--expect", "AAA", "--send", "\\x13q", "--expect", "AAAA", "--max-instructions", "100000000"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(resumed.out.find_first_not_of('A'), std::string::npos) << "the key that continues is not echoed";
}

TEST_F(CpmChain, ControlCEndsTheCommands) {
  assemble("\tORG 100H\nL:\tMVI E,'A'\n\tMVI C,2\n\tCALL 5\n\tJMP L\n", "a/LOOP.COM");
  const Ran ran = chain("loop\nloop\n", {"--console", "ascii", "--expect", "AAA", "--send", "\\x13\\x03"});
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_TRUE(has(ran.err, "command 1 of 2, \"loop\": ended by ^C; the command after it was not run")) << ran.err;
}

// --- Folders and names ---

// The program waits for a key between opening a file and reading it; a pipe lets the test change the folder meanwhile.
TEST_F(CpmChain, AFileThatDisappearsIsReported) {
  // Opens A:F, reads a record, deletes it by another name for the same file on drive B, and reads on.
  write("a/F", std::string(1000, 'x'));
  assemble(
      "\tORG 100H\n\tLXI D,F\n\tMVI C,15\n\tCALL 5\n\tLXI D,F\n\tMVI C,20\n\tCALL 5\n\tLXI D,G\n\tMVI C,19\n\tCALL 5\n\tLXI D,F\n\tMVI C,20\n\tCALL 5\n\tJMP 0\n"
      "F:\tDB 1,'F          '\n\tDS 24\nG:\tDB 2,'F          '\n\tDS 24\n");
  const Ran read_on = run({"--cpm-drive", "a=a", "--cpm-drive", "b=a"});
  EXPECT_EQ(read_on.exit_code, 3);
  EXPECT_EQ(read_on.out, "\r\nBdos Err On A: Bad Sector\r\n");
  EXPECT_TRUE(has(read_on.err, "A:F: a program reads this file, and it is not in the folder a: it was never opened, or has been removed or renamed since")) << read_on.err;
  // Makes A:N, writes a record, deletes it on B, writes again: code FF, and closes: FF.
  assemble(
      "\tORG 100H\n\tLXI D,F\n\tMVI C,22\n\tCALL 5\n\tLXI D,F\n\tMVI C,21\n\tCALL 5\n\tLXI D,G\n\tMVI C,19\n\tCALL 5\n\tLXI D,F\n\tMVI C,21\n\tCALL 5\n\tSTA 200H\n"
      "\tLXI D,F\n\tMVI C,16\n\tCALL 5\n\tSTA 201H\n\tJMP 0\nF:\tDB 1,'N          '\n\tDS 24\nG:\tDB 2,'N          '\n\tDS 24\n");
  const Ran write_on = run({"--cpm-drive", "a=a", "--cpm-drive", "b=a", "--dump", "d"});
  EXPECT_EQ(write_on.exit_code, 0) << write_on.err;
  EXPECT_EQ(memory_of("d", 0x200, 2), "FF FF");
  EXPECT_TRUE(has(write_on.err, "A:N: a program writes this file, and it is not in the folder a")) << write_on.err;
  EXPECT_TRUE(has(write_on.err, "A:N: a program closes this file")) << write_on.err;
}

TEST_F(CpmChain, NamesThatCpmCannotHaveAreReported) {
  write("a/a long name.text", "x");
  write("a/ALSO.LONG", "x");
  write("a/.hidden", "x");
  write("a/same", "1");
  write("a/SAME", "2");
  // Searches for *.*
  assemble("\tORG 100H\n\tLXI D,F\n\tMVI C,17\nNEXT:\tCALL 5\n\tMVI C,18\n\tINR A\n\tJNZ NEXT\n\tJMP 0\nF:\tDB 0,'" +
           std::string(11, '?') + "'\n\tDS 24\n");
  const Ran list = run({"--cpm-drive", "a=a"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_TRUE(has(list.err, "drive A: programs do not see \"ALSO.LONG\" and 2 more in a: CP/M has 8 and 3 characters for a name")) << list.err;
  EXPECT_EQ(list.err.find("hidden"), std::string::npos);
  // Makes a file with a slash in its name.
  assemble("\tORG 100H\n\tLXI D,F\n\tMVI C,22\n\tCALL 5\n\tSTA 200H\n\tJMP 0\nF:\tDB 0,'../X    TXT'\n\tDS 24\n");
  const Ran made = run({"--cpm-drive", "a=a", "--dump", "d"});
  EXPECT_EQ(made.exit_code, 0);
  EXPECT_EQ(memory_of("d", 0x200, 1), "FF");
  EXPECT_TRUE(has(made.err, "a program makes a file named \"../X.TXT\", expected a name of 1 to 8 and up to 3 of A-Z 0-9")) << made.err;
}

TEST_F(CpmChain, AFileThatTheHostProtectsIsReported) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read every file";
  write("a/F", "x");
  ::chmod(path("a/F").c_str(), 0);
  assemble("\tORG 100H\n\tLXI D,F\n\tMVI C,15\n\tCALL 5\n\tJMP 0\nF:\tDB 0,'F          '\n\tDS 24\n");
  EXPECT_TRUE(has(run({"--cpm-drive", "a=a"}).err, "A:F: a program opens this file, and the host does not allow it: Permission denied"));
}

// Function 16 has nothing left to do: the file has all its records before the program continues.
TEST_F(CpmChain, AFileIsCompleteWhenItIsClosed) {
  assemble(
      "\tORG 100H\n\tLXI D,F\n\tMVI C,22\n\tCALL 5\n\tMVI B,200\nNEXT:\tPUSH B\n\tLXI D,F\n\tMVI C,21\n\tCALL 5\n\tPOP B\n\tDCR B\n\tJNZ NEXT\n\tLXI D,F\n\tMVI C,16\n"
      "\tCALL 5\nLOOP:\tJMP LOOP\nF:\tDB 0,'F          '\n\tDS 24\n");
  EXPECT_EQ(run({"--cpm-drive", "a=a", "--max-instructions", "5000"}).exit_code, 0);
  EXPECT_EQ(read("a/F").size(), 200U * 128U);
}

}  // namespace
