// A run of the 8080 with marked places must stop where a run stops whose observer compares each instruction and each cycle with
// the
// marks: random walks through memory full of random bytes, which execute what they have written, push and pop across marked
// places,
// are interrupted and held, and continue from snapshots in other machines.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "emulators/i8080/isa.hpp"
#include "tests/host/machines/machine_run.hpp"
#include "tests/support/effort.hpp"

namespace sightline::test {
namespace {

using machines::Probe;
using Machine = machines::Machine;

constexpr std::size_t program_counter = 9, registers = 11;
constexpr std::uint8_t opcode_of_hlt = 0x76;

struct Marks {
  std::vector<std::pair<std::uint32_t, std::uint8_t>> places;
  std::array<std::uint8_t, 256> ports{};
  bool interrupts = false;

  void put_into(Probe& probe) const {
    probe.clear_marks();
    for (const auto& [at, marks] : places) probe.mark(at, marks);
    for (std::uint32_t port = 0; port < ports.size(); ++port)
      if (ports[port] != 0) probe.mark_port(port, ports[port]);
    if (interrupts) probe.mark_interrupts();
  }
};

// Evaluates the marks for single instructions.
class Oracle {
 public:
  Oracle(std::unique_ptr<Machine> machine, const Marks& marks) : machine_(std::move(machine)), ports_(marks.ports), interrupts_(marks.interrupts) {
    for (const auto& [at, of] : marks.places) places_[at] |= of;
    machine_->probe()->on_instruction = [](const Probe::Entry&) {};
    machine_->probe()->on_cycle = [this](const Probe::Cycle& cycle) { take(cycle); };
  }
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;
  ~Oracle() = default;

  // Up to an event, to `instructions` or to a halt that nothing ends.
  void run(std::uint64_t instructions) {
    events_.clear();
    while (events_.empty() && machine_->instructions() < instructions) {
      machines::Limits one;
      one.instructions = machine_->instructions() + 1;
      const auto stop = machine_->run(one, false);
      ASSERT_TRUE(stop);
      if (stop->name == "halt") {
        ended_ = true;
        return;
      }
      // The oracle is not called in a halt.
      if (!halted_ && (places_[machine_->get(program_counter)] & Probe::executed) != 0)
        events_.push_back({Probe::Kind::execution, machine_->ticks(), machine_->get(program_counter), 0});
    }
  }
  [[nodiscard]] const std::vector<Probe::Event>& events() const { return events_; }
  [[nodiscard]] const Machine& machine() const { return *machine_; }
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  void take(const Probe::Cycle& cycle) {
    halted_ = cycle.name == "halt";
    if (halted_) return;
    if (cycle.name == "fetch" || cycle.name == "acknowledge") {
      operands_ = i8080::lookup(static_cast<std::uint8_t>(cycle.value)).bytes() - 1;
      if (cycle.name == "acknowledge" && interrupts_) events_.push_back({Probe::Kind::interrupt, cycle.time, cycle.address, 0});
      return;
    }
    if (operands_ != 0) {
      --operands_;
      return;
    }
    const bool reads = cycle.name == "read" || cycle.name == "stack read" || cycle.name == "input";
    const std::uint8_t mark = reads ? Probe::is_read : Probe::is_written;
    if (cycle.name == "input" || cycle.name == "output") {
      const std::uint32_t port = cycle.address & 0xFFU;
      if ((ports_[port] & mark) != 0)
        events_.push_back({reads ? Probe::Kind::port_read : Probe::Kind::port_write, cycle.time, port, cycle.value});
    } else if ((places_[cycle.address] & mark) != 0) {
      events_.push_back({reads ? Probe::Kind::read : Probe::Kind::write, cycle.time, cycle.address, cycle.value});
    }
  }

