// Each command of the monitor on small programs of both machines. Expected answers follow from the program: addresses and words
// from its
// source, times from the machine's cycle of 1.75 us and the 8080's T-states.
#include "host/live/monitor/monitor.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <string>

#include "host/base/text.hpp"
#include "host/live/console.hpp"
#include "host/live/expression.hpp"
#include "host/live/snapshot.hpp"
#include "tests/host/machines/machine_run.hpp"
#include "tests/support/effort.hpp"
#include "tools/asm/i8080.hpp"
#include "tools/asm/pdp7.hpp"
#include "tools/image/intel_hex.hpp"
#include "tools/image/tape.hpp"

namespace sightline::test {
namespace {

using Kind = live::Answer::Kind;

// --- Expressions ---

live::Names names(int radix) {
  return {radix,
          [](std::string_view name) -> std::optional<std::int64_t> {
            if (name == "ac") return 5;
            if (name == "begin") return 0100;
            return std::nullopt;
          },
          [](std::int64_t address) -> std::optional<std::int64_t> {
            if (address < 0 || address > 7) return std::nullopt;
            return address * address;
          }};
}

// -999 if it was rejected.
std::int64_t value_or_none(std::string_view text, int radix) {
  const auto value = live::evaluate(text, names(radix));
  return value ? *value : -999;
}

TEST(Expression, HasTheOperatorsOfC) {
  const auto value = [](std::string_view text) { return value_or_none(text, 8); };
  EXPECT_EQ(value("10"), 8);
  EXPECT_EQ(value("10."), 10);
  EXPECT_EQ(value("0x10"), 16);
  EXPECT_EQ(value("0o10"), 8);
  EXPECT_EQ(value("1+2*3"), 7);
  EXPECT_EQ(value("(1+2)*3"), 9);
  EXPECT_EQ(value("10-3-2"), 3);
  EXPECT_EQ(value("ac==5 && begin>77"), 1);
  EXPECT_EQ(value("ac=5"), 1);
  EXPECT_EQ(value("ac!=5||0"), 0);
  EXPECT_EQ(value("1<<3|1"), 9);
  EXPECT_EQ(value("6&3^1"), 3);
  EXPECT_EQ(value("-1"), -1);
  EXPECT_EQ(value("~0"), -1);
  EXPECT_EQ(value("!0 + !7"), 1);
  EXPECT_EQ(value("[2]+[1+2]"), 13);
  EXPECT_EQ(value("[[2]]"), 16);
  EXPECT_EQ(value("7/2"), 3);
  EXPECT_EQ(value("7%4"), 3);
  EXPECT_EQ(value("1>=1"), 1);
  EXPECT_EQ(value("2<=1"), 0);
}

TEST(Expression, HexadecimalNumbersBeginWithADigit) {
  const auto value = [](std::string_view text) { return value_or_none(text, 16); };
  EXPECT_EQ(value("0FF"), 255);
  EXPECT_EQ(value("10H"), 16);
  EXPECT_EQ(value("ac"), 5);
  EXPECT_EQ(value("0ac"), 0xAC);
}

TEST(Expression, ReportsErrors) {
  const auto error = [](std::string_view text) {
    const auto value = live::evaluate(text, names(8));
    return value ? std::string("nothing") : value.error().message();
  };
  EXPECT_EQ(error("8"), "found \"8\", expected a number in octal");
  EXPECT_EQ(error("nobody"), "found \"nobody\", expected a register, a condition or a symbol; show conditions and show symbols list them");
  EXPECT_EQ(error("1+"), "found the end, expected a number or a name");
  EXPECT_EQ(error("(1"), "found the end, expected \")\"");
  EXPECT_EQ(error("1 2"), "found \"2\", expected an operator or the end");
  EXPECT_EQ(error("1/0"), "found a division by 0, expected a divisor other than 0");
  EXPECT_EQ(error("[10]"), "found address 8, expected an address in memory");
  EXPECT_NE(error(std::string(1000, '(')), "nothing");
  EXPECT_NE(error(""), "nothing");
}

// --- A session ---

class Session {
 public:
  // Nobody interrupts a run, but the patience, if there is one.
  Session(const machines::MachineDescription& description, MachineRun of, live::Symbols symbols, std::optional<std::int64_t> patience = {})
      : patience_(patience),
        prepared_([&of] {
          of.monitored();
          auto ready = of.prepared();
          EXPECT_TRUE(ready.has_value()) << of.refusal();
          return std::move(*ready);
        }()),
        monitor_(description, *prepared_.machine, prepared_.limits, std::move(symbols), host()) {}

  // Executes a line and returns the text of the answer, which must be of that kind.
  std::string operator()(std::string_view line, Kind kind = Kind::done) {
    const live::Answer answer = monitor_.execute(line);
    EXPECT_EQ(answer.kind, kind) << line << "\n" << answer.text;
    return answer.text;
  }
  machines::Machine& machine() { return *prepared_.machine; }
  live::Monitor& monitor() { return monitor_; }

  std::map<std::string, std::string> files;
  std::string printed;
  int most_slices = 1000000;  // limit of host time; then Ctrl-C is pressed

 private:
  live::MonitorHost host() {
    live::MonitorHost host = patient_host();
    host.running.nobody_interrupts = patience_.has_value();
    host.running.patience = patience_.value_or(host.running.patience);
    return host;
  }
  live::MonitorHost patient_host() {
    return {{[this](machines::Machine& machine, const machines::Limits& limits,
                   const std::function<void(std::string_view)>& heard) {
              std::optional<machines::Stop> stop;
              machines::Limits some = limits;
              if (most_slices == 0) some.instructions = std::min(limits.instructions, machine.instructions() + 5000);
              for (int slices = 0; !stop; ++slices) {
                stop = machine.run(some, true);
                if (!stop && slices == most_slices) stop = machines::Stop{machines::interrupted, {}};
                const std::string text = live::shown_text(machine.take_printed());
                printed += text;
                heard(text);
                if (!stop && machine.waits_for_key()) stop = machines::Stop{live::end_of_input, {}};
              }
              return *stop;
            },
             [this] { return most_slices == 0; },
             [this](std::string_view text) { printed += text; },
             false,
             false,
             60},
            [this](const std::string& path) -> base::Result<machines::Input> {
              const auto found = files.find(path);
              if (found == files.end()) return base::bad_input(path + ": no such file");
              return machines::Input{path, {found->second.begin(), found->second.end()}};
            },
            [this](const std::string& path, std::span<const std::uint8_t> bytes) -> base::Result<base::Done> {
              files[path] = {bytes.begin(), bytes.end()};
              return base::Done{};
            },
            [](const std::string&) -> base::Result<base::Done> { return base::usage_error("there is no console"); }};
  }

