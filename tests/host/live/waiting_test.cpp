// When a program waits for a key, and when it only asks: on both machines, for pipes, scripts, terminals and the debugger.
//
// Each program is one of these kinds: it computes and polls now and then; it does nothing but poll; it is interrupted by keys;
// it waits in HLT. The expected ends follow from what the machine would do if no key ever came.
#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/live/console.hpp"
#include "host/live/debugger.hpp"
#include "host/live/idle_loop.hpp"
#include "host/live/snapshot.hpp"
#include "tests/host/machines/machine_run.hpp"
#include "tools/asm/i8080.hpp"
#include "tools/asm/pdp7.hpp"
#include "tools/image/intel_hex.hpp"
#include "tools/image/octal.hpp"

namespace sightline::test {
namespace {

using live::KeyCodes;
using live::Step;

// A pipe: each key comes after the host has asked `silence` times; then the end, or more silence.
class Pipe final : public live::Operator {
 public:
  explicit Pipe(std::string keys, int silence = 0, bool ends = true) : keys_(keys.begin(), keys.end()), silence_(silence), ends_(ends) {}
  std::optional<std::string> keys(int milliseconds) override {
    waited += milliseconds;
    if (keys_.empty()) {
      if (ends_) return std::nullopt;
      return std::string();
    }
    if (asked_++ < silence_) return std::string();
    asked_ = 0;
    const std::string key(1, keys_.front());
    keys_.pop_front();
    return key;
  }
  bool print(std::string_view text) override {
    printed += text;
    return true;
  }

  std::string printed;
  int waited = 0;  // ms of host time that a pipe of the system would have taken

 private:
  std::deque<char> keys_;
  int silence_;
  bool ends_;
  int asked_ = 0;
};

struct Ended {
  std::string why;
  std::string complaint;
  std::string printed;
  int waited = 0;
  std::unique_ptr<machines::Machine> machine;

