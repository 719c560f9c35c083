// `sightline run i8080`: reports and files, CP/M programs on standard output, devices, every kind of bad input.
//
// Programs are given as bytes; expected T-states are sums over opcode-timing.csv.
#include <sys/stat.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"
#include "tests/support/effort.hpp"

namespace {

using nlohmann::json;
using namespace std::string_view_literals;
using sightline::test::Arguments;
using sightline::test::has;
using sightline::test::Ran;

class RunI8080Command : public sightline::test::CommandLine {
 protected:
  // MVI C,9; LXI D,010B; CALL 5; JMP 0; "Hello", 0D, 0A, "$": 7 + 10 + 17 + 20 + 10 + 10 T-states.
  static constexpr std::string_view hello = "\x0E\x09\x11\x0B\x01\xCD\x05\x00\xC3\x00\x00Hello\r\n$"sv;
  // MVI A,5; DAD H; HLT: 7 + 10 + 7.
  static constexpr std::string_view small = "\x3E\x05\x29\x76"sv;
  static constexpr std::string_view forever = "\xC3\x00\x00"sv;

  Ran run(Arguments options) {
    options.insert(options.begin(), {"run", "i8080"});
    return sightline(options);
  }
  json report(Arguments options) {
    options.push_back("--json");
    const Ran ran = run(std::move(options));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(ran.out, nullptr, false);
  }
  void expect_failure(const Arguments& options, int exit_code, std::string_view message) {
    const Ran ran = run(options);
    EXPECT_EQ(ran.exit_code, exit_code) << ran.err;
    EXPECT_TRUE(has(ran.err, message)) << ran.err;
    EXPECT_EQ(ran.out, "");
  }
};

TEST_F(RunI8080Command, JsonReport) {
  write("small.bin", small);
  const json r = report({"--load", "small.bin@2000", "--start", "2000", "--set", "h=12", "--set", "L=34h",
                         "--set", "SP=0xFEDC", "--set", "F=FF", "--set", "INTE=1", "--clock", "2000000"});
  EXPECT_EQ(r.at("schema"), "sightline/run-i8080/1");
  EXPECT_EQ(r.at("stop_reason"), "halt");
  EXPECT_EQ(r.at("pc"), "2004");
  EXPECT_EQ(r.at("instructions"), 3);
  EXPECT_EQ(r.at("t_states"), 24);
  EXPECT_EQ(r.at("clock_hz"), 2'000'000);
  EXPECT_EQ(r.at("emulated_ns"), 12'000);
  const json expected{{"a", "05"}, {"f", "D6"}, {"b", "00"},    {"c", "00"},    {"d", "00"}, {"e", "00"},
                      {"h", "24"}, {"l", "68"}, {"sp", "FEDC"}, {"pc", "2004"}, {"inte", 1}};
  EXPECT_EQ(r.at("registers"), expected);  // DAD has cleared the carry
  EXPECT_FALSE(r.contains("console"));
}

TEST_F(RunI8080Command, TableForAPerson) {
  write("small.com", small);
  const Ran ran = run({"--load", "small.com"});  // a .com file starts at 0100
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(has(ran.out, "halt, PC 0104")) << ran.out;
  EXPECT_TRUE(has(ran.out, "0.000008000 s at 3000000 Hz")) << ran.out;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << "the warning that --cpm is not given";
}

TEST_F(RunI8080Command, CpmProgramPrintsOnStandardOutput) {
  for (const char* name : {"hello.com", "hello.bin", "hello"}) {
    write(name, hello);
    const Ran ran = run({"--cpm", "--load", name});
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.out, "Hello\r\n") << name;
    EXPECT_TRUE(has(ran.err, "stopped by      exit, PC 0002\nT-states        74\n")) << ran.err;
  }
  const json r = report({"--cpm", "--load", "hello.com"});
  EXPECT_EQ(r.at("console"), "Hello\r\n");
  EXPECT_EQ(r.at("stop_reason"), "exit");
  EXPECT_EQ(r.at("t_states"), 74);
  EXPECT_EQ(r.at("registers").at("sp"), "0000");
  EXPECT_FALSE(report({"--cpm", "--load", "hello.com", "--console-out", "out"}).contains("console"));
  EXPECT_EQ(read("out"), "Hello\r\n");
}

// The beginning of a program for the Z80 that prints "hi": JR over one byte, 18 01. On an 8080 18 is a NOP.
TEST_F(RunI8080Command, UndefinedOpcodesAreCountedAndNamed) {
  write("z.com", "\x11\x0C\x01\x0E\x09\x18\x01\xC9\xCD\x05\x00\xC7hi$"sv);
  const Ran ran = run({"--cpm", "z.com", "--console-out", "c"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.err, "PC 0105: executes opcode 18, which Intel left undefined and an 8080 takes as NOP; a program for the Z80? (once)")) << ran.err;
  EXPECT_TRUE(has(ran.out, "undefined       opcodes 18 at 0105 (1)")) << ran.out;
  const Ran strict = run({"--cpm", "z.com", "--strict"});
  EXPECT_EQ(strict.exit_code, 3) << strict.err;
  EXPECT_TRUE(has(strict.err, "stopped by --strict: PC 0105: executes opcode 18, which Intel left undefined")) << strict.err;
  // Each of the twelve, four times, by a loop. CB and the CALLs lead to the next one, D9 returns there.
  write("all.bin",
        "\x31\x00\x80\x0E\x04"                      // 0000 LXI SP,8000; MVI C,4
        "\x08\x10\x18\x20\x28\x30\x38"              // 0005
        "\xCB\x0F\x00"                              // 000C JMP 000F
        "\xDD\x12\x00\xED\x15\x00\xFD\x18\x00"      // 000F CALL 0012, CALL 0015, CALL 0018
        "\x21\x1D\x00\xE5\xD9\x0D\xC2\x05\x00\x76"sv);  // 0018 LXI H,001D; PUSH H; RET; DCR C; JNZ 0005; HLT
  for (const Arguments& engine : {Arguments{}, Arguments{"--trace", "t"}, Arguments{"--hold", "0+1/4"}}) {
    Arguments words{"all.bin"};
    words.insert(words.end(), engine.begin(), engine.end());
    const json r = report(words);
    EXPECT_EQ(r.at("stop_reason"), "halt");
    const json& undefined = r.at("undefined");
    ASSERT_EQ(undefined.size(), 12U) << undefined.dump();
    EXPECT_EQ(undefined[0], (json{{"opcode", "08"}, {"first", "0005"}, {"count", 4}}));
    EXPECT_EQ(undefined[7], (json{{"opcode", "CB"}, {"first", "000C"}, {"count", 4}}));
    EXPECT_EQ(undefined[11], (json{{"opcode", "D9"}, {"first", "001C"}, {"count", 4}}));
  }
  write("small.bin", small);
  EXPECT_EQ(report({"small.bin"}).at("undefined").size(), 0U);
}

TEST_F(RunI8080Command, OverlappingHexRecordsLoadWithALine) {
  write("overlap.hex", ":030100003E017647\n:0101010002FB\n:00000001FF\n");
  const Ran ran = run({"overlap.hex", "--start", "100"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "A 02")) << ran.out;
  EXPECT_TRUE(has(ran.err, "overlap.hex:2:10: found byte 02 for address 0101, expected 01")) << ran.err;
}

TEST_F(RunI8080Command, AComFileWithoutCpmIsWarnedAbout) {
  write("hello.com", hello);
  const Ran ran = run({"hello.com", "--max-instructions", "3"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(has(ran.err, "hello.com: found a .com file, expected --cpm with it")) << ran.err;
  EXPECT_FALSE(has(run({"hello.com", "--cpm"}).err, "warning"));
  write("hello.bin", hello);
  EXPECT_EQ(run({"hello.bin@100", "--start", "100", "--max-instructions", "3"}).err, "");
}

// Like the test of the PDP-7. INR A; INX H; MOV M,A; PUSH PSW; JMP 0.
TEST_F(RunI8080Command, ADumpContinuesTheRun) {
  write("loop.bin", "\x3C\x23\x77\xF5\xC3\x00\x00"sv);
  const Arguments start{"loop.bin", "--set", "SP=F000", "--set", "H=80", "--set", "INTE=1"};
  const auto with = [](Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  ASSERT_EQ(run(with(start, {"--max-instructions", "1000", "--dump", "whole"})).exit_code, 0);
  ASSERT_EQ(run(with(start, {"--max-instructions", "333", "--dump", "part"})).exit_code, 0);
  const Ran rest = run({"part", "--max-instructions", "667", "--dump", "joined"});
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(read("joined"), read("whole"));
  EXPECT_NE(read("part"), read("whole"));
  EXPECT_EQ(report({"part", "--max-instructions", "0"}).at("registers").at("inte"), 1);
  EXPECT_EQ(sightline({"disasm", "i8080", "part", "--end", "6"}).out,
            sightline({"disasm", "i8080", "loop.bin"}).out);
  write("bad", read("part") + "00\n");
  expect_failure({"bad"}, 4, "expected 65536 words at most");
}

TEST_F(RunI8080Command, IntelHexByEndingOrContent) {
  const std::string hex = ":040100003E05297619\n:00010001FE\n";
  write("small.hex", hex);
  write("small", hex);
  for (const char* name : {"small.hex", "small"}) {
    EXPECT_EQ(report({"--load", name, "--start", "100"}).at("t_states"), 24) << name;
    EXPECT_EQ(report({"--load", name}).at("t_states"), 24) << name;  // the end record's start address
    EXPECT_EQ(report({"--cpm", "--load", name}).at("t_states"), 24) << name;
  }
}

TEST_F(RunI8080Command, TextIsIntelHexOnlyIfItBeginsWithARecord) {
  // LDA 0000; MVI A,5; HLT: 13 + 7 + 7.
  write("colon", ":\x00\x00\x3E\x05\x76"sv);
  EXPECT_EQ(report({"--load", "colon"}).at("t_states"), 27);
  EXPECT_EQ(report({"--cpm", "--load", "colon"}).at("pc"), "0106");
}

TEST_F(RunI8080Command, AProgramMayComeThroughAPipe) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  std::thread writer([this] { write("pipe", hello); });
  const Ran ran = run({"--cpm", "--load", "pipe"});
  writer.join();
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "Hello\r\n");
}

TEST_F(RunI8080Command, TheConsoleInTheReportIsBounded) {
  NEEDS_OPTIMISED_CODE();
  // LXI H,280; MVI C,9; LXI D,0118; CALL 5; DCX H; MOV A,H; ORA L; JNZ 0103; HLT; 65000 characters.
  std::string program("\x21\x18\x01\x0E\x09\x11\x18\x01\xCD\x05\x00\x2B\x7C\xB5\xC2\x03\x01\x76"sv);
  program.resize(0x18);
  write("loud.com", program + std::string(65000, 'x') + "$");
  const Ran ran = run({"--cpm", "--load", "loud.com", "--json"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(has(ran.err, "lacks the last 1422784 bytes printed")) << ran.err;  // 280 * 65000 - 2^24
  EXPECT_EQ(json::parse(ran.out).at("console").get<std::string>().size(), std::size_t{1} << 24);
}

TEST_F(RunI8080Command, ARunEndsWhenItsOutputIsClosed) {
  // LXI H,0; MVI C,2; CALL 5; DCX H; MOV A,H; ORA L; JNZ 0103; HLT: HL counts the characters.
  write("loud.com", "\x21\x00\x00\x0E\x02\xCD\x05\x00\x2B\x7C\xB5\xC2\x03\x01\x76"sv);
  send_stdout_to("/dev/full");
  const Ran ran = run({"--cpm", "--load", "loud.com", "--dump", "dump"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_TRUE(has(ran.err, "standard output: cannot write")) << ran.err;
  EXPECT_NE(read("dump").substr(18, 5), "00 00");
}

TEST_F(RunI8080Command, DumpTraceAndBus) {
  write("small.bin", small);
  ASSERT_EQ(run({"--load", "small.bin", "--dump", "dump", "--trace", "trace", "--bus", "bus"}).exit_code, 0);
  const std::string dump = read("dump");
  EXPECT_TRUE(dump.starts_with("05 02 00 00 00 00 00 00 0000 0004 0\n3E 05 29 76 00 ")) << dump.substr(0, 80);
  EXPECT_EQ(std::count(dump.begin(), dump.end(), '\n'), 4097);
  EXPECT_TRUE(has(read("trace"), "           7 0002 29     DAD     H            05 02 ")) << read("trace");
  EXPECT_EQ(read("bus"), "0 A2 0000 3E\n4 82 0001 05\n7 A2 0002 29\n17 A2 0003 76\n21 8A 0003 --\n");
  const Ran on_stdout = run({"--load", "small.bin", "--bus", "-"});
  EXPECT_EQ(on_stdout.out, read("bus"));
  EXPECT_TRUE(has(on_stdout.err, "T-states        24"));
}

TEST_F(RunI8080Command, Limits) {
  write("forever.bin", forever);
  EXPECT_EQ(report({"--load", "forever.bin", "--max-instructions", "5"}).at("t_states"), 50);
  const json r = report({"--load", "forever.bin", "--max-states", "31"});
  EXPECT_EQ(r.at("t_states"), 40);
  EXPECT_EQ(r.at("stop_reason"), "state_limit");
}

TEST_F(RunI8080Command, StoppedByCtrlC) {
  write("forever.bin", forever);
  const Ran ran = run_interrupted({"run", "i8080", "--load", "forever.bin", "--dump", "dump", "--json"});
  EXPECT_EQ(ran.exit_code, 130);
  EXPECT_EQ(json::parse(ran.out).at("stop_reason"), "interrupted");
  EXPECT_TRUE(exists("dump"));
}

TEST_F(RunI8080Command, RasterBoard) {
  // MVI A,4; OUT 50; MVI A,3; OUT 41; MVI A,10; OUT 49; MVI A,20; OUT 4B; MVI A,80; OUT 40; HLT: one red dot.
  write("dot.bin", "\x3E\x04\xD3\x50\x3E\x03\xD3\x41\x3E\x10\xD3\x49\x3E\x20\xD3\x4B\x3E\x80\xD3\x40\x76"sv);
  const json r = report({"--load", "dot.bin", "--board", "ef9365", "--png", "p.png"});
  EXPECT_EQ(r.at("devices").at("ef9365").at("dots"), 1);
  EXPECT_TRUE(r.at("unanswered").empty());
  const auto png = sightline::picture::read_png(path("p.png").string());
  ASSERT_TRUE(png);
  ASSERT_EQ(png->image.channels, 3);
  std::vector<std::uint8_t> expected(std::size_t{256} * 256 * 3);
  expected[((255 - 0x20) * 256 + 0x10) * 3] = 255;
  EXPECT_EQ(png->image.pixels, expected);
  ASSERT_EQ(run({"--load", "dot.bin", "--board", "ef9365", "--png", "p.png", "--grey"}).exit_code, 0);
  const auto grey = sightline::picture::read_png(path("p.png").string());
  ASSERT_TRUE(grey);
  ASSERT_EQ(grey->image.channels, 1);
  EXPECT_EQ(grey->image.pixels[(255 - 0x20) * 256 + 0x10], 146);  // 255 * 4 / 7, to the nearest
}

TEST_F(RunI8080Command, PlotterAndSerialLink) {
  // MVI A,9 (pen down); OUT 60; IN 60; ANI 1; JNZ 4; MVI A,2 (+x); OUT 60; HLT.
  write("step.bin", "\x3E\x09\xD3\x60\xDB\x60\xE6\x01\xC2\x04\x00\x3E\x02\xD3\x60\x76"sv);
  const json r = report({"--load", "step.bin", "--plotter", "calcomp", "--plotter-start", "10,20",
                         "--strokes", "s", "--svg", "p.svg"});
  EXPECT_EQ(r.at("devices").at("calcomp565").at("steps"), 1);
  EXPECT_EQ(r.at("devices").at("calcomp565").at("commands_while_busy"), 0);
  const std::string strokes = read("s");
  EXPECT_TRUE(has(strokes, " 10 20 7 00000\n")) << strokes;
  EXPECT_TRUE(has(strokes, " 11 20 7 00000\n")) << strokes;
  EXPECT_TRUE(has(read("p.svg"), "<polyline")) << read("p.svg");
  // The 8251: mode 4E, command 27; waits for RxRDY, reads, sends the same back, waits for TxEMPTY, halts.
  write(
      "echo.bin",
      "\x3E\x4E\xD3\xED\x3E\x27\xD3\xED\xDB\xED\xE6\x02\xCA\x08\x00\xDB\xEC\xD3\xEC\xDB\xED\xE6\x04\xCA\x13\x00\x76"sv);
  write("bytes", "A");
  const json echo = report({"--load", "echo.bin", "--serial", "bytes", "--serial-out", "back"});
  EXPECT_EQ(read("back"), "A");
  EXPECT_EQ(echo.at("devices").at("serial").at("transmitted"), 1);
}

TEST_F(RunI8080Command, PortsThatNothingAnswers) {
  write("ports.bin", "\xDB\x20\xD3\x21\xD3\x21\x76"sv);
  const Ran ran = run({"--load", "ports.bin", "--json"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(has(ran.err, "port 20: no device at this port, read as FF (once)")) << ran.err;
  EXPECT_TRUE(has(ran.err, "port 21: no device at this port, written without effect (2 times)")) << ran.err;
  EXPECT_EQ(json::parse(ran.out).at("unanswered").at(1), json({{"port", "21"}, {"reads", 0}, {"writes", 2}}));
  const Ran strict = run({"--load", "ports.bin", "--strict", "--dump", "dump"});
  EXPECT_EQ(strict.exit_code, 3);
  EXPECT_TRUE(has(strict.err, "PC 0000: stopped by --strict")) << strict.err;
  EXPECT_TRUE(exists("dump"));
}

TEST_F(RunI8080Command, ProgramsThatFail) {
  write("open.com", "\x0E\x0F\xCD\x05\x00\xC3\x00\x00"sv);  // function 15
  const Ran unknown = run({"--cpm", "--load", "open.com", "--json"});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_TRUE(has(unknown.err, "PC 0102: stopped: found a call of BDOS function 15 (Open File), which needs --cpm-drive A=FOLDER"))
      << unknown.err;
  EXPECT_EQ(json::parse(unknown.out).at("bdos").at("function"), 15);
  write("endless.com", "\x0E\x09\xCD\x05\x00"sv);
  const Ran endless = run({"--cpm", "--load", "endless.com"});
  EXPECT_EQ(endless.exit_code, 3);
  EXPECT_TRUE(has(endless.err, "found no $")) << endless.err;
}

TEST_F(RunI8080Command, BadFilesLeaveNothingBehind) {
  write("big.com", std::string(0xFF01, '\0'));
  expect_failure({"--cpm", "--load", "big.com", "--dump", "d"}, 4, "big.com: error: found 65281 bytes");
  write("full.com", std::string(0xFF00, '\x76'));
  EXPECT_EQ(run({"--cpm", "--load", "full.com"}).exit_code, 0);
  write("big.bin", std::string(0x10001, '\0'));
  expect_failure({"--load", "big.bin", "--dump", "d"}, 4, "big.bin: error:");
  expect_failure({"--load", "big.com@F000", "--dump", "d"}, 2, "big.com");
  write("sum.hex", ":040100003E05297618\n:00010001FE\n");
  expect_failure({"--load", "sum.hex", "--dump", "d"}, 4, "sum.hex:1");
  write("cut.hex", ":040100003E05297619\n");
  expect_failure({"--load", "cut.hex", "--dump", "d"}, 4, "cut.hex");
  write("empty.com", "");
  expect_failure({"--cpm", "--load", "empty.com", "--dump", "d"}, 4, "empty.com");
  write("low.bin", "\x01"sv);
  expect_failure({"--cpm", "--load", "low.bin@0005", "--dump", "d"}, 4, "0005");
  expect_failure({"--load", "none.bin", "--dump", "d"}, 5, "none.bin");
  expect_failure({"--load", "low.bin", "--serial", "none"}, 5, "none");
  expect_failure({"--load", "low.bin", "--dump", "no/such/place"}, 5, "no/such/place");
  EXPECT_FALSE(exists("d"));
}

TEST_F(RunI8080Command, WrongUsage) {
  write("small.bin", small);
  const auto refused = [this](Arguments options, std::string_view message) {
    options.insert(options.begin(), {"--load", "small.bin"});
    expect_failure(options, 2, message);
  };
  expect_failure({}, 2, "--load");
  refused({"--start", "10000"}, "--start: found \"10000\", expected an address, hexadecimal, 0 to FFFF");
  refused({"--start", "1G"}, "--start");
  refused({"--set", "HL=0"},
          "--set: found \"HL=0\", expected REGISTER=VALUE with one of A F B C D E H L SP PC INTE");
  refused({"--set", "A=100"}, "--set A: found \"100\"");
  refused({"--set", "A"}, "--set: found \"A\"");
  refused({"--set", "INTE=2"}, "--set INTE: found \"2\"");
  refused({"--set", "PC=1", "--start", "1"}, "--set PC");
  refused({"--clock", "0"}, "--clock");
  refused({"--clock", "999"}, "--clock: found 999, expected 1000 to 1000000000 Hz");
  refused({"--clock", "1000000001"}, "--clock");
  refused({"--max-states", "-1"}, "--max-states");
  refused({"--max-instructions", "many"}, "--max-instructions");
  refused({"--png", "p"}, "--png: needs --board");
  refused({"--strokes", "s"}, "--strokes: needs --plotter");
  refused({"--svg", "s"}, "--svg: needs --plotter");
  refused({"--console-out", "c"}, "--console-out: needs --cpm");
  refused({"--console", "ascii"}, "--console: needs --cpm or --terminal");
  refused({"--cpm", "--console", "c.txt"}, "--console: found \"c.txt\", expected ascii, parity, unix or upper");
  refused({"--cpm", "--console", "ascii", "--speed", "fast"}, "--speed: found \"fast\"");
  refused({"--cpm", "--console", "ascii", "--send", "\\q"}, "--send: found \"\\q\", expected \\r");
  refused({"--cpm", "--console", "ascii", "--dump", "-"}, "--console needs standard output");
  refused({"--cpm", "--speed", "max"}, "--speed: needs --console");
  refused({"--interrupt", "serial-receive=7"}, "expected an attached device");
  refused({"--interrupt", "ef9365=8", "--board", "ef9365"}, "--interrupt");
  refused({"--plotter", "calcomp", "--plotter-start", "1"}, "--plotter-start");
  for (const char* const hold : {"5", "5+", "5+0", "+5", "5+5/5", "5+5/", "5+5/x", "5+5/6/7", "-1+5"})
    refused({"--hold", hold}, "expected FIRST+LENGTH or FIRST+LENGTH/PERIOD in T-states");
  refused({"--plotter", "calcomp", "--plotter-start", "0,1101"}, "expected X,Y, decimal, X 0 to 65535, Y 0 to 1100");
  refused({"--board", "vdu"}, "--board");
  refused({"--dump", "x", "--trace", "x"}, "x: named for two outputs");
  refused({"--dump", "-", "--json"}, "--json needs standard output");
  refused({"--cpm", "--dump", "-"}, "--console-out FILE puts that elsewhere");
  EXPECT_EQ(files(), std::vector<std::string>{"small.bin"});
}

TEST_F(RunI8080Command, AHaltThatNoDeviceCanEndIsExplained) {
  write("wait.asm", "\tORG 0\n\tLXI SP,200H\n\tEI\n\tHLT\n\tEND\n");
  const std::vector<std::string> words{"run", "i8080", "wait.asm", "--max-states", "1000"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), words.begin(), words.end());
    return sightline(more);
  };
  const Ran forgotten = with({"--board", "ef9365"});
  EXPECT_EQ(forgotten.exit_code, 0) << forgotten.err;
  EXPECT_TRUE(has(forgotten.err, "HLT waits for an interrupt, and a device here is not wired to one: --interrupt LINE=N, with LINE of ef9365 ")) << forgotten.err;
  EXPECT_FALSE(has(with({"--board", "ef9365", "--interrupt", "ef9365=7"}).err, "HLT waits"));
  EXPECT_FALSE(has(with({}).err, "HLT waits")) << "there is no device";
}

}  // namespace
