// A flight on its machine compared with that of the program's native twin.
#pragma once

#include <string>

#include "host/programs/flight/machine.hpp"
#include "host/programs/flight/twin/twin.hpp"

namespace sightline::programs::flight {

// Of the frames that both have: the first difference, in words. Empty: none.
[[nodiscard]] std::string first_wrong_frame(const MachineFlight& machine, const TwinFlight& twin);
// The same of a flight that has ended: of the status, too, and what no program may do: not to end, or to write in vain.
[[nodiscard]] std::string difference_from_twin(const MachineFlight& machine, const TwinFlight& twin);

}  // namespace sightline::programs::flight
