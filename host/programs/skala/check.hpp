// Compares the picture of Skala's program on its machine with that of its native twin.
#pragma once

#include <string>

#include "host/programs/skala/machine.hpp"
#include "host/programs/skala/twin/twin.hpp"

namespace sightline::programs::skala {

// Describes the first difference: status, dot, movement of the plotter or mask. Empty: none. `device` is the one on the
// machine.
[[nodiscard]] std::string difference_from_twin(const MachinePicture& machine, const TwinPicture& twin, Device device);

}  // namespace sightline::programs::skala
