// What the devices of an 8080 run leave behind for its report.
#pragma once

#include <vector>

#include "host/harness/run_i8080.hpp"
#include "host/harness/screen.hpp"

namespace sightline::harness {

using I8080Devices = machines::SkalaPorts<Screen>;

// Counts, raster and received bytes; the devices stand at the end of the run.
void collect_devices(I8080Devices& devices, I8080Report& report);

}  // namespace sightline::harness
