// Who hears what happens in a run of the PDP-7: traces and dumps, and what a monitor has asked for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "emulators/machines/observer.hpp"
#include "emulators/pdp7/bus.hpp"
#include "host/base/text.hpp"
#include "host/guests/run/machine.hpp"
#include "host/guests/run/pdp7_vcd.hpp"
#include "host/guests/run/probe.hpp"
#include "tools/disasm/disasm.hpp"

namespace sightline::guests::run {

// The fields of a line: time (ns, decimal, of the fetch), PC, word, disassembly, then AC, L, MQ after it.
class Pdp7Tracer {
 public:
  void instruction(const machines::InstructionRecord& record) {
    text_.write([&](std::string& text) {
      base::append(text, "{:>12} {:05o} {:06o}  {:<18} {:06o} {:o} {:06o}\n",
                   core::nanoseconds_of(record.time), record.pc, record.word.value(),
                   instruction_text(record), record.after.ac.value(), record.after.link ? 1 : 0,
                   record.after.mq.value());
    });
  }
  void take(TextTaker taker) { text_.take(std::move(taker)); }
  void finish() { text_.finish(); }

 private:
  // A loop meets the same words at the same places.
  struct Remembered {
    core::Word18 word;
    std::string text;
  };
  const std::string& instruction_text(const machines::InstructionRecord& record) {
    Remembered& known = remembered_[record.pc & pdp7::address_mask];
    if (known.text.empty() || known.word != record.word) {
      known = {record.word, disassembler::disassemble_word(record.word, record.pc)};
    }
    return known.text;
  }

  TextBlocks text_;
  std::vector<Remembered> remembered_{std::size_t{pdp7::address_mask} + 1};
};

// The observer of a monitor that has marked places or waits for conditions.
class Pdp7Watcher {
 public:
  static constexpr bool instructions = false;
  static constexpr bool cycles = true;
  static constexpr bool stops = true;

  explicit Pdp7Watcher(Probe& probe) : watch_(probe) {}

  void begin(core::Instant now) { watch_.begin(core::nanoseconds_of(now)); }
  [[nodiscard]] bool reads_machine() const { return watch_.reads_machine(); }
  [[nodiscard]] bool stop(core::Instant now, pdp7::Address next) { return watch_.stop(core::nanoseconds_of(now), next); }
  void cycle(const pdp7::Cycle& cycle) {
    using pdp7::Verb;
    const std::uint32_t word = cycle.data.value();
    switch (cycle.verb) {
      case Verb::fetch:
      case Verb::break_read:
      case Verb::idle: return;
      case Verb::read: return add(Probe::is_read, Probe::Kind::read, cycle, word);
      case Verb::write: return add(Probe::is_written, Probe::Kind::write, cycle, word);
      case Verb::modify:
        add(Probe::is_read, Probe::Kind::read, cycle, (cycle.data - core::Word18(1)).value());
        return add(Probe::is_written, Probe::Kind::write, cycle, word);
      case Verb::break_write:
      case Verb::break_modify: return add(Probe::is_written, Probe::Kind::break_write, cycle, word);
      case Verb::interrupt:
        if (watch_.at_interrupts()) watch_.add(Probe::Kind::interrupt, core::nanoseconds_of(cycle.time), word & pdp7::address_mask, 0);
        return add(Probe::is_written, Probe::Kind::interrupt_write, cycle, word);
      case Verb::iot: {
        const std::uint32_t device = (cycle.address >> 6) & 077U;
        if (!watch_.port_has(device, Probe::executed)) return;
        return watch_.add(Probe::Kind::port_write, core::nanoseconds_of(cycle.time), device, cycle.address | 0700000U);
      }
    }
  }

 private:
  void add(std::uint8_t mark, Probe::Kind kind, const pdp7::Cycle& cycle, std::uint32_t value) {
    if (watch_.has(cycle.address, mark)) watch_.add(kind, core::nanoseconds_of(cycle.time), cycle.address, value);
  }

  Watch watch_;
};

// The same, and tells each instruction.
class Pdp7Listener {
 public:
  explicit Pdp7Listener(Probe& probe) : probe_(probe), watcher_(probe) {}

  void begin(core::Instant now) { watcher_.begin(now); }
  [[nodiscard]] bool reads_machine() const { return watcher_.reads_machine(); }
  bool stop(core::Instant now, pdp7::Address next) { return watcher_.stop(now, next); }
  void instruction(const machines::InstructionRecord& record) {
    entry_.time = core::nanoseconds_of(record.time);
    entry_.pc = record.pc;
    entry_.word = record.word.value();
    entry_.accumulator = record.after.ac.value();
    entry_.link = record.after.link ? 1 : 0;
    if (probe_.on_instruction) probe_.on_instruction(entry_);
    entry_.has_address = false;
  }
  void cycle(const pdp7::Cycle& cycle) {
    watcher_.cycle(cycle);
    if (probe_.on_cycle) tell(cycle);
    const bool uses = cycle.verb == pdp7::Verb::read || cycle.verb == pdp7::Verb::modify || cycle.verb == pdp7::Verb::write;
    if (!uses) return;
    entry_.has_address = true;
    entry_.address = cycle.address;
    entry_.value = cycle.data.value();
  }

 private:
  void tell(const pdp7::Cycle& cycle) {
    constexpr std::array names{"fetch", "read", "write", "read and write", "interrupt", "iot", "EAE", "break, read", "break, write", "clock tick"};
    const bool has_address = cycle.verb != pdp7::Verb::idle && cycle.verb != pdp7::Verb::iot;
    probe_.on_cycle({core::nanoseconds_of(cycle.time), cycle.length.count(), names[static_cast<std::size_t>(cycle.verb)], has_address,
                     cycle.address, cycle.data.value()});
  }

  Probe& probe_;
  Pdp7Watcher watcher_;
  Probe::Entry entry_;
};

// The observer of all that hear every instruction: a trace, a VCD or both, or a monitor. One for them all: a machine is compiled for
// each observer, which takes long, and they are slow for what they write.
class Pdp7Reporter {
 public:
  static constexpr bool instructions = true;
  static constexpr bool cycles = true;
  static constexpr bool stops = true;

  Pdp7Reporter(Pdp7Tracer* tracer, Pdp7Vcd* vcd) : tracer_(tracer), vcd_(vcd) {}
  explicit Pdp7Reporter(Probe& probe) : listener_(std::in_place, probe) {}

  void begin(core::Instant now) {
    if (listener_) listener_->begin(now);
  }
  bool stop(core::Instant now, pdp7::Address next) { return listener_ && listener_->stop(now, next); }
  [[nodiscard]] bool reads_machine() const { return listener_ && listener_->reads_machine(); }
  // Out of line: they are called from where every instruction and every cycle ends.
  [[gnu::noinline]] void instruction(const machines::InstructionRecord& record) {
    if constexpr (!few_observers) {
      if (tracer_ != nullptr) tracer_->instruction(record);
      if (vcd_ != nullptr) vcd_->instruction(record);
    }
    if (listener_) listener_->instruction(record);
  }
  [[gnu::noinline]] void cycle(const pdp7::Cycle& cycle) {
    if constexpr (!few_observers) {
      if (vcd_ != nullptr) vcd_->cycle(cycle);
    }
    if (listener_) listener_->cycle(cycle);
  }

 private:
  Pdp7Tracer* tracer_ = nullptr;
  Pdp7Vcd* vcd_ = nullptr;
  std::optional<Pdp7Listener> listener_;
};

}  // namespace sightline::guests::run
