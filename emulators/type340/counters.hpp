// What a Type 340 counts for reports: words, passes, and when the last passes began.
#pragma once

#include <cstdint>

#include "emulators/core/time.hpp"

namespace sightline::type340 {

struct Counters {
  std::uint64_t words = 0;           // display words taken
  std::uint64_t passes_started = 0;  // IDLA and IDRD
  std::uint64_t passes_stopped = 0;  // by a stop word, or by an edge in vector or increment mode
  core::Instant last_start = core::never;      // never: none yet
  core::Instant previous_start = core::never;  // the one before
};

}  // namespace sightline::type340
