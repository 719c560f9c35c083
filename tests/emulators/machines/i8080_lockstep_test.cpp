// The engines of the 8080 machine compared with the T-state-by-T-state bus and with each other. Random programs rich in EI and
// HLT
// run under random INT, READY and HOLD, with any instruction supplied. All engines must show the same machine cycles,
// instructions,
// registers and memory, for any division into runs, with all cycles reported, with marked ones and with none.
// lockstep.hpp says how to run more programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/emulators/i8080/memory_board.hpp"
#include "tests/emulators/machines/i8080_script.hpp"
#include "tests/emulators/machines/lockstep.hpp"

namespace sightline {
namespace {

struct Program {
  std::int64_t length;  // T-states
  std::vector<i8080::Byte> memory;
  std::vector<i8080::PinInputs> levels;
  i8080::Byte input;
  std::vector<i8080::Byte> supplied;
  i8080::State state;
};

// The pins that a program uses.
struct Asked {
  bool ready = false;
  bool hold = false;
};

std::vector<i8080::Byte> random_memory(std::mt19937& random, bool few_halts) {
  const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  std::vector<i8080::Byte> memory(65536);
  const unsigned halts = below(3) == 0 ? 6 : 4;
  for (auto& byte : memory) {
    const unsigned kind = below(32);
    byte = kind < 3       ? i8080::Byte{0xFB}
           : kind < halts ? i8080::Byte{0x76}
                          : static_cast<i8080::Byte>(below(256));
    if (few_halts && byte == 0x76 && below(16) != 0) byte = 0;
  }
  return memory;
}

Program random_program(std::mt19937& random, Asked asked, std::int64_t length, std::vector<i8080::Byte> memory) {
  const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  Program program{length, std::move(memory), {}, 0, {0, 0, 0}, {}};
  // INT, READY and HOLD change at random; INT and HOLD in pulses of one T-state or more. HOLD may be so rare that programs run
  // long
  // without it.
  i8080::PinInputs level;
  const unsigned idle = below(2) == 0 ? 20 : 200;
  const unsigned busy = below(2) == 0 ? 4 : 40;
  for (std::int64_t t = 0; t < length; ++t) {
    if (below(level.interrupt ? 6 : 25) == 0) level.interrupt = !level.interrupt;
    if (asked.ready) level.ready = below(8) != 0;
    if (asked.hold && below(level.hold ? busy : idle) == 0) level.hold = !level.hold;
    program.levels.push_back(level);
  }
  program.input = static_cast<i8080::Byte>(below(256));
  for (auto& byte : program.supplied) byte = static_cast<i8080::Byte>(below(8) == 0 ? 0x76 : below(8) == 1 ? 0xE3 : below(256));
  program.state.pc = static_cast<i8080::Address>(below(65536));
  program.state.sp = static_cast<i8080::Address>(below(65536));
  program.state.hl = static_cast<i8080::Address>(below(65536));
  program.state.bc = static_cast<i8080::Address>(below(65536));
  program.state.a = static_cast<i8080::Byte>(below(256));
  program.state.interrupts_on = below(2) == 0;
  return program;
}

// What a run showed, up to the program's length.
struct Shown {
  std::vector<i8080::BusCycle> cycles;
  std::vector<i8080::HoldPins> holds;
  std::vector<std::pair<std::int64_t, i8080::State>> states;  // end of each instruction, and the state after it
  std::vector<i8080::Byte> memory;
  bool whole = true;  // false: memory includes one more instruction
};

Shown run_on_pins(const Program& program) {
  const std::int64_t length = program.length;
  const auto board = std::make_unique<tests::MemoryBoard>();
  std::copy(program.memory.begin(), program.memory.end(), board->memory.begin());
  board->levels = program.levels;
  board->port_data = program.input;
  board->acknowledge_data = program.supplied;
  board->rows.reserve(static_cast<std::size_t>(length) + 100);
  i8080::PinMachine machine(*board, program.state);
  Shown shown;
  while (board->rows.size() < static_cast<std::size_t>(length)) {
    const auto begun = static_cast<std::ptrdiff_t>(board->rows.size());
    const std::size_t transfers = board->transfers.size();
    machine.step();
    // A step may be a wait state of a halt. What begins after `length`, following a HOLD, is not part of the run.
    const auto end = board->rows.begin() + std::min(length, static_cast<std::int64_t>(board->rows.size()));
    const bool began = std::any_of(board->rows.begin() + begun, end, [](const i8080::PinState& row) { return row.sync; });
    if (began) shown.states.emplace_back(static_cast<std::int64_t>(board->rows.size()), machine.registers());
    shown.whole = began || board->transfers.size() == transfers;
  }
  shown.memory.assign(board->memory.begin(), board->memory.end());
  std::size_t transfer = 0;
  i8080::HoldPins pins{};
  for (std::size_t t = 0; t < static_cast<std::size_t>(length); ++t) {
    const i8080::PinState& row = board->rows[t];
    const core::TStateInstant time = core::at_t_state(static_cast<std::int64_t>(t));
    const i8080::HoldPins found{time, row.inputs.hold, row.hold_acknowledge, row.state == i8080::TState::held};
    if (found.hold != pins.hold || found.acknowledge != pins.acknowledge || found.waits != pins.waits) {
      shown.holds.push_back(found);
      pins = found;
    }
    if (!row.sync) continue;
    // A halt transfers no data.
    const bool halt = (row.status & 0x2F) == 0x0A || (row.status & 0x2F) == 0x0B;
    const i8080::Byte data =
        halt || transfer == board->transfers.size() ? i8080::Byte{0} : board->transfers[transfer++].data;
    shown.cycles.push_back({time, row.status, row.address, data});
  }
  return shown;
}

// The final state of a machine, and what its device was asked.
struct Left {
  i8080::State state;
  core::TStateInstant now;
  std::uint64_t instructions;
  std::uint64_t held;
  std::vector<tests::PortAccess> reads;
  std::vector<tests::PortAccess> writes;
  std::vector<i8080::Byte> memory;
  friend bool operator==(const Left&, const Left&) = default;
};

struct Subject {
  Subject(const Program& of, Asked asked) : program(of), script(tests::attach_script(machine, asked.ready, asked.hold)) {
    script.levels = program.levels;
    script.input = program.input;
    script.supplied = program.supplied;
    machine.load(0, program.memory);
    machine.registers() = program.state;
  }

