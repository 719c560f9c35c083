// What a machine knows of every device on it, on whichever machine. iot_device.hpp and port_device.hpp say what is
// special to the PDP-7's and the 8080's.
//
// A device is brought up to date when it is touched and publishes the next instant at which it asks for anything by
// itself. One that is not attached costs nothing.
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
// The value of one of them.
struct Setting {
  std::string_view name;
  std::int64_t value;
};
// That of one of `options`: as it is set, or as it is initially.
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

// Something a device has counted, for reports.
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

  // Everything up to and including `now` has happened, but for what needs the processor. Time never goes back.
  virtual void advance(Time now) { static_cast<void>(now); }
  // No later than the instant at which the device, left alone, changes a line to the processor or wants something of
  // it, nor than now while it wants something; the largest instant: never.
  [[nodiscard]] virtual Time deadline() const { return Time::max(); }
  // In a section under the name of the device.
  virtual void visit_state(StateVisitor& visit) { static_cast<void>(visit); }
  // In the order of reports.
  [[nodiscard]] virtual std::vector<Count> counts() const { return {}; }
};

}  // namespace sightline::core