  std::optional<std::int64_t> patience_;
  machines::Prepared prepared_;
  live::Monitor monitor_;
};

std::unique_ptr<Session> pdp7_session(const std::string& source, const char* option = nullptr, std::optional<std::int64_t> patience = {}) {
  const std::vector<assembler::SourceFile> sources{{"test.s", "100/\n" + source}};
  const auto assembly = assembler::assemble_pdp7(sources, {});
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
  live::Symbols symbols(8);
  EXPECT_TRUE(symbols.add_table(assembler::write_symbols(assembly.symbols)));
  symbols.add_listing(assembler::write_listing(assembly.listing));
  const auto tape = image::write_rim(assembly.image, "test.rim");
  MachineRun of(machines::pdp7());
  of.set_file("--load", "test.rim", {reinterpret_cast<const char*>(tape->data()), tape->size()}).set("--start", "100");
  if (option != nullptr) of.set(option);
  return std::make_unique<Session>(machines::pdp7(), of, std::move(symbols), patience);
}

std::unique_ptr<Session> pdp7_program() {
  return pdp7_session(
      "begin,  lac (3\n"      // 100
      "        jms store\n"   // 101
      "        lac (5\n"      // 102
      "        jms store\n"   // 103
      "        hlt\n"         // 104
      "store,  0\n"           // 105
      "        dac place\n"   // 106
      "        jmp i store\n" // 107
      "place,  0\n"           // 110
      "        start begin\n");
}

void walk_back_and_forth(Session& s, std::string_view name);

TEST(MonitorPdp7, ExaminesAndDeposits) {
  auto m = pdp7_program();
  Session& s = *m;
  EXPECT_NE(s("examine pc").find("PC 00100\n"), std::string::npos);
  EXPECT_EQ(s("e 110"), "00110 000000  place: cal  ; place,  0\n");
  EXPECT_EQ(s("d 110 123456; e 110"), "00110 123456  place: jms i 3456  ; place,  0\n");
  EXPECT_EQ(s("d place 1 2 3; evaluate [place+2]"), "3 = 3.\n");
  EXPECT_EQ(s("d 200 \"dac place\"; ev [200]"), "40110 = 16456.\n");
  EXPECT_EQ(s("d ac 777777; e ac"), "AC 777777\n");
  EXPECT_EQ(s("ev ac"), "777777 = 262143. = -1. as a word with a sign\n");
  s("d ac 1000000", Kind::wrong);
  s("d 110 1000000", Kind::wrong);
  s("d 77777 1", Kind::wrong);
  s("d 200 \"nonsense here\"", Kind::wrong);
  s("d", Kind::wrong);
  s("e 20000", Kind::wrong);
  s("e 5-2", Kind::wrong);
  s("e 0-17777", Kind::wrong);
}

TEST(MonitorPdp7, Steps) {
  auto m = pdp7_program();
  Session& s = *m;
  // A direct LAC is two cycles of 1.75 us.
  EXPECT_EQ(s("step"), "00101 begin+1: jms 105  ; jms store  AC 000003  L 0  MQ 000000  SC 00  0.000003500 s\n");
  s("s 2");
  EXPECT_EQ(s("ev pc"), "107 = 71. = store+2\n");
  EXPECT_NE(s("s 100").find("stopped by halt"), std::string::npos);
  EXPECT_EQ(s("ev [place]"), "5 = 5.\n");
}

TEST(MonitorPdp7, NextRunsASubroutineToItsReturn) {
  auto m = pdp7_program();
  Session& s = *m;
  s("next");
  EXPECT_EQ(s("ev pc"), "101 = 65. = begin+1\n");
  EXPECT_NE(s("next").find("00102 begin+2"), std::string::npos);
  EXPECT_EQ(s("ev [place]"), "3 = 3.\n");
  EXPECT_EQ(s("show breaks"), "no breakpoints\n");
}

TEST(MonitorPdp7, BreaksBeforeAnInstruction) {
  auto m = pdp7_program();
  Session& s = *m;
  EXPECT_EQ(s("break store+1"), "breakpoint 1: store+1\n");
  EXPECT_NE(s("continue").find("breakpoint 1\n00106"), std::string::npos);
  EXPECT_EQ(s("ev ac"), "3 = 3.\n");
  EXPECT_NE(s("c").find("breakpoint 1\n00106"), std::string::npos);
  EXPECT_EQ(s("ev ac"), "5 = 5.\n");
  EXPECT_EQ(s("show breaks"), "1: store+1, passed 2 times\n");
  EXPECT_NE(s("c").find("stopped by halt\n00105"), std::string::npos);
}

TEST(MonitorPdp7, BreaksIfAndAfterACount) {
  auto m = pdp7_program();
  Session& s = *m;
  s("break 106 if ac==5");
  s("c");
  EXPECT_EQ(s("ev ac"), "5 = 5.\n");
  auto again = pdp7_program();
  (*again)("break 106 count 2");
  (*again)("c");
  EXPECT_EQ((*again)("ev ac"), "5 = 5.\n");
  s("delete 1");
  s("delete 1", Kind::wrong);
  s("break 106 if nothing", Kind::wrong);
  s("break 106 count many", Kind::wrong);
  s("break 100000", Kind::wrong);
}

TEST(MonitorPdp7, BreaksAtCountsByComparison) {
  const auto stops = [](const std::string& count) {
    auto m = pdp7_session("begin,  lac (0\n tad (1\n sad (6\n hlt\n jmp begin+1\n start begin\n");  // AC is 1 to 6 at 102
    Session& s = *m;
    s("break 102 count " + count);
    std::string found;
    for (int n = 0; n < 7 && s("continue").starts_with("breakpoint"); ++n) found += s("e ac").substr(8, 1);
    return found;
  };
  EXPECT_EQ(stops("2"), "246");
  EXPECT_EQ(stops("%2"), "246");
  EXPECT_EQ(stops(">=5"), "56");
  EXPECT_EQ(stops("> 5"), "6");
  EXPECT_EQ(stops("<3"), "12");
  EXPECT_EQ(stops("<= 2"), "12");
  EXPECT_EQ(stops("=3"), "3");
}

TEST(MonitorPdp7, BreakpointsPrintInsteadOfStopping) {
  auto m = pdp7_program();
  Session& s = *m;
  s("break store+1 log \"ac is {ac} if count; {{}} # {place}\"");
  s("break when ac==5 log \"five\"");
  EXPECT_TRUE(s("show breaks").starts_with("1: store+1 log \"ac is {ac} if count; {{}} # {place}\", passed 0 times\n"));
  EXPECT_EQ(s("continue").substr(0, 16), "stopped by halt\n");
  EXPECT_EQ(s.printed, "ac is 000003 if count; {} # 000110\nfive\nac is 000005 if count; {} # 000110\n");
  auto other = pdp7_program();
  (*other)("watch place log \"{[place]} {1<<18.} {-1}\" if ac==5");
  (*other)("continue");
  EXPECT_EQ(other->printed, "000005 262144. -1.\n");
}

TEST(MonitorPdp7, WatchesMemory) {
  auto m = pdp7_program();
  Session& s = *m;
  s("watch place");
  EXPECT_NE(s("c").find("breakpoint 1: 00110 place written with 000003\n00107"), std::string::npos);
  s("del; watch place value 5");
  EXPECT_NE(s("c").find("written with 000005\n00107"), std::string::npos);
  auto reading = pdp7_program();
  (*reading)("watch 105 r");
  EXPECT_NE((*reading)("c").find("00105 store read, it is 000102"), std::string::npos);
  s("watch 5 x", Kind::wrong);
  s("watch", Kind::wrong);
}

TEST(MonitorPdp7, FindsTheWriterOfAWord) {
  auto m = pdp7_program();
  Session& s = *m;
  EXPECT_EQ(s("who place"), "00110: nothing has written there since the monitor began\n");
  s("c");
  // LAC 2, JMS 2, DAC 2, JMP I 2, LAC 2, JMS 2 cycles; the DAC writes in its second cycle.
  EXPECT_EQ(s("who place"), "00110: 000005 was written at 0.000022750 s by 00106 store+1: dac 110  ; dac place\n");
}

TEST(MonitorPdp7, HistoryShowsOperands) {
  auto m = pdp7_program();
  Session& s = *m;
  EXPECT_EQ(s("history"), "no instruction has been obeyed yet\n");
  s("step 3");
  const std::string history = s("history 2");
  EXPECT_NE(history.find("00101 100105  jms 105            00105=000102"), std::string::npos) << history;
  EXPECT_NE(history.find("00106 040110  dac 110            00110=000003"), std::string::npos) << history;
  auto xct = pdp7_session("  xct 104\n  hlt\n  0\n  0\n  lac 106\n  0\n  1234\n");
  (*xct)("step");
  EXPECT_NE((*xct)("history 1").find("xct 104            00106=001234"), std::string::npos);
}

TEST(MonitorPdp7, RunsToGoals) {
  auto m = pdp7_session("  isz 200\n  jmp 100\n  hlt\n");
  Session& s = *m;
  s("run for 10 instructions");
  EXPECT_EQ(s.machine().instructions(), 10U);
  s("run for 1ms");
  EXPECT_GE(s.machine().ticks(), 1'000'000);
  s("run until 2ms");
  EXPECT_GE(s.machine().ticks(), 2'000'000);
  EXPECT_LT(s.machine().ticks(), 2'010'000);
  EXPECT_EQ(s("run until [200]==2000").substr(0, 11), "[200]==2000");
  EXPECT_EQ(s("ev [200]==2000"), "1 = 1.\n");
  const std::int64_t before = s.machine().ticks();
  s("cycle 4");
  EXPECT_GE(s.machine().ticks() - before, 4 * 1750);
  s("run for", Kind::wrong);
  s("run for ever", Kind::wrong);
  s("run until nobody", Kind::wrong);
  s("break when [200]==3000");
  EXPECT_NE(s("c").find("breakpoint 1: [200]==3000"), std::string::npos);
}

TEST(MonitorPdp7, BreaksOnIotsAndInterrupts) {
  auto m = pdp7_session("  lac (jmp 200\n  dac 1\n  700406\n  700042\n  jmp .\n");
  Session& s = *m;
  s("break iot 4");
  EXPECT_NE(s("c").find("breakpoint 1: IOT 700406\n00103"), std::string::npos);
  s("break interrupt");
  EXPECT_NE(s("c").find("breakpoint 2: interrupt before 00104\n00001"), std::string::npos);
  EXPECT_EQ(s("ev [0]&7777"), "104 = 68.\n");
}

TEST(MonitorPdp7, StopsWhenAFlagRises) {
  auto m = pdp7_session("  700406\n  jmp .\n");
  Session& s = *m;
  s("break printer");
  EXPECT_NE(s("c").find("breakpoint 1: printer"), std::string::npos);
  // TLS takes one cycle; the flag rises a character's time, 100 ms, after it.
  EXPECT_GE(s.machine().ticks(), 100'000'000);
  EXPECT_LT(s.machine().ticks(), 100'010'000);
  EXPECT_NE(s("show conditions").find("printer      1\n"), std::string::npos);
  EXPECT_NE(s("show devices").find("printer      flag up, 1 characters typed"), std::string::npos);
}

constexpr const char* echo =
    "wait, 700301\n  jmp wait\n  700312\n  700406\n  700401\n  jmp .-1\n  and (177\n  sad (41\n  hlt\n  jmp wait\n";

TEST(MonitorPdp7, SendsAndExpects) {
  auto m = pdp7_session(echo);
  Session& s = *m;
  s("send \"Hi there\"");
  s("expect \"there\"");
  EXPECT_EQ(s.printed, "Hi there");
  s("assert keyboard==0");
  EXPECT_NE(s("assert keyboard==1", Kind::failed).find("assert: keyboard==1 is not true"), std::string::npos);
  const std::int64_t second = s.machine().ticks_per_second();
  const std::int64_t before = s.machine().ticks();
  EXPECT_EQ(s("expect \"never\"", Kind::failed),
            "expect: not printed, and the program waits for a key; printed since the last expect: \"\"\n");
  EXPECT_LT(s.machine().ticks() - before, 3 * second);
  s("send \"!\"");
  EXPECT_NE(s("c").find("stopped by halt"), std::string::npos);
  s("send \"\\q\"", Kind::wrong);
  s("send a b", Kind::wrong);
}

// It computes, for ever, and polls with different registers each time.
TEST(MonitorPdp7, ExpectHasALimit) {
  auto m = pdp7_session("wait, isz 20\n  nop\n  700301\n  jmp wait\n  hlt\n");
  Session& s = *m;
  const std::int64_t second = s.machine().ticks_per_second();
  EXPECT_EQ(s("expect \"x\" within 90s", Kind::failed), "expect: not printed in 90 s; printed since the last expect: \"\"\n");
  EXPECT_GE(s.machine().ticks(), 90 * second);
  EXPECT_LT(s.machine().ticks(), 91 * second);
  EXPECT_EQ(s("expect \"x\" within 250ms", Kind::failed), "expect: not printed in 0.25 s; printed since the last expect: \"\"\n");
  EXPECT_LT(s.machine().ticks(), 92 * second);
  EXPECT_NE(s("expect \"x\"", Kind::failed).find("not printed in 60 s"), std::string::npos);
  EXPECT_EQ(s("expect \"x\" within", Kind::wrong), "expect: found \"within\", expected within TIME, such as within 90s\n");
  EXPECT_EQ(s("expect \"x\" for 5s", Kind::wrong), "expect: found \"for 5s\", expected within TIME, such as within 90s\n");
}

// An empty text has been printed already, and takes no key; no text at all is an error.
TEST(MonitorPdp7, AnEmptyTextIsAText) {
  auto m = pdp7_session(echo);
  Session& s = *m;
  EXPECT_EQ(s("expect \"\""), "");
  EXPECT_EQ(s("send \"\""), "");
  EXPECT_EQ(s.machine().instructions(), 0U);
  s("expect", Kind::wrong);
  s("send", Kind::wrong);
  s("send \"\"; send \"A\"; send \"\"; expect \"A\"; expect \"\"");
  EXPECT_EQ(s.printed, "A");
}

TEST(MonitorPdp7, AttachesATape) {
  auto m = pdp7_session("  700104\n  700101\n  jmp .-1\n  700112\n  hlt\n");
  Session& s = *m;
  s.files["tape"] = "\377";
  s("attach reader tape");
  s("c");
  EXPECT_EQ(s("ev ac"), "377 = 255.\n");
  s("detach reader");
  s("attach reader missing", Kind::wrong);
  s("attach drum tape", Kind::wrong);
  s("attach", Kind::wrong);
}

TEST(MonitorPdp7, TracesToAFile) {
  auto m = pdp7_program();
  Session& s = *m;
  s("trace t");
  s("step 2");
  s("trace off");
  EXPECT_NE(s.files["t"].find("00100 200111  lac 111"), std::string::npos) << s.files["t"];
  EXPECT_EQ(std::count(s.files["t"].begin(), s.files["t"].end(), '\n'), 2);
  s("trace off", Kind::wrong);
  s("trace", Kind::wrong);
}

TEST(MonitorPdp7, TakesPictures) {
  auto m = pdp7_session("  hlt\n", "--display");
  (*m)("screenshot a.png");
  EXPECT_EQ(m->files["a.png"].substr(1, 3), "PNG");
  auto without = pdp7_session("  hlt\n");
  (*without)("screenshot a.png", Kind::wrong);
}

// The square of host/examples/square.s, by its comments: its display words are listed as such once the display was started there.
TEST(MonitorPdp7, ListsDisplayWordsWhereTheDisplayReadsThem) {
  auto m = pdp7_session("begin, law file\n idla\n idsi\n jmp .-1\n hlt\nfile, 020137\n 220601\n 100601\n 200177\n 677577\n 003000\n 200177\n start begin\n");
  Session& s = *m;
  const std::string words = "list 105-113";
  EXPECT_NE(s(words).find(" 00106 220601  file+1: lac i 601  ; "), std::string::npos) << s(words);
  s("continue");
  const std::string list = s(words);
  EXPECT_NE(list.find("00105 020137  file: parameter, scale 1 (x2), intensity 7, then point  ; "), std::string::npos) << list;
  EXPECT_NE(list.find(" 00106 220601  file+1: point, y 601, dark, then point  ; "), std::string::npos) << list;
  EXPECT_NE(list.find(" 00107 100601  file+2: point, x 601, dark, then vector  ; "), std::string::npos) << list;
  EXPECT_NE(list.find(" 00110 200177  file+3: vector, dx +177 dy +0, lit  ; "), std::string::npos) << list;
  EXPECT_NE(list.find(" 00111 677577  file+4: vector, dx +177 dy +177, lit, then parameter  ; "), std::string::npos) << list;
  EXPECT_NE(list.find(" 00112 003000  file+5: parameter, stop and interrupt  ; "), std::string::npos) << list;
  EXPECT_NE(list.find(" 00113 200177  file+6: lac 177  ; "), std::string::npos) << list;  // after the stop
  EXPECT_NE(s("list 100-101").find(" 00101 700606  begin+1: idla  ; "), std::string::npos);
  // The changed Y word now leads to a parameter word.
  s("deposit 106 200601");
  EXPECT_NE(s(words).find(" 00106 200601  file+1: point, y 601, dark, then parameter  ; "), std::string::npos) << s(words);
  EXPECT_NE(s(words).find(" 00107 100601  file+2: parameter, "), std::string::npos) << s(words);
}

TEST(MonitorPdp7, TheDisplayIsConnectedAtItsFirstUse) {
  auto m = pdp7_session("begin, law file\n idla\nloop, idsi\n jmp loop\n jmp begin\nfile, 020137\n 220601\n 100601\n 200177\n 677577\n 003000\n start begin\n");
  Session& s = *m;
  EXPECT_EQ(s("show display"), "no display is attached, or the program has not used it yet\n");
  EXPECT_NE(s("show devices").find("display      not used yet\n"), std::string::npos);
  s("break when stop");
  s("continue");
  EXPECT_NE(s("show devices").find("display      6 words, 1 passes complete of 1 started"), std::string::npos) << s("show devices");
  EXPECT_NE(s("show display").find("stopped by its file"), std::string::npos);
  s("back " + std::to_string(s.machine().instructions()));
  EXPECT_EQ(s("show display"), "no display is attached, or the program has not used it yet\n");
  s("delete");
  walk_back_and_forth(s, "pdp7");
}

// Two words of three lines with hole 8. RSB takes one.
TEST(MonitorPdp7, DevicesReportTheirState) {
  auto m = pdp7_session(" rsb\n rsf\n jmp .-1\n hlt\n");
  Session& s = *m;
  EXPECT_NE(s("show devices").find("reader       no tape, flag down"), std::string::npos);
  s.files["words.tape"] = "\x81\x82\x83\x84\x85\x86";
  s("attach reader words.tape");
  EXPECT_NE(s("show devices").find("reader       words.tape, 0 of 6 lines read, flag down"), std::string::npos) << s("show devices");
  s("continue");
  EXPECT_NE(s("show devices").find("reader       words.tape, 3 of 6 lines read, flag up, buffer 010203"), std::string::npos) << s("show devices");
  s("detach reader");
  EXPECT_NE(s("show devices").find("reader       no tape"), std::string::npos);
}

TEST(MonitorPdp7, ReadsCommandsFromFiles) {
  auto m = pdp7_program();
  Session& s = *m;
  s.files["a"] = "# to the subroutine\nbreak store+1\ncontinue\n\nassert ac==3\n";
  s("do a");
  EXPECT_EQ(s("ev pc"), "106 = 70. = store+1\n");
  s.files["b"] = "e pc\nnonsense\ne ac\n";
  EXPECT_NE(s("do b", Kind::wrong).find("b: line 2: unknown command \"nonsense\""), std::string::npos);
  s.files["c"] = "do c\n";
  EXPECT_NE(s("do c", Kind::wrong).find("within 8 others"), std::string::npos);
  s("do missing", Kind::wrong);
}

TEST(MonitorPdp7, ListsHelpsAndShows) {
  auto m = pdp7_program();
  Session& s = *m;
  const std::string list = s("list 100-102");
  EXPECT_EQ(list.substr(0, list.find('\n')), ">00100 200111  begin: lac 111  ; begin,  lac (3");
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 3);
  EXPECT_NE(s("help").find("e[xamine]"), std::string::npos);
  EXPECT_NE(s("help watch").find("w[atch]"), std::string::npos);
  s("help nonsense", Kind::wrong);
  EXPECT_NE(s("show symbols").find("store            00105"), std::string::npos);
  EXPECT_NE(s("show time").find("0.000000000 s, 0 instructions"), std::string::npos);
  EXPECT_NE(s("show registers").find("MQ 000000"), std::string::npos);
  s("show nonsense", Kind::wrong);
  s("speed real", Kind::wrong);
  EXPECT_EQ(s("quit", Kind::quit), "");
  EXPECT_NE(s("exmaine", Kind::wrong).find("unknown command \"exmaine\""), std::string::npos);
  EXPECT_EQ(s(""), "");
  EXPECT_EQ(s("# nothing"), "");
}

TEST(MonitorPdp7, GoPressesStart) {
  auto m = pdp7_program();
  Session& s = *m;
  EXPECT_NE(s("go 102").find("stopped by halt"), std::string::npos);
  EXPECT_EQ(s("ev [place]"), "5 = 5.\n");
}

TEST(MonitorPdp7, CompletesVerbsAndNames) {
  auto m = pdp7_program();
  EXPECT_EQ(m->monitor().completions("ex", "ex"), (std::vector<std::string>{"examine", "expect", "exit"}));
  EXPECT_EQ(m->monitor().completions("break st", "st"), (std::vector<std::string>{"stop", "store"}));
}

TEST(MonitorPdp7, InspectionChangesNothing) {
  const auto typed = [](std::initializer_list<std::string> lines) {
    auto m = pdp7_session(echo);
    for (const char key : std::string("so!")) m->machine().type(static_cast<std::uint8_t>(key));
    for (const std::string& line : lines) (*m)(line);
    EXPECT_NE((*m)("c").find("stopped by halt"), std::string::npos);
    return std::make_pair(m->machine().ticks(), m->machine().instructions());
  };
  const auto plain = typed({});
  EXPECT_EQ(typed({"break wait count 1000000", "watch 0-7777 rw if 0"}), plain);
  EXPECT_EQ(typed({"break when 0"}), plain);
  EXPECT_EQ(typed({"step 1000", "run for 123us", "trace t"}), plain);
}

TEST(MonitorPdp7, SavesAndRestores) {
  auto m = pdp7_program();
  Session& s = *m;
  s("step 3; save a.snap; step 4; restore a.snap");
  EXPECT_EQ(s("ev pc"), "107 = 71. = store+2\n");
  s.files["b.snap"] = s.files["a.snap"].substr(0, 100);
  s("restore b.snap", Kind::wrong);
  s("restore missing", Kind::wrong);
  s("save", Kind::wrong);
}

std::unique_ptr<Session> i8080_session(const std::string& text);

// Random walks of steps forward and back: after the same number of instructions the machine is always the same.
void walk_back_and_forth(Session& s, std::string_view name) {
  std::map<std::uint64_t, machines::Bytes> seen;
  std::mt19937 engine(7);
  for (int round = 0; round < tests::effort(60, 20); ++round) {
    const std::uint64_t here = s.machine().instructions();
    machines::Bytes state = live::save_snapshot(name, s.machine());
    const auto known = seen.emplace(here, state);
    ASSERT_EQ(known.first->second, state) << "after " << here << " instructions";
    if (engine() % 3 == 0 && here > 0) {
      s("back " + std::to_string(1 + engine() % here));
    } else if (engine() % 4 == 0) {
      s("run for 30ms");
    } else {
      s("step " + std::to_string(1 + engine() % 200));
    }
  }
}

TEST(MonitorBack, ReturnsTheSameState) {
  auto pdp7 = pdp7_session("  700406\n  isz 200\n  lac 200\n  dac i 10\n  700244\n  jmp 100\n");
  walk_back_and_forth(*pdp7, "pdp7");
  auto i8080 = i8080_session("  LXI H,8000H\nLOOP: INR M\n  INX H\n  PUSH H\n  POP D\n  OUT 60H\n  JMP LOOP\n");
  walk_back_and_forth(*i8080, "i8080");
}

TEST(MonitorBack, ReportsHowFarItCanGo) {
  auto m = pdp7_program();
  Session& s = *m;
  EXPECT_NE(s("back", Kind::wrong).find("expected at most 0"), std::string::npos);
  s("step 5");
  EXPECT_NE(s("back 6", Kind::wrong).find("expected at most 5"), std::string::npos);
  s("back 5");
  EXPECT_EQ(s("ev pc"), "100 = 64. = begin\n");
  EXPECT_EQ(s("history"), "no instruction has been obeyed yet\n");
}

// --- The 8080 ---

std::unique_ptr<Session> i8080_session(const std::string& text) {
  const std::vector<assembler::SourceFile> sources{{"test.asm", "\tORG 100H\n" + text}};
  const auto assembly = assembler::assemble_i8080(sources);
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
  live::Symbols symbols(16);
  EXPECT_TRUE(symbols.add_table(assembler::write_i8080_symbols(assembly.symbols)));
  MachineRun of(machines::i8080());
  of.set_file("--load", "test.hex", image::write_intel_hex(assembly.image))
      .set("--start", "100")
      .set("--cpm")
      .set("--console", "ascii");
  return std::make_unique<Session>(machines::i8080(), of, std::move(symbols));
}

std::unique_ptr<Session> i8080_program() {
  return i8080_session(
      "BEGIN: LXI H,200H\n"  // 0100, 10 T-states
      "  MVI M,5AH\n"        // 0103, 10
      "  CALL SUBR\n"        // 0105, 17
      "  OUT 33H\n"          // 0108, 10
      "  HLT\n"              // 010A
      "SUBR: MOV A,M\n"      // 010B, 7
      "  RET\n");            // 010C, 10
}

TEST(MonitorI8080, ExaminesDepositsAndSteps) {
  auto m = i8080_program();
  Session& s = *m;
  const std::string bytes = s("e 100-102");
  EXPECT_EQ(bytes.substr(0, 14), "0100  21 00 02");
  EXPECT_EQ(bytes.substr(bytes.size() - 5), " !..\n");
  EXPECT_EQ(s("e 100"), "0100 21  BEGIN: LXI     H,0200H\n");
  EXPECT_EQ(s("step"), "0103 BEGIN+3: MVI     M,5AH  A 00  F 02  B 00  C 00  D 00  E 00  H 02  L 00  SP EBFE  INTE 0  0.000003333 s\n");
  EXPECT_EQ(s("ev hl").substr(0, 10), "200 = 512.");
  s("d 300 \"MVI A,12H\"");
  EXPECT_EQ(s("ev [300]*100+[301]"), "3E12 = 15890.\n");
  s("d 300 100", Kind::wrong);
  s("d a 100", Kind::wrong);
  EXPECT_EQ(s("d a 0FF; e a"), "A FF\n");
}

TEST(MonitorI8080, BreaksAndWatches) {
  auto m = i8080_program();
  Session& s = *m;
  s("break SUBR");
  EXPECT_NE(s("c").find("breakpoint 1\n010B"), std::string::npos);
  s("del");
  s("watch 200 rw");
  EXPECT_NE(s("c").find("breakpoint 2: 0200"), std::string::npos);
  s("watch port 33");
  EXPECT_NE(s("c").find("breakpoint 3: port 33 written with 5A"), std::string::npos);
  EXPECT_NE(s("c").find("stopped by halt"), std::string::npos);
  EXPECT_EQ(s("who 200").substr(0, 51), "0200: 5A was written at 0.000005666 s by 0103 BEGIN");
}

TEST(MonitorI8080, NextAndHistory) {
  auto m = i8080_program();
  Session& s = *m;
  s("step 2");
  EXPECT_NE(s("next").find("0108"), std::string::npos);
  const std::string history = s("history 2");
  EXPECT_NE(history.find("010B 7E     MOV     A,M"), std::string::npos) << history;
  EXPECT_NE(history.find("0200=5A"), std::string::npos) << history;
}

TEST(MonitorI8080, SendsAndExpectsOnTheConsoleOfCpm) {
  auto m = i8080_session("LOOP: MVI C,1\n  CALL 5\n  CPI '!'\n  JNZ LOOP\n  JMP 0\n");
  Session& s = *m;
  s("send \"abc\"");
  s("expect \"abc\"");
  EXPECT_NE(s("c").find("stopped by end of input"), std::string::npos);
  s("send \"!\"");
  EXPECT_NE(s("c").find("stopped by exit"), std::string::npos);
}

// `who` finds it even if the call has just been answered, and `back` returns to that state.
TEST(MonitorI8080, WhoFindsWhatCpmHasJustWritten) {
  auto m = i8080_session("  LXI D,300H\n  MVI C,10\n  CALL 5\n  LDA 302H\n  JMP 0\n");
  Session& s = *m;
  s("deposit 300 5; watch 302; send \"K\\r\"; c");
  EXPECT_EQ(s("who 302").substr(0, 25), "0302: 4B was written at 0");
  EXPECT_NE(s("who 302").find(" by EC06 OUT     01H"), std::string::npos);
  s("step");
  s("back");
  EXPECT_EQ(s("ev [302]").substr(0, 2), "4B");
  EXPECT_EQ(s("who 302").substr(0, 25), "0302: 4B was written at 0");
}

// CALL has 17 T-states: 5 3 3 3 3; LXI 10: 4 3 3.
TEST(MonitorI8080, CyclesStopInsideAnInstruction) {
  auto m = i8080_session("  LXI D,300H\n  CALL 5\n  LDA 302H\n  JMP 0\n");
  Session& s = *m;
  const std::string inside = s("cycle 5");
  EXPECT_NE(inside.find("inside the instruction that begins at 0.000000000 s:\n"), std::string::npos) << inside;
  EXPECT_NE(inside.find(" done       fetch          0100 11\n"), std::string::npos) << inside;
  EXPECT_NE(inside.find(" under way  read           0101 00\n"), std::string::npos) << inside;
  EXPECT_NE(inside.find(" to come    read           0102\n"), std::string::npos) << inside;
  EXPECT_EQ(s("cycle 5").substr(0, 4), "0103");
  EXPECT_NE(s("cycle 13").find(" to come    stack write    "), std::string::npos);
  EXPECT_EQ(s("cycle 4").substr(0, 4), "0005");
  // Any other run continues from the beginning of the instruction.
  s("cycle 2");
  s("step");
  EXPECT_EQ(s("ev time").substr(0, 7), "25 = 37");
}

TEST(MonitorPdp7, CyclesStopInsideAnInstruction) {
  auto m = pdp7_session("begin, lac i p\n isz q\n jmp begin\np, q\nq, 5\n start begin\n");
  Session& s = *m;
  EXPECT_EQ(s("cycle"),
            "at 0.000001750 s, inside the instruction that begins at 0.000000000 s:\n"
            "0.000000000 s done       fetch          00100 220103\n"
            "0.000001750 s to come    read           00103\n"
            "0.000003500 s to come    read           00104\n"
            "before it: 00100 begin: lac i 103  ; begin, lac i p  AC 000000  L 0  MQ 000000  SC 00  0.000000000 s\n");
  EXPECT_NE(s("cycle").find("0.000001750 s done       read           00103 000104\n"), std::string::npos);
  EXPECT_EQ(s("cycle").substr(0, 5), "00101");
  EXPECT_NE(s("cycle").find("0.000007000 s to come    read and write 00104\n"), std::string::npos);
  s("d ac 7");  // from its beginning
  EXPECT_EQ(s("cycle 2").substr(0, 5), "00102");
  EXPECT_EQ(s("ev [q]"), "6 = 6.\n");
}

// The host stores the line that BDOS reads into the buffer: a watchpoint and `who` see it.
TEST(MonitorI8080, WatchpointsSeeWritesByCpm) {
  auto m = i8080_session("  LXI D,300H\n  MVI C,10\n  CALL 5\n  LDA 302H\n  JMP 0\n");
  Session& s = *m;
  s("deposit 300 5; watch 302; watch 301 r; send \"K\\r\"");
  EXPECT_EQ(s("c").substr(0, 36), "breakpoint 1: 0302  written with 4B\n");
  EXPECT_EQ(s("ev [302]").substr(0, 2), "4B");
  s("step");
  EXPECT_EQ(s("who 302").substr(0, 25), "0302: 4B was written at 0");
  s("back 3");
  EXPECT_EQ(s("ev [302]").substr(0, 2), "0 ");
  EXPECT_NE(s("send \"L\\r\"; c").find("written with 4C"), std::string::npos);
  EXPECT_NE(s("c").find("stopped by exit"), std::string::npos) << "once";
}

// --- The past, compared with observations at the time ---

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Steps, runs, deposited words and sent keys, with a trace from the beginning. The history, computed by running again, must equal
// the
// trace's last lines.
void compare_history_with_trace(Session& s, const std::string& word) {
  std::mt19937 engine(11);
  s("trace t");
  for (int round = 0; round < 40; ++round) {
    switch (engine() % 5) {
      case 0: s("step " + std::to_string(1 + engine() % 150)); break;
      case 1: s("run for 3ms"); break;
      case 2: s("d " + word + " " + std::to_string(engine() % 8)); break;
      case 3: s("send \"abc\""); break;
      default: s("break " + word + "; run for 1ms; del"); break;
    }
  }
  s("trace off");
  const std::vector<std::string> traced = lines_of(s.files["t"]);
  ASSERT_GT(traced.size(), 3000U);
  const std::vector<std::string> last = lines_of(s("history 3000"));
  ASSERT_EQ(last.size(), 3000U);
  for (std::size_t n = 0; n < last.size(); ++n) ASSERT_EQ(last[n], traced[traced.size() - last.size() + n]) << n;
  // Afterwards the machine is in the same state, and continues.
  const std::int64_t ticks = s.machine().ticks();
  s("step");
  EXPECT_GT(s.machine().ticks(), ticks);
}

TEST(MonitorPast, HistoryEqualsTheTrace) {
  auto pdp7 = pdp7_session(
      "begin, 700301\n  jmp over\n  700312\n  700406\nover, isz 300\n  lac 300\n  dac i 10\n  jms sub\n  jmp begin\n"
      "sub, 0\n  dac 301\n  jmp i sub\n");
  compare_history_with_trace(*pdp7, "300");
  auto i8080 = i8080_session(
      "LOOP: MVI C,11\n  CALL 5\n  ORA A\n  JZ NONE\n  MVI C,1\n  CALL 5\nNONE: LXI H,300H\n  INR M\n  PUSH H\n  POP D\n  JMP LOOP\n");
  compare_history_with_trace(*i8080, "300");
}

TEST(MonitorPast, TheWriterIsFoundAfterAnyTime) {
  // The word at 300 is written once, then three million instructions follow.
  auto m = pdp7_session("  lac (5\n  dac 300\nloop, isz 301\n  jmp loop\n  jmp loop\n");
  Session& s = *m;
  s(tests::is_optimised() ? "run for 3000000 instructions" : "run for 1200000 instructions");
  // LAC and DAC: the write is the fourth cycle.
  EXPECT_NE(s("who 300").find("00300: 000005 was written at 0.000005250 s by 00101"), std::string::npos) << s("who 300");
  EXPECT_NE(s("who 301").find("by 00102"), std::string::npos);
  EXPECT_NE(s("who 302").find("nothing has written there"), std::string::npos);
}

TEST(MonitorPast, AnInterruptIsNamedAsTheWriter) {
  auto m = pdp7_session("  lac (jmp 200\n  dac 1\n  700406\n  700042\n  jmp .\n");
  Session& s = *m;
  s("break interrupt; c");
  EXPECT_NE(s("who 0").find("by the interrupt before 00104"), std::string::npos) << s("who 0");
}

TEST(MonitorStack, ShowsCallsAndStepsOut) {
  auto m = pdp7_session(
      "  jms outer\n  hlt\nouter, 0\n  jms inner\n  jmp i outer\ninner, 0\n  nop\n  jmp i inner\n");
  Session& s = *m;
  EXPECT_NE(s("show stack").find("no subroutine"), std::string::npos);
  s("out", Kind::wrong);
  s("break inner+1; c");
  const std::vector<std::string> stack = lines_of(s("show stack"));
  ASSERT_EQ(stack.size(), 2U);
  EXPECT_EQ(stack[0].substr(0, 23), "00106 called from 00103") << stack[0];
  EXPECT_EQ(stack[1].substr(0, 23), "00103 called from 00100") << stack[1];
  s("out");
  EXPECT_EQ(s("ev pc").substr(0, 3), "104");
  s("out");
  EXPECT_EQ(s("ev pc").substr(0, 3), "101");
  s("out", Kind::wrong);
}

TEST(MonitorStack, StepOutOfARecursionIsOneLevel) {
  // Counts down in B by calling itself.
  auto m = i8080_session("  LXI SP,400H\n  MVI B,5\n  CALL DOWN\n  HLT\nDOWN: DCR B\n  RZ\n  CALL DOWN\n  RET\n");
  Session& s = *m;
  s("break DOWN count 3; c; del");
  EXPECT_EQ(lines_of(s("show stack")).size(), 3U);
  EXPECT_EQ(s("ev b").substr(0, 1), "3");
  s("out");
  EXPECT_EQ(lines_of(s("show stack")).size(), 2U);
  EXPECT_EQ(s("ev sp").substr(0, 3), "3FC");
  s("out; out");
  EXPECT_EQ(s("ev sp").substr(0, 3), "400");
}

// The oracle of conditions: a machine that runs one instruction at a time and evaluates an independent rule after each. A
// condition stops
// it when it becomes true, a breakpoint after so many passes, a watchpoint after so many writes.
class Stepped {
 public:
  Stepped(const machines::MachineDescription& description, std::unique_ptr<Session> session)
      : description_(description), session_(std::move(session)), names_{
            description.radix, [this](std::string_view name) { return symbol(name); },
            [this](std::int64_t at) -> std::optional<std::int64_t> {
              if (at < 0 || at >= machine().words()) return std::nullopt;
              return machine().word(static_cast<std::uint32_t>(at));
            },
            [this](std::string_view name) { return reader(name); }} {}
  Stepped(const Stepped&) = delete;
  Stepped& operator=(const Stepped&) = delete;
  ~Stepped() = default;

