// Who hears what happens in a run of the PDP-7: traces and dumps, and what a monitor has asked for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "emulators/core/inline.hpp"
#include "emulators/machines/observer.hpp"
#include "emulators/machines/pdp7_bus.hpp"
#include "emulators/pdp7/bus.hpp"
#include "emulators/pdp7/core_memory.hpp"
#include "emulators/pdp7/isa.hpp"
#include "emulators/pdp7/registers.hpp"
#include "host/base/text.hpp"
#include "host/guests/run/machine.hpp"
#include "host/guests/run/outlook.hpp"
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

// Where Outlook finds the registers of the PDP-7. The number of a register is its place in the description.
struct Pdp7Outlook {
  using Address = pdp7::Address;
  using View = machines::Pdp7View;
  using Instant = core::Instant;
  static constexpr std::size_t addresses = std::size_t{pdp7::address_mask} + 1;
  static constexpr std::uint8_t memory = pdp7::change::memory;
  static constexpr std::array parts{pdp7::change::accumulator, pdp7::change::eae, pdp7::change::modes};
  static constexpr std::size_t program_counter = 0;

  template <std::uint8_t part>
  [[nodiscard]] SIGHTLINE_INLINE static std::uint32_t value(const View& view) {
    if constexpr (part == pdp7::change::accumulator) return view.accumulator;
    else if constexpr (part == pdp7::change::eae) return view.others->mq.value();
    else return view.others->modes;
  }
  [[nodiscard]] static Part part_of(std::size_t number, bool) {
    constexpr unsigned link = 18, interrupts_on = 1;
    static_assert(pdp7::Accumulator::carry == 1U << link && pdp7::mode::interrupts_on == 1U << interrupts_on);
    switch (number) {
      case 1: return {pdp7::change::accumulator, 0, core::Word18::mask};
      case 2: return {pdp7::change::accumulator, link, 1};
      case 3: return {pdp7::change::eae, 0, core::Word18::mask};
      case 4: return {pdp7::change::eae, 0, 0};  // SC is not compared
      case 6: return {pdp7::change::modes, interrupts_on, 1};
      default: return {};
    }
  }
  [[nodiscard]] static std::int64_t register_value(std::size_t number, Address next, const View& view) {
    const pdp7::Accumulator accumulator(view.accumulator);
    switch (number) {
      case 0: return next;
      case 1: return accumulator.ac().value();
      case 2: return accumulator.link() ? 1 : 0;
      case 3: return view.others->mq.value();
      case 4: return view.others->sc.value();
      default: return view.others->is(pdp7::mode::interrupts_on) ? 1 : 0;
    }
  }
  [[nodiscard]] static std::optional<std::int64_t> word(std::int64_t address, const View& view) {
    if (address < 0 || address >= static_cast<std::int64_t>(view.core.size())) return std::nullopt;
    return view.core[static_cast<std::size_t>(address)].without_marks().value();
  }
  [[nodiscard]] static std::int64_t ticks(Instant at) { return core::nanoseconds_of(at); }
};

// What a monitor's marks leave of the cycles of a run.
struct Pdp7Marked {
  const std::uint8_t* places;
  const std::uint8_t* ports;

  explicit Pdp7Marked(const Probe& probe) : places(probe.marks()), ports(probe.port_marks()) {}
  SIGHTLINE_INLINE bool wants(const pdp7::Cycle& cycle) const {
    switch (cycle.verb) {
      case pdp7::Verb::fetch:
      case pdp7::Verb::break_read:
      case pdp7::Verb::idle: return false;
      case pdp7::Verb::read: return (places[cycle.address] & Probe::is_read) != 0;
      case pdp7::Verb::modify: return (places[cycle.address] & (Probe::is_read | Probe::is_written)) != 0;
      case pdp7::Verb::write:
      case pdp7::Verb::break_write:
      case pdp7::Verb::break_modify: return (places[cycle.address] & Probe::is_written) != 0;
      case pdp7::Verb::interrupt: return (places[0] & (Probe::is_written | Probe::at_interrupt)) != 0;
      case pdp7::Verb::iot: return (ports[device_of(cycle)] & Probe::executed) != 0;
    }
    return true;
  }
  static std::uint32_t device_of(const pdp7::Cycle& iot) { return (iot.address >> 6) & 077U; }
};

