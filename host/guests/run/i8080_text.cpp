// See i8080_text.hpp.
#include "host/guests/run/i8080_text.hpp"

#include <iterator>

#include "emulators/i8080/bus.hpp"
#include "tools/disasm/i8080.hpp"

namespace sightline::harness {

namespace {

constexpr std::size_t block_size = 65536;

void hand_out(fmt::memory_buffer& text, const I8080TextTaker& taker) {
  if (text.size() != 0) taker({text.data(), text.size()});
  text.clear();
}

}  // namespace

void append_registers(fmt::memory_buffer& text, const i8080::State& s) {
  fmt::format_to(std::back_inserter(text),
                 "{:02X} {:02X} {:02X} {:02X} {:02X} {:02X} {:02X} {:02X} {:04X} {:04X} {}", s.a, s.f,
                 i8080::high(s.bc), i8080::low(s.bc), i8080::high(s.de), i8080::low(s.de), i8080::high(s.hl),
                 i8080::low(s.hl), s.sp, s.pc, s.interrupts_on ? 1 : 0);
}

void I8080Recorder::trace(const machines::I8080InstructionRecord& record) {
  const Remembered& known = disassembled(record);
  fmt::format_to(std::back_inserter(trace_text_), "{:>12} {:04X} ", core::t_states_of(record.time),
                 record.pc);
  for (int i = 0; i < 3; ++i) {
    if (i < known.length) {
      fmt::format_to(std::back_inserter(trace_text_), "{:02X}", record.bytes[static_cast<std::size_t>(i)]);
    } else {
      fmt::format_to(std::back_inserter(trace_text_), "  ");
    }
  }
  fmt::format_to(std::back_inserter(trace_text_), " {}{:<{}} ", record.acknowledged ? "INT " : "", known.text,
                 record.acknowledged ? 16 : 20);
  append_registers(trace_text_, record.after);
  trace_text_.push_back('\n');
  if (trace_text_.size() >= block_size) hand_out(trace_text_, job_.trace);
}

void I8080Recorder::bus(const machines::I8080Cycle& cycle) {
  fmt::format_to(std::back_inserter(bus_text_), "{} {:02X} {:04X} ", core::t_states_of(cycle.time),
                 cycle.status, cycle.address);
  if (cycle.status == i8080::status::halt_cycle) {
    fmt::format_to(std::back_inserter(bus_text_), "--\n");
  } else {
    fmt::format_to(std::back_inserter(bus_text_), "{:02X}\n", cycle.data);
  }
  if (bus_text_.size() >= block_size) hand_out(bus_text_, job_.bus);
}

// A loop meets the same bytes at the same places.
const I8080Recorder::Remembered& I8080Recorder::disassembled(const machines::I8080InstructionRecord& record) {
  Remembered& known = remembered_[record.pc];
  if (known.length == 0 || known.bytes != record.bytes) {
    const disassembler::I8080Line line = disassembler::disassemble_i8080_instruction(record.bytes);
    known = {record.bytes, line.bytes, (line.duplicate ? "*" : "") + line.text};
  }
  return known;
}

void I8080Recorder::finish() {
  if (job_.trace) hand_out(trace_text_, job_.trace);
  if (job_.bus) hand_out(bus_text_, job_.bus);
}

}  // namespace sightline::harness
