// Every instruction row compared with its hand-written bus transcript: time, verb, address and data of every cycle.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "emulators/machines/pdp7.hpp"
#include "emulators/pdp7/isa.hpp"
#include "emulators/pdp7/teletype.hpp"
#include "tests/emulators/machines/fake_display.hpp"
#include "tests/emulators/machines/recording_observer.hpp"
#include "tests/emulators/machines/transcript.hpp"

namespace sightline {
namespace {

using tests::TranscriptCase;
using pdp7::Machine;

const std::vector<TranscriptCase>& all_cases() {
  static const std::vector<TranscriptCase> cases =
      tests::read_transcripts(SIGHTLINE_TEST_DATA "/transcripts/pdp7");
  return cases;
}

std::string text_of(const pdp7::Cycle& cycle) {
  // Transcripts use one verb for all cycles that read, and one for all that write.
  static constexpr const char* names[] = {"read", "read", "write",      "modify",      "write",
                                          "iot",  "idle", "break_read", "break_write", "break_modify"};
  std::ostringstream out;
  out << core::nanoseconds_of(cycle.time) << ' ' << names[static_cast<int>(cycle.verb)] << ' ';
  if (cycle.verb == pdp7::Verb::idle) {
    out << cycle.length.count();
  } else {
    out << std::oct << cycle.address << ' ';
    out.width(6);
    out.fill('0');
    out << cycle.data.value();
  }
  return out.str();
}

pdp7::Options options_for(const TranscriptCase& c) {
  pdp7::Options options;
  for (const std::string& option : c.options) {
    if (option == "no-eae") options.model.eae = false;
    if (option == "trap") options.model.trap_mode = true;
    if (option == "strict") options.model.strict = true;
    if (option == "extend") options.core_words = 16384;
  }
  return options;
}

// Lets time pass in a one-instruction loop at the top of the first bank.
void wait_until(Machine& machine, std::int64_t ns) {
  machine.deposit(017700, core::Word18(0617700));
  machine.registers().pc = 017700;
  machine.run({static_cast<std::uint64_t>(ns / 1750), core::never});
  ASSERT_EQ(core::nanoseconds_of(machine.now()), ns);
}

void prepare(Machine& machine, const TranscriptCase& c) {
  for (const std::string& option : c.options) {
    std::istringstream words(option);
    std::string name;
    std::int64_t number = 0;
    words >> name;
    if (name == "from" && words >> number) wait_until(machine, number);
    if (name == "key") machine.find<pdp7::Keyboard>()->press(core::at_nanoseconds(-100'000'000), 0101);
    if ((name == "display" || name == "deposits") && words >> number) {
      std::string address;
      words >> address;
      auto display = std::make_unique<tests::FakeDisplay>(core::Duration(number), name == "deposits");
      display->load_address_and_start(machine.now(), core::Word18(tests::octal(address)));
      ASSERT_EQ(machine.attach(tests::FakeDisplay::info, std::move(display)), "");
    }
  }
  for (const auto& [address, word] : c.core) machine.deposit(address, core::Word18(word));
  pdp7::State& state = machine.registers();
  state.pc = 0100;
  for (const auto& [name, value] : c.set) {
    if (name == "AC") state.ac = core::Word18(value);
    if (name == "MQ") state.mq = core::Word18(value);
    if (name == "SC") state.sc = core::Word<6>(value);
    if (name == "PC") state.pc = value;
    if (name == "L") state.link = value != 0;
    if (name == "EXTEND") state.extend = value != 0;
    if (name == "SR") machine.console().set(core::Word18(value));
  }
}

std::uint32_t register_of(const pdp7::State& state, const std::string& name) {
  if (name == "AC") return state.ac.value();
  if (name == "MQ") return state.mq.value();
  if (name == "SC") return state.sc.value();
  if (name == "PC") return state.pc;
  if (name == "L") return state.link ? 1 : 0;
  if (name == "ION") return state.interrupts_on ? 1 : 0;
  if (name == "EXTEND") return state.extend ? 1 : 0;
  ADD_FAILURE() << "no register " << name;
  return 0;
}

TEST(Pdp7Transcripts, EveryCaseMatchesCycleByCycle) {
  for (const TranscriptCase& c : all_cases()) {
    SCOPED_TRACE(c.file + ": " + c.name);
    tests::RecordingObserver observer;
    Machine machine(options_for(c));
    prepare(machine, c);
    machine.run({c.run, core::never}, observer);
    std::vector<std::string> seen;
    for (const auto& event : observer.events) seen.push_back(text_of(event));
    EXPECT_EQ(seen, c.events);
    EXPECT_FALSE(c.end.empty());
    for (const auto& [name, value] : c.end) EXPECT_EQ(register_of(machine.registers(), name), value) << name;
    for (const bool fast : {true, false}) {
      Machine other(options_for(c));
      prepare(other, c);
      if (fast) other.run({c.run, core::never});
      else other.run_plainly({c.run, core::never});
      EXPECT_EQ(other.registers(), machine.registers()) << (fast ? "fast engine" : "plain loop");
      EXPECT_EQ(other.now(), machine.now());
      EXPECT_TRUE(std::equal(other.core().begin(), other.core().end(), machine.core().begin(), machine.core().end()));
    }
  }
}

TEST(Pdp7Vectors, EachEngineGivesTheResultsOfAnotherSimulator) {
  std::ifstream in(SIGHTLINE_TEST_DATA "/pdp7/instruction-vectors.csv");
  ASSERT_TRUE(in);
  int cases = 0;
  Machine fast;
  Machine plain;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    std::string name;
    std::getline(fields, name, ',');
    std::vector<std::uint32_t> v;
    for (std::string field; std::getline(fields, field, ',');) v.push_back(static_cast<std::uint32_t>(std::stoul(field, nullptr, 8)));
    ASSERT_EQ(v.size(), 10U) << line;
    for (Machine* const machine : {&fast, &plain}) {
      machine->console().set(core::Word18(0707070));
      machine->load(0100, {v[0], v[4]});
      machine->registers() = {.ac = core::Word18(v[1]), .mq = core::Word18(v[2]), .sc = core::Word<6>(025), .pc = 0100, .link = v[3] != 0};
      if (machine == &fast) machine->run({1, core::never});
      else machine->run_plainly({1, core::never});
      const pdp7::State& after = machine->registers();
      const std::vector<std::uint32_t> got{after.ac.value(), after.mq.value(), after.link ? 1U : 0U, after.sc.value(), after.pc};
      ASSERT_EQ(got, (std::vector<std::uint32_t>(v.begin() + 5, v.end()))) << line << (machine == &fast ? ": fast engine" : ": plain loop");
    }
    ++cases;
  }
  EXPECT_EQ(cases, 6688);
}

TEST(Pdp7Transcripts, EveryInstructionRowHasATranscript) {
  std::set<std::string> written;
  for (const TranscriptCase& c : all_cases()) written.insert(c.rows.begin(), c.rows.end());
  for (const auto& row : pdp7::instructions) {
    EXPECT_TRUE(written.count(std::string(row.mnemonic)) == 1) << row.mnemonic << " has no transcript";
  }
  for (const std::string& row : written) {
    EXPECT_TRUE(std::any_of(pdp7::instructions.begin(), pdp7::instructions.end(),
                            [&](const pdp7::Instruction& r) { return r.mnemonic == row; }))
        << row << " is not a row";
  }
}

}  // namespace
}  // namespace sightline
