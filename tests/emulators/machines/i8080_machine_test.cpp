// The 8080 machine alone: when ports are accessed, when a run stops, and the calls that an observer gets.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include "emulators/devices/bus_master.hpp"
#include "tests/emulators/machines/i8080_script.hpp"

namespace sightline {
namespace {

using i8080::StopReason;

struct Bench {
  tests::I8080Recorder recorder{true};
  i8080::Machine machine;
  tests::ScriptDevice& ports = tests::attach_script(machine, true, true);

  explicit Bench(std::initializer_list<std::uint8_t> program) {
    i8080::Address at = 0x100;
    for (const std::uint8_t byte : program) machine.deposit(at++, byte);
    machine.registers().pc = 0x100;
    machine.registers().sp = 0x8000;
  }
  StopReason run(std::uint64_t instructions = 100) { return machine.run({instructions, core::never_t}, recorder); }
  std::int64_t now() const { return core::t_states_of(machine.now()); }
  // INT high from T-state `from` up to and not including `to`.
  void interrupt(std::size_t from, std::size_t to) {
    ports.levels.resize(std::max(ports.levels.size(), to + 1));
    for (std::size_t t = from; t < to; ++t) ports.levels[t].interrupt = true;
  }
};

TEST(I8080Machine, PortsAreTouchedInTheTenthTState) {
  Bench bench{0x3E, 0x5A, 0xD3, 0x10, 0xDB, 0x20, 0x76};  // MVI A; OUT; IN; HLT
  bench.ports.input = 0x77;
  EXPECT_EQ(bench.run(), StopReason::halt);
  EXPECT_EQ(bench.ports.writes, (std::vector<tests::PortAccess>{{7 + 9, 0x10, 0x5A}}));
  EXPECT_EQ(bench.ports.reads, (std::vector<tests::PortAccess>{{17 + 9, 0x20, 0x77}}));
  EXPECT_EQ(bench.machine.registers().a, 0x77);
  EXPECT_EQ(bench.now(), 7 + 10 + 10 + 7);
  EXPECT_EQ(bench.machine.instructions(), 4U);
}

TEST(I8080Machine, WaitStatesComeBeforeTheTransfer) {
  Bench bench{0xD3, 0x10, 0x76};
  bench.ports.levels.resize(12);
  for (const std::size_t t : {1U, 2U, 10U, 11U}) bench.ports.levels[t].ready = false;  // T2 of the fetch, then of OUT
  bench.run();
  EXPECT_EQ(bench.ports.writes.at(0).t, 9 + 2 + 2);
  EXPECT_EQ(bench.now(), 10 + 2 + 2 + 7);
}

TEST(I8080Machine, AnInterruptIsTakenAfterTheInstructionWhoseLastTStateSeesIt) {
  for (const auto& [first, taken] : {std::pair<std::size_t, bool>{3, true}, {4, false}}) {
    Bench bench{0x00, 0x00, 0x00, 0x00};
    bench.machine.registers().interrupts_on = true;
    bench.interrupt(first, 8);
    bench.run(2);
    EXPECT_EQ(bench.recorder.executed.at(1).acknowledged, taken) << first;
    EXPECT_EQ(bench.recorder.seen.at(1).status, taken ? 0x23 : 0xA2) << first;
  }
}

TEST(I8080Machine, EiDelaysTheInterruptByOneInstruction) {
  Bench bench{0xFB, 0xFB, 0xC9};  // EI; EI; RET
  bench.machine.deposit(0x8000, 0x34);
  bench.machine.deposit(0x8001, 0x12);
  bench.interrupt(0, 40);
  bench.run(4);
  ASSERT_EQ(bench.recorder.executed.size(), 4U);
  EXPECT_FALSE(bench.recorder.executed[2].acknowledged);
  EXPECT_TRUE(bench.recorder.executed[3].acknowledged);
  EXPECT_EQ(bench.recorder.executed[3].pc, 0x1234);
  EXPECT_EQ(bench.machine.registers().pc, 0x0038);
  EXPECT_EQ(bench.machine.peek(0x8001), 0x12);  // pushed again
  EXPECT_FALSE(bench.machine.registers().interrupts_on);
}

TEST(I8080Machine, AnInterruptThreeTStatesLaterEndsAHalt) {
  Bench bench{0xFB, 0x76};  // EI; HLT
  bench.interrupt(1000, 1010);
  bench.run(3);
  ASSERT_EQ(bench.recorder.executed.size(), 3U);
  EXPECT_EQ(bench.recorder.executed[2].begun, 1003);
  EXPECT_EQ(bench.recorder.seen.at(3).status, 0x2B);
  EXPECT_EQ(bench.machine.peek(0x7FFE), 0x02);  // the address after HLT
}

TEST(I8080Machine, AnInterruptThatWasThereAlreadyEndsAHaltAfterEightTStates) {
  Bench bench{0xFB, 0x76};
  bench.interrupt(0, 40);
  bench.run(3);
  EXPECT_EQ(bench.recorder.executed.at(2).begun, 4 + 8);
}

TEST(I8080Machine, APulseEndsAHaltWithoutAnInterrupt) {
  Bench bench{0xFB, 0x76, 0x3C};
  bench.interrupt(50, 51);
  bench.run(3);
  EXPECT_EQ(bench.recorder.seen.at(3).status, 0xAA);
  EXPECT_EQ(bench.machine.registers().a, 1);
  EXPECT_TRUE(bench.machine.registers().interrupts_on);
}

TEST(I8080Machine, ACallMayBeSupplied) {
  Bench bench{0x00, 0x00};
  bench.machine.registers().interrupts_on = true;
  bench.ports.supplied = {0xCD, 0x00, 0x20};
  bench.interrupt(0, 8);  // drops in T5 of the acknowledge
  bench.run(2);
  EXPECT_EQ(bench.machine.registers().pc, 0x2000);
  EXPECT_EQ(bench.machine.peek(0x7FFE), 0x01);
  EXPECT_EQ(bench.recorder.seen.at(1).status, 0x23);
  EXPECT_EQ(bench.recorder.seen.at(2).status, 0x02);
  EXPECT_EQ(bench.recorder.seen.at(2).address, 0x0101);
  EXPECT_EQ(bench.recorder.seen.at(3).address, 0x0101);
}

TEST(I8080Machine, LimitsAreExact) {
  Bench bench{0x00, 0x23, 0xC3, 0x00, 0x01};  // NOP; INX H; JMP
  for (std::uint64_t n = 1; n < 50; ++n) {
    const std::uint64_t before = bench.machine.instructions();
    EXPECT_EQ(bench.run(n), StopReason::instruction_limit);
    EXPECT_EQ(bench.machine.instructions() - before, n);
  }
  Bench timed{0x00, 0x23, 0xC3, 0x00, 0x01};
  EXPECT_EQ(timed.machine.run({.until = core::at_t_state(9)}), StopReason::time_limit);
  EXPECT_EQ(timed.now(), 9);
  EXPECT_EQ(timed.machine.run({.until = core::at_t_state(10)}), StopReason::time_limit);
  EXPECT_EQ(timed.now(), 19);
  EXPECT_EQ(timed.run(0), StopReason::instruction_limit);
  EXPECT_EQ(timed.now(), 19);
}

TEST(I8080Machine, PortsEndARunAfterTheInstructionThatTouchedThem) {
  Bench bench{0xD3, 0x00, 0x00, 0x00};
  bench.ports.stopped_by_writes = &bench.machine;
  EXPECT_EQ(bench.run(), StopReason::device);
  EXPECT_EQ(bench.now(), 10);
}

TEST(I8080Machine, ResetKeepsAllButPcAndInte) {
  Bench bench{0xFB, 0x76};
  bench.machine.registers().a = 0x55;
  bench.run();
  EXPECT_TRUE(bench.machine.registers().halted);
  bench.machine.reset();
  EXPECT_EQ(bench.machine.registers().pc, 0);
  EXPECT_EQ(bench.machine.registers().a, 0x55);
  EXPECT_EQ(bench.machine.registers().sp, 0x8000);
  EXPECT_FALSE(bench.machine.registers().interrupts_on);
  EXPECT_FALSE(bench.machine.registers().halted);
}

TEST(I8080Machine, ResetBetweenAHaltAndTheFetchThatEndsItForgetsTheHalt) {
  Bench bench{0xFB, 0x76};  // EI; HLT
  bench.interrupt(20, 40);
  EXPECT_EQ(bench.machine.run({100, core::at_t_state(22)}, bench.recorder), StopReason::time_limit);
  EXPECT_EQ(bench.now(), 23);
  EXPECT_FALSE(bench.machine.registers().halted);
  bench.machine.reset();
  bench.run(1);
  EXPECT_EQ(bench.recorder.seen.back().address, 0);
  EXPECT_EQ(bench.recorder.seen.back().status, 0xA2);  // not AA, the fetch that ends a halt
}

TEST(I8080Machine, AHaltThatEndedUnobservedLeavesNoHlta) {
  Bench bench{0xFB, 0x76, 0x00, 0x00};  // EI; HLT
  bench.interrupt(50, 51);
  EXPECT_EQ(bench.machine.run({3, core::never_t}), StopReason::instruction_limit);
  bench.run(1);
  EXPECT_EQ(bench.recorder.seen.back().address, 0x0103);
  EXPECT_EQ(bench.recorder.seen.back().status, 0xA2);
}

TEST(I8080Machine, StopIsCalledAtTheStartOfARunAtMarksAndAfterReportedCycles) {
  struct Marked : i8080::Observer {
    std::array<std::uint8_t, 65536> of_memory{};
    std::array<std::uint8_t, 256> of_ports{};
    std::vector<i8080::Address> stops;
    std::vector<i8080::Address> cycles;
    Marked() {
      marks = of_memory.data();
      port_marks = of_ports.data();
    }
    void cycle(const i8080::BusCycle& cycle) override { cycles.push_back(cycle.address); }
    bool stop(core::TStateInstant, i8080::Address next) override {
      stops.push_back(next);
      return false;
    }
  } observer;
  Bench bench{0x00, 0x32, 0x00, 0x20, 0x3A, 0x01, 0x20, 0xD3, 0x10, 0xD3, 0x11, 0x00, 0x76};  // NOP; STA 2000; LDA 2001; OUT; OUT; NOP; HLT
  observer.of_memory[0x2000] = i8080::mark::read;
  observer.of_memory[0x2001] = i8080::mark::read;
  observer.of_memory[0x0104] = i8080::mark::read | i8080::mark::stop;  // of an opcode
  observer.of_ports[0x10] = i8080::mark::read;
  observer.of_ports[0x11] = i8080::mark::written;
  EXPECT_EQ(bench.machine.run({}, observer), StopReason::halt);
  EXPECT_EQ(observer.cycles, (std::vector<i8080::Address>{0x2001, 0x1111}));
  EXPECT_EQ(observer.stops, (std::vector<i8080::Address>{0x0100, 0x0104, 0x0107, 0x010B}));
}

TEST(I8080Machine, DadHasNoCycleToReport) {
  Bench bench{0x29, 0x76};
  bench.run();
  ASSERT_EQ(bench.recorder.seen.size(), 3U);
  EXPECT_EQ(bench.recorder.seen[1].time, core::at_t_state(10));
  EXPECT_EQ(bench.recorder.seen[2].status, 0x8A);
  EXPECT_EQ(bench.recorder.seen[2].address, 0x0101);
}

TEST(I8080Machine, HoldDoesNotKeepAHaltFromEndingTheRun) {
  for (const bool open : {false, true}) {
    // So often that the machine never leaves the pin-level engine.
    i8080::Machine machine;
    const std::array<core::Setting, 3> times{{{"first", 3}, {"length", 20}, {"period", 30}}};
    ASSERT_EQ(machine.attach("bus-master", times), "");
    machine.deposit(0x100, 0x76);
    machine.registers().pc = 0x100;
    machine.registers().interrupts_on = open;
    EXPECT_EQ(machine.run({}), StopReason::halt);
    EXPECT_EQ(machine.run({}), StopReason::halt);
    EXPECT_TRUE(machine.registers().halted);
  }
}

// INT rises with the OUT of one value; the OUT of another ends the run.
struct QuietDevice : core::PortDevice {
  static constexpr core::PortDeviceInfo info{.name = "quiet", .help = "", .choice = "", .writes = tests::all_ports};
  explicit QuietDevice(i8080::Machine& machine) : machine_(machine) {}
  bool high = false;
  std::uint8_t acknowledge(core::TStateInstant) override {
    high = false;
    return 0xFF;
  }
  void out(std::uint8_t, std::uint8_t value, core::TStateInstant) override {
    high = value == 2;
    if (value == 3) machine_.request_stop();
  }
  [[nodiscard]] bool drives_interrupt() const override { return true; }
  [[nodiscard]] unsigned requests() const override { return high ? 1 : 0; }

