// Every opcode compared with the gate-level model: registers, memory, transfers and each T-state's pins.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "emulators/machines/i8080.hpp"
#include "tests/emulators/i8080/memory_board.hpp"

namespace sightline {
namespace {

struct Cell {
  unsigned address;
  unsigned byte;
};

struct Case {
  std::string name;
  std::size_t t_states = 0;
  bool halts = false;
  i8080::State initial;
  i8080::State final;
  std::vector<Cell> memory_before;
  std::vector<Cell> memory_after;
  std::vector<std::string> rows;       // "T ADDRESS DATA FLAGS", address -- where it is undefined
  std::vector<std::string> transfers;  // "KIND ADDRESS DATA STATUS"
};

i8080::State read_state(std::istream& line, std::vector<Cell>& memory) {
  unsigned pc = 0, sp = 0, a = 0, f = 0, bc = 0, de = 0, hl = 0, inte = 0;
  line >> std::hex >> pc >> sp >> a >> f >> bc >> de >> hl >> inte;
  Cell cell{};
  for (char colon = 0; line >> cell.address >> colon >> cell.byte;) memory.push_back(cell);
  i8080::State state;
  state.pc = static_cast<i8080::Address>(pc);
  state.sp = static_cast<i8080::Address>(sp);
  state.a = static_cast<i8080::Byte>(a);
  state.f = static_cast<i8080::Byte>(f);
  state.bc = static_cast<i8080::Address>(bc);
  state.de = static_cast<i8080::Address>(de);
  state.hl = static_cast<i8080::Address>(hl);
  state.interrupts_on = inte != 0;
  return state;
}

std::vector<Case> read_cases() {
  std::ifstream file(SIGHTLINE_TEST_DATA "/i8080/single-step.txt");
  std::vector<Case> cases;
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    std::string word;
    line >> word;
    if (word == "case") {
      Case& next = cases.emplace_back();
      std::string t, halt;
      line >> next.name >> t >> halt;
      next.t_states = std::stoul(t.substr(2));
      next.halts = halt == "halt=1";
    } else if (word == "initial") {
      cases.back().initial = read_state(line, cases.back().memory_before);
    } else if (word == "final") {
      cases.back().final = read_state(line, cases.back().memory_after);
    } else if (word[0] >= '0' && word[0] <= '9') {
      std::string t, address, rest;
      line >> t >> address;
      std::getline(line, rest);
      cases.back().rows.push_back(t + (t == "4" || t == "5" ? " --" : " " + address) + rest);
    } else {
      cases.back().transfers.push_back(text);
    }
  }
  return cases;
}

std::string hexadecimal(unsigned value, int digits) {
  std::string text;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) text += "0123456789ABCDEF"[value >> shift & 15U];
  return text;
}

std::string row_text(const i8080::PinState& pins) {
  using enum i8080::TState;
  const bool late = pins.state == t4 || pins.state == t5;
  const char t = pins.state == wait ? '9'
                 : pins.state == t5 ? '5'
                 : pins.state == t4 ? '4'
                 : pins.state == t3 ? '3'
                 : pins.state == t2 ? '2'
                                    : '1';
  std::string text{t};
  text += ' ' + (late ? std::string("--") : hexadecimal(pins.address, 4));
  text += ' ' + (pins.direction == i8080::DataPins::floating ? std::string("--") : hexadecimal(pins.data, 2));
  text += ' ';
  text += pins.sync ? 's' : '-';
  text += pins.data_in ? 'd' : '-';
  text += pins.write_strobe ? 'w' : '-';
  text += pins.waiting ? 'W' : '-';
  return text;
}

std::string transfer_text(const tests::Transfer& transfer) {
  const auto kind = [&] {
    switch (transfer.status) {
      case 0xA2: return 'F';
      case 0x82: return 'R';
      case 0x00: return 'W';
      case 0x86: return 'r';
      case 0x04: return 'w';
      case 0x42: return 'I';
      case 0x10: return 'O';
      default: return '?';
    }
  }();
  return std::string{kind} + ' ' + hexadecimal(transfer.address, 4) + ' ' + hexadecimal(transfer.data, 2) + ' ' +
         hexadecimal(transfer.status, 2);
}

// The value that IN reads.
struct Input final : core::PortDevice {
  i8080::Byte byte = 0;
  std::uint8_t in(std::uint8_t, core::TStateInstant) override { return byte; }
};

void expect_same(const Case& expected) {
  SCOPED_TRACE(expected.name);
  const auto board = std::make_unique<tests::MemoryBoard>();
  for (const Cell& cell : expected.memory_before) board->memory[cell.address] = static_cast<i8080::Byte>(cell.byte);
  // The value that IN reads is given only by its transfer.
  for (const std::string& transfer : expected.transfers) {
    if (transfer[0] == 'I') board->port_data = static_cast<i8080::Byte>(std::stoul(transfer.substr(7, 2), nullptr, 16));
  }
  i8080::PinMachine machine(*board, expected.initial);
  machine.step();

  i8080::State final = machine.registers();
  EXPECT_EQ(final.halted, expected.halts);
  final.halted = final.deferred = false;
  final.interrupts_on = board->rows.back().interrupts_on;  // the pin: EI and DI change it in the next T1
  EXPECT_EQ(final, expected.final);
  std::array<i8080::Byte, 65536> memory{};
  for (const Cell& cell : expected.memory_after) memory[cell.address] = static_cast<i8080::Byte>(cell.byte);
  EXPECT_TRUE(memory == board->memory);

  EXPECT_EQ(board->rows.size(), expected.t_states);
  std::vector<std::string> rows, transfers;
  for (const auto& row : board->rows) rows.push_back(row_text(row));
  for (const auto& transfer : board->transfers) transfers.push_back(transfer_text(transfer));
  EXPECT_EQ(rows, expected.rows);
  EXPECT_EQ(transfers, expected.transfers);

  // The machine's engines have no pins to compare.
  for (const bool fast : {true, false}) {
    i8080::Machine whole;
    Input input;
    input.byte = board->port_data;
    whole.put_before({0, 0xFF}, input);
    for (const Cell& cell : expected.memory_before) whole.deposit(static_cast<i8080::Address>(cell.address), static_cast<i8080::Byte>(cell.byte));
    whole.registers() = expected.initial;
    if (fast) whole.run({1, core::never_t});
    else whole.run_plainly({1, core::never_t});
    i8080::State left = machine.registers();
    left.deferred = whole.registers().deferred;  // until the next boundary
    EXPECT_EQ(whole.registers(), left) << (fast ? "fast engine" : "plain engine");
    EXPECT_EQ(core::t_states_of(whole.now()), static_cast<std::int64_t>(expected.t_states));
    EXPECT_TRUE(std::equal(memory.begin(), memory.end(), whole.memory().begin()));
  }
}

TEST(I8080SingleStep, EveryCaseOfEveryOpcodeMatchesTheChip) {
  const std::vector<Case> cases = read_cases();
  ASSERT_EQ(cases.size(), 256U * 20U);
  for (const Case& one : cases) {
    expect_same(one);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace sightline
