// A device on the ports of an 8080.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "device.hpp"
#include "key_polls.hpp"
#include "raster.hpp"
#include "stroke.hpp"
#include "tstates.hpp"

namespace sightline::core {

struct PortRange {
  std::uint8_t first;
  std::uint8_t last;  // included
};

// The kind of a device. A host offers the devices of one kind under one option, and attaches any other device by name.
enum class PortDeviceKind : std::uint8_t {
  raster_board,  // has a raster
  plotter,       // draws strokes
  link,          // exchanges bytes with a host
  terminal,      // has a keyboard and a printer: can be the console
  other,
  special,       // for one program's machine, or not chosen by name: a host does not list it with the others
};

// What an 8080 knows about a device before it is attached.
struct PortDeviceInfo {
  std::string_view name;  // and of its section in a snapshot
  std::string_view help;  // one line
  std::string_view choice = {};  // value of its kind's option that selects it; for a link its chip
  PortDeviceKind kind = PortDeviceKind::other;
  std::span<const PortRange> reads = {};         // ports that answer an IN
  std::span<const PortRange> writes = {};        // ports that take an OUT
  std::span<const std::string_view> lines = {};  // interrupt lines: names for options
  std::span<const DeviceOption> options = {};
  bool has_state = true;  // false: snapshots have no section for it
  std::string_view received = {};  // of a link: caption for the bytes the host received, one line
};

// The arguments of a device's constructor.
struct PortDeviceSetup {
  ClockRate clock;
  StrokeBuffer& strokes;              // of a plotter
  std::span<const Setting> settings;  // of its options, each within its bounds

  // The value of an option of `info`, which must have it.
  [[nodiscard]] constexpr std::int64_t value(const PortDeviceInfo& info, std::string_view option) const {
    return value_of(option, info.options, settings);
  }
};

// The other end of a link: a host computer that sends and receives bytes.
class LinkHost {
 public:
  // Call once, before the machine runs. The bytes must outlive the link.
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  // The bytes the host has received, up to a bound, and how many more came after them.
  [[nodiscard]] virtual std::vector<std::uint8_t> received() const = 0;
  [[nodiscard]] virtual std::uint64_t left_out() const = 0;

 protected:
  ~LinkHost() = default;
};

class Terminal {
 public:
  virtual void type(std::uint8_t code) = 0;
  // The program has read all keys and polled for another.
  [[nodiscard]] virtual bool wants_key() const = 0;
  // The program has read all keys, and another would raise an interrupt request.
  [[nodiscard]] virtual bool interrupts_for_key() const = 0;
  // The instant from which on nothing has been read or printed; it may be in the future.
  [[nodiscard]] virtual TStateInstant quiet_since() const = 0;
  virtual void tell_polls(KeyPollListener* listener) = 0;
  // The characters printed since the last call.
  [[nodiscard]] virtual std::vector<std::uint8_t> take_printed() = 0;

 protected:
  ~Terminal() = default;
};

class PortDevice : public Device<TState> {
 public:
  // At T3 of the input cycle. The device brings itself up to date.
  [[nodiscard]] virtual std::uint8_t in(std::uint8_t port, TStateInstant at) {
    return static_cast<void>(port), static_cast<void>(at), std::uint8_t{0xFF};
  }
  // At T3 of the output cycle.
  virtual void out(std::uint8_t port, std::uint8_t value, TStateInstant at) {
    static_cast<void>(port), static_cast<void>(value), static_cast<void>(at);
  }

  // Bit n: interrupt line n of its PortDeviceInfo is high, as of the last call of in(), out(), advance() or acknowledge().
  [[nodiscard]] virtual unsigned requests() const { return 0; }

  // True for a device that drives INT directly. Its line 0 is INT, and it puts the instruction on the bus byte by byte, at
  // T3 of each acknowledge cycle.
  [[nodiscard]] virtual bool drives_interrupt() const { return false; }
  [[nodiscard]] virtual std::uint8_t acknowledge(TStateInstant at) { return static_cast<void>(at), std::uint8_t{0xFF}; }

  // True for a device that takes the bus. It must know in advance the first T-state at or after t in which HOLD is high (or
  // never_t), and the first in which it is low, which must exist.
  [[nodiscard]] virtual bool drives_hold() const { return false; }
  [[nodiscard]] virtual TStateInstant next_hold(TStateInstant t) const { return static_cast<void>(t), never_t; }
  [[nodiscard]] virtual TStateInstant hold_ends(TStateInstant t) const { return t; }

  // True for a device that makes the processor wait. It returns the number of T-states with READY low, counted from T2 at
  // `at`, of each machine cycle, given by its status byte (i8080/bus.hpp) and address.
  [[nodiscard]] virtual bool drives_ready() const { return false; }
  [[nodiscard]] virtual int wait_states(std::uint8_t status, std::uint16_t address, TStateInstant at) const {
    return static_cast<void>(status), static_cast<void>(address), static_cast<void>(at), 0;
  }

  // The interfaces of some kinds of device; null if the device lacks one.
  [[nodiscard]] virtual const Raster* raster() const { return nullptr; }
  [[nodiscard]] virtual LinkHost* link_host() { return nullptr; }
  [[nodiscard]] virtual Terminal* terminal() { return nullptr; }
  // Of a plotter: the length of a step.
  [[nodiscard]] virtual std::int64_t micrometres_per_step() const { return 0; }
};

}  // namespace sightline::core
