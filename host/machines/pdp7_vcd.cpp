// See pdp7_vcd.hpp.
#include "host/machines/pdp7_vcd.hpp"

#include <array>

#include "emulators/pdp7/isa.hpp"

namespace sightline::machines {

namespace {

// The indices of pdp7_signals().
namespace pdp7_signal {
enum : std::size_t {
  fetch, defer, execute, eae, brk, tick, interrupt, address, data, write, device, pulses, pc, ac, link, mq, ion, request, edge, pen,
  stop, count
};
}

constexpr std::array<VcdSignal, pdp7_signal::count> pdp7_rows{{
    {"cycle", "fetch", 1, "the cycle that takes an instruction"},
    {"cycle", "defer", 1, "of an indirect address"},
    {"cycle", "execute", 1, "of the operand, and of an instruction that XCT leads to"},
    {"cycle", "eae", 1, "time of the EAE without a cycle"},
    {"cycle", "brk", 1, "a data break of the display or the disk"},
    {"cycle", "tick", 1, "a break of the clock"},
    {"cycle", "interrupt", 1, "the break cycle of the program interrupt"},
    {"memory", "address", 15, "in the memory address register, while a cycle lasts"},
    {"memory", "data", 18, "in the memory buffer register: read, or written"},
    {"memory", "write", 1, "the cycle replaces the word"},
    {"iot", "device", 6, "bits 6-11 of an IOT, in the last 500 ns of its fetch"},
    {"iot", "pulses", 3, "its pulses 4, 2, 1, likewise"},
    {"registers", "pc", 15, "after each instruction, as all of these"},
    {"registers", "ac", 18, "the accumulator"},
    {"registers", "link", 1, "the link"},
    {"registers", "mq", 18, "the multiplier-quotient register"},
    {"registers", "ion", 1, "interrupts are on"},
    {"display", "request", 1, "the display asks for a word, as of the end of an instruction, as all of these"},
    {"display", "edge", 1, "its beam has left the screen"},
    {"display", "pen", 1, "its light pen has seen light"},
    {"display", "stop", 1, "its file has stopped it"},
}};

}  // namespace

std::span<const VcdSignal> pdp7_signals() {
  return pdp7_rows;
}

void Pdp7Vcd::finish(core::Instant now) { writer_.finish(core::nanoseconds_of(now)); }

void Pdp7Vcd::cycle(const pdp7::Cycle& cycle) {
  const std::int64_t at = core::nanoseconds_of(cycle.time);
  if (cycle.verb == pdp7::Verb::iot) return iot(cycle, at);
  clear_pulses(at);
  const std::size_t kind = kind_of(cycle);
  for (std::size_t each = pdp7_signal::fetch; each <= pdp7_signal::interrupt; ++each) writer_.show(at, each, each == kind ? 1 : 0);
  const bool asynchronous = cycle.verb == pdp7::Verb::idle;
  writer_.show(at, pdp7_signal::address, asynchronous ? VcdWriter::floating : cycle.address);
  writer_.show(at, pdp7_signal::data, asynchronous ? VcdWriter::floating : cycle.data.value());
  const bool writes = cycle.verb == pdp7::Verb::write || cycle.verb == pdp7::Verb::modify ||
                      cycle.verb == pdp7::Verb::interrupt || cycle.verb == pdp7::Verb::break_write ||
                      cycle.verb == pdp7::Verb::break_modify;
  if (cycle.verb == pdp7::Verb::interrupt) writer_.show(at, pdp7_signal::ion, 0);
  writer_.show(at, pdp7_signal::write, writes ? 1 : 0);
}

void Pdp7Vcd::instruction(const pdp7::InstructionRecord& record) {
  const std::int64_t at = core::nanoseconds_of(record.end);
  clear_pulses(at);
  writer_.show(at, pdp7_signal::pc, record.after.pc);
  writer_.show(at, pdp7_signal::ac, record.after.ac.value());
  writer_.show(at, pdp7_signal::link, record.after.link ? 1 : 0);
  writer_.show(at, pdp7_signal::mq, record.after.mq.value());
  writer_.show(at, pdp7_signal::ion, record.after.interrupts_on ? 1 : 0);
  const type340::Registers* const display = display_();
  if (display == nullptr) return;
  writer_.show(at, pdp7_signal::request, display->request ? 1 : 0);
  writer_.show(at, pdp7_signal::edge, display->edge() ? 1 : 0);
  writer_.show(at, pdp7_signal::pen, display->pen_flag ? 1 : 0);
  writer_.show(at, pdp7_signal::stop, display->stop ? 1 : 0);
}

std::size_t Pdp7Vcd::kind_of(const pdp7::Cycle& cycle) {
  switch (cycle.verb) {
    case pdp7::Verb::idle: return pdp7_signal::eae;
    case pdp7::Verb::break_read:
    case pdp7::Verb::break_write: return pdp7_signal::brk;
    case pdp7::Verb::break_modify: return pdp7_signal::tick;
    case pdp7::Verb::interrupt: return pdp7_signal::interrupt;
    case pdp7::Verb::fetch: follow(cycle.data.value()); return pdp7_signal::fetch;
    default: break;
  }
  if (defers_) {
    defers_ = false;
    return pdp7_signal::defer;
  }
  if (executes_another_) follow(cycle.data.value());
  return pdp7_signal::execute;
}

void Pdp7Vcd::follow(std::uint32_t word) {
  const pdp7::Operation operation = pdp7::instruction_of(word).operation;
  defers_ = operation <= pdp7::Operation::jmp && (word & pdp7::indirect_bit) != 0;
  executes_another_ = operation == pdp7::Operation::xct;
}

void Pdp7Vcd::iot(const pdp7::Cycle& cycle, std::int64_t end) {
  constexpr std::int64_t shown = 500;
  writer_.show(end - shown, pdp7_signal::device, (cycle.address >> 6) & 077U);
  writer_.show(end - shown, pdp7_signal::pulses, cycle.address & 7U);
  pulses_ = true;
}

void Pdp7Vcd::clear_pulses(std::int64_t at) {
  if (pulses_) writer_.show(at, pdp7_signal::pulses, 0);
  pulses_ = false;
}

}  // namespace sightline::machines
