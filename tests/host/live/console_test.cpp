// The live console: the codes of keys, when keys from a pipe are typed, scripts, and the end of a session.
//
// Users' scripts rely on the codes of the modes: ascii has 7 bits, parity has bit 200, unix has RETURN as 212, LINE FEED as 215
// and
// ESCAPE as 375, upper has capitals.
#include "host/live/console.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <deque>
#include <string>
#include <vector>

#include "tests/host/machines/machine_run.hpp"
#include "tests/support/effort.hpp"
#include "tools/asm/i8080.hpp"
#include "tools/asm/pdp7.hpp"
#include "tools/image/intel_hex.hpp"
#include "tools/image/octal.hpp"

namespace sightline::test {
namespace {

using live::KeyCodes;

// --- Codes ---

TEST(KeyCodes, EveryKeyInEveryMode) {
  for (int key = 0; key < 128; ++key) {
    const char c = static_cast<char>(key);
    EXPECT_EQ(live::code_of_key(KeyCodes::ascii, c), key);
    EXPECT_EQ(live::code_of_key(KeyCodes::parity, c), key + 0200);
    const int unix = key == '\r' ? 0212 : key == '\n' ? 0215 : key == 27 ? 0375 : key + 0200;
    EXPECT_EQ(live::code_of_key(KeyCodes::unix, c), unix);
    const int upper = key >= 'a' && key <= 'z' ? key - 'a' + 'A' + 0200 : key + 0200;
    EXPECT_EQ(live::code_of_key(KeyCodes::upper, c), upper);
  }
}

TEST(KeyCodes, PrintedCodesAreTruncatedToSevenBits) {
  EXPECT_EQ(live::shown_text("\310\351\215\212"), "Hi\r\n");
  EXPECT_EQ(live::shown_text(std::string_view("\0a\200b\177\377", 6)), "ab");
}

TEST(PlainText, EscapesStandForTheirCharacters) {
  const auto text = live::plain_text("--send", "a\\r\\n\\t\\e\\\\\\101\\x7ez");
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "a\r\n\t\033\\A~z");
  for (const char* wrong : {"\\", "\\q", "\\8", "\\77", "\\777", "\\x", "\\x1", "\\xzz", "\\1 2"})
    EXPECT_FALSE(live::plain_text("--send", wrong)) << wrong;
}

// --- Sessions ---

// Types what the test gives and records what is printed. Then: the end of the input, or nobody at the terminal.
class Typist final : public live::Operator {
 public:
  explicit Typist(std::string keys, bool terminal = false) : terminal_(terminal) {
    for (const char key : keys) keys_.push_back(key);
  }
  std::optional<std::string> keys(int milliseconds) override {
    most_waited = std::max(most_waited, milliseconds);
    if (keys_.empty()) return terminal_ ? std::optional(std::string("\005")) : std::nullopt;
    const std::string key(1, keys_.front());
    keys_.pop_front();
    return key;
  }
  bool print(std::string_view text) override {
    printed += text;
    return true;
  }
  bool at_terminal() const override { return terminal_; }

  std::string printed;
  int most_waited = 0;

