// One run of an 8080 program: CP/M's entry points and their cost, the texts of trace, bus and dump, interrupts through the ports;
// and that
// polling during a run changes nothing.
//
// Expected T-states are sums over opcode-timing.csv, written beside each program; the stub's OUT and RET take 10 each.
#include "host/machines/i8080.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/picture/pen_drawing.hpp"
#include "tests/host/machines/machine_run.hpp"
#include "tests/support/effort.hpp"
#include "tools/asm/i8080.hpp"
#include "tools/image/intel_hex.hpp"

namespace sightline::test {
namespace {

// Without limits a wrong machine might not stop.
MachineRun run_of(const std::string& text, const char* most_instructions = "100000000") {
  const std::vector<assembler::SourceFile> sources{{"test.asm", "  ORG 100H\n" + text}};
  const auto assembly = assembler::assemble_i8080(sources);
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
  return MachineRun(machines::i8080())
      .set_file("--load", "test.hex", image::write_intel_hex(assembly.image))
      .set("--start", "100")
      .set("--max-instructions", most_instructions);
}

MachineRun cpm_run_of(const std::string& text) {
  return run_of(text).set("--cpm").set("--console-out");
}

const std::string& console(const Left& left) {
  return left.streams.at("--console-out");
}

constexpr const char* hello =
    "  MVI C,9\n"     // 7
    "  LXI D,TEXT\n"  // 10
    "  CALL 5\n"      // 17, and 20 for the stub
    "  JMP 0\n"       // 10, and 10 for the end
    "TEXT: DB 'Hello, world',13,10,'$'\n";

TEST(CpmRun, PrintsAString) {
  const Left left = cpm_run_of(hello).go();
  EXPECT_EQ(left.stop.name, "exit");
  EXPECT_EQ(console(left), "Hello, world\r\n");
  EXPECT_EQ(left.number("t_states"), 7 + 10 + 17 + 20 + 10 + 10);
  EXPECT_EQ(left.number("instructions"), 7);
  EXPECT_EQ(left.text("registers", "pc"), "0002");
  EXPECT_EQ(left.text("registers", "sp"), "0000");
  EXPECT_EQ(left.report.find("unanswered")->size(), 0U);
}

TEST(CpmRun, PrintsCharactersAndReturnsAtTheTopLevel) {
  const Left left = cpm_run_of(
                        "  MVI B,3\n"      // 7
                        "  MVI E,'A'\n"    // 7
                        "LOOP: MVI C,2\n"  // 7
                        "  PUSH B\n"       // 11
                        "  CALL 5\n"       // 17, and 20
                        "  POP B\n"        // 10
                        "  INR E\n"        // 5
                        "  DCR B\n"        // 5
                        "  JNZ LOOP\n"     // 10 taken or not
                        "  RET\n")         // 10, and 10 for the end
                        .go();
  EXPECT_EQ(left.stop.name, "exit");
  EXPECT_EQ(console(left), "ABC");
  EXPECT_EQ(left.number("t_states"), 14 + 3 * (7 + 11 + 37 + 10 + 5 + 5 + 10) + 20);
  EXPECT_EQ(left.number("instructions"), 2 + 3 * 9 + 2);
  EXPECT_EQ(left.text("registers", "sp"), "0002");
}

TEST(CpmRun, FunctionZeroEndsLikeAJumpToZero) {
  const Left left = cpm_run_of("  MVI C,0\n  CALL 5\n  HLT\n").go();  // 7, 17, OUT 1, OUT 0
  EXPECT_EQ(left.stop.name, "exit");
  EXPECT_EQ(left.number("t_states"), 7 + 17 + 10 + 10);
}

TEST(CpmRun, UnknownFunctionsNameTheirCaller) {
  const Left called = cpm_run_of("  MVI C,15\n  CALL 5\n  JMP 0\n").go();
  EXPECT_EQ(called.stop.name, "unknown_bdos");
  EXPECT_EQ(called.report.find("bdos")->find("function")->integer(), 15);
  EXPECT_EQ(called.text("bdos", "caller"), "0102");
  EXPECT_EQ(called.number("t_states"), 7 + 17 + 10);
  const Left jumped = cpm_run_of("  LXI SP,300H\n  MVI C,1\n  JMP 5\n").go();
  EXPECT_EQ(jumped.stop.name, "unknown_bdos");
  EXPECT_EQ(jumped.text("bdos", "caller"), "0005");
  EXPECT_EQ(console(jumped), "");
}

TEST(CpmRun, AStringWithoutEndIsAnError) {
  const Left left = cpm_run_of("  MVI C,9\n  LXI D,200H\n  CALL 5\n  JMP 0\n").go();
  EXPECT_EQ(left.stop.name, "endless_string");
  EXPECT_EQ(left.text("bdos", "caller"), "0105");
  EXPECT_EQ(console(left), "");
}

TEST(CpmRun, AStringWrapsAtTheEndOfMemory) {
  const Left left =
      cpm_run_of(
          "  LXI SP,300H\n  LXI H,'A'*256+'B'\n  SHLD 0FFFEH\n  MVI C,9\n  LXI D,0FFFEH\n  MVI A,'$'\n"
          "  STA 0002H\n  CALL 5\n  JMP 0\n")
          .go();
  EXPECT_EQ(console(left), std::string("BA\xD3\0", 4));
}

// A loop with a call every 46 T-states never takes a whole slice.
TEST(CpmRun, AProgramThatPrintsAllTheTimeCanBeInterrupted) {
  int asked = 0;
  const Left left = run_of("LOOP: MVI C,2\n  CALL 5\n  JMP LOOP\n", "1000000")
                        .set("--cpm")
                        .set("--console-out")
                        .ask([&asked](const machines::Progress&) { return ++asked < 10; })
                        .go();
  EXPECT_EQ(left.stop.name, machines::interrupted);
  EXPECT_EQ(console(left).size(), 10U);
}

TEST(CpmRun, ItsOwnOutToTheStubsPortsIsAnUnansweredPort) {
  const Left left = cpm_run_of("  OUT 0\n  OUT 1\n  OUT 1\n  IN 1\n  JMP 0\n").go();
  EXPECT_EQ(left.stop.name, "exit");
  EXPECT_EQ(left.number("t_states"), 4 * 10 + 10 + 10);
  EXPECT_EQ(left.report.find("unanswered")->dump(),
            R"([{"port":"00","reads":0,"writes":1},{"port":"01","reads":1,"writes":2}])");
}

TEST(CpmRun, WithoutATakerTheReportHasTheOutput) {
  const Left left = run_of(hello).set("--cpm").set("--json").go();
  EXPECT_EQ(*left.report.find("console")->text(), "Hello, world\r\n");
  EXPECT_EQ(cpm_run_of(hello).set("--json").go().report.find("console"), nullptr);
}

TEST(RunI8080, StrictStopsAtAPortThatNothingAnswers) {
  for (const char* program :
       {"  NOP\n  IN 20H\n  HLT\n", "  NOP\n  OUT 20H\n  HLT\n", "  NOP\n  OUT 1\n  HLT\n"}) {
    EXPECT_EQ(run_of(program).go().stop.name, "halt");
    const Left left = run_of(program).set("--strict").set("--cpm").go();
    EXPECT_EQ(left.stop.name, "strict") << program;
    EXPECT_EQ(left.stop.complaint, "PC 0101: stopped by --strict: no device at that port") << program;
    EXPECT_EQ(left.text("registers", "pc"), "0103") << program;
    EXPECT_EQ(left.number("t_states"), 14) << program;
  }
}

TEST(RunI8080, Limits) {
  const char* const loop = "LOOP: JMP LOOP\n";
  Left left = run_of(loop, "7").go();
  EXPECT_EQ(left.stop.name, "instruction_limit");
  EXPECT_EQ(left.number("t_states"), 70);
  left = run_of(loop).set("--max-states", "71").go();
  EXPECT_EQ(left.stop.name, "state_limit");
  EXPECT_EQ(left.number("t_states"), 80);
  EXPECT_EQ(run_of(loop).set("--max-states", "0").go().number("instructions"), 0);
}

TEST(RunI8080, PollingDuringARunChangesNothing) {
  NEEDS_OPTIMISED_CODE();
  // 22 x 65536 x (5 + 5 + 4 + 10), more than one slice
  const MachineRun counting = run_of(
      "  MVI B,22\nOUTER: LXI D,0\nINNER: DCX D\n  MOV A,D\n  ORA E\n  JNZ INNER\n  DCR B\n  JNZ OUTER\n  "
      "HLT\n");
  const Left alone = counting.go();
  EXPECT_EQ(alone.number("t_states"), 7 + 22LL * (10 + 65536 * 24 + 5 + 10) + 7);
  int asked = 0;
  const Left watched =
      MachineRun(counting).ask([&asked](const machines::Progress&) { return ++asked < 1000; }).go();
  EXPECT_GE(asked, 1);
  EXPECT_EQ(watched.stop.name, "halt");
  expect_same(watched, alone);
  EXPECT_EQ(MachineRun(counting).ask([](const machines::Progress&) { return false; }).go().stop.name,
            machines::interrupted);
}

TEST(RunI8080, TraceAndBusLines) {
  const Left left =
      run_of("  LXI H,1234H\n  DAD H\n  DB 08H\n  OUT 20H\n  HLT\n").set("--trace").set("--bus").go();
  EXPECT_EQ(left.number("t_states"), 10 + 10 + 4 + 10 + 7);
  EXPECT_EQ(left.streams.at("--trace"),
            "           0 0100 213412 LXI     H,1234H      00 02 00 00 00 00 12 34 0000 0103 0\n"
            "          10 0103 29     DAD     H            00 02 00 00 00 00 24 68 0000 0104 0\n"
            "          20 0104 08     *NOP                 00 02 00 00 00 00 24 68 0000 0105 0\n"
            "          24 0105 D320   OUT     20H          00 02 00 00 00 00 24 68 0000 0107 0\n"
            "          34 0107 76     HLT                  00 02 00 00 00 00 24 68 0000 0108 0\n");
  EXPECT_EQ(left.streams.at("--bus"),
            "0 A2 0100 21\n4 82 0101 34\n7 82 0102 12\n"
            "10 A2 0103 29\n"
            "20 A2 0104 08\n"
            "24 A2 0105 D3\n28 82 0106 20\n31 10 2020 00\n"
            "34 A2 0107 76\n38 8A 0107 --\n");
}

TEST(RunI8080, AnInterruptEndsAHaltAndIsTraced) {
  // The 8255: port A strobed input with its interrupt enabled. The host sends one byte; its RST 7 reads the byte and halts for
  // good.
  const MachineRun deaf =
      run_of("  MVI A,0B0H\n  OUT 0E7H\n  MVI A,09H\n  OUT 0E7H\n  EI\n  HLT\n  ORG 38H\n  IN 0E4H\n  HLT\n")
          .set("--set", "sp=200")
          .set_file("--parallel", "sent", "\x5A");
  const Left left = MachineRun(deaf).set("--interrupt", "parallel=7").set("--trace").set("--bus").go();
  EXPECT_EQ(left.stop.name, "halt");
  EXPECT_EQ(left.text("registers", "a"), "5A");
  EXPECT_EQ(left.text("registers", "sp"), "01FE");
  const std::string& trace = left.streams.at("--trace");
  const std::string& bus = left.streams.at("--bus");
  EXPECT_NE(trace.find(" FF     INT RST     7 "), std::string::npos) << trace;
  EXPECT_NE(bus.find(" 2B "), std::string::npos) << bus;  // INTA while halted
  EXPECT_EQ(deaf.go().text("registers", "pc"), "010A");
}

TEST(RunI8080, StepsOfThePlotterAreJoined) {
  // The Minigraf: pen down at (0, 0), two steps along x, one diagonal; pen up for two steps, down for a dot.
  std::string program;
  for (const char* byte : {"80H", "81H", "82H", "8BH", "0CH", "0DH", "8DH", "0DH"}) {
    program += std::string("  MVI A,") + byte + "\n  OUT 0F0H\n  CALL WAIT\n";
  }
  program += "  HLT\nWAIT: LXI D,1000\nLOOP: DCX D\n  MOV A,D\n  ORA E\n  JNZ LOOP\n  RET\n";  // 8 ms
  const Left left =
      run_of(program).set("--set", "SP=1000").set("--plotter", "minigraf").set("--svg", "drawing").go();
  const std::vector<picture::PenPath> paths{{{{0, 0}, {2, 0}, {3, 1}}}, {{{5, 1}}}};
  const std::string expected = picture::pen_svg(
      paths, picture::minigraf_paper, "8080: plotter at T-state " + std::to_string(left.number("t_states")));
  const machines::Bytes svg = left.machine->output("--svg");
  EXPECT_EQ(std::string(svg.begin(), svg.end()), expected);
  EXPECT_TRUE(left.machine->warnings().empty());
}

// A program for CP/M without CP/M: its call of 5 runs through the empty bytes up to 0100.
TEST(RunI8080, WarnsOnceOfMemoryThatIsEmpty) {
  const auto warnings = [](bool cpm) {
    MachineRun setup = run_of("BEGIN: MVI C,2\n  MVI E,2AH\n  CALL 5\n  JMP BEGIN\n");
    if (cpm) setup.set("--cpm").set("--console-out");
    auto ready = setup.prepared();
    if (!ready) return std::vector<std::string>{ready.error().message()};
    std::vector<std::string> texts;
    for (int slice = 0; slice < 2; ++slice) {
      EXPECT_FALSE(ready->machine->run({}, true).has_value());
      for (const std::string& text : ready->machine->take_early_warnings()) texts.push_back(text.substr(text.find(':')));
    }
    return texts;
  };
  EXPECT_EQ(warnings(false), std::vector<std::string>{": executes memory that is empty: nothing was loaded there; --cpm gives a CP/M program "
                                                      "its system"});
  EXPECT_EQ(warnings(true), std::vector<std::string>{});
}

TEST(RunI8080, Dump) {
  const Left left = run_of("  HLT\n")
                        .set("--set", "SP=FEDC")
                        .set("--set", "B=1")
                        .set("--set", "C=2")
                        .set("--set", "INTE=1")
                        .go();
  EXPECT_TRUE(left.dump.starts_with("00 02 01 02 00 00 00 00 FEDC 0101 1\n00 00 "))
      << left.dump.substr(0, 60);
  EXPECT_EQ(std::count(left.dump.begin(), left.dump.end(), '\n'), 1 + 4096);
  const std::string line_of_zeros = "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00\n";
  EXPECT_EQ(left.dump.size(), 36 + 4096 * line_of_zeros.size());
  EXPECT_EQ(left.dump.substr(36 + 16 * line_of_zeros.size(), 6), "76 00 ");
}

}  // namespace
}  // namespace sightline::test
