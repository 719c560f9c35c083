// Compares a flight on its machine with that of the program's native twin.
#pragma once

#include <string>

#include "host/programs/flight/machine.hpp"
#include "host/programs/flight/twin/twin.hpp"

namespace sightline::programs::flight {

// Describes the first difference among the frames that both have; empty if none.
[[nodiscard]] std::string first_wrong_frame(const MachineFlight& machine, const TwinFlight& twin);
// The same for a flight that has ended; also compares the status, and reports a program that did not end or lost writes.
[[nodiscard]] std::string difference_from_twin(const MachineFlight& machine, const TwinFlight& twin);

}  // namespace sightline::programs::flight
