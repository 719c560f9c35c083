// The vector generator of the Type 340: a seven-stage binary rate multiplier, not a line algorithm.
//
// Each count pulse toggles some stages of BRM. A stage going from 0 to 1 passes the bit of |dx| (and of |dy|) whose weight
// it carries: stage 0 the 64s, stage 6 the units. Leading stages that carry nothing toggle with stage 0, which shortens the
// run: 127, 63, 31, 15 or 7 pulses, by the larger of the two. The end point is exact; the path deviates up to 1.6 points
// from the straight line. `RateMultiplier` is the logic, pulse by pulse; the functions below it give the number of pulses
// of a whole vector, and the steps of each.
//
// Source: logic of the count levels as drawn, taken before the pulse (as capacitor-diode gates do).
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace sightline::type340 {

// Leading stages that toggle with stage 0 and carry nothing: 0 to 4; d = |dx| OR |dy|.
[[nodiscard]] constexpr unsigned idle_stages(std::uint8_t d) {
  const auto width = static_cast<unsigned>(std::bit_width(d));
  return width >= 7 ? 0 : (width <= 3 ? 4 : 7 - width);
}

// The seven flip-flops. Bit k of brm is stage k.
struct RateMultiplier {
  // Stage k passes the bit of weight 2^(6-k). The table converts between stages and weights, in both directions.
  static constexpr std::array<std::uint8_t, 128> weights = [] {
    std::array<std::uint8_t, 128> table{};
    for (unsigned stages = 0; stages < 128; ++stages) {
      unsigned bits = 0;
      for (unsigned k = 0; k < 7; ++k) bits |= (stages >> k & 1U) << (6 - k);
      table[stages] = static_cast<std::uint8_t>(bits);
    }
    return table;
  }();
  static constexpr std::uint8_t full = 0177;

  struct Step {
    bool x;
    bool y;
  };

  std::uint8_t brm = 0;

  // One count pulse for magnitudes dx, dy (0..127). Both coordinates may step in one pulse.
  constexpr Step count(std::uint8_t dx, std::uint8_t dy) {
    const auto levels = count_levels(static_cast<std::uint8_t>(dx | dy));
    const std::uint8_t passed = weights[levels & ~brm & full];
    brm ^= levels;
    return {(passed & dx) != 0, (passed & dy) != 0};
  }

  friend constexpr bool operator==(RateMultiplier, RateMultiplier) = default;

  // The stages that the next pulse toggles; d = |dx| OR |dy|. A stage toggles when all before it are 1 (the carry of an
  // increment); the idle ones and the first that carries anything toggle at every pulse.
  [[nodiscard]] constexpr std::uint8_t count_levels(std::uint8_t d) const {
    return static_cast<std::uint8_t>(((brm ^ (brm + 1U)) & full) | ((2U << idle_stages(d)) - 1));
  }
};

// Pulses from BRM = 0 back to 0: 128, 64, 32, 16 or 8. A vector runs one fewer, then a last one that cannot step.
[[nodiscard]] constexpr std::int64_t pulses_per_turn(std::uint8_t d) { return std::int64_t{1} << (7 - idle_stages(d)); }

// Pulses from BRM = 0 until every stage is 1 and all steps have been made.
[[nodiscard]] constexpr int pulses_of_vector(std::uint8_t dx, std::uint8_t dy) {
  return static_cast<int>(pulses_per_turn(static_cast<std::uint8_t>(dx | dy))) - 1;
}

// Bit i: stage i, counted from the first that is not idle, passes a bit of this magnitude. Pulse n from BRM = 0 toggles on
// the stage whose number is the count of trailing zeros of n.
[[nodiscard]] constexpr unsigned steps_by_stage(std::uint8_t magnitude, std::uint8_t d) {
  return unsigned{RateMultiplier::weights[magnitude]} >> idle_stages(d);
}

}  // namespace sightline::type340