  // Runs the whole program, or pieces of it: run(limits) returns a stop reason.
  template <class Piece>
  void run(std::mt19937* pieces, Piece piece) {
    const core::TStateInstant end = core::at_t_state(program.length);
    i8080::Limits limits{.until = end};
    while (machine.now() < end) {
      if (pieces != nullptr) {
        limits.instructions = (*pieces)() % 20 + 1;
        limits.until = std::min(end, machine.now() + core::TStates((*pieces)() % 100 + 1));
      }
      if (piece(limits) == i8080::StopReason::halt) break;
    }
  }
  [[nodiscard]] Left left() const {
    return {machine.registers(), machine.now(),   machine.instructions(), machine.held(), script.reads, script.writes,
            {machine.memory().begin(), machine.memory().end()}};
  }

  const Program& program;
  i8080::Machine machine;
  tests::ScriptDevice& script;
};

struct Seen {
  Shown shown;
  Left left;
  std::vector<i8080::BusCycle> cycles;  // to the end of the last instruction, with their operands
};

Seen run_observed(const Program& program, Asked asked, bool tells_instructions, std::mt19937* pieces) {
  Subject subject(program, asked);
  tests::I8080Recorder recorder(tells_instructions);
  subject.run(pieces, [&](const i8080::Limits& limits) { return subject.machine.run(limits, recorder); });
  Seen seen{{}, subject.left(), recorder.seen};
  const auto end = core::at_t_state(program.length);
  const auto cut = [end](auto& events) {
    while (!events.empty() && events.back().time >= end) events.pop_back();
  };
  cut(recorder.seen);
  cut(recorder.holds);
  for (auto& cycle : recorder.seen) cycle.operand = false;  // which pins do not show
  seen.shown = {recorder.seen, recorder.holds, {}, {}, true};
  for (const auto& instruction : recorder.executed) seen.shown.states.emplace_back(instruction.end, instruction.after);
  seen.shown.memory = seen.left.memory;
  return seen;
}

Left run_unobserved(const Program& program, Asked asked, bool plainly, std::mt19937* pieces) {
  Subject subject(program, asked);
  subject.run(pieces, [&](const i8080::Limits& limits) {
    return plainly ? subject.machine.run_plainly(limits) : subject.machine.run(limits);
  });
  return subject.left();
}

// An observer of marks.
struct Marked : tests::I8080Recorder {
  explicit Marked(std::mt19937& random) : I8080Recorder(false) {
    for (auto& byte : of_memory) byte = static_cast<std::uint8_t>(random() % 8 == 0 ? random() & 13U : 0);
    for (auto& byte : of_ports) byte = static_cast<std::uint8_t>(random() % 8 == 0 ? random() & 12U : 0);
    marks = of_memory.data();
    port_marks = of_ports.data();
  }
  bool stop(core::TStateInstant now, i8080::Address next) override {
    // At every boundary, keeps those that the marks request.
    if (!every_boundary || boundaries.empty() || seen.size() != seen_before || (of_memory[next] & i8080::mark::stop) != 0) boundaries.push_back(now);
    seen_before = seen.size();
    return false;
  }
  // By the definition of the interface.
  [[nodiscard]] bool wants(const i8080::BusCycle& cycle) const {
    namespace status = i8080::status;
    if (cycle.operand) return false;
    if ((cycle.status & status::first) != 0) return (cycle.status & status::acknowledge) != 0;
    if ((cycle.status & status::halt) != 0) return false;
    const std::uint8_t bit = (cycle.status & status::read) != 0 ? i8080::mark::read : i8080::mark::written;
    if ((cycle.status & (status::input | status::output)) != 0) return (of_ports[i8080::low(cycle.address)] & bit) != 0;
    return (of_memory[cycle.address] & bit) != 0;
  }

