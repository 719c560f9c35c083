// The 8080 as programs use it: a device's requests take effect at the next boundary, and a run ends at an address.
#include "host/machines/i8080_run_to.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <vector>

#include "emulators/core/port_device.hpp"

namespace sightline::machines {
namespace {

using i8080::StopReason;

// INT is high from the OUT of an odd byte, or a time after it, to the acknowledge, which receives RST 7. Without `drives` it is
// not
// connected. The OUT of `stop_at` ends the run.
class Board final : public core::PortDevice {
 public:
  static constexpr core::PortRange ports[]{{0x10, 0x10}};
  static constexpr std::string_view lines[]{"board"};
  static constexpr core::PortDeviceInfo info{.name = "board", .help = "for tests", .choice = "board", .reads = ports, .writes = ports, .lines = lines};

  Board(i8080::Machine& machine, bool drives, std::int64_t delay) : machine_(machine), drives_(drives), delay_(delay) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t, core::TStateInstant) override { return 0; }
  void out(std::uint8_t, std::uint8_t value, core::TStateInstant at) override {
    written.push_back(value);
    if (value == stop_at) machine_.request_stop();
    if (value % 2 == 0) return;
    rises_ = at + core::TStates(delay_);
    advance(at);
  }
  [[nodiscard]] bool drives_interrupt() const override { return drives_; }
  void advance(core::TStateInstant now) override {
    if (now < rises_) return;
    high_ = true;
    rises_ = core::never_t;
  }
  [[nodiscard]] core::TStateInstant deadline() const override { return rises_; }
  [[nodiscard]] unsigned requests() const override { return high_ ? 1 : 0; }
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant) override {
    high_ = false;
    return 0xFF;
  }

  std::vector<std::uint8_t> written;
  std::uint8_t stop_at = 0;

 private:
  i8080::Machine& machine_;
  bool drives_;
  std::int64_t delay_;
  bool high_ = false;
  core::TStateInstant rises_ = core::never_t;
};

Board& attach_board(i8080::Machine& machine, bool drives = false, std::int64_t delay = 0) {
  EXPECT_EQ(machine.attach(Board::info, std::make_unique<Board>(machine, drives, delay)), "");
  return *machine.find<Board>();
}

void put(i8080::Machine& machine, std::initializer_list<i8080::Byte> program, i8080::Address address = 0) {
  machine.load(address, {program.begin(), program.size()});
}

std::int64_t now(const i8080::Machine& machine) { return core::t_states_of(machine.now()); }

TEST(GuestI8080, ADeviceEndsARunAfterTheInstructionThatTouchedIt) {
  i8080::Machine machine;
  Board& board = attach_board(machine);
  board.stop_at = 3;
  put(machine, {0x3C, 0xD3, 0x10, 0xC3, 0x00, 0x00});  // INR A; OUT 10; JMP 0
  EXPECT_EQ(machine.run({}), StopReason::device);
  EXPECT_EQ(board.written, (std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_EQ(now(machine), 3 * (5 + 10) + 2 * 10);
  EXPECT_EQ(machine.registers().pc, 3);
}

TEST(GuestI8080, LimitsApplyWhileAProgramPollsAPort) {
  i8080::Machine machine;
  attach_board(machine);
  put(machine, {0xDB, 0x10, 0xC3, 0x00, 0x00});  // IN 10; JMP 0
  i8080::Limits limits;
  limits.until = core::at_t_state(1'000'001);
  EXPECT_EQ(machine.run(limits), StopReason::time_limit);
  EXPECT_EQ(now(machine), 1'000'010);
  EXPECT_EQ(machine.instructions(), 100'001U);
  limits = {};
  limits.instructions = 9'999;
  EXPECT_EQ(machine.run(limits), StopReason::instruction_limit);
  EXPECT_EQ(machine.instructions(), 110'000U);
  EXPECT_EQ(now(machine), 1'100'000);
}

TEST(GuestI8080, AnInterruptCausedByAnOutFollowsTheOut) {
  for (const bool wired : {true, false}) {
    i8080::Machine machine;
    attach_board(machine, wired);
    put(machine, {0xFB, 0x00, 0x3C, 0xD3, 0x10, 0x76});  // EI; NOP; INR A; OUT 10; HLT
    machine.deposit(0x38, 0x76);
    machine.registers().sp = 0x8000;
    EXPECT_EQ(machine.run({}), StopReason::halt);
    EXPECT_EQ(machine.registers().pc, wired ? 0x39 : 6);
    EXPECT_EQ(now(machine), 4 + 4 + 5 + 10 + 7 + (wired ? 11 : 0));
  }
}

// T3 of the OUT's last cycle is T-state 22; the NOPs after it begin in 23, 27, and so on.
TEST(GuestI8080, ADelayedInterruptCausedByAnOutComesInTime) {
  for (const std::int64_t delay : {1, 4, 5, 100, 1000}) {
    i8080::Machine machine;
    attach_board(machine, true, delay);
    put(machine, {0xFB, 0x00, 0x3C, 0xD3, 0x10});  // EI; NOP; INR A; OUT 10; NOPs
    machine.deposit(0x38, 0x00);
    machine.registers().sp = 0x8000;
    machine.registers().pc = 0;
    i8080::Limits limits;
    limits.until = core::at_t_state(22 + delay + 1);
    EXPECT_EQ(machine.run(limits), StopReason::time_limit);
    const std::int64_t nops = (delay + 3) / 4;  // up to the NOP whose last T-state samples INT high
    EXPECT_EQ(now(machine), 23 + 4 * nops) << delay;
    EXPECT_TRUE(machine.registers().interrupts_on);
    limits.instructions = 1;
    limits.until = core::never_t;
    EXPECT_EQ(machine.run(limits), StopReason::instruction_limit);
    EXPECT_EQ(machine.registers().pc, 0x38) << delay;
  }
}

TEST(GuestI8080, ARunEndsAtAnAddress) {
  i8080::Machine machine;
  Board& board = attach_board(machine);
  put(machine, {0x00, 0xC3, 0x00, 0x10});  // NOP; JMP 1000
  put(machine, {0x3C, 0xD3, 0x10, 0xFE, 0x02, 0xC2, 0x00, 0x10, 0x76}, 0x1000);  // INR A; OUT 10; CPI 2; JNZ 1000; HLT
  EXPECT_EQ(run_to(machine, 0x1000, {}), StopReason::observer);
  EXPECT_EQ(now(machine), 4 + 10);
  EXPECT_EQ(machine.registers().pc, 0x1000);
  EXPECT_EQ(machine.registers().a, 0);
  constexpr std::int64_t once = 5 + 10 + 7 + 10;
  EXPECT_EQ(run_to(machine, 0x1000, {}), StopReason::observer);
  EXPECT_EQ(now(machine), 4 + 10 + once);
  EXPECT_EQ(run_to(machine, 0x1000, {}), StopReason::halt);
  EXPECT_EQ(now(machine), 4 + 10 + 2 * once + 7);
  EXPECT_EQ(board.written, (std::vector<std::uint8_t>{1, 2}));
  EXPECT_EQ(machine.instructions(), 2U + 2 * 4 + 1);
}

TEST(GuestI8080, ARunToAnAddressHasLimits) {
  i8080::Machine machine;
  put(machine, {0xC3, 0x00, 0x00});
  i8080::Limits limits;
  limits.until = core::at_t_state(95);
  EXPECT_EQ(run_to(machine, 0x1000, limits), StopReason::time_limit);
  EXPECT_EQ(now(machine), 100);
}

}  // namespace
}  // namespace sightline::machines
