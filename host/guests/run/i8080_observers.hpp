// Who hears what happens in a run of the 8080: traces, logs and dumps, and what a monitor has asked for.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
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

// Where Outlook finds the registers of the 8080. The number of a register is its place in the description. The sets of all addresses lie
// in the frame of the run, where a test of one is a single host instruction.
struct I8080Places {
  explicit I8080Places(const std::uint8_t* places) { std::copy_n(places, all.size(), all.begin()); }
  [[nodiscard]] SIGHTLINE_INLINE std::uint8_t at(i8080::Address next) const { return all[next]; }
  [[nodiscard]] SIGHTLINE_INLINE std::uint8_t again(i8080::Address next) const {
    return *static_cast<const volatile std::uint8_t*>(all.data() + next);
  }

  std::array<std::uint8_t, 0x10000> all;
};

struct I8080Outlook {
  using Address = i8080::Address;
  using View = machines::I8080View;
  using Instant = core::TStateInstant;
  using Places = I8080Places;
  static constexpr std::size_t addresses = 0x10000;
  static constexpr std::uint8_t memory = i8080::change::memory;
  static constexpr std::array parts{i8080::change::a,  i8080::change::hl, i8080::change::bc,
                                    i8080::change::de, i8080::change::sp, i8080::change::f};
  static constexpr std::size_t program_counter = 9;

  template <std::uint8_t part>
  [[nodiscard]] SIGHTLINE_INLINE static std::uint32_t value(const View& view) {
    if constexpr (part == i8080::change::a) return view.a;
    else if constexpr (part == i8080::change::f) return view.others->f;
    else if constexpr (part == i8080::change::bc) return by_halves(view.others->bc);
    else if constexpr (part == i8080::change::de) return by_halves(view.others->de);
    else if constexpr (part == i8080::change::hl) return view.hl;
    else return view.others->sp;
  }
  // An instruction that has just written a half would delay a load of both.
  [[nodiscard]] SIGHTLINE_INLINE static std::uint32_t by_halves(const i8080::Address& pair) {
    const auto* const bytes = reinterpret_cast<const volatile std::uint8_t*>(&pair);
    constexpr std::size_t low = std::endian::native == std::endian::little ? 0 : 1;
    return bytes[low] | static_cast<std::uint32_t>(bytes[1 - low]) << 8;
  }
  [[nodiscard]] static Part part_of(std::size_t number, bool pair) {
    constexpr std::uint32_t byte = 0xFF, word = 0xFFFF;
    constexpr std::array pairs{i8080::change::bc, i8080::change::de, i8080::change::hl};
    switch (number) {
      case 0: return {i8080::change::a, 0, byte};
      case 1: return {i8080::change::f, 0, byte};
      case 8: return {i8080::change::sp, 0, word};
      case 9: return {};
      case 10: return {i8080::change::sp, 0, 0};  // INTE is not compared
      default: break;
    }
    const std::uint8_t change = pairs[(number - 2) / 2];
    if (pair) return {change, 0, word};
    return {change, number % 2 == 0 ? 8U : 0U, byte};
  }
  [[nodiscard]] static std::int64_t register_value(std::size_t number, Address next, const View& view) {
    switch (number) {
      case 0: return view.a;
      case 1: return view.others->f;
      case 2: return i8080::high(view.others->bc);
      case 3: return i8080::low(view.others->bc);
      case 4: return i8080::high(view.others->de);
      case 5: return i8080::low(view.others->de);
      case 6: return view.hl >> 8;
      case 7: return view.hl & 0xFFU;
      case 8: return view.others->sp;
      case 9: return next;
      default: return view.control->interrupts_on ? 1 : 0;
    }
  }
  [[nodiscard]] static std::optional<std::int64_t> word(std::int64_t address, const View& view) {
    if (address < 0 || address >= std::int64_t{addresses}) return std::nullopt;
    return view.memory[static_cast<std::size_t>(address)];
  }
  [[nodiscard]] static std::int64_t ticks(Instant at) { return core::t_states_of(at); }
};
using I8080Looker = Looker<I8080Outlook>;

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

// The observer of a monitor that has marked places, too.
class I8080Watcher : public I8080Looker {
 public:
  static constexpr bool cycles = true;
  static constexpr bool ends_of_halts = false;
  using Filter = I8080Marked;

  explicit I8080Watcher(Probe& probe) : I8080Looker(probe) {}
  [[nodiscard]] I8080Marked filter() const { return I8080Marked(probe()); }

  // Kept until the boundary, without a call: one would cost every instruction the registers that it might spoil.
  SIGHTLINE_INLINE void cycle(const machines::I8080Cycle& cycle) {
    kept_[kept_count_] = cycle;
    if (kept_count_ + 1 < kept_.size()) ++kept_count_;
  }
  [[nodiscard]] bool told() {
    for (std::size_t n = 0; n < kept_count_; ++n) tell(kept_[n]);
    kept_count_ = 0;
    return I8080Looker::told();
  }
  bool stop(core::TStateInstant now, i8080::Address next) {
    static_cast<void>(told());
    return I8080Looker::stop(now, next);
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
  // More than an instruction and the breaks before it have.
  std::array<machines::I8080Cycle, 64> kept_{};
  std::size_t kept_count_ = 0;
};

// The same, and tells each instruction.
class I8080Listener {
 public:
  explicit I8080Listener(Probe& probe) : probe_(probe), watcher_(probe) {}

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
  I8080Watcher watcher_;
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
  explicit I8080Reporter(Probe& probe) : listener_(std::in_place, probe) {}

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
