// Observers of a run of the 8080: trace, bus log, VCD and monitor.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "emulators/i8080/bus.hpp"
#include "emulators/i8080/state.hpp"
#include "emulators/machines/i8080.hpp"
#include "host/base/text.hpp"
#include "host/machines/i8080_vcd.hpp"
#include "host/machines/machine.hpp"
#include "host/machines/probe.hpp"
#include "tools/disasm/i8080.hpp"

namespace sightline::machines {

// Writes the trace, the bus log and the VCD that have a taker, in blocks.
class I8080Recorder final : public i8080::Observer {
 public:
  I8080Recorder() { instructions = true; }

  void take(std::string_view option, TextTaker taker) {
    if (option == "--vcd" && vcd) {
      vcd->take(std::move(taker));
    } else {
      (option == "--trace" ? trace_ : bus_).take(std::move(taker));
    }
  }
  void finish(core::TStateInstant now) {
    trace_.finish();
    bus_.finish();
    if (vcd) vcd->finish(now);
  }

  // A line: T-state of the fetch in decimal, address and bytes, the instruction, registers after it. INT precedes an
  // instruction that a device supplied, * an opcode that Intel left undefined and that repeats another.
  void instruction(const i8080::InstructionRecord& record) override {
    if (trace_.wanted()) write(record);
    if (vcd) vcd->instruction(record);
  }
  // A line: T-state of the cycle's T1 in decimal, status byte, address, data; -- in the halt cycle.
  void cycle(const i8080::BusCycle& cycle) override {
    if (bus_.wanted()) write(cycle);
    if (vcd) vcd->cycle(cycle);
  }
  void hold(const i8080::HoldPins& pins) override {
    if (vcd) vcd->hold(pins);
  }

  std::optional<I8080Vcd> vcd;

 private:
  struct CachedText {
    std::array<i8080::Byte, 3> bytes;
    int length = 0;  // 0: nothing remembered
    std::string text;
  };

  // Cached because a loop executes the same bytes at the same addresses.
  const CachedText& disassemble(const i8080::InstructionRecord& record) {
    CachedText& known = cache_[record.pc];
    if (known.length == 0 || known.bytes != record.bytes) {
      const disassembler::I8080Line line = disassembler::disassemble_i8080_instruction(record.bytes);
      known = {record.bytes, line.bytes, (line.duplicate ? "*" : "") + line.text};
    }
    return known;
  }

  void write(const i8080::InstructionRecord& record) {
    const CachedText& known = disassemble(record);
    const i8080::State& s = record.after;
    trace_.write([&](std::string& text) {
      base::append(text, "{:>12} {:04X} ", core::t_states_of(record.time), record.pc);
      for (std::size_t i = 0; i < record.bytes.size(); ++i) {
        if (static_cast<int>(i) < known.length) {
          base::append(text, "{:02X}", record.bytes[i]);
        } else {
          text += "  ";
        }
      }
      base::append(text,
                   " {}{:<{}} {:02X} {:02X} {:02X} {:02X} {:02X} {:02X} {:02X} {:02X} {:04X} {:04X} {}\n",
                   record.acknowledged ? "INT " : "", known.text, record.acknowledged ? 16 : 20, s.a, s.f,
                   i8080::high(s.bc), i8080::low(s.bc), i8080::high(s.de), i8080::low(s.de),
                   i8080::high(s.hl), i8080::low(s.hl), s.sp, s.pc, s.interrupts_on ? 1 : 0);
    });
  }
  void write(const i8080::BusCycle& cycle) {
    bus_.write([&](std::string& text) {
      base::append(text, "{} {:02X} {:04X} ", core::t_states_of(cycle.time), cycle.status, cycle.address);
      if (cycle.status == i8080::status::halt_cycle) {
        text += "--\n";
      } else {
        base::append(text, "{:02X}\n", cycle.data);
      }
    });
  }

