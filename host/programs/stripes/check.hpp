// Compares the picture of the stripes program on its machine with that of its native twin.
#pragma once

#include <string>

#include "host/programs/stripes/machine.hpp"
#include "host/programs/stripes/twin/twin.hpp"

namespace sightline::programs::stripes {

// Describes the first difference: status, position in the priority list, dot or command to the plotter. Empty: none.
[[nodiscard]] std::string difference_from_twin(const MachinePicture& machine, const TwinPicture& twin);

}  // namespace sightline::programs::stripes
