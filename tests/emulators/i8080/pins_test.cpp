// INT, READY and HOLD, compared with the gate-level model: random programs, every pin at the end of every T-state.
#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "tests/emulators/i8080/memory_board.hpp"

namespace sightline {
namespace {

using Fields = std::vector<std::string>;

struct Program {
  Fields header;
  std::vector<Fields> rows;  // inputs, T-state, address, data, flags, status
  Fields end;                // registers after the last row
};

std::vector<Program> read_programs() {
  std::ifstream file(SIGHTLINE_TEST_DATA "/i8080/pins.txt");
  std::vector<Program> programs;
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    Fields fields;
    for (std::string field; line >> field;) fields.push_back(field);
    if (fields.empty()) continue;
    if (fields[0] == "CASE") programs.push_back({fields, {}, {}});
    else if (fields[0] == "END") programs.back().end = fields;
    else programs.back().rows.push_back(fields);
  }
  return programs;
}

std::uint64_t value_of(const Fields& line, const std::string& key, int base = 16) {
  for (const std::string& field : line) {
    if (field.rfind(key + "=", 0) == 0) return std::stoull(field.substr(key.size() + 1), nullptr, base);
  }
  ADD_FAILURE() << "no " << key << " in " << line[0];
  return 0;
}

i8080::Byte memory_byte(std::uint64_t i, std::uint64_t salt, std::uint64_t bias) {
  std::uint64_t z = (i + 1) * 0x9E3779B97F4A7C15U ^ salt * 0xBF58476D1CE4E5B9U;
  z ^= z >> 29;
  z *= 0x94D049BB133111EBU;
  z ^= z >> 32;
  if (bias == 1 && (z >> 40) % 4 == 0) return 0xFB;
  if (bias == 2 && (z >> 40) % 8 == 0) return 0x76;
  return static_cast<i8080::Byte>(z);
}

i8080::State initial_state(const Program& program) {
  const auto pair = [&](const char* key) { return static_cast<i8080::Address>(value_of(program.header, key)); };
  i8080::State state;
  state.pc = pair("pc");
  state.sp = pair("sp");
  state.a = static_cast<i8080::Byte>(value_of(program.header, "a"));
  state.f = static_cast<i8080::Byte>(value_of(program.header, "f"));
  state.bc = pair("bc");
  state.de = pair("de");
  state.hl = pair("hl");
  state.interrupts_on = value_of(program.header, "inte") != 0;
  return state;
}

std::string hexadecimal(unsigned value, int digits) {
  std::string text;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) text += "0123456789ABCDEF"[value >> shift & 15U];
  return text;
}

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

// Where the chip has a transparent latch the model knows only one instant per clock phase. If HOLD falls in the T-state in which
// a
// cycle ends, the model never starts again: from there on 31 of the programs show only held T-states. Returns true at such a
// place
// if the processor under test began its next cycle as the manual says.
bool model_hangs(const Program& program, const i8080::PinState& found, std::size_t at) {
  if (at < 2 || found.state != i8080::TState::t1 || program.rows[at - 1][1] == "-") return false;
  const bool released = program.rows[at - 1][0][2] == '0' && program.rows[at - 2][0][2] == '1';
  bool silent = true;
  for (std::size_t i = at; i < program.rows.size(); ++i) {
    silent = silent && program.rows[i][1] == "-" && program.rows[i][4].find('H') == std::string::npos;
  }
  return released && silent;
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
    if (model_hangs(program, board->rows[i], i)) {
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
  const std::vector<Program> programs = read_programs();
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