  std::unique_ptr<Machine> machine_;
  std::array<std::uint8_t, 0x10000> places_{};
  std::array<std::uint8_t, 256> ports_;
  bool interrupts_;
  std::vector<Probe::Event> events_;
  int operands_ = 0;
  bool halted_ = false;
  bool ended_ = false;
};

// The terminal's board requests an interrupt whenever it can send, and each EI admits one.
std::unique_ptr<Machine> machine_of(const std::string& memory, const std::string& hold) {
  MachineRun of(machines::i8080());
  of.monitored().set_file("--load", "random.bin", memory).set("--start", "100").set("--terminal", "sio").set("--interrupt", "sio=7").set("--set", "sp=8000");
  if (!hold.empty()) of.set("--hold", hold);
  auto ready = of.prepared();
  EXPECT_TRUE(ready.has_value()) << of.refusal();
  return ready ? std::move(ready->machine) : nullptr;
}

struct Walk {
  bool executed = false, accesses = false, ports = false;
  std::size_t stops = 0;
  std::size_t pieces = 0;
  std::size_t of_kind[9] = {};
};

void walk(std::uint32_t seed, Walk& found) {
  std::mt19937 random(seed);
  const auto below = [&random](std::uint32_t most) { return static_cast<std::uint32_t>(random() % most); };
  std::string memory(0x10000, '\0');
  for (char& byte : memory) {
    auto value = static_cast<std::uint8_t>(random());
    // It would soon halt for good.
    if (value == opcode_of_hlt && below(8) != 0) value = 0xFB;
    byte = static_cast<char>(value);
  }
  // MVI A,2; OUT 0; EI: enables the board's request to send.
  const std::string begin("\x3E\x02\xD3\x00\xFB", 5);
  memory.replace(0x100, begin.size(), begin);
  std::string hold;
  if (seed % 3 == 0) {
    // Separate statements, because compilers differ in the order of evaluation.
    hold = std::to_string(below(1000)) + "+";
    hold += std::to_string(1 + below(9)) + "/";
    hold += std::to_string(40 + below(900));
  }

  Marks marks;
  const std::uint32_t rare = 8U << below(8);
  for (std::uint32_t at = 0; at < memory.size(); ++at) {
    std::uint8_t set = 0;
    if (found.executed && below(rare) == 0) set |= Probe::executed;
    if (found.accesses && below(rare) == 0) set |= Probe::is_read;
    if (found.accesses && below(rare) == 0) set |= Probe::is_written;
    if (set != 0) marks.places.emplace_back(at, set);
  }
  if (found.ports) {
    for (std::uint8_t& port : marks.ports) port = static_cast<std::uint8_t>(below(2) == 0 ? (1 + below(3)) * Probe::is_read : 0);
    marks.interrupts = below(2) == 0;
  }

  Oracle oracle(machine_of(memory, hold), marks);
  auto watched = machine_of(memory, hold);
  ASSERT_TRUE(watched);
  marks.put_into(*watched->probe());
  const std::uint64_t end = sightline::tests::effort(4000U, 1500U);
  while (!oracle.ended() && watched->instructions() < end) {
    // A run that begins at a marked place does not stop there; the limit is sometimes between two stops.
    const std::uint64_t part = std::min(end, watched->instructions() + 1 + below(1000));
    oracle.run(part);
    watched->probe()->resume();
    std::optional<machines::Stop> stop;
    while (!stop) {
      machines::Limits limits;
      limits.instructions = part;
      // At any T-state, also within a HOLD: another machine then completes the HOLD.
      if (below(8) == 0) limits.until = watched->ticks() + below(200);
      stop = watched->run(limits, below(2) == 0);
      if (!stop || !stop->at_until) continue;
      stop.reset();
      ++found.pieces;
      const auto state = watched->save();
      watched = machine_of(memory, hold);
      ASSERT_TRUE(watched->restore(state).has_value());
      marks.put_into(*watched->probe());
    }
    ASSERT_EQ(watched->instructions(), oracle.machine().instructions()) << "seed " << seed;
    ASSERT_EQ(watched->ticks(), oracle.machine().ticks()) << "seed " << seed;
    for (std::size_t n = 0; n < registers; ++n)
      ASSERT_EQ(watched->get(n), oracle.machine().get(n)) << "seed " << seed << ", register " << n << ", T-state " << watched->ticks();
    ASSERT_EQ(watched->probe()->events(), oracle.events()) << "seed " << seed << ", T-state " << watched->ticks();
    found.stops += oracle.events().empty() ? 0 : 1;
    for (const Probe::Event& event : oracle.events()) ++found.of_kind[static_cast<std::size_t>(event.kind)];
  }
  for (std::uint32_t at = 0; at < memory.size(); ++at)
    if (watched->word(at) != oracle.machine().word(at)) FAIL() << "seed " << seed << ", address " << at;
  // Snapshots do not contain marks.
  const auto state = watched->save();
  watched->probe()->clear_marks();
  EXPECT_EQ(watched->save(), state);
}

Walk walks(Walk found, std::uint32_t first_seed) {
  for (std::uint32_t seed = first_seed; seed < first_seed + sightline::tests::effort(50U, 20U) && !::testing::Test::HasFatalFailure(); ++seed) walk(seed, found);
  return found;
}

// HOLD from the first T-state on, for 100: the processor stops after the first NOP. A run that begins there skips the breakpoint,
// however
// often it ends within the HOLD.
TEST(I8080Probe, ABreakpointIsSkippedOnceAfterAHold) {
  const std::string nops(0x200, '\0');
  const auto unwatched = machine_of(nops, "0+100");
  unwatched->start(0x101);
  machines::Limits two;
  two.instructions = 2;
  static_cast<void>(unwatched->run(two, false));
  EXPECT_GT(unwatched->ticks(), 100 + 4);
  const auto first = machine_of(nops, "0+100");
  first->start(0x101);
  first->probe()->mark(0x102, Probe::executed);
  machines::Limits limits;
  ASSERT_EQ(first->run(limits, false)->name, machines::stopped_by_probe);
  EXPECT_EQ(first->ticks(), 4);
  first->probe()->resume();
  const auto state = first->save();
  for (const bool restored : {false, true}) {
    const auto other = machine_of(nops, "0+100");
    ASSERT_TRUE(other->restore(state).has_value());
    machines::Machine& machine = restored ? *other : *first;
    machine.probe()->clear_marks();
    machine.probe()->mark(0x102, Probe::executed);
    machine.probe()->mark(0x103, Probe::executed);
    for (const std::int64_t until : {50, 80}) {
      limits.until = until;
      const auto stop = machine.run(limits, false);
      EXPECT_TRUE(stop->at_until) << stop->name;
      EXPECT_TRUE(machine.probe()->events().empty());
      EXPECT_EQ(machine.ticks(), until);
    }
    limits.until = 1000;
    ASSERT_EQ(machine.run(limits, false)->name, machines::stopped_by_probe);
    EXPECT_EQ(machine.probe()->events().at(0), (Probe::Event{Probe::Kind::execution, unwatched->ticks(), 0x103, 0}));
  }
}

// LHLD 2000, and a jump back to it. HOLD for 30 T-states, from each T-state of its second and third execution on: the processor
// stops within
// the instruction, between it and the jump, or within the jump. The watched access is reported at its own time, also from
// snapshots.
TEST(I8080Probe, AWatchpointSeesReadsOfAHeldInstructionAlsoFromASnapshot) {
  std::string memory(0x200, '\0');
  const std::string program("\x2A\x00\x20\xC3\x00\x01", 6);
  memory.replace(0x100, program.size(), program);
  constexpr std::uint64_t instructions = 8;
  constexpr std::uint32_t watched_place = 0x2001;
  int held_within = 0;
  int pieces = 0;
  for (int first = 26; first < 78; ++first) {
    const std::string hold = std::to_string(first) + "+30";
    // The expected events, from each cycle of a run without marks.
    const auto told = machine_of(memory, hold);
    std::vector<Probe::Cycle> cycles;
    told->probe()->on_instruction = [](const Probe::Entry&) {};
    told->probe()->on_cycle = [&cycles](const Probe::Cycle& cycle) { cycles.push_back(cycle); };
    machines::Limits limits;
    limits.instructions = instructions;
    ASSERT_EQ(told->run(limits, false)->name, "instruction_limit");
    std::vector<Probe::Event> expected;
    for (std::size_t n = 0; n < cycles.size(); ++n) {
      if (cycles[n].address == watched_place)
        expected.push_back({Probe::Kind::read, cycles[n].time, watched_place, 0});
      // No cycle of LHLD or JMP has more than four T-states.
      if (n != 0 && cycles[n].name != "fetch" && cycles[n].time - cycles[n - 1].time > 30) ++held_within;
    }
    ASSERT_EQ(expected.size(), instructions / 2);
    for (std::int64_t piece = 1; piece < 60; piece += sightline::tests::effort(1, 7)) {
      auto watched = machine_of(memory, hold);
      watched->probe()->mark(watched_place, Probe::is_read);
      std::vector<Probe::Event> seen;
      while (watched->instructions() < instructions) {
        limits.until = watched->ticks() + piece;
        const auto stop = watched->run(limits, false);
        ASSERT_TRUE(stop);
        if (stop->name == machines::stopped_by_probe) {
          for (const Probe::Event& event : watched->probe()->events()) seen.push_back(event);
          watched->probe()->resume();
        } else if (stop->at_until) {
          ++pieces;
          const auto state = watched->save();
          watched = machine_of(memory, hold);
          ASSERT_TRUE(watched->restore(state).has_value());
          watched->probe()->mark(watched_place, Probe::is_read);
        }
      }
      ASSERT_EQ(seen, expected) << hold << ", pieces of " << piece;
      ASSERT_EQ(watched->ticks(), told->ticks()) << hold << ", pieces of " << piece;
      ASSERT_EQ(watched->save(), told->save()) << hold << ", pieces of " << piece;
    }
  }
  EXPECT_GT(held_within, 20);
  EXPECT_GT(pieces, sightline::tests::effort(1000, 100));
}

std::size_t times(const Walk& found, Probe::Kind kind) { return found.of_kind[static_cast<std::size_t>(kind)]; }

TEST(I8080Probe, BreakpointsStopLikeTheOracle) {
  const Walk found = walks({.executed = true}, 19740401);
  EXPECT_GT(found.pieces, sightline::tests::effort(200U, 20U));
  EXPECT_GT(times(found, Probe::Kind::execution), sightline::tests::effort(1000U, 100U));
}

TEST(I8080Probe, WatchpointsStopLikeTheOracle) {
  const Walk found = walks({.accesses = true}, 19750101);
  EXPECT_GT(times(found, Probe::Kind::read), sightline::tests::effort(500U, 50U));
  EXPECT_GT(times(found, Probe::Kind::write), sightline::tests::effort(500U, 50U));
}

TEST(I8080Probe, AllKindsOfMarksTogether) {
  [[maybe_unused]] const Walk found = walks({.executed = true, .accesses = true, .ports = true}, 19760101);
  // Few walks reach ports.
  if (sightline::tests::is_optimised()) {
    for (const auto kind : {Probe::Kind::execution, Probe::Kind::read, Probe::Kind::write, Probe::Kind::port_read, Probe::Kind::port_write, Probe::Kind::interrupt})
      EXPECT_GT(times(found, kind), 20U) << static_cast<int>(kind);
  }
}

}  // namespace
}  // namespace sightline::test
