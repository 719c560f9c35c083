// What the device tests share: the machine's clock and a sink that keeps the strokes.
#pragma once

#include <cstdint>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/core/tstates.hpp"

namespace sightline::tests {

inline constexpr core::ClockRate three_megahertz{3'000'000};

struct KeptStrokes {
  static constexpr bool consumes = true;
  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& stroke) { strokes.push_back(stroke); }
  void end_pass(core::Instant) {}

  std::vector<core::Stroke> strokes;
};

// One access of the processor in a transcript: at T-state `t`, write `value`, or read and find it.
struct Access {
  std::int64_t t;
  bool reads;
  std::uint8_t value;
};

}  // namespace sightline::tests