 private:
  i8080::Machine& machine_;
};

TEST(I8080Machine, ADeviceMayRequestAnInterruptOrAStopByAnAccess) {
  i8080::Machine machine;
  ASSERT_EQ(machine.attach(QuietDevice::info, std::make_unique<QuietDevice>(machine)), "");
  i8080::Address at = 0;
  // EI; IN; MVI A,1; OUT; INR A; OUT; INR A; OUT; HLT
  for (const int byte : {0xFB, 0xDB, 0x10, 0x3E, 0x01, 0xD3, 0x10, 0x3C, 0xD3, 0x10, 0x3C, 0xD3, 0x10, 0x76})
    machine.deposit(at++, static_cast<i8080::Byte>(byte));
  machine.deposit(0x38, 0xC9);  // RET
  machine.registers().sp = 0x8000;
  EXPECT_EQ(machine.run({}), StopReason::device);
  EXPECT_EQ(machine.registers().pc, 0x0D);
  EXPECT_EQ(core::t_states_of(machine.now()), 4 + 10 + 7 + 10 + 5 + 10 + (11 + 10) + 5 + 10);
  EXPECT_EQ(machine.peek(0x7FFE), 0x0A);  // the interrupt came after the second OUT
  machine.registers().pc = 1;
  EXPECT_EQ(machine.run({.instructions = 1}), StopReason::instruction_limit);
  EXPECT_EQ(machine.registers().pc, 3);
  EXPECT_EQ(machine.run({}), StopReason::device);
}

TEST(I8080Machine, ALongHoldIsSkipped) {
  i8080::Machine machine;
  const std::array<core::Setting, 2> times{{{"first", 2'000}, {"length", 4'000'000'000}}};
  ASSERT_EQ(machine.attach("bus-master", times), "");
  EXPECT_EQ(machine.run({.until = core::at_t_state(3'000'000'000)}), StopReason::time_limit);
  EXPECT_EQ(machine.now(), core::at_t_state(3'000'000'000));
  // NOPs: HOLD comes in T1 of a fetch, is sampled in T2 and granted in T3; T4 is the last T-state before the processor stops.
  EXPECT_EQ(machine.instructions(), 501U);
  EXPECT_EQ(machine.held(), 3'000'000'000U - 2'004U);
  EXPECT_EQ(machine.run({1, core::never_t}), StopReason::instruction_limit);
  EXPECT_EQ(machine.now(), core::at_t_state(4'000'002'001 + 4));
}

}  // namespace
}  // namespace sightline
