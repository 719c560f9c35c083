// Who hears what happens in a run of the 8080: traces, logs and dumps, and what a monitor has asked for.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/inline.hpp"
#include "emulators/core/tstates.hpp"
#include "emulators/i8080/bus.hpp"
#include "emulators/i8080/isa.hpp"
#include "emulators/i8080/state.hpp"
#include "emulators/machines/i8080_bus.hpp"
#include "emulators/machines/i8080_observer.hpp"
#include "host/base/text.hpp"
#include "host/guests/run/i8080_outlook.hpp"
#include "host/guests/run/i8080_vcd.hpp"
#include "host/guests/run/machine.hpp"
#include "host/guests/run/outlook.hpp"
#include "host/guests/run/probe.hpp"
#include "tools/disasm/i8080.hpp"

namespace sightline::guests::run {

// Writes what has a taker, in blocks.
class I8080Recorder {
 public:
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

  // T of the fetch in decimal, address and bytes, the instruction, registers after it. INT is before an
  // instruction that a device supplied, * before an opcode that Intel left undefined and that does the same
  // as another.
  void instruction(const machines::I8080InstructionRecord& record) {
    if (trace_.wanted()) write(record);
    if (vcd) vcd->instruction(record);
  }
  // T of the cycle's T1 in decimal, status byte, address, data; -- in the halt cycle.
  void cycle(const machines::I8080Cycle& cycle) {
    if (bus_.wanted()) write(cycle);
    if (vcd) vcd->cycle(cycle);
  }
  void hold(const machines::I8080HoldPins& pins) {
    if (vcd) vcd->hold(pins);
  }

  std::optional<I8080Vcd> vcd;

 private:
  struct Remembered {
    std::array<i8080::Byte, 3> bytes;
    int length = 0;  // 0: nothing remembered
    std::string text;
  };

  // A loop meets the same bytes at the same places.
  const Remembered& disassembled(const machines::I8080InstructionRecord& record) {
    Remembered& known = remembered_[record.pc];
    if (known.length == 0 || known.bytes != record.bytes) {
      const disassembler::I8080Line line = disassembler::disassemble_i8080_instruction(record.bytes);
      known = {record.bytes, line.bytes, (line.duplicate ? "*" : "") + line.text};
    }
    return known;
  }