  [[nodiscard]] machines::Machine& machine() const { return session_->machine(); }
  [[nodiscard]] Session& session() const { return *session_; }
  void wait_for(const std::string& condition) {
    auto expression = live::Expression::read(condition, names_);
    ASSERT_TRUE(expression.has_value()) << condition;
    const bool is_true = holds(*expression);
    conditions_.emplace_back(std::move(*expression), is_true);
  }
  void count_place(std::uint32_t place, std::uint64_t every) {
    place_ = place;
    every_ = every;
  }
  // Of the 8080.
  void count_writes(std::uint32_t first, std::uint32_t last, std::uint64_t every) {
    machine().probe()->on_instruction = [](const machines::Probe::Entry&) {};
    machine().probe()->on_cycle = [this, first, last, every](const machines::Probe::Cycle& cycle) {
      const bool writes = (cycle.name == "write" || cycle.name == "stack write") && cycle.address >= first && cycle.address <= last;
      if (writes && ++written_ % every == 0) stop_ = true;
    };
  }
  void run(std::uint64_t instructions) {
    stop_ = false;
    for (std::uint64_t n = 0; n < instructions && !stop_; ++n) {
      machines::Limits one;
      one.instructions = machine().instructions() + 1;
      std::optional<machines::Stop> stop;
      while (!stop) stop = machine().run(one, false);
      ASSERT_EQ(stop->name, "instruction_limit");
      if (every_ != 0 && register_named("pc")() == place_ && ++passed_ % every_ == 0) stop_ = true;
      for (auto& [expression, was_true] : conditions_) {
        const bool is_true = holds(expression);
        if (is_true && !was_true) stop_ = true;
        was_true = is_true;
      }
    }
  }

