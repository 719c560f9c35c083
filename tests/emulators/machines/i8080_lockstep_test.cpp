// The fast 8080 machine against the T-state-by-T-state bus: random programs rich in EI and HLT under random
// INT and READY must show the same machine cycles, in whatever pieces they are run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tests/emulators/i8080/memory_board.hpp"
#include "tests/emulators/machines/i8080_script.hpp"

namespace sightline {
namespace {

constexpr std::int64_t length = 2000;  // T-states of a program

struct Program {
  std::vector<i8080::Byte> memory;
  std::vector<i8080::PinInputs> levels;
  i8080::Byte input;
  i8080::Byte supplied;
  i8080::State state;
};

Program random_program(std::mt19937& random) {
  const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  Program program;
  program.memory.resize(65536);
  for (auto& byte : program.memory) {
    const unsigned kind = below(32);
    byte = kind < 3    ? i8080::Byte{0xFB}
           : kind == 3 ? i8080::Byte{0x76}
                       : static_cast<i8080::Byte>(below(256));
  }
  // INT and READY change now and then; INT in pulses of one T-state and upwards.
  i8080::PinInputs level;
  for (std::int64_t t = 0; t < length; ++t) {
    if (below(level.interrupt ? 6 : 25) == 0) level.interrupt = !level.interrupt;
    level.ready = below(8) != 0;
    program.levels.push_back(level);
  }
  program.input = static_cast<i8080::Byte>(below(256));
  // RST, CALL, NOP, MOV, INR, LXI, MVI, PUSH, POP, EI, DI, JMP, MOV A,M, DAD
  constexpr std::array<i8080::Byte, 16> given{0xFF, 0xCF, 0xD7, 0xCD, 0x00, 0x41, 0x04, 0x21,
                                              0x3E, 0xC5, 0xD1, 0xFB, 0xF3, 0xC3, 0x7E, 0x09};
  program.supplied = given[below(16)];
  program.state.pc = static_cast<i8080::Address>(below(65536));
  program.state.sp = static_cast<i8080::Address>(below(65536));
  program.state.hl = static_cast<i8080::Address>(below(65536));
  program.state.interrupts_on = below(2) == 0;
  return program;
}

std::vector<machines::I8080Cycle> cycles_by_pins(const Program& program) {
  const auto board = std::make_unique<tests::MemoryBoard>();
  std::copy(program.memory.begin(), program.memory.end(), board->memory.begin());
  board->levels = program.levels;
  board->port_data = program.input;
  board->acknowledge_data = {program.supplied};
  i8080::PinMachine machine(*board, program.state);
  while (board->rows.size() < static_cast<std::size_t>(length)) machine.step();
  std::vector<machines::I8080Cycle> cycles;
  std::size_t transfer = 0;
  for (std::size_t t = 0; t < static_cast<std::size_t>(length); ++t) {
    const i8080::PinState& row = board->rows[t];
    if (!row.sync) continue;
    // A halt moves no data.
    const bool halt = (row.status & 0x2F) == 0x0A;
    const i8080::Byte data =
        halt || transfer == board->transfers.size() ? i8080::Byte{0} : board->transfers[transfer++].data;
    cycles.push_back({core::at_t_state(static_cast<std::int64_t>(t)), row.status, row.address, data});
  }
  return cycles;
}

std::vector<machines::I8080Cycle> cycles_by_machine(const Program& program, std::mt19937* pieces) {
  tests::ScriptPorts ports;
  ports.levels = program.levels;
  ports.input = program.input;
  ports.supplied = {program.supplied};
  tests::I8080Recorder recorder;
  tests::ScriptMachine machine(ports, recorder);
  std::copy(program.memory.begin(), program.memory.end(), machine.memory().begin());
  machine.registers() = program.state;
  machines::I8080Limits limits{~std::uint64_t{0}, core::at_t_state(length)};
  while (machine.now() < core::at_t_state(length)) {
    if (pieces != nullptr) {
      limits.instructions = (*pieces)() % 20 + 1;
      limits.until = std::min(core::at_t_state(length), machine.now() + core::TStates((*pieces)() % 100 + 1));
    }
    if (machine.run(limits) == machines::I8080StopReason::halt) break;
  }
  while (!recorder.seen.empty() && recorder.seen.back().time >= core::at_t_state(length))
    recorder.seen.pop_back();
  return recorder.seen;
}

std::string text(const machines::I8080Cycle& cycle) {
  const auto hexadecimal = [](unsigned value) {
    std::string digits;
    for (int shift = 12; shift >= 0; shift -= 4) digits += "0123456789ABCDEF"[value >> shift & 15U];
    return digits;
  };
  return std::to_string(core::t_states_of(cycle.time)) + ' ' + hexadecimal(cycle.status) + ' ' +
         hexadecimal(cycle.address) + ' ' + hexadecimal(cycle.data);
}

void expect_equal(const std::vector<machines::I8080Cycle>& found,
                  const std::vector<machines::I8080Cycle>& expected, int program) {
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
    // The last cycle may have been cut off before its data.
    if (i + 1 == expected.size()) break;
    ASSERT_EQ(text(found[i]), text(expected[i])) << "program " << program << " cycle " << i;
  }
  ASSERT_EQ(found.size(), expected.size()) << "program " << program;
}

TEST(I8080Machine, ShowsTheCyclesOfTheTStateByTStateBus) {
  std::mt19937 random(8080);
  std::size_t interrupts = 0;
  std::size_t waking_fetches = 0;
  for (int i = 0; i < 400; ++i) {
    const Program program = random_program(random);
    const auto expected = cycles_by_pins(program);
    expect_equal(cycles_by_machine(program, nullptr), expected, i);
    if (HasFatalFailure()) return;
    for (const auto& cycle : expected) {
      interrupts += cycle.status == 0x23 || cycle.status == 0x2B ? 1 : 0;
      waking_fetches += cycle.status == 0xAA ? 1 : 0;
    }
  }
  EXPECT_GT(interrupts, 1000U);
  EXPECT_GT(waking_fetches, 5U);
}

// Program 167 of seed 77 drops INT and raises it again within an acknowledge cycle that ends a piece.
TEST(I8080Machine, ARunInPiecesIsTheSameRun) {
  for (const unsigned seed : {1985U, 77U}) {
    std::mt19937 random(seed);
    for (int i = 0; i < 200; ++i) {
      const Program program = random_program(random);
      expect_equal(cycles_by_machine(program, &random), cycles_by_machine(program, nullptr), i);
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace sightline
