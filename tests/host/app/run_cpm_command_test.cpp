// `sightline run i8080 --cpm` with drives, a BIOS and a list device; stepping back over a program's file operations.
// The programs are assembled by `sightline asm`; their sources determine the expected files on the host.
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tests/host/app/cpm_fixture.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::CpmCommand;
using sightline::test::has;
using sightline::test::Ran;

TEST_F(CpmCommand, TheExampleCopiesAFile) {
  std::string content;
  for (int n = 0; n < 20000; ++n) content += static_cast<char>('a' + n % 23);
  write("a/from.txt", content);
  std::filesystem::copy_file(std::filesystem::path(SIGHTLINE_SOURCE_DIR) / "host/examples/copy.asm", path("copy.asm"));
  ASSERT_EQ(sightline({"asm", "i8080", "copy.asm", "-o", "p.com"}).exit_code, 0);
  const Ran ran = run({"--cpm-drive", "a=a", "--cpm-args", "from.txt to.txt"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(read("a/TO.TXT"), content + std::string(128 - 20000 % 128, '\x1A'));
  const Ran none = run({"--cpm-drive", "a=a", "--cpm-args", "none.txt to.txt"});
  EXPECT_EQ(none.out, "No file");
  const Ran locked = run({"--cpm-drive", "a=a,ro", "--cpm-args", "from.txt to2.txt"});
  EXPECT_EQ(locked.exit_code, 3);
  EXPECT_EQ(locked.out, "\r\nBdos Err On A: R/O\r\n");
  EXPECT_TRUE(has(locked.err, "in BDOS function 19 (Delete File), after which CP/M ends a program")) << locked.err;
  EXPECT_FALSE(exists("a/TO2.TXT"));
}

TEST_F(CpmCommand, AFunctionThatNeedsAnOptionNamesIt) {
  assemble("\tORG 100H\n\tMVI C,15\n\tCALL 5\n\tJMP 0\n");
  const Ran bare = run({});
  EXPECT_EQ(bare.exit_code, 3);
  EXPECT_TRUE(has(bare.err, "PC 0102: stopped: found a call of BDOS function 15 (Open File), which needs --cpm-drive A=FOLDER")) << bare.err;
  assemble("\tORG 100H\n\tMVI C,1\n\tCALL 5\n\tJMP 0\n");
  const Ran key = run({"--cpm-drive", "a=a"});
  EXPECT_EQ(key.exit_code, 3);
  EXPECT_TRUE(has(key.err, "BDOS function 1 (Console Input), which needs --console MODE")) << key.err;
}

// Prints A of each function in hexadecimal, as BDOS 2.2 answers without a reader, a punch and a disk.
TEST_F(CpmCommand, ASystemWithoutPeripheralsAnswers) {
  const std::string source =
      "\tORG 100H\n\tLXI SP,STACK\n\tLXI H,LIST\nNEXT:\tMOV C,M\n\tINX H\n\tMOV E,M\n\tINX H\n\tMOV A,C\n\tORA A\n\tJZ 0\n"
      "\tMVI D,0\n\tPUSH H\n\tCALL 5\n\tPUSH PSW\n\tRRC\n\tRRC\n\tRRC\n\tRRC\n\tCALL DIGIT\n\tPOP PSW\n\tCALL DIGIT\n\tMVI E,' '\n\tMVI C,2\n"
      "\tCALL 5\n\tPOP H\n\tJMP NEXT\nDIGIT:\tANI 0FH\n\tADI 90H\n\tDAA\n\tACI 40H\n\tDAA\n\tMOV E,A\n\tMVI C,2\n\tJMP 5\n"
      "LIST:\tDB 3,0,8,95H,7,0,12,0,24,0,25,0,13,0,32,255,38,0,39,0,48,0,0\n\tDS 64\nSTACK:\tDS 1\n";
  assemble(source);
  EXPECT_EQ(run({}).out, "1A 00 95 22 00 00 00 00 00 00 00 ");
  EXPECT_EQ(run({"--cpm-drive", "b=a"}).out, "1A 00 95 22 02 01 00 00 00 00 00 ") << "drive B is in use from the start";
}

// The allocation of an empty disk and its parameters agree: bits for DSM + 1 blocks, the directory's are taken.
TEST_F(CpmCommand, FreeSpaceCanBeComputed) {
  assemble(
      "\tORG 100H\n\tMVI C,31\n\tCALL 5\n\tSHLD 200H\n\tLXI D,5\n\tDAD D\n\tMOV E,M\n\tINX H\n\tMOV D,M\n\tINX D\n\tXCHG\n\tSHLD 202H\n"
      "\tMVI C,27\n\tCALL 5\n\tMOV A,M\n\tSTA 204H\n\tINX H\n\tMOV A,M\n\tSTA 205H\n\tJMP 0\n");
  EXPECT_EQ(run({"--cpm-drive", "a=a", "--dump", "d"}).exit_code, 0);
  EXPECT_EQ(memory_of("d", 0x202, 4), "F3 00 C0 00") << "243 blocks of 1K";
  EXPECT_EQ(run({"--dump", "d"}).exit_code, 0) << "without a drive";
  EXPECT_EQ(memory_of("d", 0x202, 4), "F3 00 C0 00");
}

// CP/M 2.2 answers a function above 40 with A = L = B = H = 0. Programs find out so which system they run on.
TEST_F(CpmCommand, FunctionsAbove40AnswerZeroWithOneWarning) {
  assemble(
      "        ORG     100H\n        LXI     H,LIST\nNEXT:   MOV     A,M\n        ORA     A\n        JZ      OK\n        INX     H\n"
      "        PUSH    H\n        MOV     C,A\n        LXI     D,0\n        CALL    5\n        ADI     '0'\n        MOV     E,A\n"
      "        MVI     C,2\n        CALL    5\n        MVI     E,' '\n        MVI     C,2\n        CALL    5\n        POP     H\n"
      "        JMP     NEXT\nOK:     LXI     D,TEXT\n        MVI     C,9\n        CALL    5\n        RST     0\n"
      "LIST:   DB      48,45,105,108,0\nTEXT:   DB      'ok',13,10,'$'\n        END     100H\n");
  for (const Arguments& options : {Arguments{}, Arguments{"--cpm-drive", "a=a"}}) {
    const Ran ran = run(options);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.out, "0 0 0 0 ok\r\n");
    EXPECT_TRUE(has(ran.err, "PC 010E: calls BDOS function 48, expected 0 to 40: CP/M 2.2 answers all above with 0")) << ran.err;
    EXPECT_EQ(ran.err.find("function 45"), std::string::npos);
  }
}

TEST_F(CpmCommand, TheBiosIsFoundThroughPageZero) {
  // Prints by CONOUT, found 9 bytes after WBOOT, and returns at the top level; the word at 6 gives the top of memory.
  assemble("\tORG 100H\n\tLHLD 1\n\tLXI D,9\n\tDAD D\n\tMVI C,'!'\n\tLXI D,BACK\n\tPUSH D\n\tPCHL\nBACK:\tLHLD 6\n\tSHLD 200H\n\tLHLD 1\n\tSHLD 202H\n\tRET\n");
  const Ran ran = run({"--cpm-drive", "a=a", "--dump", "d", "--console-out", "c"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(read("c"), "!");
  // The addresses of MOVCPM's 64K system: BDOS at EC00, the BIOS at FA00 (Alteration Guide, section 2).
  EXPECT_EQ(memory_of("d", 0x200, 4), "06 EC 03 FA");
}

// As DDT does: the program moves itself below BDOS, makes room there by the word at 0006, and passes calls on.
TEST_F(CpmCommand, AResidentProgramMovesBelowTheMemoryTop) {
  assemble(
      "\tORG 100H\n\tLHLD 6\n\tSHLD PASS+1\n\tMVI L,0\n\tDCR H\n\tPUSH H\n\tLXI D,PASS\n\tMVI B,3\nMOVE:\tLDAX D\n\tMOV M,A\n\tINX H\n\tINX D\n"
      "\tDCR B\n\tJNZ MOVE\n\tPOP H\n\tSHLD 6\n\tMVI C,2\n\tMVI E,'k'\n\tCALL 5\n\tJMP 0\nPASS:\tJMP 0\n");
  const Ran ran = run({"--cpm-drive", "a=a", "--dump", "d", "--console-out", "c"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(read("c"), "k");
  EXPECT_EQ(memory_of("d", 0xEB00, 3), "C3 06 EC");
}

// A program that reads and writes sectors finds no drive.
TEST_F(CpmCommand, TheBiosHasNoSectors) {
  // HL after SELDSK, A after READ, WRITE and READER, HL after SECTRAN of BC = 7.
  assemble(
      "\tORG 100H\n\tLXI SP,400H\n\tMVI C,0\n\tLXI D,24\n\tCALL BIOS\n\tSHLD 200H\n\tLXI D,21\n\tCALL BIOS\n\tLXI D,36\n\tCALL BIOS\n\tSTA 202H\n"
      "\tLXI D,39\n\tCALL BIOS\n\tSTA 203H\n\tLXI D,18\n\tCALL BIOS\n\tSTA 204H\n\tLXI B,7\n\tLXI D,45\n\tCALL BIOS\n\tSHLD 205H\n\tJMP 0\n"
      "BIOS:\tLHLD 1\n\tDAD D\n\tPCHL\n");
  const Ran ran = run({"--cpm-drive", "a=a", "--dump", "d"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(memory_of("d", 0x200, 7), "00 00 01 01 1A 07 00");
}

// Between the entries of the BIOS's table and behind them there is nothing, and nothing in BDOS beside its entry.
TEST_F(CpmCommand, AJumpToNoEntryIsAnError) {
  assemble("\tORG 100H\n\tPCHL\n");
  const auto jump = [this](int at, const char* flags) {
    char high[8], low[8];
    std::snprintf(high, sizeof high, "H=%02X", at >> 8);
    std::snprintf(low, sizeof low, "L=%02X", at & 0xFF);
    return run({"--cpm-drive", "a=a", "--set", high, "--set", low, "--set", flags, "--max-instructions", "1000"});
  };
  for (int at = 0xEC09; at <= 0xFFFF; at += (at >= 0xFA00 && at < 0xFA40) || at >= 0xFFA0 ? 1 : 0x61) {
    const bool entry = at >= 0xFA00 && at <= 0xFA30 && (at - 0xFA00) % 3 == 0;
    if (entry || (at >= 0xFE80 && at < 0xFE80 + 17 * 3)) continue;
    for (const char* flags : {"F=02", "F=C7"}) {
      const Ran ran = jump(at, flags);
      ASSERT_EQ(ran.exit_code, 3) << at << ran.err;
      ASSERT_TRUE(has(ran.err, "stopped: found a jump to ")) << at << ran.err;
      ASSERT_TRUE(has(ran.err, "expected an entry: that of BDOS at EC06, or one of the BIOS, every third address from FA00")) << ran.err;
    }
  }
}

TEST_F(CpmCommand, TheListDeviceHasAFile) {
  assemble("\tORG 100H\n\tMVI E,'x'\n\tMVI C,5\n\tCALL 5\n\tJMP 0\n");
  EXPECT_EQ(run({"--list", "l.txt"}).exit_code, 0);
  EXPECT_EQ(read("l.txt"), "x");
  EXPECT_TRUE(has(run({}).err, "the list device: 1 characters were discarded; --list FILE keeps them"));
}

TEST_F(CpmCommand, BiosKeysComeFromTheConsole) {
  // CONIN at 6 bytes after WBOOT; function 2 prints its key twice.
  assemble(
      "\tORG 100H\n\tLHLD 1\n\tLXI D,6\n\tDAD D\n\tLXI D,BACK\n\tPUSH D\n\tPCHL\nBACK:\tMOV E,A\n\tPUSH D\n\tMVI C,2\n\tCALL 5\n"
      "\tPOP D\n\tMVI C,2\n\tCALL 5\n\tJMP 0\n");
  const Ran ran = run({"--console", "ascii", "--send", "k", "--expect", "kk"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "kk");
}

// An empty text is typed and waited for in no time; an empty path is an error as ever.
TEST_F(CpmCommand, ATextMayBeEmpty) {
  assemble("\tORG 100H\n\tMVI C,1\n\tCALL 5\n\tMVI C,1\n\tCALL 5\n\tJMP 0\n");
  const Ran ran = run({"--console", "ascii", "--cpm-args", "", "--expect", "", "--send", "", "--send", "a", "--expect", "a", "--expect", "", "--send", "b"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "ab");
  EXPECT_EQ(run({"--console", "ascii", "--expect", ""}).exit_code, 0);
  EXPECT_EQ(run({"--console", ""}).exit_code, 2);
  EXPECT_EQ(run({"--console", "ascii", "--dump", ""}).exit_code, 2);
}

// The program polls with another count in BC each time.
TEST_F(CpmCommand, AnExpectHasItsOwnLimit) {
  assemble("\tORG 100H\n\tMVI E,'x'\n\tMVI C,2\n\tCALL 5\nLOOP:\tINX H\n\tPUSH H\n\tMVI C,11\n\tCALL 5\n\tPOP H\n\tJMP LOOP\n");
  const Ran ran = run({"--console", "ascii", "--expect", "x", "--within", "5", "--expect", "y", "--within", "2.5"});
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_EQ(ran.out, "x");
  EXPECT_TRUE(has(ran.err, "--expect \"y\": --within 2.5 is over, and the text was not printed; printed since the last match: \"\"")) << ran.err;
  EXPECT_TRUE(has(ran.err, "emulated time   2.5")) << ran.err;
  for (const auto& [words, why] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--within", "5", "--expect", "x"}, "--within 5: found no --expect before it, expected the one that it limits"},
           {{"--send", "x", "--within", "5"}, "found no --expect before it"},
           {{"--expect", "x", "--within", "5", "--within", "6"}, "--within 6: found no --expect before it"},
           {{"--expect", "x", "--within", "soon"}, "--within: found \"soon\", expected seconds of emulated time, such as 90 or 0.5"},
           {{"--expect", "x", "--within", "1x"}, "--within: found \"1x\""}}) {
    std::vector<std::string> all{"--console", "ascii"};
    all.insert(all.end(), words.begin(), words.end());
    const Ran wrong = run(all);
    EXPECT_EQ(wrong.exit_code, 2) << why;
    EXPECT_TRUE(has(wrong.err, why)) << wrong.err;
  }
}

TEST_F(CpmCommand, SteppingBackLeavesTheFilesAndGivesTheSameAnswers) {
  // Deletes A:GONE, stores the result at 200, then appends a record to A:LOG. If this ran again, the deletion would fail and the
  // record
  // would be written twice.
  assemble(
      "\tORG 100H\n\tLXI D,GONE\n\tMVI C,19\n\tCALL 5\n\tSTA 200H\n\tLXI D,LOG\n\tMVI C,35\n\tCALL 5\n\tLXI D,LOG\n\tMVI C,34\n"
      "\tCALL 5\n\tNOP\n\tHLT\nGONE:\tDB 0,'GONE       '\n\tDS 24\nLOG:\tDB 0,'LOG        '\n\tDS 24\n");
  write("a/GONE", "x");
  write("a/LOG", "");
  write("do",
        "deposit 200 55\nrun for 1000 instructions\nassert [200]==0\nback 6\nback 12\nassert [200]==55\nrun for 1000 instructions\n"
        "assert [200]==0\nhistory 30\nwho 200\n");
  const Ran ran = sightline({"monitor", "i8080", "p.com", "--cpm", "--cpm-drive", "a=a", "--do", "do"});
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_FALSE(exists("a/GONE"));
  EXPECT_EQ(read("a/LOG").size(), 128U);
  EXPECT_TRUE(has(ran.out, "0108")) << "the STA is in the history: " << ran.out;
}

TEST_F(CpmCommand, ASnapshotContinuesWithItsFiles) {
  assemble(
      "\tORG 100H\n\tLXI D,F\n\tMVI C,22\n\tCALL 5\n\tMVI A,'1'\n\tSTA 80H\n\tLXI D,F\n\tMVI C,21\n\tCALL 5\n\tMVI A,'2'\n\tSTA 80H\n"
      "\tLXI D,F\n\tMVI C,21\n\tCALL 5\n\tJMP 0\nF:\tDB 0,'F       DAT'\n\tDS 24\n");
  ASSERT_EQ(run({"--cpm-drive", "a=a", "--max-instructions", "16", "--save", "s"}).exit_code, 0);
  EXPECT_EQ(read("a/F.DAT").size(), 128U);
  const Ran ran = sightline({"run", "i8080", "--restore", "s", "--cpm", "--cpm-drive", "a=a", "--max-instructions", "1000"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  ASSERT_EQ(read("a/F.DAT").size(), 256U);
  EXPECT_EQ(read("a/F.DAT")[128], '2');
  EXPECT_EQ(sightline({"run", "i8080", "--restore", "s", "--cpm"}).exit_code, 4) << "without the drive";
}

TEST_F(CpmCommand, InvalidDrives) {
  const auto refused = [this](Arguments options, std::string_view message) {
    options.insert(options.begin(), {"run", "i8080", "--load", "p.com"});
    const Ran ran = sightline(options);
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_TRUE(has(ran.err, message)) << ran.err;
  };
  write("p.com", "\xC9");
  refused({"--cpm-drive", "a=a"}, "--cpm-drive: needs --cpm");
  refused({"--cpm", "--cpm-drive", "a=none"}, "--cpm-drive: found \"a=none\", expected a folder behind the =");
  refused({"--cpm", "--cpm-drive", "q=a"}, "expected X=FOLDER or X=FOLDER,ro with X of A to P");
  refused({"--cpm", "--cpm-drive", "a=a", "--cpm-drive", "A=a"}, "found two folders for drive A, expected one");
}

// A program for the Altair echoes typed characters through the 2SIO, each taking ten bits on the line.
TEST_F(CpmCommand, TheTerminalOfAnAltairIsTheConsole) {
  std::filesystem::copy_file(std::filesystem::path(SIGHTLINE_SOURCE_DIR) / "host/examples/boards/altair.asm", path("p.asm"));
  ASSERT_EQ(sightline({"asm", "i8080", "p.asm", "-o", "p.hex"}).exit_code, 0);
  const auto session = [this](Arguments options) {
    Arguments words{"run", "i8080", "p.hex", "--terminal", "2sio", "--max-states", "30000000"};
    words.insert(words.end(), options.begin(), options.end());
    return sightline(words);
  };
  const Ran ran = session({"--console", "ascii", "--send", "Hi\\e"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "Hi");
  EXPECT_TRUE(has(ran.err, "stopped by      halt")) << ran.err;
  const Ran slow = session({"--console", "ascii", "--send", "abc\\e", "--baud", "110", "--dump", "d"});
  EXPECT_EQ(slow.out, "abc");
  // Three characters of a tenth of a second each must be received before the last key.
  EXPECT_TRUE(has(slow.err, "emulated time   0.3")) << slow.err;
  EXPECT_TRUE(has(session({"--console", "ascii", "--baud", "7"}).err, "--baud: found 7, expected 50 to 1000000"));
  EXPECT_TRUE(has(sightline({"run", "i8080", "p.hex", "--baud", "300"}).err, "--baud: needs --terminal"));
}

}  // namespace