 private:
  std::deque<char> keys_;
  bool terminal_;
};

struct Ended {
  machines::Stop stop;
  std::string printed;
  std::unique_ptr<machines::Machine> machine;
};

Ended session(const MachineRun& of, Typist typist, const live::ConsoleOptions& options) {
  auto ready = of.prepared();
  EXPECT_TRUE(ready.has_value()) << of.refusal();
  if (!ready) return {};
  Ended done;
  done.stop = live::run_console(*ready->machine, ready->limits, options, typist);
  done.printed = typist.printed;
  done.machine = std::move(ready->machine);
  return done;
}

MachineRun pdp7_run(const std::string& source) {
  const std::vector<assembler::SourceFile> sources{{"test.s", "100/\n" + source}};
  const auto assembly = assembler::assemble_pdp7(sources, {});
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
  return MachineRun(machines::pdp7())
      .set_file("--load", "test.oct", image::write_octal(assembly.image))
      .set("--start", "100")
      .set("--max-time", "300");
}

// Prints * and echoes typed characters, polling all the time; ! ends.
MachineRun pdp7_echo() {
  return pdp7_run(
      "  lac (252\n  jms type\n"
      "wait, 700301\n  jmp wait\n  700312\n  jms type\n"
      "  and (177\n  sad (41\n  hlt\n  jmp wait\n"
      "type, 0\n  700406\n  700401\n  jmp .-1\n  jmp i type\n");
}

// The same with the keyboard's interrupt alone, without polling.
MachineRun pdp7_interrupts() {
  return pdp7_run(
      "  lac (jmp serve\n  dac 1\n  lac (252\n  jms type\n  700042\n  jmp .\n"
      "serve, dac save\n  700312\n  jms type\n"
      "  and (177\n  sad (41\n  hlt\n"
      "  700402\n  lac save\n  700042\n  jmp i 0\n"
      "type, 0\n  700406\n  700401\n  jmp .-1\n  700402\n  jmp i type\n"
      "save, 0\n");
}

MachineRun i8080_run(const std::string& text) {
  const std::vector<assembler::SourceFile> sources{{"test.asm", "  ORG 100H\n" + text}};
  const auto assembly = assembler::assemble_i8080(sources);
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
  return MachineRun(machines::i8080())
      .set_file("--load", "test.hex", image::write_intel_hex(assembly.image))
      .set("--start", "100")
      .set("--cpm")
      .set("--console", "ascii")
      .set("--max-states", "1000000000");
}

TEST(ConsolePipe, KeysAreTypedWhenTheProgramAsks) {
  for (const MachineRun& program : {pdp7_echo(), pdp7_interrupts()}) {
    const Ended done = session(program, Typist("Hello there\nsecond line!"), {KeyCodes::parity, {}, {}});
    EXPECT_EQ(done.stop.name, "halt");
    EXPECT_EQ(done.printed, "*Hello there\rsecond line!");
  }
}

TEST(ConsolePipe, CodesOfTheModeReachTheProgram) {
  const Ended done = session(pdp7_run("wait, 700301\n  jmp wait\n  700312\n  dac i 10\n  isz count\n  jmp wait\n  hlt\n"
                                        "count, 777774\n  10/\n  277\n"),
                               Typist("a\rZ\033"), {KeyCodes::unix, {}, {}});
  ASSERT_EQ(done.stop.name, "halt");
  EXPECT_EQ(done.machine->word(0300), 0341U);
  EXPECT_EQ(done.machine->word(0301), 0212U);
  EXPECT_EQ(done.machine->word(0302), 0332U);
  EXPECT_EQ(done.machine->word(0303), 0375U);
}

TEST(ConsolePipe, EndsWhenTheProgramWaitsForMore) {
  for (const MachineRun& program : {pdp7_echo(), pdp7_interrupts()}) {
    const Ended done = session(program, Typist("ab"), {});
    EXPECT_EQ(done.stop.name, "end_of_input");
    EXPECT_EQ(done.stop.complaint, "");
    EXPECT_EQ(done.printed, "*ab");
    EXPECT_LT(core::nanoseconds_of(done.machine->now()), 5'000'000'000);
  }
}

TEST(ConsolePipe, LineEndsOfFilesAreReturns) {
  EXPECT_EQ(session(pdp7_echo(), Typist("a\nb\r\nc\rd!"), {}).printed, "*a\rb\rc\rd!");
}

TEST(ConsolePipe, TheSameInputTakesTheSameTime) {
  const Ended a = session(pdp7_echo(), Typist("some text!"), {});
  const Ended b = session(pdp7_echo(), Typist("some text!"), {});
  EXPECT_EQ(core::nanoseconds_of(a.machine->now()), core::nanoseconds_of(b.machine->now()));
  EXPECT_EQ(a.machine->instructions(), b.machine->instructions());
}

TEST(ConsoleTerminal, KeysAreTypedAsTheyComeAndCtrlEEnds) {
  const Ended done = session(pdp7_run("  jmp .\n"), Typist("abc", true), {});
  EXPECT_EQ(done.stop.name, "operator");
  EXPECT_EQ(done.stop.complaint, "");
}

TEST(ConsoleTerminal, TheSpeedIsThatOfTheMachineTimesTheNumber) {
  Typist person("", false);
  const auto begun = std::chrono::steady_clock::now();
  const Ended done = session(pdp7_run("  jmp .\n").set("--max-time", "1"), Typist(""), {KeyCodes::ascii, 4.0, {}});
  const auto taken = std::chrono::steady_clock::now() - begun;
  EXPECT_EQ(done.stop.name, "time_limit");
  // Never early; the delay depends on the host.
  EXPECT_GE(taken, std::chrono::milliseconds(220));
}

TEST(ConsoleLimits, AreThoseOfTheRun) {
  const Ended by_time = session(pdp7_run("  jmp .\n").set("--max-time", "0.123456789"), Typist(""), {});
  EXPECT_EQ(by_time.stop.name, "time_limit");
  EXPECT_GE(core::nanoseconds_of(by_time.machine->now()), 123'456'789);
  EXPECT_LT(core::nanoseconds_of(by_time.machine->now()), 123'456'789 + 1750);
  const Ended by_count = session(pdp7_run("  jmp .\n").set("--max-instructions", "100000"), Typist(""), {});
  EXPECT_EQ(by_count.stop.name, "instruction_limit");
  EXPECT_EQ(by_count.machine->instructions(), 100000U);
}

// --- Scripts ---

live::Step expect(std::string text) {
  return {live::Step::Kind::expect, std::move(text)};
}
live::Step send(std::string text) {
  return {live::Step::Kind::send, std::move(text)};
}
live::ConsoleOptions script(std::vector<live::Step> steps) {
  return {KeyCodes::parity, {}, std::move(steps)};
}

TEST(ConsoleScript, TypesAfterWhatItExpects) {
  const Ended done = session(pdp7_echo(), Typist("not read"), script({expect("*"), send("abc"), expect("abc"), send("!")}));
  EXPECT_EQ(done.stop.name, "halt");
  EXPECT_EQ(done.stop.complaint, "");
  EXPECT_EQ(done.printed, "*abc!");
}

TEST(ConsoleScript, EndsWithTheLastTextExpected) {
  const Ended done = session(pdp7_echo(), Typist(""), script({expect("*"), send("abc"), expect("bc")}));
  EXPECT_EQ(done.stop.name, "end_of_input");
  EXPECT_EQ(done.stop.complaint, "");
  EXPECT_EQ(done.printed, "*abc");
}

TEST(ConsoleScript, WithoutTextsToExpectTypesAtOnce) {
  EXPECT_EQ(session(pdp7_echo(), Typist(""), script({send("ab"), send("c!")})).printed, "*abc!");
}

TEST(ConsoleScript, ReportsTheTextThatWasNotPrinted) {
  NEEDS_OPTIMISED_CODE();
  const Ended waits = session(pdp7_echo(), Typist(""), script({expect("*"), send("ab"), expect("#"), send("c")}));
  EXPECT_EQ(waits.stop.complaint,
            "--expect \"#\": the program waits for a key, and the text was not printed; printed since the last match: "
            "\"ab\"");
  const Ended halts = session(pdp7_echo(), Typist(""), script({expect("*"), send("!"), expect("#")}));
  EXPECT_NE(halts.stop.complaint.find("--expect \"#\": the run ended, and the text was not printed"), std::string::npos);
  const Ended unsent = session(pdp7_echo(), Typist(""), script({expect("*"), send("!"), send("more")}));
  EXPECT_EQ(unsent.stop.complaint, "--send \"more\": the run ended before it was typed");
}

// --- CP/M ---

// Calls of BDOS as in the CP/M 2.2 Interface Guide.
TEST(CpmConsole, FunctionOneWaitsEchoesAndReturnsTheKey) {
  const Ended done = session(i8080_run("  MVI C,1\n  CALL 5\n  STA 200H\n  MOV A,L\n  STA 201H\n  MVI C,1\n  CALL 5\n"
                                         "  STA 202H\n  JMP 0\n"),
                               Typist("x\033"), {});
  EXPECT_EQ(done.stop.name, "exit");
  EXPECT_EQ(done.printed, "x");
  EXPECT_EQ(done.machine->word(0x200), 'x' + 0U);
  EXPECT_EQ(done.machine->word(0x201), 'x' + 0U);
  EXPECT_EQ(done.machine->word(0x202), 033U);
}

TEST(CpmConsole, FunctionTenReadsAnEditedLine) {
  const auto line = [](const char* keys, const char* size = "10") {
    const Ended done = session(i8080_run("  LXI D,200H\n  MVI A," + std::string(size) +
                                           "\n  STAX D\n  MVI C,10\n  CALL 5\n  JMP 0\n"),
                                 Typist(keys), {});
    EXPECT_EQ(done.stop.name, "exit") << keys;
    std::string read;
    for (std::uint32_t n = 0; n < done.machine->word(0x201); ++n)
      read.push_back(static_cast<char>(done.machine->word(0x202 + n)));
    return read;
  };
  EXPECT_EQ(line("hello\n"), "hello");
  EXPECT_EQ(line("\n"), "");
  EXPECT_EQ(line("hek\bllo\n"), "hello");
  EXPECT_EQ(line("\b\177hi\177o\n"), "ho");
  EXPECT_EQ(line("wrong\025right\n"), "right");
  EXPECT_EQ(line("wrong\030right\n"), "right");
  EXPECT_EQ(line("0123456789abc"), "0123456789");
  EXPECT_EQ(line("\003"), "");
  EXPECT_EQ(line("x", "0"), "");
}

TEST(CpmConsole, FunctionsSixAndElevenPollWithoutWaiting) {
  const Ended done = session(i8080_run("POLL: MVI C,11\n  CALL 5\n  ORA A\n  JZ POLL\n  STA 200H\n"
                                         "  MVI C,6\n  MVI E,0FEH\n  CALL 5\n  STA 201H\n"
                                         "  MVI C,6\n  MVI E,0FFH\n  CALL 5\n  STA 202H\n"
                                         "  MVI C,6\n  MVI E,0FFH\n  CALL 5\n  STA 203H\n"
                                         "  MVI C,6\n  MVI E,'!'\n  CALL 5\n  JMP 0\n"),
                               Typist("k"), {});
  EXPECT_EQ(done.stop.name, "exit");
  EXPECT_EQ(done.printed, "!");
  EXPECT_EQ(done.machine->word(0x200), 0xFFU);
  EXPECT_EQ(done.machine->word(0x201), 0xFFU);
  EXPECT_EQ(done.machine->word(0x202), 'k' + 0U);
  EXPECT_EQ(done.machine->word(0x203), 0U);
}

TEST(CpmConsole, WaitingTakesNoTime) {
  const Ended done = session(i8080_run("  MVI C,1\n  CALL 5\n  JMP 0\n"), Typist("x"), {});
  // MVI 7, CALL 17, JMP 10 to the entry, OUT 10, RET 10; JMP 10, JMP 10 to the table, JMP 10 there, OUT 10.
  EXPECT_EQ(done.machine->ticks(), 94);
}

TEST(CpmConsole, TheEndOfTheInputEndsTheRun) {
  const Ended done = session(i8080_run("LOOP: MVI C,1\n  CALL 5\n  JMP LOOP\n"), Typist("ab"), {});
  EXPECT_EQ(done.stop.name, "end_of_input");
  EXPECT_EQ(done.printed, "ab");
}

}  // namespace
}  // namespace sightline::test
