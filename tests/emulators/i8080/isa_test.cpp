// The instruction table compared with the measured timing of all opcodes, and the processor with both, for either outcome of
// a condition.
#include "emulators/i8080/isa.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "tests/emulators/i8080/memory_board.hpp"

namespace sightline {
namespace {

// One line of opcode-timing.csv: op,"mnemonic",bytes,t,t taken,"cycles","cycles taken".
struct Timing {
  unsigned opcode;
  std::string mnemonic;
  int bytes;
  int t_states[2];
  std::string cycles[2];
};

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    else if (c == ',' && !quoted) fields.emplace_back();
    else fields.back() += c;
  }
  return fields;
}

std::vector<Timing> read_timings() {
  std::ifstream file(SIGHTLINE_TEST_DATA "/i8080/opcode-timing.csv");
  std::vector<Timing> timings;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    // The endless TWs of HLT are not counted as cycles.
    if (const auto endless = line.find(" TW.."); endless != std::string::npos) {
      line.erase(endless, 5);
      line.erase(line.find(" TW.."), 5);
    }
    const auto f = split(line);
    timings.push_back({static_cast<unsigned>(std::stoul(f.at(0), nullptr, 16)), f.at(1), std::stoi(f.at(2)),
                       {std::stoi(f.at(3)), std::stoi(f.at(4))}, {f.at(5), f.at(6)}});
  }
  return timings;
}

std::string text_of(const i8080::Cycles& cycles) {
  std::string text;
  for (const auto& cycle : cycles) {
    if (!text.empty()) text += ' ';
    text += "FRWrwIOHx"[static_cast<std::size_t>(cycle.kind)];
    text += std::to_string(cycle.t_states);
  }
  return text;
}

// "MOV B,M" in the notation of the CSV file: upper case, d8 d16 a16 for immediate operands.
std::string operand_text(i8080::Operand operand, unsigned opcode) {
  using enum i8080::Operand;
  const auto upper = [](std::string_view name) {
    std::string text;
    for (const char c : name) text += static_cast<char>(c - 'a' + 'A');
    return text;
  };
  switch (operand) {
    case none: return "";
    case to_register: return upper(i8080::register_names[opcode >> 3 & 7]);
    case from_register: return upper(i8080::register_names[opcode & 7]);
    case memory: return "M";
    case pair:
    case pair_b_d: return upper(i8080::pair_names[opcode >> 4 & 3]);
    case pair_psw: return upper(i8080::psw_pair_names[opcode >> 4 & 3]);
    case restart: return std::to_string(opcode >> 3 & 7);
    case data8:
    case port: return "d8";
    case data16: return "d16";
    case address: return "a16";
  }
  return "?";
}

std::string text_of(const i8080::Instruction& row, unsigned opcode) {
  std::string text = row.duplicate ? "*" : "";
  for (const char c : row.mnemonic) text += static_cast<char>(c - 'a' + 'A');
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string operand = operand_text(row.operands[i], opcode);
    if (!operand.empty()) text += (i == 0 ? " " : ",") + operand;
  }
  return text;
}

TEST(I8080Isa, TheTableEqualsTheMeasurements) {
  const auto timings = read_timings();
  ASSERT_EQ(timings.size(), 256U);
  for (const Timing& timing : timings) {
    const auto& row = i8080::lookup(static_cast<i8080::Byte>(timing.opcode));
    EXPECT_EQ(text_of(row, timing.opcode), timing.mnemonic) << timing.opcode;
    EXPECT_EQ(row.bytes(), timing.bytes) << timing.mnemonic;
    EXPECT_EQ(row.cycles.t_states(), timing.t_states[0]) << timing.mnemonic;
    EXPECT_EQ(row.taken.t_states(), timing.t_states[1]) << timing.mnemonic;
    EXPECT_EQ(text_of(row.cycles), timing.cycles[0]) << timing.mnemonic;
    EXPECT_EQ(text_of(row.taken), timing.cycles[1]) << timing.mnemonic;
  }
}

// The machine cycles that one instruction with these flags uses, seen at the pins alone.
std::string cycles_used(unsigned opcode, i8080::Byte flags) {
  const auto board = std::make_unique<tests::MemoryBoard>();
  board->memory[0x1000] = static_cast<i8080::Byte>(opcode);
  i8080::State state;
  state.pc = 0x1000;
  state.sp = 0x8000;
  state.f = flags;
  i8080::PinMachine machine(*board, state);
  machine.step();
  std::string text;
  for (const auto& row : board->rows) {
    if (row.state == i8080::TState::t1) {
      const auto kind = [&] {
        if (!row.sync) return 'x';
        switch (row.status) {
          case 0xA2: return 'F';
          case 0x82: return 'R';
          case 0x00: return 'W';
          case 0x86: return 'r';
          case 0x04: return 'w';
          case 0x42: return 'I';
          case 0x10: return 'O';
          case 0x8A: return 'H';
          default: return '?';
        }
      }();
      if (!text.empty()) text += ' ';
      text += {kind, '1'};
    } else {
      ++text.back();
    }
  }
  return text;
}

// Flags that make the condition in bits 5-3 false or true.
i8080::Byte flags_for(unsigned opcode, bool holds) {
  constexpr std::array<i8080::Byte, 4> tested{0x40, 0x01, 0x04, 0x80};
  const bool wants_one = (opcode >> 3 & 1) != 0;
  return holds == wants_one ? tested[opcode >> 4 & 3] : i8080::Byte{0};
}

TEST(I8080Isa, TheProcessorTakesTheMeasuredCycles) {
  for (const Timing& timing : read_timings()) {
    EXPECT_EQ(cycles_used(timing.opcode, flags_for(timing.opcode, false)), timing.cycles[0]) << timing.mnemonic;
    EXPECT_EQ(cycles_used(timing.opcode, flags_for(timing.opcode, true)), timing.cycles[1]) << timing.mnemonic;
  }
}

}  // namespace
}  // namespace sightline
