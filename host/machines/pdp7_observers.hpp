// Observers of a run of the PDP-7: trace, VCD and monitor.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "emulators/machines/pdp7.hpp"
#include "host/machines/machine.hpp"
#include "host/machines/pdp7_vcd.hpp"
#include "host/machines/probe.hpp"

namespace sightline::machines {

// Writes lines with time (ns, decimal, of the fetch), PC, word, disassembly, and AC, L, MQ after the instruction.
class Pdp7Tracer {
 public:
  void instruction(const pdp7::InstructionRecord& record);
  void take(TextTaker taker) { text_.take(std::move(taker)); }
  void finish() { text_.finish(); }

 private:
  // Cached because a loop executes the same words at the same addresses.
  struct CachedText {
    core::Word18 word;
    std::string text;
  };
  const std::string& instruction_text(const pdp7::InstructionRecord& record);

  TextBlocks text_;
  std::vector<CachedText> cache_{std::size_t{pdp7::address_mask} + 1};
};

// The observer of a run with a trace, a VCD or both.
class Pdp7Recorder final : public pdp7::Observer {
 public:
  Pdp7Recorder() { instructions = true; }
  [[nodiscard]] bool records() const { return tracer.has_value() || vcd.has_value(); }
  void finish(core::Instant now);

  void instruction(const pdp7::InstructionRecord& record) override;
  void cycle(const pdp7::Cycle& cycle) override;

  std::optional<Pdp7Tracer> tracer;
  std::optional<Pdp7Vcd> vcd;
};

// The observer of a monitor with marks, conditions or an instruction listener.
class Pdp7Watcher final : public pdp7::Observer {
 public:
  // Made when a run begins: the probe must outlive the watcher, and its marks must not change during the run.
  Pdp7Watcher(Probe& probe, core::Instant now);

  void instruction(const pdp7::InstructionRecord& record) override;
  void cycle(const pdp7::Cycle& cycle) override;
  bool stop(core::Instant now, pdp7::Address next) override { return watch_.stop(core::nanoseconds_of(now), next); }

 private:
  void compare_with_marks(const pdp7::Cycle& cycle);
  void add(std::uint8_t mark, Probe::Kind kind, const pdp7::Cycle& cycle, std::uint32_t value);

  Probe& probe_;
  Watch watch_;
  bool listens_;  // each instruction is reported
  Probe::Entry entry_;
};

}  // namespace sightline::machines