 private:
  using Reader = std::function<std::int64_t()>;

  [[nodiscard]] static bool holds(const live::Expression& expression) {
    const auto value = expression.value();
    return !value || *value != 0;
  }

  [[nodiscard]] Reader register_named(std::string_view name) const {
    for (std::size_t n = 0; n < description_.registers.size(); ++n)
      if (base::lower_case(description_.registers[n].name) == name) return [this, n] { return std::int64_t{machine().get(n)}; };
    return nullptr;
  }
  [[nodiscard]] Reader reader(std::string_view name) const {
    if (auto found = register_named(name)) return found;
    if (name == "bc" || name == "de" || name == "hl")
      return [high = register_named(name.substr(0, 1)), low = register_named(name.substr(1))] { return high() << 8 | low(); };
    if (name == "time") return [this] { return machine().ticks(); };
    if (name == "instructions") return [this] { return static_cast<std::int64_t>(machine().instructions()); };
    const auto flags = machine().conditions();
    for (std::size_t n = 0; n < flags.size(); ++n)
      if (flags[n].first == name) return [this, n] { return std::int64_t{machine().conditions()[n].second ? 1 : 0}; };
    return nullptr;
  }
  [[nodiscard]] std::optional<std::int64_t> symbol(std::string_view name) const {
    const std::string text = (*session_)("evaluate " + std::string(name));
    return live::number("0" + text.substr(0, text.find(' ')), description_.radix);
  }

