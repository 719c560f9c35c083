// INT, READY and HOLD, compared with the gate-level model: random programs, every pin at the end of every T-state.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "tests/emulators/i8080/gate_level_data.hpp"
#include "tests/emulators/i8080/memory_board.hpp"

namespace sightline {
namespace {

using tests::Fields;
using tests::hexadecimal;
using tests::initial_state;
using tests::memory_byte;
using tests::Program;
using tests::value_of;

// The comparable fields of a row: no address in T4, T5, a halt's or HOLD's floating bus; no floating data.
std::string comparable(const Fields& row) {
  const bool held = row[4].find('H') != std::string::npos;
  const bool no_address = row[1] == "T4" || row[1] == "T5" || row[1] == "-" || held;
  const bool no_data = row[3].back() == 'z' || held;
  return row[1] + ' ' + (no_address ? "*" : row[2]) + ' ' + (no_data ? "*" : row[3]) + ' ' + row[4] + ' ' + row[5];
}

Fields fields_of(const i8080::PinState& pins) {
  static constexpr std::array<const char*, 7> names{"T1", "T2", "TW", "T3", "T4", "T5", "-"};
  static constexpr std::array<char, 3> directions{'o', 'i', 'z'};
  const auto mark = [](bool on, char letter) { return on ? letter : '-'; };
  return {"", names[static_cast<std::size_t>(pins.state)], hexadecimal(pins.address, 4),
          hexadecimal(pins.data, 2) + directions[static_cast<std::size_t>(pins.direction)],
          {mark(pins.sync, 'S'), mark(pins.data_in, 'D'), mark(pins.write_strobe, 'W'), mark(pins.waiting, 'w'),
           mark(pins.hold_acknowledge, 'H'), mark(pins.interrupts_on, 'E')},
          hexadecimal(pins.status, 2)};
}

// `hung` counts the programs of which the model shows only the beginning.
void expect_same(const Program& program, int& hung) {
  const auto board = std::make_unique<tests::MemoryBoard>();
  const std::uint64_t salt = value_of(program.header, "salt", 10);
  const std::uint64_t bias = value_of(program.header, "bias", 10);
  for (std::size_t i = 0; i < board->memory.size(); ++i) board->memory[i] = memory_byte(i, salt, bias);
  board->port_data = static_cast<i8080::Byte>(value_of(program.header, "in"));
  board->acknowledge_data = {static_cast<i8080::Byte>(value_of(program.header, "vec"))};
  for (const Fields& row : program.rows) {
    board->levels.push_back({row[0][0] == '1', row[0][1] == '1', row[0][2] == '1'});
  }
  i8080::PinMachine machine(*board, initial_state(program));
  while (board->rows.size() < program.rows.size()) machine.step();
  const bool settled = board->rows.size() == program.rows.size();
  for (std::size_t i = 0; i < program.rows.size(); ++i) {
    if (tests::model_hangs(program, board->rows[i].state == i8080::TState::t1, i)) {
      ++hung;
      return;
    }
    const std::string found = comparable(fields_of(board->rows[i]));
    ASSERT_EQ(found, comparable(program.rows[i])) << "T-state " << i << " of case " << program.header[1];
  }
  if (settled) {  // between two instructions; A may not be updated yet
    EXPECT_EQ(machine.registers().bc, value_of(program.end, "bc")) << program.header[1];
    EXPECT_EQ(machine.registers().sp, value_of(program.end, "sp")) << program.header[1];
  }
}

TEST(I8080Pins, EveryTStateOfEveryProgramMatchesTheChip) {
  const std::vector<Program> programs = tests::read_programs();
  ASSERT_EQ(programs.size(), 100U);
  int hung = 0;
  for (const Program& program : programs) {
    ASSERT_EQ(program.rows.size(), 120U);
    expect_same(program, hung);
  }
  EXPECT_EQ(hung, 31);
}

TEST(I8080Pins, ResetEndsAHaltWithoutATrace) {
  const auto board = std::make_unique<tests::MemoryBoard>();
  board->memory[0x100] = 0x76;
  i8080::State state;
  state.pc = 0x100;
  i8080::PinMachine machine(*board, state);
  for (int n = 0; n < 5; ++n) machine.step();
  machine.reset();
  machine.step();
  EXPECT_EQ(board->transfers.back().address, 0);
  EXPECT_EQ(board->transfers.back().status, 0xA2);  // not AA, the fetch that ends a halt
}

}  // namespace
}  // namespace sightline
