// The 8080 of all guests: what its ports and its lines say is seen at the next boundary, and a run ends at a place.
#include "host/guests/run/i8080_processor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace sightline::guests::run {
namespace {

using machines::I8080StopReason;

// INT is high from the OUT of an odd byte, or a time after it, to the acknowledge, which is given RST 7.
class Line final : public I8080Lines {
 public:
  explicit Line(std::int64_t delay = 0) : I8080Lines(false), delay_(delay) {}
  void start(core::TStateInstant now) {
    rises_ = now + core::TStates(delay_);
    advance(now);
  }
  void advance(core::TStateInstant now) override {
    if (now < rises_) return;
    high = true;
    rises_ = core::never_t;
  }
  [[nodiscard]] core::TStateInstant deadline() const override { return rises_; }
  [[nodiscard]] bool interrupt() const override { return high; }
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant) override {
    high = false;
    return 0xFF;
  }
  [[nodiscard]] core::TStateInstant next_hold(core::TStateInstant) const override { return core::never_t; }
  [[nodiscard]] core::TStateInstant hold_ends(core::TStateInstant t) const override { return t; }

  bool high = false;

 private:
  std::int64_t delay_;
  core::TStateInstant rises_ = core::never_t;
};

class Ports final : public I8080Ports {
 public:
  explicit Ports(Line* line = nullptr) : I8080Ports(line), line_(line) {}
  [[nodiscard]] std::uint8_t in(std::uint8_t, core::TStateInstant) override { return 0; }
  void out(std::uint8_t, std::uint8_t value, core::TStateInstant at) override {
    written.push_back(value);
    stopped_ = value == stop_at;
    if (line_ != nullptr && value % 2 != 0) line_->start(at);
  }

  std::vector<std::uint8_t> written;
  std::uint8_t stop_at = 0;

 private:
  Line* line_;
};

void put(I8080Processor& processor, std::initializer_list<i8080::Byte> program) {
  std::copy(program.begin(), program.end(), processor.memory().begin());
}

std::int64_t now(const I8080Processor& processor) { return core::t_states_of(processor.now()); }

TEST(I8080Processor, PortsEndARunAfterTheInstructionThatTouchedThem) {
  Ports ports;
  ports.stop_at = 3;
  I8080Processor processor(ports);
  put(processor, {0x3C, 0xD3, 0x10, 0xC3, 0x00, 0x00});  // INR A; OUT 10; JMP 0
  EXPECT_EQ(processor.run({}), I8080StopReason::ports);
  EXPECT_EQ(ports.written, (std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_EQ(now(processor), 3 * (5 + 10) + 2 * 10);
  EXPECT_EQ(processor.registers().pc, 3);
}

TEST(I8080Processor, LimitsHoldWhileAProgramAsksAPort) {
  Ports ports;
  I8080Processor processor(ports);
  put(processor, {0xDB, 0x10, 0xC3, 0x00, 0x00});  // IN 10; JMP 0
  machines::I8080Limits limits;
  limits.until = core::at_t_state(1'000'001);
  EXPECT_EQ(processor.run(limits), I8080StopReason::time_limit);
  EXPECT_EQ(now(processor), 1'000'010);
  EXPECT_EQ(processor.instructions(), 100'001U);
  limits = {};
  limits.instructions = 9'999;
  EXPECT_EQ(processor.run(limits), I8080StopReason::instruction_limit);
  EXPECT_EQ(processor.instructions(), 110'000U);
  EXPECT_EQ(now(processor), 1'100'000);
}

TEST(I8080Processor, AnInterruptThatAnOutBringsFollowsTheOut) {
  for (const bool wired : {true, false}) {
    Line line;
    Ports ports(wired ? &line : nullptr);
    I8080Processor processor(ports);
    put(processor, {0xFB, 0x00, 0x3C, 0xD3, 0x10, 0x76});  // EI; NOP; INR A; OUT 10; HLT
    processor.deposit(0x38, 0x76);
    processor.registers().sp = 0x8000;
    EXPECT_EQ(processor.run({}), I8080StopReason::halt);
    EXPECT_EQ(processor.registers().pc, wired ? 0x39 : 6);
    EXPECT_EQ(now(processor), 4 + 4 + 5 + 10 + 7 + (wired ? 11 : 0));
  }
}

// The OUT has T3 of its last cycle in T-state 22; the NOPs behind it begin in 23, 27, and so on.
TEST(I8080Processor, AnInterruptThatAnOutBringsLaterComesInTime) {
  for (const std::int64_t delay : {1, 4, 5, 100, 1000}) {
    Line line(delay);
    Ports ports(&line);
    I8080Processor processor(ports);
    put(processor, {0xFB, 0x00, 0x3C, 0xD3, 0x10});  // EI; NOP; INR A; OUT 10; NOPs
    processor.deposit(0x38, 0x00);
    processor.registers().sp = 0x8000;
    processor.registers().pc = 0;
    machines::I8080Limits limits;
    limits.until = core::at_t_state(22 + delay + 1);
    EXPECT_EQ(processor.run(limits), I8080StopReason::time_limit);
    const std::int64_t nops = (delay + 3) / 4;  // up to the one whose last T-state finds INT high
    EXPECT_EQ(now(processor), 23 + 4 * nops) << delay;
    EXPECT_TRUE(processor.registers().interrupts_on);
    limits.instructions = 1;
    limits.until = core::never_t;
    EXPECT_EQ(processor.run(limits), I8080StopReason::instruction_limit);
    EXPECT_EQ(processor.registers().pc, 0x38) << delay;
  }
}

TEST(I8080Processor, ARunEndsWhereTheProgramComesToAPlace) {
  Ports ports;
  I8080Processor processor(ports);
  put(processor, {0x00, 0xC3, 0x00, 0x10});  // NOP; JMP 1000
  const std::initializer_list<i8080::Byte> there{0x3C, 0xD3, 0x10, 0xFE, 0x02, 0xC2, 0x00, 0x10, 0x76};  // INR A; OUT 10; CPI 2; JNZ 1000; HLT
  std::copy(there.begin(), there.end(), processor.memory().begin() + 0x1000);
  EXPECT_EQ(processor.run_to(0x1000, {}), I8080StopReason::observer);
  EXPECT_EQ(now(processor), 4 + 10);
  EXPECT_EQ(processor.registers().pc, 0x1000);
  EXPECT_EQ(processor.registers().a, 0);
  constexpr std::int64_t once = 5 + 10 + 7 + 10;
  EXPECT_EQ(processor.run_to(0x1000, {}), I8080StopReason::observer);
  EXPECT_EQ(now(processor), 4 + 10 + once);
  EXPECT_EQ(processor.run_to(0x1000, {}), I8080StopReason::halt);
  EXPECT_EQ(now(processor), 4 + 10 + 2 * once + 7);
  EXPECT_EQ(ports.written, (std::vector<std::uint8_t>{1, 2}));
  EXPECT_EQ(processor.instructions(), 2U + 2 * 4 + 1);
}

TEST(I8080Processor, ARunToAPlaceHasLimits) {
  Ports ports;
  I8080Processor processor(ports);
  put(processor, {0xC3, 0x00, 0x00});
  machines::I8080Limits limits;
  limits.until = core::at_t_state(95);
  EXPECT_EQ(processor.run_to(0x1000, limits), I8080StopReason::time_limit);
  EXPECT_EQ(now(processor), 100);
}

}  // namespace
}  // namespace sightline::guests::run