  const machines::MachineDescription& description_;
  std::unique_ptr<Session> session_;
  live::Names names_;
  std::vector<std::pair<live::Expression, bool>> conditions_;
  std::uint32_t place_ = 0;
  std::uint64_t every_ = 0, passed_ = 0, written_ = 0;
  bool stop_ = false;
};

void expect_same_place(const machines::Machine& found, const Stepped& expected, const std::string& what) {
  EXPECT_EQ(found.instructions(), expected.machine().instructions()) << what;
  EXPECT_EQ(found.ticks(), expected.machine().ticks()) << what;
}

void compare_conditions(const machines::MachineDescription& description, const std::function<std::unique_ptr<Session>()>& begin,
                        const std::vector<std::string>& conditions, std::uint64_t instructions = 300) {
  constexpr std::uint32_t first_instruction = 0100;
  const std::uint32_t place = description.radix == 8 ? first_instruction : 0x100;
  for (const std::string& condition : conditions) {
    auto m = begin();
    Stepped stepped(description, begin());
    (*m)("break when " + condition);
    (*m)(description.radix == 8 ? "break 100 count 7" : "break 100H count 7");
    stepped.wait_for(condition);
    stepped.count_place(place, 7);
    for (int n = 0; n < 6; ++n) {
      (*m)(fmt::format("run for {} instructions", instructions));
      stepped.run(instructions);
      expect_same_place(m->machine(), stepped, condition);
    }
  }
}

TEST(MonitorPdp7, ConditionsOnMemoryStopLikeTheOracle) {
  std::mt19937 random(1965);
  std::vector<std::string> conditions;
  for (int round = 0; round < 20; ++round) {
    const std::string wanted = std::to_string(random() % 8);
    conditions.push_back("[place]==" + wanted + " || [200+1]==" + std::to_string(random() % 8));
  }
  compare_conditions(
      machines::pdp7(),
      [] {
        return pdp7_session(
            "begin,  isz place\n jms sub\n isz 201\n isz 201\n jmp begin\nsub, 0\n lac place\n and (3\n dac place\n jmp i sub\n"
            "place, 0\n start begin\n");
      },
      conditions, 200);
}

TEST(MonitorPdp7, ConditionsOnRegistersStopLikeTheOracle) {
  compare_conditions(
      machines::pdp7(),
      [] {
        return pdp7_session(
            "begin, isz place\n jms sub\n rcl\n 700406\n lmq\n 700401\n cma\n jmp begin\nsub, 0\n lac place\n and (17\n tad (3\n"
            " jmp i sub\nplace, 0\n start begin\n");
      },
      {"ac==7", "ac>=10 && ac<=14", "ac!=0", "l", "l==0", "!l", "l==1 && ac==12", "ac&4", "(ac&6)==6", "mq==16", "mq>20", "3==mq", "17>ac", "ac==mq",
       "pc==101", "pc>=105 && pc<107", "pc==101 && ac==7", "[place]==5 && ac==7", "ac>mq", "ac<=mq", "mq==ac+3", "ac-mq==4", "10-ac==mq", "ac!=mq", "(ac^mq)==2", "(ac&7)==(mq&7)", "l==(ac&1)", "l && ac==12", "ion", "sc==mq", "(mq&1)+ac>16", "1/(ac-3)", "[ac]==ac", "printer && ac==7", "sc==0 && ac==5", "ac==7 || mq==7", "printer", "printer==0", "time>3000", "ac==777777", "ac<0", "ac>=0", "instructions==123", "instructions>=456 && time<10000000", "instructions<20", "20>instructions", "time>=1000000 && time<2000000",
       "instructions!=40 && !(time>5000)", "instructions", "time==52500. || instructions==1000", "instructions>3000 && ac==7", "1", "0"});
}

// The display repeatedly draws a vector beyond the edge: IDCF clears that flag, and a file that ends in a stop raises the other.
TEST(MonitorPdp7, ConditionsOnFlagsOfTheDisplayStopLikeTheOracle) {
  compare_conditions(
      machines::pdp7(),
      [] {
        return pdp7_session(
            "begin, lac (300\n 700606\nloop, isz 301\n isz count\n 701001\n jmp more\n 700704\n lac (310\n 700606\nmore, 700601\n jmp loop\n"
            " 700406\n jmp begin\ncount, 0\n300/ 020117\n221000\n101700\n437700\n310/ 020117\n3000\n start begin\n",
            "--display");
      },
      {"edge", "!edge", "stop", "!stop", "edge && ac==300", "stop || edge", "edge && !printer", "pen", "printer && stop", "stop && [count]>3",
       "edge && time>400000", "edge && pc==103"});
}

// The display fetches words, and the clock counts in 7, at consecutive boundaries.
TEST(MonitorPdp7, WordsThatTheClockWritesDuringADisplayAreTestedAtOnce) {
  compare_conditions(
      machines::pdp7(),
      [] {
        return pdp7_session("begin, cla\n dac 7\n 700044\n lac (300\n 700606\nloop, jmp loop\n300/ 020117\n221000\n101700\n437700\n010000\n start begin\n",
                            "--display");
      },
      {"[7]&1 && ac==300", "[7]==2 && l==0"}, tests::effort(20'000U, 6'000U));
}

bool step_back(Stepped& stepped, std::unique_ptr<Session> again, std::uint64_t instructions) {
  machines::Limits limits;
  limits.instructions = stepped.machine().instructions() - instructions;
  const auto stop = again->machine().run(limits, false);
  return stop && stop->name == "instruction_limit" && stepped.machine().restore(again->machine().save()).has_value();
}

// At the start of a run a flag may differ from its value at the last test of the condition: after `back`, after START, or because
// the
// condition was never tested.
TEST(MonitorPdp7, AFlagThatDiffersAtTheStartOfARunIsTested) {
  struct Walk {
    std::string condition;
    std::vector<std::string> lines;
  };
  constexpr std::uint64_t for_ever = 200'000;
  const std::vector<Walk> walks{
      {"printer", {"continue", "back 1000", "run for 5000 instructions"}},
      {"printer", {"continue", "go 100"}},
      {"printer==0", {"continue", "back 1000", "run for 50000 instructions"}},
  };
  for (const Walk& walk : walks) {
    const auto begin = [] { return pdp7_session("begin, lac (301\n 700406\nloop, isz count\n jmp loop\n jmp loop\ncount, 0\n start begin\n"); };
    auto m = begin();
    Stepped stepped(machines::pdp7(), begin());
    (*m)("break when " + walk.condition);
    (*m)(fmt::format("break when instructions=={}.", for_ever));
    stepped.wait_for(walk.condition);
    stepped.wait_for(fmt::format("instructions=={}.", for_ever));
    for (const std::string& line : walk.lines) {
      (*m)(line);
      if (line == "go 100") stepped.machine().start(0100);
      if (line.starts_with("run for ")) stepped.run(std::stoull(line.substr(8)));
      else if (line == "back 1000") ASSERT_TRUE(step_back(stepped, begin(), 1000));
      else stepped.run(for_ever);
      expect_same_place(m->machine(), stepped, walk.condition + ": " + line);
    }
  }
  // `run until` tests whether it holds, not whether it has become true.
  auto m = pdp7_session("begin, lac (301\n 700406\nloop, isz count\n jmp loop\n jmp loop\ncount, 0\n start begin\n");
  (*m)("run until printer==0");
  EXPECT_EQ(m->machine().instructions(), 1U);
}

TEST(MonitorI8080, ConditionsOnRegistersStopLikeTheOracle) {
  compare_conditions(
      machines::i8080(),
      [] {
        return i8080_session(
            "BEGIN: INR B\n INX H\n DCX D\n MOV A,B\n ADD L\n PUSH PSW\n POP B\n INR C\n JNZ BEGIN\n MVI C,9\n CALL SUB\n JMP BEGIN\nSUB: RET\n");
      },
      {"a==7", "a>=10 && a<=14", "hl==5", "h==0 && l==6", "b==12", "b>0F0", "bc==1213", "de==0FFF8", "d==0FF", "e<4", "c&10", "a==b", "sp==0FFFA",
       "pc==105", "f&40", "l!=0", "a>=80 && b<40", "bc>8000", "hl>2 && hl<8", "b!=a", "a==l+3", "b-d==5", "bc==hl+1200", "e<c", "(a^l)==3", "b==c", "h==l", "(b&3)==(l&3)", "inte", "sp<0FFF8 || a==3", "[hl]==l", "time>1000 && a==4", "a", "!(a-b)", "b>=0", "d<0", "f!=46", "instructions==123", "instructions>=200 && time<4000", "time>=1000 && time<1005", "time!=20", "!(instructions<40 || time>2000)"});
}

// Random programs, which may overwrite themselves, and random conditions; some wait for two things at once.
std::string random_condition(std::mt19937& random) {
  const auto one_of = [&random](const std::vector<std::string>& texts) { return texts[random() % texts.size()]; };
  const auto byte = [&] { return one_of({"a", "f", "b", "c", "d", "e", "h", "l"}); };
  const auto word = [&] { return one_of({"bc", "de", "hl", "sp"}); };
  const auto sign = [&] { return one_of({"==", "!=", "<", "<=", ">", ">="}); };
  const auto number = [&](unsigned most) { return fmt::format("0{:X}", random() % most); };
  const std::string left = random() % 2 == 0 ? byte() : word();
  const std::string right = random() % 2 == 0 ? byte() : word();
  switch (random() % 8) {
    case 0: return byte() + sign() + number(0x100);
    case 1: return word() + sign() + number(0x10000);
    case 2: return left + sign() + right + one_of({"+", "-"}) + number(0x10000);
    case 3: return byte() + sign() + byte() + one_of({"+", "-"}) + number(0x100);
    case 4: return "(" + left + one_of({"^", "&", "|"}) + right + ")" + sign() + number(0x100);
    case 5: return "(" + byte() + "&" + number(0x100) + ")" + sign() + number(0x20) + one_of({" && ", " || "}) + byte() + sign() + number(0x100);
    case 6: return "[" + word() + "]" + sign() + byte();
    default: return byte() + "*" + byte() + sign() + left + one_of({"", "+inte", "+1/(" + byte() + "-1)"});
  }
}

TEST(MonitorI8080, RandomConditionsStopLikeTheOracle) {
  const std::vector<unsigned> others{0x02, 0x03, 0x04, 0x05, 0x07, 0x09, 0x0A, 0x0B, 0x0C, 0x0D, 0x0F, 0x12, 0x13, 0x14, 0x15, 0x17, 0x19, 0x1A,
                                     0x1B, 0x1C, 0x1D, 0x1F, 0x23, 0x24, 0x25, 0x27, 0x29, 0x2B, 0x2C, 0x2D, 0x2F, 0x34, 0x35, 0x37, 0x39, 0x3C,
                                     0x3D, 0x3F, 0xC1, 0xC5, 0xD1, 0xD5, 0xE1, 0xE3, 0xE5, 0xEB, 0xF1, 0xF3, 0xF5, 0xFB};
  for (unsigned seed = 1; seed <= tests::effort(60U, 12U); ++seed) {
    std::mt19937 random(seed);
    std::string program = fmt::format("BEGIN: LXI SP,{}\n LXI H,{}\nLOOP: NOP\n", 0x2000 + random() % 0x8000, 0x100 + random() % 0x1000);
    for (int n = 0; n < 30; ++n) {
      unsigned code = 0x40 + static_cast<unsigned>(random() % 0x80);
      if (code == 0x76 || random() % 3 == 0) code = others[random() % others.size()];
      program += fmt::format(" DB {}\n", code);
    }
    program += " JMP LOOP\n";
    const std::string first = random_condition(random), second = random_condition(random);
    const bool both = random() % 3 == 0;
    auto m = i8080_session(program);
    Stepped stepped(machines::i8080(), i8080_session(program));
    for (const std::string& condition : both ? std::vector{first, second} : std::vector{first}) {
      (*m)("break when " + condition);
      stepped.wait_for(condition);
    }
    (*m)("break LOOP count 5");
    (*m)("watch 2000-5000 w count 9");
    stepped.count_place(0x106, 5);  // after two LXI
    stepped.count_writes(0x2000, 0x5000, 9);
    for (int n = 0; n < 6; ++n) {
      (*m)("run for 200 instructions");
      stepped.run(200);
      expect_same_place(m->machine(), stepped, fmt::format("seed {}: {}{}", seed, first, both ? ", " + second : ""));
    }
  }
}

// A program that does nothing but wait for a key is stopped, whether the monitor is at a terminal or not. `run for` runs on.
TEST(MonitorPdp7, StopsAProgramThatWaitsForAKey) {
  for (const std::optional<std::int64_t> patience : {std::optional<std::int64_t>(), std::optional<std::int64_t>(2)}) {
    auto m = pdp7_session("begin, 700301\n jmp begin\n 700312\n hlt\nbusy, jmp busy\n start begin\n", nullptr, patience);
    const std::string text = (*m)("go");
    EXPECT_NE(text.find("stopped by end of input\nthe program waits for a key, and there is none: `send` types keys"), std::string::npos) << text;
    const std::int64_t second = m->machine().ticks_per_second();
    const std::int64_t then = m->machine().ticks();
    EXPECT_LT(then, 5 * second);
    EXPECT_EQ((*m)("run for 4000ms").find("waits for a key"), std::string::npos);
    EXPECT_GE(m->machine().ticks(), then + 4 * second);
    (*m)("send \"A\"");
    EXPECT_NE((*m)("go begin").find("stopped by halt"), std::string::npos);
    // A program that has read its key and works is not waiting.
    (*m)("d pc busy");
    EXPECT_EQ((*m)("run for 4000ms").find("waits for a key"), std::string::npos);
    EXPECT_FALSE(m->machine().wants_key());
  }
}

// While the clock runs something else may happen; without a terminal the patience ends the run.
TEST(MonitorPdp7, LimitsTheWaitForAKeyWhileTheClockRuns) {
  auto m = pdp7_session("begin, 700044\nwait, 700301\n jmp wait\n 700312\n hlt\n start begin\n", nullptr, 2);
  const std::string text = (*m)("go");
  EXPECT_NE(text.find("the program has only waited for a key for 2 s of its time, and there is none"), std::string::npos) << text;
  const std::int64_t second = m->machine().ticks_per_second();
  EXPECT_GE(m->machine().ticks(), 2 * second);
  EXPECT_LT(m->machine().ticks(), 6 * second);
}

// --- The console keys ---

TEST(MonitorPdp7, StartClearsTheFlagsAndResetDoesNotRun) {
  auto m = pdp7_session("begin, 700406\n 700401\n jmp .-1\n 700042\n hlt\n lac (5\n hlt\n start begin\n");
  Session& s = *m;
  EXPECT_NE(s("c").find("stopped by halt\n00105"), std::string::npos);
  s("assert printer==1; assert ion==1");
  EXPECT_NE(s("reset; c").find("stopped by halt\n00107"), std::string::npos);  // it continues after the HLT
  s("assert printer==0; assert ion==0; assert ac==5");
  EXPECT_NE(s("d pc 105; c").find("stopped by halt\n00107"), std::string::npos);
  EXPECT_NE(s("start").find("stopped by halt\n00105"), std::string::npos);
  EXPECT_NE(s("start 105").find("stopped by halt\n00107"), std::string::npos);
  s("assert printer==0; assert ion==0");
  s("start nowhere", Kind::wrong);
  s("reset now", Kind::wrong);
}

// --- All verbs ---

// One expectation per command: in a session of pdp7_program() with a console, after the lines of `before`, the line has exactly
// this
// answer. Words and addresses follow from the program, times from two or three cycles of 1.75 us per instruction.
struct VerbCase {
  std::string_view verb;
  std::vector<std::string_view> before;
  std::string_view line;
  std::string_view answer;
  Kind kind = Kind::done;
};

constexpr std::string_view at_store = "00106 store+1: dac 110  ; dac place  AC 000003  L 0  MQ 000000  SC 00  0.000007000 s\n";

const std::vector<VerbCase>& verb_cases() {
  static const std::vector<VerbCase> all{
      {"examine", {}, "e 104", "00104 740040  begin+4: hlt  ; hlt\n"},
      {"deposit", {}, "deposit 110 \"dac place\"; e 110", "00110 040110  place: dac 110  ; place,  0\n"},
      {"step", {}, "step 2",
       "00101 begin+1: jms 105  ; jms store  AC 000003  L 0  MQ 000000  SC 00  0.000003500 s\n"
       "00106 store+1: dac 110  ; dac place  AC 000003  L 0  MQ 000000  SC 00  0.000007000 s\n"},
      {"next", {"step"}, "next", "00102 begin+2: lac 112  ; lac (5  AC 000003  L 0  MQ 000000  SC 00  0.000014000 s\n"},
      {"out", {"step 2"}, "out", "00102 begin+2: lac 112  ; lac (5  AC 000003  L 0  MQ 000000  SC 00  0.000014000 s\n"},
      {"cycle", {"step"}, "cycle 2", at_store},
      {"continue", {"break store+1"}, "continue", "breakpoint 1\n00106 store+1: dac 110  ; dac place  AC 000003  L 0  MQ 000000  SC 00  0.000007000 s\n"},
      {"go", {"d 200 740040"}, "go 200", "stopped by halt\n00201 place+71: cal  AC 000000  L 0  MQ 000000  SC 00  0.000001750 s\n"},
      {"start", {"d 200 740040", "step"}, "start 200", "stopped by halt\n00201 place+71: cal  AC 000003  L 0  MQ 000000  SC 00  0.000005250 s\n"},
      {"reset", {"step", "d ion 1"}, "reset; show time", "0.000003500 s, 1 instructions\n"},
      {"run", {}, "run until ac==3 && pc>105", "ac==3 && pc>105\n00106 store+1: dac 110  ; dac place  AC 000003  L 0  MQ 000000  SC 00  0.000007000 s\n"},
      {"break", {}, "break store if ac==5 count 2", "breakpoint 1: store if ac==5 count 2\n"},
      {"watch", {}, "watch place w value 5", "breakpoint 1: watch place w value 5\n"},
      {"delete", {"break 100", "break 101"}, "delete 1; show breaks", "2: 101, passed 0 times\n"},
      {"nobreak", {"break 100", "break 101"}, "nobreak; show breaks", "no breakpoints\n"},
      {"history", {"step 3"}, "history 1", "        7000 00106 040110  dac 110            00110=000003 000003 0\n"},
      {"list", {}, "list 103-104", " 00103 100105  begin+3: jms 105  ; jms store\n 00104 740040  begin+4: hlt  ; hlt\n"},
      {"disassemble", {}, "disassemble 103-104", " 00103 100105  begin+3: jms 105  ; jms store\n 00104 740040  begin+4: hlt  ; hlt\n"},
      {"evaluate", {}, "evaluate place+1", "111 = 73. = place+1\n"},
      {"show", {"step 2"}, "show stack", "00106 called from 00101  begin+1: jms 105  ; jms store\n"},
      {"who", {"step 3"}, "who place", "00110: 000003 was written at 0.000008750 s by 00106 store+1: dac 110  ; dac place\n"},
      {"attach", {}, "attach drum FILE", "", Kind::wrong},
      {"detach", {}, "detach drum", "", Kind::wrong},
      {"send", {}, "send \"A\\q\"", "", Kind::wrong},
      {"expect", {}, "expect \"x\"", "", Kind::failed},
      {"assert", {"step"}, "assert ac==3", ""},
      {"back", {"step 3"}, "back", at_store},
      {"save", {"step 2", "save s.snap", "step 2"}, "restore s.snap", at_store},
      {"restore", {}, "restore nowhere", "restore: nowhere: no such file\n", Kind::wrong},
      {"screenshot", {}, "screenshot a.png", "screenshot: this machine has no display or raster board, or its program has not used the display yet\n", Kind::wrong},
      {"trace", {"trace t", "step", "trace off"}, "do t", "", Kind::wrong},
      {"speed", {}, "speed real", "speed: there is no console\n", Kind::wrong},
      {"do", {}, "do commands", "3 = 3.\n"},
      {"help", {}, "help assert", "ass[ert] EXPRESSION\n        fail unless it is true\n"},
      {"quit", {}, "quit", "", Kind::quit},
      {"exit", {}, "exit", "", Kind::quit},
  };
  return all;
}

TEST(MonitorVerbs, EachHasAnExpectation) {
  const std::vector<std::string_view> verbs = live::Monitor::verbs();
  for (const std::string_view verb : verbs) {
    EXPECT_TRUE(std::any_of(verb_cases().begin(), verb_cases().end(), [verb](const VerbCase& each) { return each.verb == verb; }))
        << "no case for " << verb;
    EXPECT_TRUE(live::Monitor::is_command(verb));
  }
  EXPECT_FALSE(live::Monitor::is_command("nonsense 1"));
  for (const VerbCase& each : verb_cases()) {
    EXPECT_TRUE(std::find(verbs.begin(), verbs.end(), each.verb) != verbs.end()) << each.verb;
    auto session = pdp7_program();
    session->files["commands"] = "# once\nevaluate 1+2\n";
    for (const std::string_view line : each.before) (*session)(line);
    const std::string answer = (*session)(each.line, each.kind);
    if (!each.answer.empty() || each.kind == Kind::done) {
      EXPECT_EQ(answer, each.answer) << each.line;
    }
  }
}

TEST(MonitorVerbs, InstructionsAreTypedInTheDialectOfTheProgram) {
  auto m = pdp7_program();
  Session& s = *m;
  s("d 200 \"lac 20 i\"");  // octal
  EXPECT_EQ(s("e 200"), "00200 220020  place+70: lac i 20\n");
  s.monitor().set_dialect("bell");
  s("d 200 \"lac 20 i\"");               // decimal; indirect
  EXPECT_EQ(s("e 200"), "00200 220024  place+70: lac i 24\n");
  s("d 200 \"-1; lac place+010; <ab>\"");
  EXPECT_EQ(s("ev [200]"), "777777 = 262143. = -1. as a word with a sign\n");
  EXPECT_EQ(s("ev [201]").substr(0, 6), "200120");
  EXPECT_EQ(s("ev [202]").substr(0, 6), "141142");
  s("d 200 \"LAC 5\"", Kind::wrong);
  auto z = i8080_program();
  (*z)("d 200 \"NOP ! HLT\"");
  EXPECT_EQ((*z)("ev [201]").substr(0, 2), "76");
  z->monitor().set_dialect("m80");
  (*z)("d 200 \"NOP ! HLT\"", Kind::wrong);
}

// Each error says what was found and what is expected, and has no effect.
TEST(MonitorVerbs, WrongArgumentsAreErrors) {
  const std::vector<std::pair<std::string_view, std::string_view>> pdp7{
      {"deposit 100 \"", "deposit: found \" without a \" at its end"},
      {"deposit 100 lac i 10", "an instruction must be in quotes"},
      {"deposit 100 1000000", "found 1000000, expected a word of 18 bits"},
      {"deposit l 2", "found 2 for L"},
      {"examine 103-100", "the smaller address first"},
      {"examine 20000", "expected one in core, 00000-17777"},
      {"step x", "found \"x\", expected a count, decimal"},
      {"run for 5", "expected a time such as 20ms, N cycles or N instructions"},
      {"break interrupt x", "found \"x\" behind interrupt"},
      {"break 100 junk", "found \"junk\" behind 100, expected if, count or log \"TEXT\""},
      {"break store log x", "found \"log x\" behind store"},
      {"break store log", "found \"log\" behind store"},
      {"watch place w junk", "found \"junk\", expected value, if, count or log \"TEXT\""},
      {"break 100 if", "expected an expression behind `if`"},
      {"break 100 count 0", "found count 0, expected 1 or more"},
      {"break 100 count =>3", "found \"=>3\", expected a decimal count: 3 or %3"},
      {"break 100 log \"\"", "expected log \"TEXT\" with a text"},
      {"break 100 log \"{\"", "found { alone, expected an expression in braces"},
      {"break 100 log \"{nobody}\"", "found \"nobody\""},
      {"break 100 \"text\"", "found \"text\", expected log before a text in quotes"},
      {"break disk", "show conditions and show symbols list them"},
      {"watch port 100", "found device 100, expected 0 to 000077"},
      {"watch place x", "found \"x\", expected r, w, rw, value, if, count or log"},
      {"send", "expected \"KEYS\""},
      {"send a b", "found b after the keys, expected one text"},
      {"expect", "expected \"TEXT\" or \"TEXT\" within TIME"},
      {"reset 5", "expected no arguments"},
      {"send \"x", "found \"x without a \" at its end"},
      {"do", "expected a file of commands"},
      {"quit now", "expected no arguments"},
      {"continue 100", "expected no arguments"},
      {"delete 7", "there is no breakpoint 7; show breaks lists them"},
      {"back 1", "the past reaches no further"},
      {"trace off", "no trace is being written"}};
  for (const auto& [line, complaint] : pdp7) {
    auto m = pdp7_program();
    const std::string answer = (*m)(line, Kind::wrong);
    EXPECT_NE(answer.find(complaint), std::string::npos) << line << ": " << answer;
    EXPECT_EQ(m->machine().instructions(), 0U);
    EXPECT_EQ(m->machine().word(0100), pdp7_program()->machine().word(0100)) << line;
  }
  auto z = i8080_program();
  EXPECT_NE((*z)("deposit 100 ff", Kind::wrong).find("a number begins with a digit, 0ff"), std::string::npos);
  EXPECT_NE((*z)("watch port 100", Kind::wrong).find("found port 100, expected 0 to FF"), std::string::npos);
  EXPECT_NE((*z)("deposit hl 10000", Kind::wrong).find("expected 0 to FFFF"), std::string::npos);
}

TEST(MonitorVerbs, ACommentEndsTheLine) {
  auto m = pdp7_program();
  Session& s = *m;
  EXPECT_EQ(s("evaluate 1 # one; evaluate 2"), "1 = 1.\n");
  EXPECT_EQ(s("# evaluate 1; evaluate 2"), "");
  EXPECT_EQ(s("evaluate 1;# \"nothing"), "1 = 1.\n");
}

// An open trace is written when the next one begins and when the session ends.
TEST(MonitorVerbs, NoTraceIsLost) {
  auto m = pdp7_program();
  Session& s = *m;
  s("trace a; step 2; trace b; step; quit", Kind::quit);
  EXPECT_EQ(lines_of(s.files["a"]).size(), 2U);
  EXPECT_EQ(s.files["b"], "");  // opened: `trace` reports one that cannot be written
  EXPECT_EQ(s.monitor().finish().kind, Kind::done);
  EXPECT_EQ(s.files["b"], "        7000 00106 040110  dac 110            00110=000003 000003 0\n");
}

// BC, DE, HL and AF; no other two register letters form a name. The machine has no separate register AF.
TEST(MonitorI8080, PairsAreNames) {
  auto m = i8080_session("BEGIN: INR B\n INX H\n ADD L\n JMP BEGIN\n");
  Session& s = *m;
  EXPECT_EQ(s("deposit hl 1234; examine hl; examine h; examine l"), "HL 1234\nH 12\nL 34\n");
  EXPECT_EQ(s("deposit de 0; deposit bc 0FFFF; evaluate bc+de").substr(0, 4), "FFFF");
  for (const std::string_view name : {"ff", "aa", "fb", "cd", "lh", "ba"}) s("evaluate " + std::string(name), Kind::wrong);
  s("deposit hl 0; deposit b 0; deposit a 0");
  // A is 1, 3, 6, 0A, 0F: even parity at 3, 6, 0A and 0F; F has bit 1, and bit 4 after a carry out of bit 3.
  EXPECT_NE(s("run until af==306").find("af==306"), std::string::npos);
  EXPECT_EQ(s("evaluate a").substr(0, 1), "3");
  EXPECT_EQ(s("evaluate l").substr(0, 1), "2");
  s("break when af==606; run for 100 instructions");
  EXPECT_EQ(s("evaluate l").substr(0, 1), "3");
}

TEST(MonitorRadix, AppliesToNumbersTypedAndShown) {
  auto m = pdp7_program();
  Session& s = *m;
  s.monitor().set_radix(16);
  EXPECT_EQ(s("d 48 1F; e 48").substr(0, 10), "0048 0001F");
  s.monitor().set_radix(10);
  EXPECT_EQ(s("d 72 19; e 72").substr(0, 5), "72 19");
  EXPECT_EQ(s("ev 19+1").substr(0, 3), "20.");
}

// --- Lines of any bytes ---

TEST(MonitorLines, WithAnyBytesAreAnswered) {
  auto m = pdp7_program();
  Session& s = *m;
  s.most_slices = 0;  // runs may have no end
  const std::vector<std::string> words{"e",  "d",    "s",    "b",     "watch", "h",  "l",  "ev",  "show", "who", "(",
                                       ")",  "[",    "]",    "100",   "-",     "+",  "ac", "if",  "count", "\"", "value",
                                       ";",  "port", "iot",  "when",  "del",   "==", "/",  "0",   "777777", "trace", "send",
                                       "go", "\377", "cycle", "assert", "interrupt", "attach", "run", "for", "1us", "until"};
  std::mt19937 engine(20261123);
  const auto below = [&engine](std::size_t n) { return engine() % n; };
  for (int round = 0; round < tests::effort(2000, 300); ++round) {
    std::string line;
    for (std::size_t n = below(8); n > 0; --n) {
      line += words[below(words.size())];
      if (below(4) != 0) line += ' ';
      if (below(20) == 0) line += static_cast<char>(below(256));
    }
    static_cast<void>(s.monitor().execute(line));
  }
}

}  // namespace
}  // namespace sightline::test
