// The error table of Jones's program, as first measured in a prototype and as measured on the emulated
// machine, and every piece that is wrong by more than 20 pixels.
#pragma once

#include <vector>

#include "host/guests/jones/precision/study.hpp"
#include "host/report/report.hpp"

namespace sightline::harness::report {

// Two tables.
[[nodiscard]] std::vector<Block> published_error_blocks(const guests::jones::ErrorTable& table);

}  // namespace sightline::harness::report