// What the run is to test beside marks.
class Pdp7Look : public Outlook<Pdp7Outlook> {
 public:
  // `marks`: all marks in core.
  Pdp7Look(const OutlookTable<Pdp7Outlook>& table, const Probe& probe, std::uint32_t marks)
      : Outlook(table, probe), changes_(table.everywhere() & pdp7::change::anything), marks_(marks), places_(table.places()) {
    for (const Condition& each : probe.conditions()) {
      devices_ = devices_ || each.devices;
      words_ = words_ || each.words;
    }
  }

  [[nodiscard]] std::uint8_t changes() const { return changes_; }
  [[nodiscard]] std::uint32_t marks() const { return marks_; }
  // Conditions on words, and on registers beside them, are evaluated wherever memory may have changed.
  template <unsigned changes>
  [[nodiscard]] SIGHTLINE_INLINE bool may_ask(const View& view) const {
    if constexpr ((changes & pdp7::change::memory) != 0) return true;
    else return in_range<changes>(view);
  }
  [[nodiscard]] SIGHTLINE_INLINE bool may_ask(const View& view) const {
    return (changes_ & pdp7::change::memory) != 0 || in_range<pdp7::change::anything>(view);
  }
  // The display has a word to fetch every few instructions, and hardly one of them raises a flag: they are compared with those of the last
  // question.
  template <class Flags>
  void see(Flags flags) {
    if (!devices_) return;
    const std::uint32_t now = flags();
    changed_ = changed_ || !seen_ || *seen_ != now;
    seen_ = now;
  }
  template <class Flags>
  [[nodiscard]] bool looks_again(Flags flags, bool broken_into) {
    see(flags);
    return changed_ || (words_ && broken_into);
  }
  // Where no flag has changed, nothing is in its range and no place is asked about, no condition can have changed.
  [[nodiscard]] bool asks(pdp7::Address next, const View& view) {
    if (!changed_ && (places_[next] & Probe::executed) == 0 && !may_ask(view)) return false;
    if (Outlook::asks(next, view)) return true;
    changed_ = false;
    return false;
  }
  void answered() { changed_ = false; }

 private:
  std::uint8_t changes_;
  std::uint32_t marks_;
  const std::uint8_t* places_;  // Probe::executed: asked about
  bool devices_ = false;
  bool words_ = false;
  std::optional<std::uint32_t> seen_;
  bool changed_ = false;
};

// The observer of a monitor that has marked places or waits for conditions.
class Pdp7Watcher : public Looker<Pdp7Outlook> {
 public:
  static constexpr bool cycles = true;
  using Filter = Pdp7Marked;
  using Look = Pdp7Look;

  explicit Pdp7Watcher(Probe& probe) : Looker(probe) {
    // Eight at a time, of which hardly any has one.
    const std::uint8_t* const places = table().places();
    const std::uint8_t* const marks = probe.marks();
    for (pdp7::Address first = 0; first < Pdp7Outlook::addresses; first += 8) {
      std::uint64_t asked = 0, accessed = 0;
      std::memcpy(&asked, places + first, sizeof asked);
      std::memcpy(&accessed, marks + first, sizeof accessed);
      constexpr std::uint64_t ones = 0x0101'0101'0101'0101U;
      if (((asked & ones * Probe::executed) | (accessed & ones * (Probe::is_read | Probe::is_written))) == 0) continue;
      for (pdp7::Address n = first; n < first + 8; ++n) mark(n, places[n], marks[n]);
    }
  }
  [[nodiscard]] Pdp7Marked filter() const { return Pdp7Marked(probe()); }
  [[nodiscard]] Pdp7Look look() const { return {table(), probe(), marks_}; }
  [[nodiscard]] const std::vector<std::pair<pdp7::Address, std::uint32_t>>& marked_places() const { return marked_places_; }

