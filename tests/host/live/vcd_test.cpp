// Value change dumps of both machines. Expected instants follow from the manuals: a cycle of the PDP-7 is 1,750 ns, an LAC is a
// fetch and
// an execute; a T-state of the 8080 at 3 MHz is 333.3 ns, MOV takes 5 of them, STA 4+3+3+3.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/host/app/command_line.hpp"

namespace sightline::test {
namespace {

struct Dump {
  std::map<std::string, unsigned> bits;  // by the name of the signal
  // When a signal took a value, as text: "0", "1", "z" or digits after b.
  std::map<std::string, std::vector<std::pair<std::int64_t, std::string>>> changes;

  // The value at an instant; "x" before the first change.
  [[nodiscard]] std::string at(const std::string& signal, std::int64_t time) const {
    std::string value = "x";
    const auto found = changes.find(signal);
    if (found == changes.end()) return value;
    for (const auto& [when, text] : found->second)
      if (when <= time) value = text;
    return value;
  }
};

// Reads a dump by the standard's grammar, as far as Sightline uses it, and checks its rules: instants ascend, each change changes
// the
// value, every identifier is declared, values fit.
Dump parse_dump(const std::string& text) {
  Dump dump;
  std::map<std::string, std::string> names;
  std::istringstream in(text);
  std::int64_t time = -1;
  std::string word;
  int scopes = 0;
  while (in >> word) {
    if (word == "$version" || word == "$timescale" || word == "$scope") {
      if (word == "$scope") ++scopes;
      while (in >> word && word != "$end") {
      }
    } else if (word == "$upscope") {
      --scopes;
      in >> word;
    } else if (word == "$enddefinitions") {
      EXPECT_EQ(scopes, 0);
      in >> word;
    } else if (word == "$var") {
      std::string type, identifier, name, end;
      unsigned bits = 0;
      in >> type >> bits >> identifier >> name >> end;
      EXPECT_EQ(type + end, "wire$end");
      EXPECT_TRUE(names.emplace(identifier, name).second) << identifier;
      dump.bits[name] = bits;
    } else if (word[0] == '#') {
      const std::int64_t next = std::stoll(word.substr(1));
      EXPECT_GT(next, time);
      time = next;
    } else {
      std::string value = word.substr(0, 1);
      std::string identifier = word.substr(1);
      if (value == "b") {
        value = identifier;
        in >> identifier;
      }
      const auto name = names.find(identifier);
      if (name == names.end()) {
        ADD_FAILURE() << "no signal " << identifier;
        break;
      }
      EXPECT_LE(value.size(), dump.bits[name->second]);
      EXPECT_GE(time, 0);
      EXPECT_NE(dump.at(name->second, time), value) << name->second << " at " << time;
      dump.changes[name->second].emplace_back(time, value);
    }
  }
  return dump;
}

class Vcd : public CommandLine {
 protected:
  Dump run(const std::string& machine, const std::string& source, std::vector<std::string> options) {
    const std::string file = machine == "pdp7" ? "p.s" : "p.asm";
    const std::string program = machine == "pdp7" ? "p.rim" : "p.hex";
    write(file, source);
    const Ran made = sightline({"asm", machine, file, "-o", program});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    std::vector<std::string> words{"run", machine, program, "--start", "100", "--vcd", "d.vcd"};
    words.insert(words.end(), options.begin(), options.end());
    const Ran ran = sightline(words);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return parse_dump(read("d.vcd"));
  }
  // Converts the dump by GTKWave's converter.
  void expect_converts() {
    if (std::system("command -v vcd2fst > /dev/null") != 0) GTEST_SKIP() << "vcd2fst (package gtkwave) is not installed";
    const std::string command = "cd '" + path(".").string() + "' && vcd2fst d.vcd d.fst > /dev/null && fst2vcd d.fst > back.vcd";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_NE(read("back.vcd").find("address"), std::string::npos);
  }
};

constexpr std::int64_t cycle = 1750;

// The purpose of each machine cycle from the first on, at its beginning and at its end.
void expect_cycles(const Dump& dump, const std::vector<std::string>& expected) {
  const auto kind = [&dump](std::int64_t time) {
    std::string kinds;
    for (const char* const each : {"fetch", "defer", "execute", "eae", "brk", "tick", "interrupt"})
      if (dump.at(each, time) == "1") kinds += std::string(kinds.empty() ? "" : " ") + each;
    return kinds;
  };
  for (std::size_t n = 0; n < expected.size(); ++n) {
    EXPECT_EQ(kind(static_cast<std::int64_t>(n) * cycle), expected[n]) << n;
    EXPECT_EQ(kind(static_cast<std::int64_t>(n + 1) * cycle - 1), expected[n]) << n;
  }
}

TEST_F(Vcd, Pdp7CyclesHaveTheTimesOfTheManual) {
  // LAC I 200: fetch, defer, execute; DAC 201; ISZ 202; TLS (an IOT); HLT.
  const Dump dump = run("pdp7",
                        "100/\n  lac i 200\n  dac 201\n  isz 202\n  tls\n  hlt\n200/ 300\n  0\n  5\n300/ 123456\n  start 100\n", {});
  expect_cycles(dump, {"fetch", "defer", "execute", "fetch", "execute", "fetch", "execute", "fetch", "fetch"});
  // The defer reads 300 at 200, the execute the word there.
  EXPECT_EQ(dump.at("address", 1 * cycle), "10000000");
  EXPECT_EQ(dump.at("data", 1 * cycle), "11000000");
  EXPECT_EQ(dump.at("address", 2 * cycle), "11000000");
  EXPECT_EQ(dump.at("data", 2 * cycle), "1010011100101110");
  EXPECT_EQ(dump.at("write", 2 * cycle), "0");
  EXPECT_EQ(dump.at("write", 4 * cycle), "1");
  EXPECT_EQ(dump.at("data", 6 * cycle), "110");
  // AC has the word when the LAC ends, not before; PC counts with each instruction.
  EXPECT_EQ(dump.at("ac", 3 * cycle - 1), "x");
  EXPECT_EQ(dump.at("ac", 3 * cycle), "1010011100101110");
  EXPECT_EQ(dump.at("pc", 5 * cycle), "1000010");
  // TLS 700406: device 4, pulses 4 and 2, at the end of its fetch.
  EXPECT_EQ(dump.at("pulses", 8 * cycle - 500), "110");
  EXPECT_EQ(dump.at("device", 8 * cycle - 500), "100");
  EXPECT_EQ(dump.at("pulses", 8 * cycle), "0");
  expect_converts();
}

TEST_F(Vcd, TheTargetOfXctHasASeparateDeferCycle) {
  // XCT I 200 executes LAC I 211 at 210, which loads the word at 212.
  const Dump dump = run("pdp7", "100/\n  xct i 200\n  hlt\n200/ 210\n210/ lac i 211\n212\n5\n  start 100\n", {});
  expect_cycles(dump, {"fetch", "defer", "execute", "defer", "execute", "fetch"});
}

TEST_F(Vcd, Pdp7BreaksAndInterruptsAreSeparateCycles) {
  const Dump dump = run("pdp7",
                        "1/ jmp 200\n100/\n  lac (400\n  700606\n  ion\n  700406\n  jmp .\n200/ hlt\n400/ 003000\n  start 100\n",
                        {"--display"});
  const auto shown = [&dump](const char* signal) {
    const auto found = dump.changes.find(signal);
    return found != dump.changes.end() &&
           std::any_of(found->second.begin(), found->second.end(), [](const auto& change) { return change.second == "1"; });
  };
  EXPECT_TRUE(shown("brk"));
  EXPECT_TRUE(shown("interrupt"));
  EXPECT_TRUE(shown("stop"));
  // The break of the interrupt turns interrupts off, not the instruction after it.
  const auto& breaks = dump.changes.at("interrupt");
  const auto taken = std::find_if(breaks.begin(), breaks.end(), [](const auto& change) { return change.second == "1"; });
  ASSERT_NE(taken, breaks.end());
  EXPECT_EQ(dump.at("ion", taken->first - 1), "1");
  EXPECT_EQ(dump.at("ion", taken->first), "0");
  EXPECT_FALSE(shown("tick"));
  EXPECT_FALSE(shown("pen"));
  expect_converts();
}

TEST_F(Vcd, I8080PinsShowEveryTState) {
  const Dump dump = run("i8080", "  ORG 100H\n  MOV A,B\n  STA 1234H\n  IN 7\n  DAD B\n  HLT\n", {});
  const auto state = [&dump](int t) {
    const std::int64_t time = (static_cast<std::int64_t>(t) * 1000 + 2) / 3;
    return dump.at("t", time) + (dump.at("sync", time) == "1" ? "s" : "") + (dump.at("dbin", time) == "1" ? "d" : "") +
           (dump.at("wr", time) == "1" ? "w" : "") + (dump.at("wait", time) == "1" ? "W" : "");
  };
  const std::vector<std::string> expected{
      "1s", "10d", "11", "100", "101",              // MOV A,B: five T-states
      "1s", "10d", "11", "100",                     // STA: the opcode
      "1s", "10d", "11", "1s", "10d", "11",         // its address
      "1s", "10", "11w",                            // the write
      "1s", "10d", "11", "100",                     // IN 7
      "1s", "10d", "11", "1s", "10d", "11",         // the port's number, the port
      "1s", "10d", "11", "100",                     // DAD B: a fetch, then six T-states inside
      "111", "111", "111", "111", "111", "111",
      "1s", "10d", "11", "100",                     // HLT
      "1s", "10", "110W", "110W"};
  for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_EQ(state(static_cast<int>(n)), expected[n]) << n;
  // During SYNC the data pins have the status: A2 for a fetch, 42 for an input cycle.
  EXPECT_EQ(dump.at("data", 0), "10100010");
  EXPECT_EQ(dump.at("m1", 0), "1");
  EXPECT_EQ(dump.at("address", 25 * 1000 / 3 + 1), "11100000111");
  EXPECT_EQ(dump.at("inp", 25 * 1000 / 3 + 1), "1");
  expect_converts();
}

TEST_F(Vcd, TheLastCycleOfXthlHasFiveTStates) {
  const Dump dump = run("i8080", "  ORG 100H\n  XTHL\n  HLT\n", {});
  // 18 T-states: 4, then reads of 3 and 3, a write of 3 and one of 5.
  std::string states;
  for (int t = 13; t < 18; ++t) {
    const std::int64_t time = (static_cast<std::int64_t>(t) * 1000 + 2) / 3;
    states += dump.at("t", time) + (dump.at("wr", time) == "1" ? "w " : " ");
    EXPECT_EQ(dump.at("wait", time), "0");
  }
  EXPECT_EQ(states, "1 10 11w 100 101 ");
}

// MCS-80 User's Manual, chapter 2: HOLD is sampled in T2. HLDA comes in T3 of a read cycle, and one T-state later after a write
// cycle; the
// processor needs no bus in T4 and T5. The next cycle begins in the T-state after the one in which HOLD is low.
TEST_F(Vcd, HoldTakesTheBusBetweenCycles) {
  const auto state = [](const Dump& dump, int t) {
    const std::int64_t time = (static_cast<std::int64_t>(t) * 1000 + 2) / 3;
    return dump.at("t", time) + (dump.at("sync", time) == "1" ? "s" : "") + (dump.at("dbin", time) == "1" ? "d" : "") +
           (dump.at("wr", time) == "1" ? "w" : "") + (dump.at("hold", time) == "1" ? "H" : "") +
           (dump.at("hlda", time) == "1" ? "A" : "") + (dump.at("address", time) == "z" ? "z" : "");
  };
  // MOV A,B; STA 1234H; HLT. HOLD in the T-states 1 to 8; the first is the fetch's T2.
  const std::string source = "  ORG 100H\n  MOV A,B\n  STA 1234H\n  HLT\n";
  const Dump reading = run("i8080", source, {"--hold", "1+8"});
  const std::vector<std::string> read{"1s",   "10dH", "11HAz", "100HAz", "101HAz", "0HAz", "0HAz", "0HAz", "0HAz", "0Az",
                                      "1s",   "10d",  "11",    "100",    "1s",     "10d",  "11"};
  for (std::size_t n = 0; n < read.size(); ++n) EXPECT_EQ(state(reading, static_cast<int>(n)), read[n]) << n;
  // In T2 of the write, T-state 16: the write's T3, then two T-states for the board.
  const Dump writing = run("i8080", source, {"--hold", "16+3"});
  const std::vector<std::string> written{"1s", "10H", "11wH", "0HAz", "0Az", "1s", "10d", "11", "100", "1s"};
  for (std::size_t n = 0; n < written.size(); ++n) EXPECT_EQ(state(writing, static_cast<int>(n) + 15), written[n]) << n;
  // Too late for a fetch, over before the next T2.
  const Dump missed = run("i8080", source, {"--hold", "2+4"});
  EXPECT_EQ(missed.changes.at("hlda").size(), 1U);
  EXPECT_EQ(missed.changes.at("hold").size(), 3U);
  expect_converts();
}

// The 88-2SIO requests an interrupt when a character has arrived, and withdraws it when the character is read. There are no wait
// states.
TEST_F(Vcd, TheInterruptOfADeviceOfThe8080) {
  write("p.asm",
        "  ORG 38H\n  IN 11H\n  NOP\n  HLT\n  ORG 100H\n  LXI SP,200H\n  MVI A,95H\n  OUT 10H\n  IN 10H\n  EI\nLOOP: JMP LOOP\n");
  ASSERT_EQ(sightline({"asm", "i8080", "p.asm", "-o", "p.hex"}).exit_code, 0);
  ASSERT_EQ(sightline({"run", "i8080", "p.hex", "--start", "100", "--vcd", "d.vcd:int,inta,inte,ready", "--terminal", "2sio",
                       "--interrupt", "2sio=7", "--console", "ascii", "--send", "A"})
                .exit_code,
            0);
  const Dump dump = parse_dump(read("d.vcd"));
  std::string values;
  std::vector<std::int64_t> times;
  for (const auto& [time, value] : dump.changes.at("int")) {
    values += value;
    times.push_back(time);
  }
  ASSERT_EQ(values, "010");
  std::int64_t acknowledged = 0;
  for (const auto& [time, value] : dump.changes.at("inta"))
    if (value == "1") acknowledged = time;
  // The machine polls the board between instructions, and acknowledges at once.
  EXPECT_EQ(acknowledged, times[1]);
  EXPECT_EQ(dump.at("inte", acknowledged - 1), "1");
  EXPECT_EQ(dump.at("inte", acknowledged), "0");
  // The RST takes 11 T-states and the IN 10; in its last one the board withdraws its request.
  EXPECT_EQ((times[2] - acknowledged + 1) / 333, 21);
  EXPECT_EQ(dump.changes.at("ready").size(), 1U);
  EXPECT_EQ(dump.at("ready", 0), "1");
}

TEST_F(Vcd, ADumpWithoutChangesIsOne) {
  static_cast<void>(run("pdp7", "100/ hlt\n  start 100\n", {}));
  ASSERT_EQ(sightline({"run", "pdp7", "p.rim", "--start", "100", "--vcd", "d.vcd:display"}).exit_code, 0);
  const Dump dump = parse_dump(read("d.vcd"));
  EXPECT_EQ(dump.bits.size(), 4U);
  EXPECT_TRUE(read("d.vcd").ends_with("#1750\n")) << read("d.vcd");
}

TEST_F(Vcd, SignalsWithoutAFileAreAnError) {
  write("halt.oct", "100: 740040\n");
  for (const char* const target : {":ac", ":nothing"}) {
    const Ran ran = sightline({"run", "pdp7", "halt.oct", "--start", "100", "--vcd", target});
    EXPECT_EQ(ran.exit_code, 2) << target << ran.err;
  }
}

TEST_F(Vcd, SignalsAreChosenByNameAndGroup) {
  const Dump dump = run("pdp7", "100/ hlt\n  start 100\n", {});
  EXPECT_EQ(dump.bits.size(), 21U);
  ASSERT_EQ(sightline({"run", "pdp7", "p.rim", "--start", "100", "--vcd", "c.vcd:pc,display"}).exit_code, 0);
  const Dump chosen = parse_dump(read("c.vcd"));
  std::string names;
  for (const auto& [name, bits] : chosen.bits) names += name + " ";
  EXPECT_EQ(names, "edge pc pen request stop ");
  const Ran wrong = sightline({"run", "pdp7", "p.rim", "--vcd", "c.vcd:pc,diplay"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("found signal \"diplay\""), std::string::npos) << wrong.err;
  EXPECT_NE(wrong.err.find("did you mean \"display\""), std::string::npos) << wrong.err;
}

TEST_F(Vcd, TheRunIsTheSameWithIt) {
  write("p.s", "100/\nbegin, isz 200\n  jmp begin\n  hlt\n200/ 770000\n  start begin\n");
  ASSERT_EQ(sightline({"asm", "pdp7", "p.s", "-o", "p.rim"}).exit_code, 0);
  const Ran plain = sightline({"run", "pdp7", "p.rim", "--trace", "a"});
  const Ran with = sightline({"run", "pdp7", "p.rim", "--trace", "b", "--vcd", "d.vcd"});
  EXPECT_EQ(plain.out, with.out);
  EXPECT_TRUE(read("a") == read("b"));
}

}  // namespace
}  // namespace sightline::test
