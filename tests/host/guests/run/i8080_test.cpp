// One run of an 8080 program: the entries of CP/M and what they cost, the texts of trace, bus and dump,
// interrupts through the ports, and that being asked in between changes nothing.
//
// Expected T-states are sums over opcode-timing.csv, written out beside each program; the stub's OUT and RET
// take 10 each.
#include "host/guests/run/i8080.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tools/asm/i8080.hpp"

namespace sightline::harness {
namespace {

image::ByteImage assembled(const std::string& text) {
  const std::vector<assembler::SourceFile> sources{{"test.asm", text}};
  const auto assembly = assembler::assemble_i8080(sources);
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
  return assembly.image;
}

// Without limits a wrong machine might not stop.
I8080Job job_of(const std::string& text) {
  I8080Job job;
  job.memory = assembled("  ORG 100H\n" + text);
  job.registers.pc = 0x100;
  job.limits.instructions = 100'000'000;
  return job;
}

class CpmRun : public ::testing::Test {
 protected:
  I8080Report run(const std::string& text) {
    I8080Job job = job_of(text);
    job.cpm = true;
    job.console = [this](std::string_view printed) { console_ += printed; };
    return run_i8080(job);
  }
  std::string console_;
};

constexpr const char* hello =
    "  MVI C,9\n"     // 7
    "  LXI D,TEXT\n"  // 10
    "  CALL 5\n"      // 17, and 20 for the stub
    "  JMP 0\n"       // 10, and 10 for the end
    "TEXT: DB 'Hello, world',13,10,'$'\n";

TEST_F(CpmRun, PrintsAString) {
  const I8080Report report = run(hello);
  EXPECT_EQ(report.stop, I8080Stop::exit);
  EXPECT_EQ(console_, "Hello, world\r\n");
  EXPECT_EQ(core::t_states_of(report.end), 7 + 10 + 17 + 20 + 10 + 10);
  EXPECT_EQ(report.instructions, 7U);
  EXPECT_EQ(report.registers.pc, 0x0002);
  EXPECT_EQ(report.registers.sp, 0x0000);
  EXPECT_TRUE(report.unanswered.empty());
}

TEST_F(CpmRun, PrintsCharactersAndReturnsAtTheTopLevel) {
  const I8080Report report =
      run("  MVI B,3\n"      // 7
          "  MVI E,'A'\n"    // 7
          "LOOP: MVI C,2\n"  // 7
          "  PUSH B\n"       // 11
          "  CALL 5\n"       // 17, and 20
          "  POP B\n"        // 10
          "  INR E\n"        // 5
          "  DCR B\n"        // 5
          "  JNZ LOOP\n"     // 10 taken or not
          "  RET\n");        // 10, and 10 for the end
  EXPECT_EQ(report.stop, I8080Stop::exit);
  EXPECT_EQ(console_, "ABC");
  EXPECT_EQ(core::t_states_of(report.end), 14 + 3 * (7 + 11 + 37 + 10 + 5 + 5 + 10) + 20);
  EXPECT_EQ(report.instructions, 2U + 3 * 9 + 2);
  EXPECT_EQ(report.registers.sp, 0x0002);
}

TEST_F(CpmRun, FunctionZeroEndsLikeAJumpToZero) {
  const I8080Report report = run("  MVI C,0\n  CALL 5\n  HLT\n");  // 7, 17, OUT 1, OUT 0
  EXPECT_EQ(report.stop, I8080Stop::exit);
  EXPECT_EQ(core::t_states_of(report.end), 7 + 17 + 10 + 10);
}

TEST_F(CpmRun, UnknownFunctionsNameTheirCaller) {
  const I8080Report called = run("  MVI C,15\n  CALL 5\n  JMP 0\n");
  EXPECT_EQ(called.stop, I8080Stop::unknown_bdos);
  EXPECT_EQ(called.bdos_function, 15);
  EXPECT_EQ(called.bdos_caller, 0x0102);
  EXPECT_EQ(core::t_states_of(called.end), 7 + 17 + 10);
  const I8080Report jumped = run("  LXI SP,300H\n  MVI C,1\n  JMP 5\n");
  EXPECT_EQ(jumped.stop, I8080Stop::unknown_bdos);
  EXPECT_EQ(jumped.bdos_caller, 0x0005);
  EXPECT_EQ(console_, "");
}

TEST_F(CpmRun, AStringWithoutEndIsAnError) {
  const I8080Report report = run("  MVI C,9\n  LXI D,200H\n  CALL 5\n  JMP 0\n");
  EXPECT_EQ(report.stop, I8080Stop::endless_string);
  EXPECT_EQ(report.bdos_caller, 0x0105);
  EXPECT_EQ(console_, "");
}

TEST_F(CpmRun, AStringWrapsAtTheEndOfMemory) {
  run("  LXI SP,300H\n  LXI H,'A'*256+'B'\n  SHLD 0FFFEH\n  MVI C,9\n  LXI D,0FFFEH\n  MVI A,'$'\n  STA "
      "0002H\n  CALL 5\n  JMP 0\n");
  EXPECT_EQ(console_, std::string("BA\xD3\0", 4));
}

// The loop of a call each 46 T-states never lasts as long as one slice.
TEST_F(CpmRun, AProgramThatPrintsAllTheTimeCanBeInterrupted) {
  I8080Job job = job_of("LOOP: MVI C,2\n  CALL 5\n  JMP LOOP\n");
  job.cpm = true;
  job.limits.instructions = 1'000'000;
  job.console = [this](std::string_view printed) { console_ += printed; };
  job.keep_running = [this](const I8080Progress&) { return console_.size() < 10; };
  EXPECT_EQ(run_i8080(job).stop, I8080Stop::interrupted);
  EXPECT_EQ(console_.size(), 10U);
}

TEST_F(CpmRun, ItsOwnOutToTheStubsPortsIsAnUnansweredPort) {
  const I8080Report report = run("  OUT 0\n  OUT 1\n  OUT 1\n  IN 1\n  JMP 0\n");
  EXPECT_EQ(report.stop, I8080Stop::exit);
  EXPECT_EQ(core::t_states_of(report.end), 4 * 10 + 10 + 10);
  ASSERT_EQ(report.unanswered.size(), 2U);
  EXPECT_EQ(report.unanswered[0].port, 0);
  EXPECT_EQ(report.unanswered[0].writes, 1U);
  EXPECT_EQ(report.unanswered[1].port, 1);
  EXPECT_EQ(report.unanswered[1].writes, 2U);
  EXPECT_EQ(report.unanswered[1].reads, 1U);
}

TEST(RunI8080, StrictStopsAtAPortThatNothingAnswers) {
  for (const char* program :
       {"  NOP\n  IN 20H\n  HLT\n", "  NOP\n  OUT 20H\n  HLT\n", "  NOP\n  OUT 1\n  HLT\n"}) {
    I8080Job job = job_of(program);
    EXPECT_EQ(run_i8080(job).stop, I8080Stop::halt);
    job.strict = true;
    job.cpm = true;
    const I8080Report report = run_i8080(job);
    EXPECT_EQ(report.stop, I8080Stop::unanswered) << program;
    EXPECT_EQ(report.registers.pc, 0x0103) << program;
    EXPECT_EQ(core::t_states_of(report.end), 14) << program;
  }
}

TEST(RunI8080, Limits) {
  I8080Job job = job_of("LOOP: JMP LOOP\n");
  job.limits.instructions = 7;
  I8080Report report = run_i8080(job);
  EXPECT_EQ(report.stop, I8080Stop::instruction_limit);
  EXPECT_EQ(core::t_states_of(report.end), 70);
  job.limits = {};
  job.limits.until = core::at_t_state(71);
  report = run_i8080(job);
  EXPECT_EQ(report.stop, I8080Stop::state_limit);
  EXPECT_EQ(core::t_states_of(report.end), 80);
  job.limits.until = core::at_t_state(0);
  EXPECT_EQ(run_i8080(job).instructions, 0U);
}

TEST(RunI8080, BeingAskedInBetweenChangesNothing) {
  // 22 x 65536 x (5 + 5 + 4 + 10), more than one slice
  I8080Job job = job_of(
      "  MVI B,22\nOUTER: LXI D,0\nINNER: DCX D\n  MOV A,D\n  ORA E\n  JNZ INNER\n  DCR B\n  JNZ OUTER\n  "
      "HLT\n");
  const I8080Report alone = run_i8080(job);
  EXPECT_EQ(core::t_states_of(alone.end), 7 + 22LL * (10 + 65536 * 24 + 5 + 10) + 7);
  int asked = 0;
  job.keep_running = [&asked](const I8080Progress&) { return ++asked < 1000; };
  const I8080Report watched = run_i8080(job);
  EXPECT_GE(asked, 1);
  EXPECT_EQ(watched.stop, I8080Stop::halt);
  EXPECT_EQ(watched.registers, alone.registers);
  EXPECT_EQ(watched.end, alone.end);
  EXPECT_EQ(watched.instructions, alone.instructions);
  job.keep_running = [](const I8080Progress&) { return false; };
  EXPECT_EQ(run_i8080(job).stop, I8080Stop::interrupted);
}

TEST(RunI8080, TraceAndBusLines) {
  I8080Job job = job_of("  LXI H,1234H\n  DAD H\n  DB 08H\n  OUT 20H\n  HLT\n");
  std::string trace;
  std::string bus;
  job.trace = [&trace](std::string_view text) { trace += text; };
  job.bus = [&bus](std::string_view text) { bus += text; };
  EXPECT_EQ(core::t_states_of(run_i8080(job).end), 10 + 10 + 4 + 10 + 7);
  EXPECT_EQ(trace,
            "           0 0100 213412 LXI     H,1234H      00 02 00 00 00 00 12 34 0000 0103 0\n"
            "          10 0103 29     DAD     H            00 02 00 00 00 00 24 68 0000 0104 0\n"
            "          20 0104 08     *NOP                 00 02 00 00 00 00 24 68 0000 0105 0\n"
            "          24 0105 D320   OUT     20H          00 02 00 00 00 00 24 68 0000 0107 0\n"
            "          34 0107 76     HLT                  00 02 00 00 00 00 24 68 0000 0108 0\n");
  EXPECT_EQ(bus,
            "0 A2 0100 21\n4 82 0101 34\n7 82 0102 12\n"
            "10 A2 0103 29\n"
            "20 A2 0104 08\n"
            "24 A2 0105 D3\n28 82 0106 20\n31 10 2020 00\n"
            "34 A2 0107 76\n38 8A 0107 --\n");
}

TEST(RunI8080, AnInterruptEndsAHaltAndIsTraced) {
  // The 8255: port A strobed input, its interrupt on; the host sends one byte, whose RST 7 reads it and halts
  // for good.
  I8080Job job =
      job_of("  MVI A,0B0H\n  OUT 0E7H\n  MVI A,09H\n  OUT 0E7H\n  EI\n  HLT\n  ORG 38H\n  IN 0E4H\n  HLT\n");
  job.registers.sp = 0x200;
  job.parallel = std::vector<std::uint8_t>{0x5A};
  job.machine.parallel_restart = 7;
  std::string trace;
  std::string bus;
  job.trace = [&trace](std::string_view text) { trace += text; };
  job.bus = [&bus](std::string_view text) { bus += text; };
  const I8080Report report = run_i8080(job);
  EXPECT_EQ(report.stop, I8080Stop::halt);
  EXPECT_EQ(report.registers.a, 0x5A);
  EXPECT_EQ(report.registers.sp, 0x1FE);
  EXPECT_NE(trace.find(" FF     INT RST     7 "), std::string::npos) << trace;
  EXPECT_NE(bus.find(" 2B "), std::string::npos) << bus;  // INTA while halted
  I8080Job deaf = job;
  deaf.machine.parallel_restart = std::nullopt;
  EXPECT_EQ(run_i8080(deaf).registers.pc, 0x010A);
}

TEST(RunI8080, WhatThePlotterDrawsIsJoinedByStep) {
  // The Minigraf: pen down at (0, 0), two steps along x, one diagonal; pen up for two steps, down for a dot.
  std::string program;
  for (const char* byte : {"80H", "81H", "82H", "8BH", "0CH", "0DH", "8DH", "0DH"}) {
    program += std::string("  MVI A,") + byte + "\n  OUT 0F0H\n  CALL WAIT\n";
  }
  program += "  HLT\nWAIT: LXI D,1000\nLOOP: DCX D\n  MOV A,D\n  ORA E\n  JNZ LOOP\n  RET\n";  // 8 ms
  I8080Job job = job_of(program);
  job.registers.sp = 0x1000;
  job.machine.minigraf0507 = true;
  job.drawing = true;
  const I8080Report report = run_i8080(job);
  ASSERT_EQ(report.drawing.size(), 2U);
  EXPECT_EQ(report.drawing[0].corners, (std::vector<picture::PenPoint>{{0, 0}, {2, 0}, {3, 1}}));
  EXPECT_EQ(report.drawing[1].corners, (std::vector<picture::PenPoint>{{5, 1}}));
  EXPECT_EQ(report.drawing_left_out, 0U);
}

TEST(RunI8080, Dump) {
  I8080Job job = job_of("  HLT\n");
  job.registers.sp = 0xFEDC;
  job.registers.bc = 0x0102;
  job.registers.interrupts_on = true;
  const std::string text = dump_text(run_i8080(job));
  EXPECT_TRUE(text.starts_with("00 02 01 02 00 00 00 00 FEDC 0101 1\n00 00 ")) << text.substr(0, 60);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 4096);
  const std::string line_of_zeros = "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00\n";
  EXPECT_EQ(text.size(), 36 + 4096 * line_of_zeros.size());
  EXPECT_EQ(text.substr(36 + 16 * line_of_zeros.size(), 6), "76 00 ");
}

}  // namespace
}  // namespace sightline::harness
