// What the device tests share: the machine's clock and a taker that keeps the strokes.
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

// One access of the processor in a transcript: at T-state `t`, write `value`, or read and find it.
struct Access {
  std::int64_t t;
  bool reads;
  std::uint8_t value;
};

}  // namespace sightline::tests
