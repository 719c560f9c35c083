// The times of the PDP-7 that a run may set: one table of their names, units, bounds and places in
// emulators/pdp7/timing.hpp, where the status of each is told.
//
// Bounds keep a run sensible, not realistic: a clock tick takes less than the clock's period, and the sum of
// the times of any run that a host lives to see stays inside the emulated clock.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "emulators/pdp7/timing.hpp"

namespace sightline::app {

struct TimingSetting {
  std::string name;  // "eae_setup", "iot_stretch.03"
  std::int64_t value;
};

// "NAME=VALUE" each, in any order; the same name again replaces the value. In the order first named. Failure
// usage.
[[nodiscard]] std::vector<TimingSetting> timing_settings(const std::vector<std::string>& texts);

// `settings` as timing_settings() gives them.
void set_timing(pdp7::Timing& timing, const std::vector<TimingSetting>& settings);

// The names with their units, defaults and bounds, a line each, for --help.
[[nodiscard]] std::string timing_help();

}  // namespace sightline::app