  std::array<std::uint8_t, 65536> of_memory{};
  std::array<std::uint8_t, 256> of_ports{};
  std::size_t seen_before = 0;
  std::vector<core::TStateInstant> boundaries;
};

void expect_marked(const Program& program, Asked asked, const Seen& all, std::mt19937& random, const std::string& name) {
  const auto marked = std::make_unique<Marked>(random);
  const auto run = [&](Marked& observer) {
    Subject subject(program, asked);
    subject.run(nullptr, [&](const i8080::Limits& limits) { return subject.machine.run(limits, observer); });
    EXPECT_TRUE(subject.left() == all.left) << name;
  };
  const auto at_all = std::make_unique<Marked>(*marked);
  at_all->marks = at_all->of_memory.data();
  at_all->port_marks = at_all->of_ports.data();
  at_all->every_boundary = true;
  run(*marked);
  run(*at_all);
  std::vector<i8080::BusCycle> expected;
  for (const auto& cycle : all.cycles) {
    if (marked->wants(cycle)) expected.push_back(cycle);
  }
  EXPECT_TRUE(marked->seen == expected) << name;
  EXPECT_TRUE(at_all->seen == expected) << name;
  EXPECT_TRUE(marked->boundaries == at_all->boundaries) << name;
}

std::string text(const i8080::BusCycle& cycle) {
  const auto hexadecimal = [](unsigned value) {
    std::string digits;
    for (int shift = 12; shift >= 0; shift -= 4) digits += "0123456789ABCDEF"[value >> shift & 15U];
    return digits;
  };
  return std::to_string(core::t_states_of(cycle.time)) + ' ' + hexadecimal(cycle.status) + ' ' +
         hexadecimal(cycle.address) + ' ' + hexadecimal(cycle.data);
}

std::string text(const i8080::HoldPins& pins) {
  return std::to_string(core::t_states_of(pins.time)) + (pins.hold ? " hold" : "") + (pins.acknowledge ? " hlda" : "") +
         (pins.waits ? " waits" : "");
}

template <class Event>
void expect_equal(const std::vector<Event>& found, const std::vector<Event>& expected, const std::string& program) {
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
    // The last cycle may have been truncated before its data.
    if (i + 1 == expected.size()) break;
    if (found[i] == expected[i]) continue;
    ASSERT_EQ(text(found[i]), text(expected[i])) << program << " event " << i;
  }
  ASSERT_EQ(found.size(), expected.size()) << program;
}

void expect_same(const Shown& found, const Shown& expected, const std::string& program) {
  expect_equal(found.cycles, expected.cycles, program);
  if (testing::Test::HasFatalFailure()) return;
  for (std::size_t i = 0; i < std::min(found.states.size(), expected.states.size()); ++i) {
    ASSERT_EQ(found.states[i].first, expected.states[i].first) << program << " instruction " << i;
    ASSERT_TRUE(found.states[i].second == expected.states[i].second) << program << " instruction " << i;
  }
  ASSERT_EQ(found.states.size(), expected.states.size()) << program;
  ASSERT_TRUE(found.memory == expected.memory || !expected.whole) << program;
  // A halt that nothing can end ends a run, while HOLD still changes on the pins.
  const bool halted = !expected.states.empty() && expected.states.back().second.halted;
  auto holds = expected.holds;
  if (halted) holds.resize(std::min(holds.size(), found.holds.size()));
  expect_equal(found.holds, holds, program);
}

void compare(std::mt19937& random, Asked asked, int programs, const std::string& name) {
  std::size_t interrupts = 0;
  std::size_t waking_fetches = 0;
  std::size_t holds = 0;
  std::size_t cycles = 0;
  std::uint64_t modified = 0;
  std::uint64_t instructions = 0;
  int i = 0;
  // A long run has long programs, which seldom halt. 16 of them begin with the same memory at different addresses, because making
  // memory takes longer than running a program.
  const std::uint64_t wanted = tests::lockstep_instructions(0);
  const std::int64_t length = wanted == 0 ? 2000 : 20000;
  std::vector<i8080::Byte> memory;
  for (; i < programs || instructions < wanted; ++i) {
    if (wanted == 0 || i % 16 == 0) memory = random_memory(random, wanted != 0);
    const Program program = random_program(random, asked, length, memory);
    const Shown expected = run_on_pins(program);
    const std::string number = name + ", program " + std::to_string(i);
    const Seen seen = run_observed(program, asked, true, nullptr);
    expect_same(seen.shown, expected, number);
    if (testing::Test::HasFatalFailure()) return;
    Shown fewer = run_observed(program, asked, false, nullptr).shown;
    fewer.states = expected.states;
    expect_same(fewer, expected, number + ", no instructions told");
    if (testing::Test::HasFatalFailure()) return;
    fewer = run_observed(program, asked, false, &random).shown;
    fewer.states = expected.states;
    fewer.holds = expected.holds;
    expect_same(fewer, expected, number + ", in pieces");
    if (testing::Test::HasFatalFailure()) return;
    ASSERT_TRUE(run_unobserved(program, asked, true, nullptr) == seen.left) << number << ", plain engine";
    ASSERT_TRUE(run_unobserved(program, asked, false, nullptr) == seen.left) << number << ", fast engine";
    ASSERT_TRUE(run_unobserved(program, asked, false, &random) == seen.left) << number << ", fast engine in pieces";
    expect_marked(program, asked, seen, random, number + ", marked");
    tests::WrittenWords words(65536);
    for (const auto& cycle : expected.cycles) {
      if ((cycle.status & (i8080::status::read | i8080::status::output)) == 0) words.write(cycle.address);
      if ((cycle.status & i8080::status::first) != 0) words.fetch(cycle.address);
      interrupts += cycle.status == 0x23 || cycle.status == 0x2B ? 1 : 0;
      waking_fetches += cycle.status == 0xAA ? 1 : 0;
    }
    holds += expected.holds.size();
    cycles += expected.cycles.size();
    modified += words.fetched();
    instructions += expected.states.size();
  }
  std::printf("%d programs, %llu instructions, %zu bus cycles, %zu acknowledge cycles, %zu ends of halts, %zu changes of HOLD and HLDA, "
              "%llu fetches of bytes that the program had written\n",
              i, static_cast<unsigned long long>(instructions), cycles, interrupts, waking_fetches, holds,
              static_cast<unsigned long long>(modified));
  EXPECT_GT(interrupts, static_cast<std::size_t>(programs));
  EXPECT_GT(waking_fetches, 5U);
  EXPECT_EQ(holds > static_cast<std::size_t>(programs), asked.hold);
}

TEST(I8080Machine, ShowsTheCyclesOfTheTStateByTStateBus) {
  std::mt19937 random(static_cast<unsigned>(tests::lockstep_seed(8080)));
  compare(random, {.ready = true}, 400, "INT and READY");
}

TEST(I8080Machine, HoldMatchesTheTStateByTStateBus) {
  std::mt19937 random(static_cast<unsigned>(tests::lockstep_seed(1975)));
  compare(random, {.hold = true}, 600, "INT and HOLD");
}

TEST(I8080Machine, HoldAmongWaitStatesMatchesTheTStateByTStateBus) {
  std::mt19937 random(static_cast<unsigned>(tests::lockstep_seed(8228)));
  compare(random, {.ready = true, .hold = true}, 200, "INT, READY and HOLD");
}

// Program 167 of seed 77 drops INT and raises it again within an acknowledge cycle that ends a piece.
TEST(I8080Machine, ARunInPiecesIsTheSameRun) {
  for (const unsigned seed : {1985U, 77U}) {
    std::mt19937 random(seed);
    compare(random, {}, 200, "INT");
  }
}

}  // namespace
}  // namespace sightline
