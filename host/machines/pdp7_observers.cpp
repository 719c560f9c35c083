// See pdp7_observers.hpp.
#include "host/machines/pdp7_observers.hpp"

#include <array>
#include <cstddef>

#include "host/base/text.hpp"
#include "tools/disasm/disasm.hpp"

namespace sightline::machines {

using pdp7::Verb;

static_assert(Probe::executed == pdp7::mark::stop && Probe::is_read == pdp7::mark::read && Probe::is_written == pdp7::mark::written);

// --- Traces and dumps ---

void Pdp7Tracer::instruction(const pdp7::InstructionRecord& record) {
  text_.write([&](std::string& text) {
    base::append(text, "{:>12} {:05o} {:06o}  {:<18} {:06o} {:o} {:06o}\n", core::nanoseconds_of(record.time), record.pc,
                 record.word.value(), instruction_text(record), record.after.ac.value(), record.after.link ? 1 : 0,
                 record.after.mq.value());
  });
}

const std::string& Pdp7Tracer::instruction_text(const pdp7::InstructionRecord& record) {
  CachedText& known = cache_[record.pc & pdp7::address_mask];
  if (known.text.empty() || known.word != record.word)
    known = {record.word, disassembler::disassemble_word(record.word, record.pc)};
  return known.text;
}

void Pdp7Recorder::finish(core::Instant now) {
  if (tracer) tracer->finish();
  if (vcd) vcd->finish(now);
}

void Pdp7Recorder::instruction(const pdp7::InstructionRecord& record) {
  if (tracer) tracer->instruction(record);
  if (vcd) vcd->instruction(record);
}

void Pdp7Recorder::cycle(const pdp7::Cycle& cycle) {
  if (vcd) vcd->cycle(cycle);
}

// --- A monitor ---

Pdp7Watcher::Pdp7Watcher(Probe& probe, core::Instant now)
    : probe_(probe), watch_(probe), listens_(probe.watches_instructions()) {
  watch_.begin(core::nanoseconds_of(now));
  every_boundary = probe.has_conditions();
  instructions = listens_;
  if (!listens_) marks = probe.marks();
}

void Pdp7Watcher::instruction(const pdp7::InstructionRecord& record) {
  entry_.time = core::nanoseconds_of(record.time);
  entry_.pc = record.pc;
  entry_.word = record.word.value();
  entry_.accumulator = record.after.ac.value();
  entry_.link = record.after.link ? 1 : 0;
  if (probe_.on_instruction) probe_.on_instruction(entry_);
  entry_.has_address = false;
}

void Pdp7Watcher::cycle(const pdp7::Cycle& cycle) {
  compare_with_marks(cycle);
  if (!listens_) return;
  if (probe_.on_cycle) {
    constexpr std::array names{"fetch", "read",        "write",        "read and write", "interrupt", "iot",
                               "EAE",   "break, read", "break, write", "clock tick"};
    const bool has_address = cycle.verb != Verb::idle && cycle.verb != Verb::iot;
    probe_.on_cycle({core::nanoseconds_of(cycle.time), cycle.length.count(), names[static_cast<std::size_t>(cycle.verb)],
                     has_address, cycle.address, cycle.data.value()});
  }
  if (cycle.verb != Verb::read && cycle.verb != Verb::modify && cycle.verb != Verb::write) return;
  entry_.has_address = true;
  entry_.address = cycle.address;
  entry_.value = cycle.data.value();
}

void Pdp7Watcher::compare_with_marks(const pdp7::Cycle& cycle) {
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
      if (watch_.wants_interrupts())
        watch_.add(Probe::Kind::interrupt, core::nanoseconds_of(cycle.time), word & pdp7::address_mask, 0);
      return add(Probe::is_written, Probe::Kind::interrupt_write, cycle, word);
    case Verb::iot: {
      const std::uint32_t device = (cycle.address >> 6) & 077U;
      if (!watch_.port_has(device, Probe::executed)) return;
      return watch_.add(Probe::Kind::port_write, core::nanoseconds_of(cycle.time), device, cycle.address | 0700000U);
    }
  }
}

void Pdp7Watcher::add(std::uint8_t mark, Probe::Kind kind, const pdp7::Cycle& cycle, std::uint32_t value) {
  if (watch_.has(cycle.address, mark)) watch_.add(kind, core::nanoseconds_of(cycle.time), cycle.address, value);
}

}  // namespace sightline::machines