  TextBlocks trace_;
  TextBlocks bus_;
  std::vector<CachedText> cache_ = std::vector<CachedText>(65536);
};

static_assert(Probe::executed == i8080::mark::stop && Probe::is_read == i8080::mark::read && Probe::is_written == i8080::mark::written);

// The observer of a monitor with marks or conditions. Made for each call of Machine::run().
class I8080Watcher : public i8080::Observer {
 public:
  I8080Watcher(Probe& probe, core::TStateInstant now) : watch_(probe) {
    marks = probe.marks();
    port_marks = probe.port_marks();
    every_boundary = probe.has_conditions();
    watch_.begin(core::t_states_of(now));
  }

  [[nodiscard]] bool stop(core::TStateInstant now, i8080::Address next) override {
    return watch_.stop(core::t_states_of(now), next);
  }
  // Bytes of the instruction itself are not reported.
  void cycle(const i8080::BusCycle& cycle) override {
    namespace status = i8080::status;
    if (cycle.operand) return;
    if ((cycle.status & status::first) != 0) {
      if ((cycle.status & status::acknowledge) != 0 && watch_.wants_interrupts()) add(Probe::Kind::interrupt, cycle, cycle.address);
      return;
    }
    if ((cycle.status & status::halt) != 0) return;
    const bool reads = (cycle.status & status::read) != 0;
    const std::uint8_t mark = reads ? Probe::is_read : Probe::is_written;
    if ((cycle.status & (status::input | status::output)) != 0) {
      const std::uint32_t port = i8080::low(cycle.address);
      if (watch_.port_has(port, mark)) add(reads ? Probe::Kind::port_read : Probe::Kind::port_write, cycle, port);
    } else if (watch_.has(cycle.address, mark)) {
      add(reads ? Probe::Kind::read : Probe::Kind::write, cycle, cycle.address);
    }
  }

 private:
  // The byte of an interrupt acknowledge is not from memory and is not reported.
  void add(Probe::Kind kind, const i8080::BusCycle& cycle, std::uint32_t address) {
    watch_.add(kind, core::t_states_of(cycle.time), address, kind == Probe::Kind::interrupt ? 0 : cycle.data);
  }

  Watch watch_;
};

// An I8080Watcher that also reports each instruction and each cycle.
class I8080Listener final : public I8080Watcher {
 public:
  I8080Listener(Probe& probe, core::TStateInstant now) : I8080Watcher(probe, now), probe_(probe) {
    marks = port_marks = nullptr;
    instructions = true;
  }

  void instruction(const i8080::InstructionRecord& record) override {
    entry_.time = core::t_states_of(record.time);
    entry_.pc = record.pc;
    entry_.word = record.bytes[0] | static_cast<std::uint32_t>(record.bytes[1]) << 8 |
                  static_cast<std::uint32_t>(record.bytes[2]) << 16;
    entry_.accumulator = record.after.a;
    entry_.link = record.after.f;
    entry_.supplied = record.acknowledged;
    if (probe_.on_instruction) probe_.on_instruction(entry_);
    entry_.has_address = false;
  }
  void cycle(const i8080::BusCycle& cycle) override {
    namespace status = i8080::status;
    I8080Watcher::cycle(cycle);
    if (probe_.on_cycle) {
      const std::int64_t least = (cycle.status & status::first) != 0 ? 4 : 3;
      probe_.on_cycle({core::t_states_of(cycle.time), least, name_of(cycle.status), true, cycle.address, cycle.data});
    }
    constexpr i8080::Status not_memory = status::first | status::halt | status::input | status::output;
    if ((cycle.status & not_memory) != 0 || cycle.operand) return;
    entry_.has_address = true;
    entry_.address = cycle.address;
    entry_.value = cycle.data;
  }

 private:
  static std::string_view name_of(i8080::Status cycle) {
    namespace status = i8080::status;
    if ((cycle & status::acknowledge) != 0) return "acknowledge";
    if ((cycle & status::first) != 0) return "fetch";
    if ((cycle & status::halt) != 0) return "halt";
    if ((cycle & status::input) != 0) return "input";
    if ((cycle & status::output) != 0) return "output";
    const bool reads = (cycle & status::read) != 0;
    if ((cycle & status::stack) != 0) return reads ? "stack read" : "stack write";
    return reads ? "read" : "write";
  }

  Probe& probe_;
  Probe::Entry entry_;
};

}  // namespace sightline::machines
