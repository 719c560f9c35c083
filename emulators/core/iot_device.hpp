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

// An IOT, by the name that the assembler and the disassembler use.
struct IotName {
  std::string_view mnemonic;  // lower case
  std::uint32_t word;
  std::string_view what;
};

// What a PDP-7 knows about a device before it is attached.
struct IotDeviceInfo {
  std::string_view name;  // and of its section in a snapshot
  std::string_view help;  // one line
  std::span<const std::uint8_t> codes;  // of the device, bits 6-11 of an IOT
  std::span<const IotName> iots = {};
  std::span<const DeviceOption> options = {};
};

// The arguments of a device's constructor.
struct IotDeviceSetup {
  std::span<const Setting> settings;  // of its options, within their bounds; value() reads them
  StrokeBuffer& strokes;
  std::uint16_t address_mask;  // core addresses of data breaks wrap at this mask

  // The value of an option of `info`, which must have it.
  [[nodiscard]] constexpr std::int64_t value(const IotDeviceInfo& info, std::string_view option) const {
    return value_of(option, info.options, settings);
  }
};

// The reply of the devices to an IOT.
struct IotReply {
  Word18 ac;  // AC with the bits that devices have put on the information collector
  bool skip = false;
  std::uint32_t answered = 0;  // the pulses (4, 2, 1) that some device obeyed

  // A skip pulse: skips if the flag is up.
  constexpr void test(std::uint32_t word, bool flag) {
    answered |= word & 01U;
    if ((word & 01U) != 0 && flag) skip = true;
  }
  constexpr void collect(Word18 bits) { ac = ac | bits; }
};

// A data break that a device requests.
struct DataBreak {
  enum class Direction : std::uint8_t {
    from_core,  // to the device
    to_core,
    count,      // the word in core counts up by one, and the device gets the sum
  };
  Direction direction = Direction::from_core;
  std::uint16_t address = 0;  // 15 bits
  Word18 word{};              // to_core: the word to store
  int cycles = 1;             // for which the processor waits
};

// Every function with a time argument first brings the device up to that time, except for data breaks. A machine calls
// `advance` when the deadline has passed.
class IotDevice : public Device<Nanosecond> {
 public:
  // The pulses at `now` of an IOT with one of its codes; on entry `reply` holds AC. Pulse 1 only tests: it changes no state
  // that the processor waits for.
  virtual void iot(Instant now, std::uint32_t word, IotReply& reply) = 0;

  // As of the last call of any function with a time argument.
  [[nodiscard]] virtual bool interrupt_request() const { return false; }
  // The device's bits of the word that IORS reads, at `now`.
  [[nodiscard]] virtual std::uint32_t status(Instant now) { return static_cast<void>(now), 0; }
  // CAF clears all flags.
  virtual void clear_flags(Instant now) { static_cast<void>(now); }
  // The START key.
  virtual void power_clear(Instant now) { clear_flags(now); }

  // The data break requested as of the last advance; null if none. If several devices request one, the machine serves the
  // first in its list.
  [[nodiscard]] virtual const DataBreak* data_break() const { return nullptr; }
  // The break has ended: `word` is the word moved, or the sum.
  virtual void end_break(Instant end, Word18 word) { static_cast<void>(end), static_cast<void>(word); }

  // Ends a run at `now`: puts what the device draws up to then into the machine's stroke buffer. Flags and outputs stay as
  // of the last boundary, so that a run in pieces equals a run in one piece.
  virtual void finish_strokes(Instant now) { static_cast<void>(now); }

  // After the device is restored: checks its relations to the machine's time (StateVisitor::require).
  virtual void require_time(StateVisitor& visit, Instant now) { static_cast<void>(visit), static_cast<void>(now); }
};

}  // namespace sightline::core
