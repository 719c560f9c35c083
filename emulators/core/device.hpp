// What a machine knows about every device on it. iot_device.hpp and port_device.hpp add what is special to the PDP-7 and to
// the 8080.
//
// The machine brings a device up to date when the processor accesses it or when its deadline has passed. A device that is
// not attached costs nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "state_visitor.hpp"
#include "time.hpp"

namespace sightline::core {

// A setting of a device that is chosen when it is attached, as a number; a switch is 0 or 1.
struct DeviceOption {
  std::string_view name;
  std::string_view what;  // one line, for help
  std::int64_t initial;
  std::int64_t least;
  std::int64_t most;
};
// The value chosen for an option.
struct Setting {
  std::string_view name;
  std::int64_t value;
};
// The value of one of `options`: as set, or else its initial value.
[[nodiscard]] constexpr std::int64_t value_of(std::string_view option, std::span<const DeviceOption> options,
                                              std::span<const Setting> settings) {
  for (const Setting& setting : settings) {
    if (setting.name == option) return setting.value;
  }
  for (const DeviceOption& row : options) {
    if (row.name == option) return row.initial;
  }
  return 0;
}

// A number that a device has counted, for reports.
struct Count {
  std::string_view name;  // words joined by _
  std::uint64_t value;
};

template <class Tick>
class Device {
 public:
  using Time = TickInstant<Tick>;

  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  virtual ~Device() = default;

  // Performs everything up to and including `now`, except what needs the processor. Time never goes back.
  virtual void advance(Time now) { static_cast<void>(now); }
  // The latest instant at which the machine must call advance(): no later than the first change of a line to the processor
  // or request to it that happens without an access, and at most `now` while a request is pending. The largest instant
  // means never.
  [[nodiscard]] virtual Time deadline() const { return Time::max(); }
  // The device's section of a snapshot, which has the device's name.
  virtual void visit_state(StateVisitor& visit) { static_cast<void>(visit); }
  // In the order in which reports list them.
  [[nodiscard]] virtual std::vector<Count> counts() const { return {}; }
};

}  // namespace sightline::core
