// The cycles, breaks, registers and display flags of a PDP-7 as a value change dump.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include "emulators/core/time.hpp"
#include "emulators/machines/pdp7.hpp"
#include "emulators/pdp7/bus.hpp"
#include "emulators/type340/registers.hpp"
#include "host/machines/vcd.hpp"

namespace sightline::machines {

// The signals that --vcd offers for a PDP-7.
[[nodiscard]] std::span<const VcdSignal> pdp7_signals();

// Converts bus events and registers into a VCD. The registers of the display are read when an instruction ends.
class Pdp7Vcd {
 public:
  // Returns the registers of the display; nullptr: it is not plugged in.
  using DisplayRegisters = std::function<const type340::Registers*()>;
  // The writer must be made from pdp7_signals().
  Pdp7Vcd(VcdWriter writer, DisplayRegisters display) : writer_(std::move(writer)), display_(std::move(display)) {}
  void take(TextTaker taker) { writer_.take(std::move(taker)); }
  void finish(core::Instant now);

  void cycle(const pdp7::Cycle& cycle);
  void instruction(const pdp7::InstructionRecord& record);

 private:
  [[nodiscard]] std::size_t kind_of(const pdp7::Cycle& cycle);
  // Predicts the purpose of the cycles after this instruction, including those of the target of an XCT.
  void follow(std::uint32_t word);
  void iot(const pdp7::Cycle& cycle, std::int64_t end);
  void clear_pulses(std::int64_t at);

  VcdWriter writer_;
  DisplayRegisters display_;
  bool defers_ = false;            // the next cycle fetches an indirect address
  bool executes_another_ = false;  // the cycle after that fetches an instruction
  bool pulses_ = false;
};

}  // namespace sightline::machines