  [[nodiscard]] double seconds() const {
    return static_cast<double>(machine->ticks()) / static_cast<double>(machine->ticks_per_second());
  }
};

Ended session(const MachineRun& of, Pipe pipe, const live::ConsoleOptions& options = {}) {
  auto ready = of.prepared();
  EXPECT_TRUE(ready.has_value()) << of.refusal();
  if (!ready) return {};
  const machines::Stop stop = live::run_console(*ready->machine, ready->limits, options, pipe);
  return {std::string(stop.name), stop.complaint, pipe.printed, pipe.waited, std::move(ready->machine)};
}
Ended script(const MachineRun& of, std::vector<Step> steps) {
  return session(of, Pipe(""), {KeyCodes::ascii, {}, std::move(steps)});
}
Step expect(std::string text, std::optional<double> within = {}) { return {Step::Kind::expect, std::move(text), within}; }
Step send(std::string text) { return {Step::Kind::send, std::move(text)}; }

MachineRun pdp7(const std::string& source) {
  const std::vector<assembler::SourceFile> sources{{"test.s", "100/\n" + source}};
  const auto assembly = assembler::assemble_pdp7(sources, {});
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
  return MachineRun(machines::pdp7())
      .set_file("--load", "test.oct", image::write_octal(assembly.image))
      .set("--start", "100")
      .set("--console", "ascii")
      .set("--max-time", "400");
}

MachineRun i8080(const std::string& origin, const std::string& text) {
  const std::vector<assembler::SourceFile> sources{{"test.asm", "  ORG " + origin + "H\n" + text}};
  const auto assembly = assembler::assemble_i8080(sources);
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
  return MachineRun(machines::i8080())
      .set_file("--load", "test.hex", image::write_intel_hex(assembly.image))
      .set("--start", origin)
      .set("--console", "ascii")
      .set("--max-states", "1200000000");
}
MachineRun cpm(const std::string& text) { return i8080("100", text).set("--cpm"); }
MachineRun altair(const std::string& board, const std::string& text) { return i8080("0", text).set("--terminal", board); }

// Four seconds of work in 200 rounds, with a poll in each: `poll` leaves Z set without a key.
std::string computes(const std::string& poll, const std::string& print) {
  return "  MVI B,200\nROUND: PUSH B\n" + poll + "  JNZ STOP\n  LXI D,2500\nWORK: DCX D\n  MOV A,D\n  ORA E\n  JNZ WORK\n  POP B\n"
         "  DCR B\n  JNZ ROUND\n" + print + "STOP: ";
}
const std::string print_of_bdos = "  LXI D,TEXT\n  MVI C,9\n  CALL 5\n";
const std::string end_of_bdos = "RST 0\nTEXT: DB 'done$'\n";
const std::string bios_call = "  LHLD 1\n  INX H\n  INX H\n  INX H\n  LXI D,BACK\n  PUSH D\n  PCHL\nBACK: ORA A\n";

// --- Programs that ask while they compute ---

struct Computing {
  std::string name;
  MachineRun run;
  std::string end;
  std::string printed;
};

std::vector<Computing> computing_programs() {
  std::vector<Computing> all;
  const auto of_bdos = [&](const std::string& name, const std::string& poll) {
    all.push_back({name, cpm(computes(poll, print_of_bdos) + end_of_bdos), "exit", "done"});
  };
  of_bdos("function 11", "  MVI C,11\n  CALL 5\n  ORA A\n");
  of_bdos("function 6", "  MVI C,6\n  MVI E,0FFH\n  CALL 5\n  ORA A\n");
  of_bdos("CONST", bios_call);
  all.push_back({"2sio", altair("2sio", "  LXI SP,1000H\n" + computes("  IN 10H\n  ANI 1\n", "  MVI A,'d'\n  OUT 11H\n") + "HLT\n"), "halt", "d"});
  all.push_back({"sio", altair("sio", "  LXI SP,1000H\n" + computes("  IN 0\n  XRI 1\n  ANI 1\n", "  MVI A,'d'\n  OUT 1\n") + "HLT\n"), "halt", "d"});
  all.push_back({"ksf", pdp7("begin, lam -143\n dac n\nround, ksf\n skp\n jmp done\n law 10000\n dac m\nwork, lac m\n tad (-1+1\n isz m\n"
                             " jmp work\n isz n\n jmp round\ndone, lac (304\n tls\n tsf\n jmp .-1\n hlt\nn, 0\nm, 0\n"),
                 "halt", "D"});
  return all;
}

TEST(Waiting, APollWhileComputingEndsNoRun) {
  for (const Computing& each : computing_programs()) {
    const Ended ended = session(each.run, Pipe(""));
    EXPECT_EQ(ended.why, each.end) << each.name;
    EXPECT_EQ(ended.printed, each.printed) << each.name;
    EXPECT_GT(ended.seconds(), 3) << each.name;
    // The same without a console at all, to the tick.
    const Ended scripted = script(each.run, {expect(each.printed), send("")});
    EXPECT_EQ(scripted.why, each.end) << each.name;
    EXPECT_EQ(scripted.machine->ticks(), ended.machine->ticks()) << each.name;
  }
}

// A pipe that stays open and silent holds a program that computes for a second of host time, once.
TEST(Waiting, ASilentPipeHoldsNoProgramThatComputes) {
  for (const Computing& each : computing_programs()) {
    const Ended silent = session(each.run, Pipe("", 0, false));
    EXPECT_EQ(silent.why, each.end) << each.name;
    EXPECT_EQ(silent.printed, each.printed) << each.name;
    EXPECT_LE(silent.waited, 1400) << each.name;
  }
}

TEST(Waiting, AKeyInThePipeStopsIt) {
  for (const Computing& each : computing_programs()) {
    const Ended ended = session(each.run, Pipe("x"));
    EXPECT_EQ(ended.why, each.end) << each.name;
    EXPECT_LT(ended.seconds(), 1) << each.name;
    EXPECT_EQ(ended.printed, each.name == "ksf" ? "D" : "") << each.name;
  }
}

// --- Programs that only poll ---

struct Polling {
  std::string name;
  MachineRun run;
};

std::vector<Polling> polling_programs() {
  const std::string pause = "  LXI H,2000\nPAUSE: DCX H\n  MOV A,H\n  ORA L\n  JNZ PAUSE\n";
  std::vector<Polling> all;
  all.push_back({"function 11", cpm("LOOP: MVI C,11\n  CALL 5\n  ORA A\n  JZ LOOP\n  RST 0\n")});
  all.push_back({"function 6", cpm("LOOP: MVI C,6\n  MVI E,0FFH\n  CALL 5\n  ORA A\n  JZ LOOP\n  RST 0\n")});
  all.push_back({"CONST", cpm("LOOP:\n" + bios_call + "  JZ LOOP\n  RST 0\n")});
  all.push_back({"function 11 with a pause", cpm("LOOP: MVI C,11\n  CALL 5\n  ORA A\n  RNZ\n" + pause + "  JMP LOOP\n")});
  all.push_back({"two functions", cpm("LOOP: MVI C,11\n  CALL 5\n  MVI C,6\n  MVI E,0FFH\n  CALL 5\n  ORA A\n  JZ LOOP\n  RST 0\n")});
  all.push_back({"2sio", altair("2sio", "LOOP: IN 10H\n  ANI 1\n  JZ LOOP\n  HLT\n")});
  all.push_back({"2sio with a pause", altair("2sio", "LOOP: IN 10H\n  ANI 1\n  JNZ STOP\n" + pause + "  JMP LOOP\nSTOP: HLT\n")});
  all.push_back({"sio", altair("sio", "LOOP: IN 0\n  ANI 1\n  JNZ LOOP\n  HLT\n")});
  // It counts to eight again and again: eight different states.
  all.push_back({"2sio with a counter", altair("2sio", "LOOP: LDA 80H\n  INR A\n  ANI 7\n  STA 80H\n  IN 10H\n  ANI 1\n  JZ LOOP\n  HLT\n")});
  all.push_back({"ksf", pdp7("wait, ksf\n jmp wait\n hlt\n")});
  all.push_back({"ksf with a pause", pdp7("wait, ksf\n skp\n hlt\n law 10000\n dac m\nwork, isz m\n jmp work\n jmp wait\nm, 0\n")});
  return all;
}

TEST(Waiting, AnIdleLoopEndsTheRunAfterTheInput) {
  for (const Polling& each : polling_programs()) {
    const Ended ended = session(each.run, Pipe(""));
    EXPECT_EQ(ended.why, "end_of_input") << each.name;
    EXPECT_EQ(ended.complaint, "") << each.name;
    EXPECT_LT(ended.seconds(), 4) << each.name;
    const Ended scripted = script(each.run, {expect("never")});
    EXPECT_EQ(scripted.why, "end_of_input") << each.name;
    EXPECT_NE(scripted.complaint.find("--expect \"never\": the program waits for a key, and the text was not printed"), std::string::npos)
        << each.name << scripted.complaint;
    EXPECT_LT(scripted.seconds(), 4) << each.name;
  }
}

// Emulated time stands still while the pipe is silent: it does not tell when the key came.
TEST(Waiting, AnIdleLoopTakesTheSameTimeForASlowPipe) {
  for (const Polling& each : polling_programs()) {
    const bool pauses = each.name.find("pause") != std::string::npos;
    const Ended at_once = session(each.run, Pipe("x"));
    const Ended later = session(each.run, Pipe("x", 100));
    EXPECT_TRUE(at_once.why == "halt" || at_once.why == "exit") << each.name << at_once.why;
    if (pauses) continue;  // they compute until they have polled twice
    EXPECT_EQ(at_once.machine->ticks(), later.machine->ticks()) << each.name;
    EXPECT_GT(later.waited, 10'000) << each.name;
  }
}

// The debugger stops them, too, at once or when `run` has been told a goal for which it does not matter.
TEST(Waiting, TheDebuggerStopsAtAnIdleLoop) {
  for (Polling& each : polling_programs()) {
    auto ready = each.run.monitored().prepared();
    ASSERT_TRUE(ready.has_value()) << each.run.refusal();
    const auto& description = each.name.starts_with("ksf") ? machines::pdp7() : machines::i8080();
    live::RunHost host;
    host.run = [](machines::Machine& machine, const machines::Limits& limits, const auto&) {
      std::optional<machines::Stop> stop;
      while (!stop) {
        stop = machine.run(limits, true);
        if (!stop && machine.waits_for_key()) stop = machines::Stop{live::end_of_input, {}};
      }
      return *stop;
    };
    host.interrupted = [] { return false; };
    host.print = [](std::string_view) {};
    live::Debugger debugger(description, *ready->machine, ready->limits, live::Symbols(description.radix), host);
    const live::Halted halted = debugger.run({});
    EXPECT_EQ(halted.stop.name, live::end_of_input) << each.name;
    EXPECT_EQ(halted.stop.complaint, live::no_key) << each.name;
    const std::int64_t then = ready->machine->ticks();
    const std::int64_t second = ready->machine->ticks_per_second();
    EXPECT_LT(then, 20 * second) << each.name;
    EXPECT_EQ(debugger.run({.until = then + 2 * second}).why, live::Halted::Why::goal) << each.name;
    debugger.send("x");
    const std::string_view why = debugger.run({}).stop.name;
    EXPECT_TRUE(why == "halt" || why == "exit") << each.name << why;
  }
}

// Counts in registers or memory: never the same state, so it may do something one day, and here it does.
TEST(Waiting, ACounterIsNoIdleLoop) {
  const Ended ended = session(cpm("  LXI H,0\nLOOP: PUSH H\n  MVI C,11\n  CALL 5\n  POP H\n  ORA A\n  JNZ STOP\n  INX H\n  MOV A,H\n  CPI 0C0H\n"
                                  "  JNZ LOOP\n" + print_of_bdos + "STOP: " + end_of_bdos),
                              Pipe(""));
  EXPECT_EQ(ended.why, "exit");
  EXPECT_EQ(ended.printed, "done");
}

// --- What is still to come from outside ---

// The clock counts in an idle loop, 50 times a second; after 120 ticks it interrupts, and the program prints and halts.
const std::string clock_program =
    "begin, lac (jmp tick\n dac 1\n lac (-170\n dac 7\n 700044\n 700042\nwait, ksf\n jmp wait\n hlt\n"
    "tick, 700004\n lac (304\n tls\n tsf\n jmp .-1\n hlt\n";

TEST(Waiting, AClockThatRunsIsWaitedFor) {
  const Ended ended = session(pdp7(clock_program), Pipe(""));
  EXPECT_EQ(ended.why, "halt");
  EXPECT_EQ(ended.printed, "D");
  EXPECT_NEAR(ended.seconds(), 2.5, 0.05);
  const Ended scripted = script(pdp7(clock_program), {expect("D"), send("")});
  EXPECT_EQ(scripted.why, "halt") << scripted.complaint;
}

// The clock runs and nothing else happens: the run ends after a minute of it.
TEST(Waiting, AClockIsNotWaitedForForEver) {
  const Ended ended = session(pdp7("begin, 700044\nwait, ksf\n jmp wait\n hlt\n"), Pipe(""));
  EXPECT_EQ(ended.why, "end_of_input");
  EXPECT_NEAR(ended.seconds(), 61, 3);
}

// An interrupt of the clock each second counts to a hundred: a minute of it is not a minute of waiting.
TEST(Waiting, AProgramThatCountsByInterruptsIsWaitedFor) {
  const Ended ended = session(pdp7("begin, lac (jmp tick\n dac 1\n lac (-62\n dac 7\n 700044\n 700042\nwait, ksf\n jmp wait\n hlt\n"
                                   "tick, 700004\n lac (-62\n dac 7\n isz count\n jmp back\n lac (304\n tls\n tsf\n jmp .-1\n hlt\n"
                                   "back, 700044\n 700042\n jmp i 0\ncount, -144\n"),
                              Pipe(""));
  EXPECT_EQ(ended.why, "halt");
  EXPECT_EQ(ended.printed, "D");
  EXPECT_GT(ended.seconds(), 100);  // the clock begins anew at each interrupt
}

// The switches move after three seconds; the loop reads them.
TEST(Waiting, AScriptOfSwitchesIsWaitedFor) {
  const Ended ended = session(pdp7("wait, ksf\n skp\n hlt\n las\n sna\n jmp wait\n lac (304\n tls\n tsf\n jmp .-1\n hlt\n")
                                  .set_file("--switches", "moves", "3 1\n"),
                              Pipe(""));
  EXPECT_EQ(ended.why, "halt");
  EXPECT_EQ(ended.printed, "D");
}

// The board erases for 33 ms, and the loop polls it, too: until then its states are all the same.
TEST(Waiting, ABoardThatIsBusyIsWaitedFor) {
  const std::string text = "  OUT 33H\nLOOP: IN 10H\n  ANI 1\n  JNZ STOP\n  IN 30H\n  ANI 80H\n  JZ LOOP\n  MVI A,'r'\n  OUT 11H\nSTOP: HLT\n";
  const Ended ended = session(altair("2sio", text).set("--board", "alt256"), Pipe(""));
  EXPECT_EQ(ended.why, "halt");
  EXPECT_EQ(ended.printed, "r");
}

// --- Interrupts of the console ---

const std::string halts_for_keys =
    "  LXI SP,1000H\n  MVI A,3\n  OUT 10H\n  MVI A,95H\n  OUT 10H\nLOOP: EI\n  HLT\nAFTER: LDA COUNT\n  INR A\n  STA COUNT\n  JMP LOOP\n"
    "  ORG 38H\n  PUSH PSW\n  PUSH H\n  IN 11H\n  OUT 11H\n  LXI H,4\n  DAD SP\n  MOV A,M\n  STA LASTPC\n  INX H\n  MOV A,M\n"
    "  STA LASTPC+1\n  POP H\n  POP PSW\n  EI\n  RET\n  ORG 80H\nCOUNT: DB 0\nLASTPC: DW 0\n";
MachineRun halting() { return altair("2sio", halts_for_keys).set("--interrupt", "2sio=7"); }
MachineRun interrupted_loop() {
  return altair("2sio", "  LXI SP,100H\n  MVI A,3\n  OUT 10H\n  MVI A,95H\n  OUT 10H\n  EI\nLOOP: NOP\n  JMP LOOP\n"
                        "  ORG 38H\n  PUSH PSW\n  IN 11H\n  OUT 11H\n  POP PSW\n  EI\n  RET\n")
      .set("--interrupt", "2sio=7");
}

TEST(Waiting, AKeyInterruptsHlt) {
  for (const int silence : {0, 7}) {
    const Ended ended = session(halting(), Pipe("ABC", silence));
    EXPECT_EQ(ended.why, "end_of_input");
    EXPECT_EQ(ended.printed, "ABC");
    EXPECT_EQ(ended.machine->word(0x80), 3U);
    EXPECT_EQ(ended.machine->word(0x81), 0x0DU);  // the address after HLT
    EXPECT_EQ(ended.machine->word(0x82), 0U);
    EXPECT_TRUE(ended.machine->halted());
  }
  const Ended scripted = script(halting(), {send("AB"), expect("AB"), send("C"), expect("C")});
  EXPECT_EQ(scripted.complaint, "");
  EXPECT_EQ(scripted.printed, "ABC");
  const Ended in_vain = script(halting(), {send("A"), expect("X")});
  EXPECT_NE(in_vain.complaint.find("--expect \"X\": the program waits for a key"), std::string::npos) << in_vain.complaint;
}

TEST(Waiting, OnlyWhatCanInterruptIsWaitedForInHlt) {
  // Without the wire, with the receive interrupt off, or without EI no key can end it.
  EXPECT_EQ(session(altair("2sio", halts_for_keys), Pipe("ABC")).why, "halt");
  EXPECT_EQ(session(altair("2sio", "  MVI A,15H\n  OUT 10H\n  EI\n  HLT\n").set("--interrupt", "2sio=7"), Pipe("ABC")).why, "halt");
  EXPECT_EQ(session(altair("2sio", "  MVI A,95H\n  OUT 10H\n  DI\n  HLT\n").set("--interrupt", "2sio=7"), Pipe("ABC")).why, "halt");
  // Without a console no key will ever come.
  MachineRun alone(machines::i8080());
  const std::vector<assembler::SourceFile> sources{{"test.asm", halts_for_keys}};
  alone.set_file("--load", "test.hex", image::write_intel_hex(assembler::assemble_i8080(sources).image)).set("--terminal", "2sio").set("--interrupt", "2sio=7");
  auto ready = alone.prepared();
  ASSERT_TRUE(ready.has_value());
  EXPECT_EQ(machines::run_to_stop(*ready->machine, ready->limits).name, "halt");
}

TEST(Waiting, AnEnabledReceiveInterruptAsksForKeys) {
  const Ended ended = session(interrupted_loop(), Pipe("ABC"));
  EXPECT_EQ(ended.why, "end_of_input");
  EXPECT_EQ(ended.printed, "ABC");
  EXPECT_LT(ended.seconds(), 6);
  EXPECT_EQ(script(interrupted_loop(), {send("AB"), expect("AB")}).complaint, "");
  // The same on the PDP-7, whose keyboard always interrupts.
  const Ended pdp = session(pdp7("begin, lac (jmp serve\n dac 1\n 700042\n jmp .\nserve, dac save\n 700312\n 700406\n 700401\n jmp .-1\n"
                                 " 700402\n lac save\n 700042\n jmp i 0\nsave, 0\n"),
                            Pipe("ABC"));
  EXPECT_EQ(pdp.why, "end_of_input");
  EXPECT_EQ(pdp.printed, "ABC");
}

// A program that computes with the receive interrupt on does not end after the input.
TEST(Waiting, AnInterruptedComputationRunsOn) {
  const Ended ended = session(altair("2sio", "  LXI SP,100H\n  MVI A,95H\n  OUT 10H\n  EI\n  LXI H,0\n  LXI B,0\nLOOP: INX H\n  MOV A,H\n  ORA L\n"
                                             "  JNZ LOOP\n  INR B\n  MVI A,20\n  CMP B\n  JNZ LOOP\n  MVI A,'d'\n  OUT 11H\n  DI\n  HLT\n"
                                             "  ORG 38H\n  IN 11H\n  EI\n  RET\n")
                                  .set("--interrupt", "2sio=7"),
                              Pipe(""));
  EXPECT_EQ(ended.why, "halt");
  EXPECT_EQ(ended.printed, "d");
  EXPECT_GT(ended.seconds(), 10);
}

// A snapshot in the HLT continues there, and a key ends it.
TEST(Waiting, ASnapshotKeepsTheHalt) {
  const Ended first = session(halting(), Pipe("A"));
  const auto snapshot = live::save_snapshot("i8080", *first.machine);
  auto again = halting().prepared();
  ASSERT_TRUE(again.has_value());
  ASSERT_TRUE(live::restore_snapshot("i8080", *again->machine, snapshot, "snapshot").has_value());
  Pipe pipe("BC");
  const machines::Stop stop = live::run_console(*again->machine, again->limits, {}, pipe);
  EXPECT_EQ(stop.name, "end_of_input");
  EXPECT_EQ(pipe.printed, "BC");
  const Ended whole = session(halting(), Pipe("ABC"));
  EXPECT_EQ(again->machine->ticks(), whole.machine->ticks());
  EXPECT_EQ(again->machine->instructions(), whole.machine->instructions());
}

// --- A HALT can be left ---

// HLT at 0; 10: 55 in A; HLT; 66 in A; HLT.
MachineRun halts() { return i8080("0", "  HLT\n  ORG 10H\n  MVI A,55H\n  HLT\n  MVI A,66H\n  HLT\n").set("--terminal", "2sio"); }

TEST(Waiting, ANewPcLeavesAHalt) {
  auto ready = halts().prepared();
  ASSERT_TRUE(ready.has_value());
  machines::Machine& machine = *ready->machine;
  constexpr std::size_t a = 0, pc = 9, inte = 10;
  const auto run = [&] { return std::string(machine.run(ready->limits, false)->name); };
  EXPECT_EQ(run(), "halt");
  EXPECT_EQ(run(), "halt");
  EXPECT_EQ(machine.instructions(), 1U);
  machine.start(0x10);
  EXPECT_EQ(run(), "halt");
  EXPECT_EQ(machine.get(a), 0x55U);
  machine.set(pc, 0x13);
  EXPECT_EQ(run(), "halt");
  EXPECT_EQ(machine.get(a), 0x66U);
  EXPECT_EQ(machine.instructions(), 5U);
  EXPECT_EQ(machine.ticks(), 7 + 7 + 7 + 7 + 7);
  machine.set(inte, 1);
  machine.reset();
  EXPECT_FALSE(machine.halted());
  EXPECT_EQ(machine.get(pc), 0U);
  EXPECT_EQ(machine.get(inte), 0U);
  EXPECT_EQ(machine.get(a), 0x66U);
}

// --- Scripts ---

TEST(Waiting, AnExpectHasItsOwnLimit) {
  const std::string counter = "wait, isz 20\n nop\n ksf\n jmp wait\n hlt\n";
  const Ended ended = script(pdp7(counter), {expect("x", 2.5)});
  EXPECT_EQ(ended.why, "end_of_input");
  EXPECT_EQ(ended.complaint, "--expect \"x\": --within 2.5 is over, and the text was not printed; printed since the last match: \"\"");
  EXPECT_NEAR(ended.seconds(), 2.5, 0.05);
  // It counts from the text or the keys before it.
  const Ended echo = script(pdp7("wait, ksf\n jmp wait\n 700312\n 700406\n 700401\n jmp .-1\n jmp wait\n"),
                            {send("abcdefgh"), expect("h", 0.5), send("i"), expect("i", 0.5)});
  EXPECT_EQ(echo.complaint, "");
  EXPECT_EQ(echo.printed, "abcdefghi");
}

TEST(Waiting, AnEmptyTextIsAText) {
  const std::string echo = "wait, ksf\n jmp wait\n 700312\n 700406\n 700401\n jmp .-1\n jmp wait\n";
  const Ended ended = script(pdp7(echo), {expect(""), send(""), send("a"), expect(""), expect("a"), send("")});
  EXPECT_EQ(ended.why, "end_of_input");
  EXPECT_EQ(ended.complaint, "");
  EXPECT_EQ(ended.printed, "a");
  const Ended nothing = script(pdp7(echo), {expect("")});
  EXPECT_EQ(nothing.complaint, "");
  EXPECT_LT(nothing.seconds(), 0.1);
}

}  // namespace
}  // namespace sightline::test
