// The pins and registers of an 8080 as a value change dump.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "emulators/core/tstates.hpp"
#include "emulators/machines/i8080.hpp"
#include "host/machines/vcd.hpp"

namespace sightline::machines {

// The signals that --vcd offers for an 8080.
[[nodiscard]] std::span<const VcdSignal> i8080_signals();

// Derives pins by T-state from machine cycles. The levels of a T-state are fixed except for the number of wait states,
// which follows from the time until the next cycle.
class I8080Vcd {
 public:
  // The writer must be made from i8080_signals(). `requested`: whether a device requests an interrupt.
  I8080Vcd(VcdWriter writer, core::ClockRate clock, std::function<bool()> requested)
      : writer_(std::move(writer)), clock_(clock), requested_(std::move(requested)) {}
  void take(TextTaker taker) { writer_.take(std::move(taker)); }
  void finish(core::TStateInstant now);

  void cycle(const i8080::BusCycle& cycle);
  void instruction(const i8080::InstructionRecord& record);
  // Called before the cycle in which the pins change. If the processor begins to wait, the previous cycle ends there.
  void hold(const i8080::HoldPins& pins);

 private:
  void show(core::TStateInstant at, std::size_t row, std::uint32_t value);
  // Shows the changes up to `at`. The board that has the bus drives address and data.
  void show_holds(core::TStateInstant at);
  void show_pin(core::TStateInstant at, std::size_t row, std::uint32_t value);
  void first_t_state(const i8080::BusCycle& cycle);
  // Shows the halt until the next cycle begins.
  void begin_halt(const i8080::BusCycle& cycle);
  // Shows all T-states of the cycle, which ends at `end`.
  void end_cycle(core::TStateInstant end);

  VcdWriter writer_;
  core::ClockRate clock_;
  std::function<bool()> requested_;
  std::optional<i8080::BusCycle> pending_;
  i8080::Byte opcode_ = 0;                     // of the current instruction
  std::deque<i8080::HoldPins> holds_;  // not shown yet
  bool begun_ = false;
  core::TStateInstant latest_{};
};

}  // namespace sightline::machines
