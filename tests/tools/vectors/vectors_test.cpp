// The vectors of the 8080: what is written for the cases and programs of the gate-level model is what that model does; the machine's
// engines, which share no bus with the pins, end every case in its final state; and the files are complete.
#include "tools/vectors/vectors.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "emulators/machines/i8080.hpp"
#include "tests/emulators/i8080/gate_level_data.hpp"
#include "tests/support/effort.hpp"

namespace sightline {
namespace {

using nlohmann::json;
using tests::hexadecimal;

// --- The gate-level model ---

// Its cases have no INTE pin: the fifth and sixth flag are left out.
TEST(I8080Vectors, EveryCaseOfTheGateLevelModelIsWrittenAsItRan) {
  const auto cases = tests::read_cases();
  ASSERT_EQ(cases.size(), 256U * 20U);
  for (const tests::Case& expected : cases) {
    SCOPED_TRACE(expected.name);
    std::map<i8080::Address, i8080::Byte> before, after;
    for (const tests::Cell& cell : expected.memory_before) before[static_cast<i8080::Address>(cell.address)] = static_cast<i8080::Byte>(cell.byte);
    for (const tests::Cell& cell : expected.memory_after) after[static_cast<i8080::Address>(cell.address)] = static_cast<i8080::Byte>(cell.byte);
    vectors::Start start{expected.initial, [&before](i8080::Address address) {
                           const auto found = before.find(address);
                           return found == before.end() ? i8080::Byte{0} : found->second;
                         }};
    std::vector<std::string> statuses;
    for (const std::string& transfer : expected.transfers) {
      if (transfer[0] == 'I') start.input = static_cast<i8080::Byte>(std::stoul(transfer.substr(7, 2), nullptr, 16));
      statuses.push_back(transfer.substr(2, 4) + ' ' + transfer.substr(10, 2));
    }
    const json written = json::parse(vectors::run_case(expected.name, start).dump());

    std::vector<std::string> rows, expected_rows, begun;
    ASSERT_EQ(written.at("cycles").size(), written.at("pins").size());
    for (std::size_t i = 0; i < written.at("cycles").size(); ++i) {
      const json& row = written.at("cycles").at(i);
      std::string flags = written.at("pins").at(i).get<std::string>().substr(0, 4);
      if (flags[3] == 'a') flags[3] = 'W';
      rows.push_back((row.at(0).is_null() ? std::string("--") : hexadecimal(row.at(0), 4)) + ' ' +
                     (row.at(1).is_null() ? std::string("--") : hexadecimal(row.at(1), 2)) + ' ' + flags);
      if (flags[0] == 's') {
        begun.push_back(hexadecimal(row.at(0), 4) + ' ' + hexadecimal(row.at(2), 2));
        EXPECT_EQ(row.at(1), row.at(2));
      }
    }
    for (const std::string& row : expected.rows) expected_rows.push_back(row.substr(2));  // without the number of the T-state
    EXPECT_EQ(rows, expected_rows);
    if (expected.halts) begun.pop_back();  // the halt cycle transfers nothing
    EXPECT_EQ(begun, statuses);

    const json& end = written.at("final");
    const i8080::State& state = expected.final;
    const std::array<std::pair<const char*, unsigned>, 10> registers{{{"pc", state.pc}, {"sp", state.sp}, {"a", state.a}, {"f", state.f},
                                                                      {"b", i8080::high(state.bc)}, {"c", i8080::low(state.bc)}, {"d", i8080::high(state.de)},
                                                                      {"e", i8080::low(state.de)}, {"h", i8080::high(state.hl)}, {"l", i8080::low(state.hl)}}};
    for (const auto& [name, value] : registers) EXPECT_EQ(end.at(name), value) << name;
    const std::string opcode = expected.name.substr(0, 2);
    // The pin INTE changes in the next T-state; the vectors have what the instruction decides.
    EXPECT_EQ(end.at("inte"), opcode == "fb" ? 1 : opcode == "f3" ? 0 : state.interrupts_on ? 1 : 0);
    EXPECT_EQ(end.at("halted"), expected.halts ? 1 : 0);
    for (const json& cell : end.at("ram")) EXPECT_EQ(cell.at(1), after[cell.at(0).get<i8080::Address>()]);
    for (const auto& [address, byte] : after) {
      if (before[address] == byte) continue;
      bool named = false;
      for (const json& cell : end.at("ram")) named = named || cell.at(0) == address;
      EXPECT_TRUE(named) << address;
    }
    if (HasFailure()) return;
  }
}

TEST(I8080Vectors, EveryProgramOfTheGateLevelModelIsWrittenAsItRan) {
  int hung = 0;
  const auto programs = tests::read_programs();
  ASSERT_EQ(programs.size(), 100U);
  for (const tests::Program& program : programs) {
    SCOPED_TRACE(program.header[1]);
    const std::uint64_t salt = tests::value_of(program.header, "salt", 10);
    const std::uint64_t bias = tests::value_of(program.header, "bias", 10);
    vectors::Start start{tests::initial_state(program), [&](i8080::Address address) { return tests::memory_byte(address, salt, bias); }};
    start.input = static_cast<i8080::Byte>(tests::value_of(program.header, "in"));
    start.vector = static_cast<i8080::Byte>(tests::value_of(program.header, "vec"));
    for (const tests::Fields& row : program.rows) start.inputs.push_back({row[0][0] == '1', row[0][1] == '1', row[0][2] == '1'});
    const json written = json::parse(vectors::run_case("program", start, program.rows.size()).dump());
    ASSERT_GE(written.at("cycles").size(), program.rows.size());
    ASSERT_EQ(written.at("cycles").size(), written.at("pins").size());
    ASSERT_EQ(written.at("cycles").size(), written.at("inputs").size());
    for (std::size_t i = 0; i < program.rows.size(); ++i) {
      const json& row = written.at("cycles").at(i);
      const tests::Fields& expected = program.rows[i];
      std::string flags = written.at("pins").at(i);
      if (tests::model_hangs(program, flags[0] == 's', i)) {
        ++hung;
        break;
      }
      for (std::size_t n = 0; n < flags.size(); ++n)
        if (flags[n] != '-') flags[n] = "SDWwHE"[n];
      ASSERT_EQ(flags, expected[4]) << "T-state " << i;
      ASSERT_EQ(hexadecimal(row.at(2), 2), expected[5]) << "T-state " << i;
      const bool held = expected[1] == "-" || expected[4][4] == 'H';
      ASSERT_EQ(row.at(0).is_null(), held || expected[1] == "T4" || expected[1] == "T5") << "T-state " << i;
      if (!row.at(0).is_null()) { ASSERT_EQ(hexadecimal(row.at(0), 4), expected[2]) << "T-state " << i; }
      ASSERT_EQ(row.at(1).is_null(), held || expected[3].back() == 'z') << "T-state " << i;
      if (!row.at(1).is_null()) { ASSERT_EQ(hexadecimal(row.at(1), 2), expected[3].substr(0, 2)) << "T-state " << i; }
      const json& inputs = written.at("inputs").at(i);
      ASSERT_EQ(expected[0], std::to_string(inputs.at(0).get<int>()) + std::to_string(inputs.at(1).get<int>()) + std::to_string(inputs.at(2).get<int>()));
    }
  }
  EXPECT_EQ(hung, 31);  // as in pins_test.cpp
}

// --- The files ---

i8080::State state_in(const json& from) {
  const auto byte = [&from](const char* name) { return from.at(name).get<i8080::Byte>(); };
  i8080::State state;
  state.pc = from.at("pc");
  state.sp = from.at("sp");
  state.a = byte("a");
  state.f = byte("f");
  state.bc = i8080::joined(byte("b"), byte("c"));
  state.de = i8080::joined(byte("d"), byte("e"));
  state.hl = i8080::joined(byte("h"), byte("l"));
  state.interrupts_on = from.at("inte") == 1;
  state.deferred = from.at("ei") == 1;
  state.halted = from.at("halted") == 1;
  return state;
}

struct Ports final : core::PortDevice {
  explicit Ports(const json& all) : expected(all) {}
  std::uint8_t in(std::uint8_t port, core::TStateInstant) override {
    EXPECT_LT(used, expected.size());
    EXPECT_EQ(expected.at(used).at(0), port);
    EXPECT_EQ(expected.at(used).at(2), "r");
    return expected.at(used++).at(1);
  }
  void out(std::uint8_t port, std::uint8_t byte, core::TStateInstant) override {
    EXPECT_LT(used, expected.size());
    EXPECT_EQ(expected.at(used++), json::array({port, byte, "w"}));
  }
  const json& expected;
  std::size_t used = 0;
};

// A case that leaves the pins alone, on an engine of the machine.
void run_on_an_engine(const json& one, bool fast) {
  static const json no_ports = json::array();
  i8080::Machine machine;
  Ports ports(one.contains("ports") ? one.at("ports") : no_ports);
  machine.put_before({0, 0xFF}, ports);
  for (const json& cell : one.at("initial").at("ram")) machine.deposit(cell.at(0), cell.at(1));
  machine.registers() = state_in(one.at("initial"));
  if (fast) machine.run({1, core::never_t});
  else machine.run_plainly({1, core::never_t});
  i8080::State expected = state_in(one.at("final"));
  expected.deferred = machine.registers().deferred;  // until the next boundary
  EXPECT_EQ(machine.registers(), expected);
  EXPECT_EQ(core::t_states_of(machine.now()), static_cast<std::int64_t>(one.at("cycles").size()));
  EXPECT_EQ(ports.used, ports.expected.size());
  for (const json& cell : one.at("final").at("ram")) EXPECT_EQ(machine.memory()[cell.at(0).get<std::size_t>()], cell.at(1));
}

std::set<std::string> keys_of(const json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

void expect_byte(const json& value) {
  ASSERT_TRUE(value.is_number_unsigned());
  ASSERT_LE(value, 255);
}

// Members, ranges, and what the bus says about memory: reads give what is in `ram`, writes are in the final `ram`.
void expect_well_formed(const json& one, bool with_inputs) {
  std::set<std::string> keys{"name", "initial", "final", "cycles", "pins"};
  if (with_inputs) keys.merge(std::set<std::string>{"inputs", "vector"});
  std::set<std::string> found = keys_of(one);
  found.erase("ports");
  ASSERT_EQ(found, keys);
  std::map<unsigned, unsigned> memory, last;
  for (const char* const part : {"initial", "final"}) {
    const json& state = one.at(part);
    ASSERT_EQ(keys_of(state), (std::set<std::string>{"pc", "sp", "a", "b", "c", "d", "e", "f", "h", "l", "inte", "ei", "halted", "ram"}));
    for (const char* const pair : {"pc", "sp"}) ASSERT_LE(state.at(pair), 65535);
    for (const char* const byte : {"a", "b", "c", "d", "e", "f", "h", "l"}) expect_byte(state.at(byte));
    ASSERT_EQ(state.at("f").get<unsigned>() & 0x2AU, 0x02U);
    for (const char* const bit : {"inte", "ei", "halted"}) ASSERT_LE(state.at(bit), 1);
    auto& cells = part == std::string("initial") ? memory : last;
    for (const json& cell : state.at("ram")) {
      ASSERT_EQ(cell.size(), 2U);
      ASSERT_LE(cell.at(0), 65535);
      expect_byte(cell.at(1));
      ASSERT_TRUE(cells.emplace(cell.at(0), cell.at(1)).second);
    }
  }
  ASSERT_GE(one.at("cycles").size(), 4U);
  std::size_t n = 0;
  for (const json& row : one.at("cycles")) {
    ASSERT_EQ(row.size(), 3U);
    if (!row.at(0).is_null()) { ASSERT_LE(row.at(0), 65535); }
    if (!row.at(1).is_null()) expect_byte(row.at(1));
    expect_byte(row.at(2));
    const std::string pins = one.at("pins").at(n);
    ASSERT_EQ(pins.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) ASSERT_TRUE(pins[i] == '-' || pins[i] == "sdwahe"[i]) << pins;
    const unsigned status = row.at(2);
    if (pins[1] == 'd' && (status & 0x80U) != 0) {
      ASSERT_EQ(memory.at(row.at(0)), row.at(1).get<unsigned>()) << "T-state " << n;
    }
    if (pins[2] == 'w' && (status & 0x10U) == 0 && !row.at(0).is_null()) memory.at(row.at(0)) = row.at(1);
    ++n;
  }
  ASSERT_EQ(memory, last);
  ASSERT_EQ(one.at("pins").size(), n);
  if (with_inputs) { ASSERT_EQ(one.at("inputs").size(), one.at("cycles").size()); }
}

std::filesystem::path folder_of(const std::string& options, const std::string& name) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("sightline-vectors-" + name + std::to_string(::getpid()));
  EXPECT_EQ(std::system(("'" SIGHTLINE_VECTORS "' '" + folder.string() + "' " + options).c_str()), 0);
  return folder;
}

std::string text_in(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_TRUE(file) << path;
  return text.str();
}

TEST(I8080Vectors, TheFilesAreCompleteAndTheEnginesPassThem) {
  const auto cases = static_cast<std::size_t>(tests::effort(100, 4));
  const auto folder = folder_of("--cases " + std::to_string(cases), "whole");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& each : std::filesystem::directory_iterator(folder)) ++files;
  EXPECT_EQ(files, 256U + 4U + 1U);
  EXPECT_EQ(json::parse(text_in(folder / "metadata.json")).at("cases"), cases);
  for (unsigned opcode = 0; opcode < 256; ++opcode) {
    std::string name = hexadecimal(opcode, 2);
    SCOPED_TRACE(name);
    std::string file = name + ".json";
    for (char& c : file) c = static_cast<char>(std::tolower(c));
    const json all = json::parse(text_in(folder / file));
    ASSERT_EQ(all.size(), cases);
    std::size_t n = 0;
    for (const json& one : all) {
      std::string number = std::to_string(n++);
      number.insert(0, 4 - number.size(), '0');
      ASSERT_EQ(one.at("name"), name + " " + number);
      ASSERT_NO_FATAL_FAILURE(expect_well_formed(one, false)) << one;
      // The first byte that is fetched is the opcode.
      const json& fetch = one.at("cycles").at(1);
      ASSERT_EQ(fetch, json::array({one.at("initial").at("pc"), opcode, 0xA2}));
      ASSERT_EQ(one.at("pins").at(1), one.at("initial").at("inte") == 1 ? "-d---e" : "-d----");
      for (const bool fast : {true, false}) run_on_an_engine(one, fast);
      if (HasFailure()) {
        ADD_FAILURE() << one;
        return;
      }
    }
  }
  for (const char* const name : {"int", "ready", "hold", "pins"}) {
    SCOPED_TRACE(name);
    const json all = json::parse(text_in(folder / (std::string(name) + ".json")));
    ASSERT_EQ(all.size(), 10 * cases);
    std::size_t acknowledged = 0, waiting = 0, held = 0;
    std::set<unsigned> opcodes;
    for (const json& one : all) {
      ASSERT_NO_FATAL_FAILURE(expect_well_formed(one, true)) << one;
      for (std::size_t i = 0; i < one.at("cycles").size(); ++i) {
        const json& row = one.at("cycles").at(i);
        const std::string pins = one.at("pins").at(i);
        acknowledged += pins[0] == 's' && (row.at(2).get<unsigned>() & 1U) != 0 ? 1 : 0;
        waiting += pins[3] == 'a' ? 1 : 0;
        held += pins[4] == 'h' ? 1 : 0;
        if (pins[1] == 'd' && row.at(2) == 0xA2) opcodes.insert(row.at(1).get<unsigned>());
      }
    }
    const bool any = std::string(name) == "pins";
    EXPECT_EQ(acknowledged > 0, any || std::string(name) == "int");
    EXPECT_EQ(held > 0, any || std::string(name) == "hold");
    EXPECT_GT(waiting, 0U);  // also TW of HLT
    if (cases >= 26) { EXPECT_EQ(opcodes.size(), 256U); }
  }
  std::filesystem::remove_all(folder);
}

TEST(I8080Vectors, TheSeedDecidesEveryByte) {
  const auto one = folder_of("--cases 2", "a"), same = folder_of("--cases 2 --seed 1", "b"), other = folder_of("--seed 2 --cases 2", "c");
  for (const char* const file : {"00.json", "27.json", "e3.json", "pins.json"}) {
    EXPECT_EQ(text_in(one / file), text_in(same / file)) << file;
    EXPECT_NE(text_in(one / file), text_in(other / file)) << file;
  }
  for (const auto& folder : {one, same, other}) std::filesystem::remove_all(folder);
}

TEST(I8080Vectors, TheExampleOfTheReadmeIsACase) {
  const std::string readme = text_in(SIGHTLINE_SOURCE_DIR "/tools/vectors/README.md");
  const std::string begin = "```json\n";
  const std::size_t at = readme.find(begin) + begin.size();
  const json example = json::parse(readme.substr(at, readme.find("```", at) - at));
  EXPECT_EQ(example, json::parse(vectors::opcode_cases(0x86, 1, 1).front().dump()));
}

TEST(I8080Vectors, WrongArgumentsAreErrors) {
  const auto exit_code = [](const std::string& arguments) {
    const int status = std::system(("'" SIGHTLINE_VECTORS "' " + arguments + " > /dev/null 2>&1").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  EXPECT_EQ(exit_code("--help"), 0);
  for (const char* const wrong : {"", "a b", "a --cases", "a --cases 0", "a --cases 10001", "a --seed x", "--what", "''"}) EXPECT_EQ(exit_code(wrong), 2) << wrong;
  EXPECT_EQ(exit_code("/dev/null/x --cases 1"), 5);
}

}  // namespace
}  // namespace sightline
