// Every opcode compared with the gate-level model: registers, memory, transfers and each T-state's pins.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "emulators/machines/i8080.hpp"
#include "tests/emulators/i8080/gate_level_data.hpp"
#include "tests/emulators/i8080/memory_board.hpp"

namespace sightline {
namespace {

using tests::Case;
using tests::Cell;
using tests::hexadecimal;

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
  const std::vector<Case> cases = tests::read_cases();
  ASSERT_EQ(cases.size(), 256U * 20U);
  for (const Case& one : cases) {
    expect_same(one);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace sightline
