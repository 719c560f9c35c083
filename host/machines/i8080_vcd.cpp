// See i8080_vcd.hpp.
#include "host/machines/i8080_vcd.hpp"

#include <algorithm>
#include <array>

#include "emulators/i8080/bus.hpp"

namespace sightline::machines {

namespace {

// The indices of i8080_signals(); those of the status byte in order from its lowest bit.
namespace i8080_signal {
enum : std::size_t {
  address, data, sync, dbin, wr, wait, ready, interrupt, hold, hlda, t, inta, wo, stack, hlta, out, m1, inp, memr, pc, sp, a, f, bc, de, hl, inte, count
};
}

constexpr std::array<VcdSignal, i8080_signal::count> i8080_rows{{
    {"pins", "address", 16, "A15-A0; z while a board has the bus"},
    {"pins", "data", 8, "D7-D0: the status byte with SYNC, then the byte; z while nobody drives them"},
    {"pins", "sync", 1, "a machine cycle begins"},
    {"pins", "dbin", 1, "the processor reads D7-D0"},
    {"pins", "wr", 1, "WR# is low: the byte is to be written"},
    {"pins", "wait", 1, "a wait state, or HLT"},
    {"pins", "ready", 1, "READY: low while a wait state is asked for"},
    {"pins", "int", 1, "INT, as the machine finds it between instructions"},
    {"pins", "hold", 1, "HOLD: a board asks for the bus"},
    {"pins", "hlda", 1, "HLDA: it has the bus, and address and data are z"},
    {"pins", "t", 3, "the T-state: 1 to 5, 6 in a wait state, 7 in a cycle inside the processor, 0 while it waits for the bus"},
    {"status", "inta", 1, "of the machine cycle, as all of these: interrupt acknowledge"},
    {"status", "wo", 1, "WO#: not a write"},
    {"status", "stack", 1, "the address is SP"},
    {"status", "hlta", 1, "HLT acknowledge"},
    {"status", "out", 1, "an output port"},
    {"status", "m1", 1, "the first cycle of an instruction"},
    {"status", "inp", 1, "an input port"},
    {"status", "memr", 1, "memory is read"},
    {"registers", "pc", 16, "after each instruction, as all of these"},
    {"registers", "sp", 16, "the stack pointer"},
    {"registers", "a", 8, "the accumulator"},
    {"registers", "f", 8, "the flags"},
    {"registers", "bc", 16, "B and C"},
    {"registers", "de", 16, "D and E"},
    {"registers", "hl", 16, "H and L"},
    {"registers", "inte", 1, "interrupts are on"},
}};

}  // namespace

std::span<const VcdSignal> i8080_signals() {
  return i8080_rows;
}

void I8080Vcd::finish(core::TStateInstant now) {
  show_holds(now);
  writer_.finish(core::nanoseconds_of(clock_.to_nanoseconds(now)));
}

void I8080Vcd::cycle(const i8080::BusCycle& cycle) {
  namespace status = i8080::status;
  end_cycle(cycle.time);
  const bool first = (cycle.status & status::first) != 0;
  if (first) opcode_ = cycle.data;
  // INTE falls when the interrupt is acknowledged.
  if (first && (cycle.status & status::acknowledge) != 0) {
    show(cycle.time, i8080_signal::interrupt, 1);
    show(cycle.time, i8080_signal::inte, 0);
  }
  if (!first && (cycle.status & status::halt) != 0) {
    begin_halt(cycle);
  } else {
    pending_ = cycle;
  }
}

void I8080Vcd::instruction(const i8080::InstructionRecord& record) {
  end_cycle(record.end);
  const i8080::State& s = record.after;
  show(record.end, i8080_signal::pc, s.pc);
  show(record.end, i8080_signal::sp, s.sp);
  show(record.end, i8080_signal::a, s.a);
  show(record.end, i8080_signal::f, s.f);
  show(record.end, i8080_signal::bc, s.bc);
  show(record.end, i8080_signal::de, s.de);
  show(record.end, i8080_signal::hl, s.hl);
  show(record.end, i8080_signal::inte, s.interrupts_on ? 1 : 0);
  show(record.end, i8080_signal::interrupt, requested_() ? 1 : 0);
}

void I8080Vcd::hold(const i8080::HoldPins& pins) {
  if (pins.waits) end_cycle(pins.time);
  holds_.push_back(pins);
}

void I8080Vcd::show(core::TStateInstant at, std::size_t row, std::uint32_t value) {
  show_holds(at);
  show_pin(at, row, value);
}

void I8080Vcd::show_holds(core::TStateInstant at) {
  while (!holds_.empty() && holds_.front().time <= at) {
    const i8080::HoldPins pins = holds_.front();
    holds_.pop_front();
    show_pin(pins.time, i8080_signal::hold, pins.hold ? 1 : 0);
    show_pin(pins.time, i8080_signal::hlda, pins.acknowledge ? 1 : 0);
    if (pins.acknowledge) {
      show_pin(pins.time, i8080_signal::address, VcdWriter::floating);
      show_pin(pins.time, i8080_signal::data, VcdWriter::floating);
    }
    if (pins.waits) show_pin(pins.time, i8080_signal::t, 0);
  }
}

void I8080Vcd::show_pin(core::TStateInstant at, std::size_t row, std::uint32_t value) {
  latest_ = std::max(latest_, at);
  writer_.show(core::nanoseconds_of(clock_.to_nanoseconds(latest_)), row, value);
}

void I8080Vcd::first_t_state(const i8080::BusCycle& cycle) {
  show(cycle.time, i8080_signal::address, cycle.address);
  show(cycle.time, i8080_signal::data, cycle.status);
  show(cycle.time, i8080_signal::sync, 1);
  for (const std::size_t pin : {i8080_signal::dbin, i8080_signal::wr, i8080_signal::wait}) show(cycle.time, pin, 0);
  show(cycle.time, i8080_signal::ready, 1);
  if (!begun_) {
    begun_ = true;
    show(cycle.time, i8080_signal::hold, 0);
    show(cycle.time, i8080_signal::hlda, 0);
  }
  show(cycle.time, i8080_signal::t, 1);
  for (std::size_t bit = 0; bit < 8; ++bit) show(cycle.time, i8080_signal::inta + bit, cycle.status >> bit & 1U);
}

void I8080Vcd::begin_halt(const i8080::BusCycle& cycle) {
  first_t_state(cycle);
  const core::TStateInstant second = cycle.time + core::TStates(1);
  show(second, i8080_signal::data, VcdWriter::floating);
  show(second, i8080_signal::sync, 0);
  show(second, i8080_signal::t, 2);
  show(second + core::TStates(1), i8080_signal::wait, 1);
  show(second + core::TStates(1), i8080_signal::t, 6);
}

void I8080Vcd::end_cycle(core::TStateInstant end) {
  namespace status = i8080::status;
  if (!pending_) return;
  const i8080::BusCycle cycle = *std::exchange(pending_, std::nullopt);
  const auto at = [&cycle](std::int64_t n) { return cycle.time + core::TStates(n); };
  const bool reads = (cycle.status & status::read) != 0;
  const std::int64_t length = (end - cycle.time).count();
  // The rest of a fetch is T4, T5 and internal cycles, which cannot be told from wait states. The last cycle of XTHL has a
  // T4 and a T5 too.
  constexpr i8080::Byte xthl = 0xE3;
  const std::int64_t own = opcode_ == xthl && !reads && length >= 5 ? 5 : 3;
  const std::int64_t waits = (cycle.status & status::first) != 0 ? 0 : length - own;
  first_t_state(cycle);
  show(at(1), i8080_signal::data, cycle.data);
  show(at(1), i8080_signal::sync, 0);
  show(at(1), i8080_signal::dbin, reads ? 1 : 0);
  show(at(1), i8080_signal::t, 2);
  if (waits > 0) {
    show(at(1), i8080_signal::ready, 0);
    show(at(2), i8080_signal::wait, 1);
    show(at(2), i8080_signal::t, 6);
    if (!reads) show(at(2), i8080_signal::wr, 1);
    show(at(1 + waits), i8080_signal::ready, 1);  // which the last wait state samples
  }
  const std::int64_t third = 2 + waits;
  show(at(third), i8080_signal::wait, 0);
  show(at(third), i8080_signal::dbin, 0);
  if (reads) show(at(third), i8080_signal::data, VcdWriter::floating);
  if (!reads) show(at(third), i8080_signal::wr, 1);
  show(at(third), i8080_signal::t, 3);
  if (!reads) show(at(third + 1), i8080_signal::wr, 0);
  // DAD has internal cycles after T4.
  const std::int64_t inside = (cycle.data & 0xCFU) == 0x09 ? 4 : 5;
  for (std::int64_t n = third + 1; n < length; ++n) show(at(n), i8080_signal::t, n < inside ? static_cast<std::uint32_t>(n + 1) : 7U);
}

}  // namespace sightline::machines
