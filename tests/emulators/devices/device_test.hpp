// Shared by the device tests: the machine's clock and a taker that records strokes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/core/tstates.hpp"

namespace sightline::tests {

inline constexpr core::ClockRate three_megahertz{3'000'000};

struct KeptStrokes : core::StrokeTaker {
  void strokes(std::span<const core::Stroke> taken) override { kept.insert(kept.end(), taken.begin(), taken.end()); }

  std::vector<core::Stroke> kept;
};

// One processor access in a transcript: at T-state `t`, write `value`, or read and expect it.
struct Access {
  std::int64_t t;
  bool reads;
  std::uint8_t value;
};

}  // namespace sightline::tests
