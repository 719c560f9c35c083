// A device on the PDP-7's IOT bus.
//
// Bits 6-11 of an IOT choose the device, bits 12-13 its subdevice (040, 020), bits 15-17 make pulses 4, 2, 1, which act
// in the order 1, 2, 4. A device that wants a word moved from or to core memory asks for a data break, which is granted
// at the first instruction boundary at or after the request. Source: PDP-4 manual pages 16, 23 and 65.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "device.hpp"
#include "stroke.hpp"
#include "time.hpp"
#include "word.hpp"

namespace sightline::core {

// An IOT, by the name that the assembler and the disassembler have for it.
struct IotName {
  std::string_view mnemonic;  // lower case
  std::uint32_t word;
  std::string_view what;
};

// What a PDP-7 knows of a device before it is attached.
struct IotDeviceInfo {
  std::string_view name;  // of the device, of its section in a snapshot
  std::string_view help;  // one line
  std::span<const std::uint8_t> codes;  // of the device, bits 6-11 of an IOT
  std::span<const IotName> iots = {};
  std::span<const DeviceOption> options = {};
};

// What a device is made from.
struct IotDeviceSetup {
  std::span<const Setting> settings;  // of its options, within their bounds; `value` reads them
  StrokeBuffer& strokes;
  std::uint16_t address_mask;  // where the core address of a data break wraps

  // The value of an option of `info`, which must have it.
  [[nodiscard]] constexpr std::int64_t value(const IotDeviceInfo& info, std::string_view option) const {
    return value_of(option, info.options, settings);
  }
};

// What an IOT is answered.
struct IotReply {
  Word18 ac;  // AC with what the devices put on the information collector
  bool skip = false;
  std::uint32_t answered = 0;  // the pulses (4, 2, 1) that some device obeyed

  // A skip pulse: skips if the flag is up.
  constexpr void test(std::uint32_t word, bool flag) {
    answered |= word & 01U;
    if ((word & 01U) != 0 && flag) skip = true;
  }
  constexpr void collect(Word18 bits) { ac = ac | bits; }
};

// A word that a device wants moved.
struct DataBreak {
  enum class Direction : std::uint8_t {
    from_core,  // to the device
    to_core,
    count,      // the word in core counts up by one, and the device gets the sum
  };
  Direction direction = Direction::from_core;
  std::uint16_t address = 0;  // 15 bits
  Word18 word{};              // to_core: this one
  int cycles = 1;             // that the processor waits
};

// The device brings itself up to date in every function that is given the time, but for what needs a data break. A machine
// calls `advance` when the deadline has passed.
class IotDevice : public Device<Nanosecond> {
 public:
  // The pulses of an IOT of one of its codes at `now`; `reply` has AC on entry. Pulse 1 only tests: it changes nothing that
  // the processor waits for.
  virtual void iot(Instant now, std::uint32_t word, IotReply& reply) = 0;

  // As of the last call above or below.
  [[nodiscard]] virtual bool interrupt_request() const { return false; }
  // Its bits of the word that IORS reads, at `now`.
  [[nodiscard]] virtual std::uint32_t status(Instant now) { return static_cast<void>(now), 0; }
  // CAF clears all flags.
  virtual void clear_flags(Instant now) { static_cast<void>(now); }
  // The START key.
  virtual void power_clear(Instant now) { clear_flags(now); }

  // A data break that is asked for as of the last advance; null: none. Of several devices the first in the machine's
  // list is served first.
  [[nodiscard]] virtual const DataBreak* data_break() const { return nullptr; }
  // The break has ended: `word` is the one moved, or the sum.
  virtual void served(Instant end, Word18 word) { static_cast<void>(end), static_cast<void>(word); }

  // A run ends at `now`: what the device draws up to then is in the machine's stroke buffer. Flags and outputs stay as of the
  // last boundary, so that a run in pieces is the same as one in one piece.
  virtual void finish_strokes(Instant now) { static_cast<void>(now); }

  // After a restored device: relations to the machine's time (StateVisitor::require).
  virtual void require_time(StateVisitor& visit, Instant now) { static_cast<void>(visit), static_cast<void>(now); }
};

}  // namespace sightline::core