  // Out of line: every access of every instruction calls them.
  [[gnu::noinline]] void write(const machines::I8080InstructionRecord& record) {
    const Remembered& known = disassembled(record);
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
  [[gnu::noinline]] void write(const machines::I8080Cycle& cycle) {
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
  std::vector<Remembered> remembered_ = std::vector<Remembered>(65536);
};

// What a monitor's marks leave of the cycles of a run. The status of a cycle is known where it is compiled
// in, so that one test is left of each.
struct I8080Marked {
  const std::uint8_t* places;
  const std::uint8_t* ports;

  explicit I8080Marked(const Probe& probe) : places(probe.marks()), ports(probe.port_marks()) {}
  SIGHTLINE_INLINE bool wants(const machines::I8080Cycle& cycle) const {
    namespace status = i8080::status;
    // The bytes of the instruction itself are not asked for.
    if (cycle.operand || (cycle.status & status::halt) != 0) return false;
    if ((cycle.status & status::first) != 0)
      return (cycle.status & status::acknowledge) != 0 && (places[0] & Probe::at_interrupt) != 0;
    if ((cycle.status & status::input) != 0) return (ports[port_of(cycle)] & Probe::is_read) != 0;
    if ((cycle.status & status::output) != 0) return (ports[port_of(cycle)] & Probe::is_written) != 0;
    if ((cycle.status & status::read) != 0) return (places[cycle.address] & Probe::is_read) != 0;
    return (places[cycle.address] & Probe::is_written) != 0;
  }
  static std::uint8_t port_of(const machines::I8080Cycle& cycle) { return static_cast<std::uint8_t>(cycle.address); }
};

// The observer of a monitor that waits for conditions and has marked places. It may be used for many runs, until the probe says that
// it has others.
class I8080Watcher : public Looker<I8080Outlook> {
 public:
  static constexpr bool cycles = true;
  static constexpr bool ends_of_halts = false;
  using Filter = I8080Marked;
  using Look = I8080Look;

  explicit I8080Watcher(Probe& probe) : Looker(probe), plan_(table(), probe) {}
  [[nodiscard]] Look look() const { return Look(table(), probe(), plan_); }
  [[nodiscard]] std::optional<machines::I8080Wanted> renewed() {
    if (std::exchange(told_wants_, true)) return std::nullopt;
    static_assert(Probe::executed == 1 && machines::I8080Store::is_read == Probe::is_read && machines::I8080Store::is_written == Probe::is_written);
    return machines::I8080Wanted{table().places(), probe().marks(), probe().watches_memory(), plan_.tested, plan_.test};
  }
  [[nodiscard]] I8080Marked filter() const { return I8080Marked(probe()); }

  // Kept until the boundary, without a call: one would cost every instruction the registers that it might spoil.
  SIGHTLINE_INLINE void cycle(const machines::I8080Cycle& cycle) {
    kept_[kept_count_] = cycle;
    if (kept_count_ + 1 < kept_.size()) ++kept_count_;
  }
  [[nodiscard]] SIGHTLINE_INLINE bool told() {
    if (kept_count_ != 0) [[unlikely]] tell_kept();
    return Looker::told();
  }
  bool stop(core::TStateInstant now, i8080::Address next) {
    static_cast<void>(told());
    return Looker::stop(now, next);
  }
  void tell(const machines::I8080Cycle& cycle) {
    namespace status = i8080::status;
    if ((cycle.status & status::first) != 0) return add(Probe::Kind::interrupt, cycle.time, cycle.address, 0);
    if ((cycle.status & status::input) != 0)
      return add(Probe::Kind::port_read, cycle.time, I8080Marked::port_of(cycle), cycle.data);
    if ((cycle.status & status::output) != 0)
      return add(Probe::Kind::port_write, cycle.time, I8080Marked::port_of(cycle), cycle.data);
    const bool reads = (cycle.status & status::read) != 0;
    add(reads ? Probe::Kind::read : Probe::Kind::write, cycle.time, cycle.address, cycle.data);
  }

 private:
  [[gnu::noinline]] void tell_kept() {
    for (std::size_t n = 0; n < kept_count_; ++n) tell(kept_[n]);
    kept_count_ = 0;
  }

  I8080Plan plan_;
  bool told_wants_ = false;
  // More than an instruction and the breaks before it have.
  std::array<machines::I8080Cycle, 64> kept_{};
  std::size_t kept_count_ = 0;
};

// The same, and tells each instruction.
class I8080Listener {
 public:
  I8080Listener(Probe& probe, I8080Watcher& watcher) : probe_(probe), watcher_(watcher) {}

  void begin(core::TStateInstant now) { watcher_.begin(now); }
  bool stop(core::TStateInstant now, i8080::Address next) { return watcher_.stop(now, next); }
  void instruction(const machines::I8080InstructionRecord& record) {
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
  void cycle(const machines::I8080Cycle& cycle) {
    namespace status = i8080::status;
    if (watcher_.filter().wants(cycle)) watcher_.tell(cycle);
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
  I8080Watcher& watcher_;
  Probe::Entry entry_;
};

// The observer of all that hear every instruction and every cycle. One for them all: a machine is compiled for each observer, which
// takes long, and they are slow for what they write.
class I8080Reporter {
 public:
  static constexpr bool instructions = true;
  static constexpr bool cycles = true;
  static constexpr bool stops = true;

  explicit I8080Reporter(I8080Recorder& recorder) : recorder_(&recorder) {}
  I8080Reporter(Probe& probe, I8080Watcher& watcher) : listener_(std::in_place, probe, watcher) {}

  void begin(core::TStateInstant now) {
    if (listener_) listener_->begin(now);
  }
  bool stop(core::TStateInstant now, i8080::Address next) { return listener_ && listener_->stop(now, next); }
  static bool told() { return false; }
  [[gnu::noinline]] void instruction(const machines::I8080InstructionRecord& record) {
    if (recorder_ != nullptr) recorder_->instruction(record);
    if (listener_) listener_->instruction(record);
  }
  [[gnu::noinline]] void cycle(const machines::I8080Cycle& cycle) {
    if (recorder_ != nullptr) recorder_->cycle(cycle);
    if (listener_) listener_->cycle(cycle);
  }
  void hold(const machines::I8080HoldPins& pins) {
    if (recorder_ != nullptr) recorder_->hold(pins);
  }

 private:
  I8080Recorder* recorder_ = nullptr;
  std::optional<I8080Listener> listener_;
};

}  // namespace sightline::guests::run