  // Kept until the boundary, without a call: one would cost every instruction the registers that it might spoil.
  SIGHTLINE_INLINE void cycle(const pdp7::Cycle& cycle) {
    kept_[kept_count_] = cycle;
    if (kept_count_ + 1 < kept_.size()) ++kept_count_;
  }
  [[nodiscard]] bool told() {
    for (std::size_t n = 0; n < kept_count_; ++n) tell(kept_[n]);
    kept_count_ = 0;
    return Looker::told();
  }
  bool stop(core::Instant now, pdp7::Address next) {
    static_cast<void>(told());
    return Looker::stop(now, next);
  }
  void tell(const pdp7::Cycle& cycle) {
    const std::uint8_t marks = probe().marks()[cycle.address];
    const std::uint32_t word = cycle.data.value();
    switch (cycle.verb) {
      case pdp7::Verb::modify:
        if ((marks & Probe::is_read) != 0)
          add(Probe::Kind::read, cycle.time, cycle.address, (cycle.data - core::Word18(1)).value());
        if ((marks & Probe::is_written) != 0) add(Probe::Kind::write, cycle.time, cycle.address, word);
        return;
      case pdp7::Verb::interrupt:
        if ((marks & Probe::at_interrupt) != 0)
          add(Probe::Kind::interrupt, cycle.time, word & pdp7::address_mask, 0);
        if ((marks & Probe::is_written) != 0) add(Probe::Kind::interrupt_write, cycle.time, cycle.address, word);
        return;
      case pdp7::Verb::read: return add(Probe::Kind::read, cycle.time, cycle.address, word);
      case pdp7::Verb::write: return add(Probe::Kind::write, cycle.time, cycle.address, word);
      case pdp7::Verb::break_write:
      case pdp7::Verb::break_modify: return add(Probe::Kind::break_write, cycle.time, cycle.address, word);
      case pdp7::Verb::iot:
        return add(Probe::Kind::port_write, cycle.time, Pdp7Marked::device_of(cycle), cycle.address | 0700000U);
      case pdp7::Verb::fetch:
      case pdp7::Verb::break_read:
      case pdp7::Verb::idle: return;
    }
  }

 private:
  void mark(pdp7::Address at, std::uint8_t asked, std::uint8_t accessed) {
    std::uint32_t in_core = 0;
    if ((asked & Probe::executed) != 0) in_core |= pdp7::core_mark::asked;
    if ((accessed & Probe::is_read) != 0) in_core |= pdp7::core_mark::read;
    if ((accessed & Probe::is_written) != 0) in_core |= pdp7::core_mark::written;
    if (in_core == 0) return;
    marked_places_.emplace_back(at, in_core);
    marks_ |= in_core;
  }

  // More than an instruction and the breaks before it have.
  std::array<pdp7::Cycle, 64> kept_{};
  std::size_t kept_count_ = 0;
  std::vector<std::pair<pdp7::Address, std::uint32_t>> marked_places_;
  std::uint32_t marks_ = 0;  // of all places
};

// The same, and tells each instruction.
class Pdp7Listener {
 public:
  explicit Pdp7Listener(Probe& probe) : probe_(probe), watcher_(probe) {}

  void begin(core::Instant now) { watcher_.begin(now); }
  bool stop(core::Instant now, pdp7::Address next) { return watcher_.stop(now, next); }
  bool told() { return watcher_.told(); }
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
    if (watcher_.filter().wants(cycle)) watcher_.tell(cycle);
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
  bool told() { return listener_ && listener_->told(); }
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
