// The light pen of the Type 340 (Type 370): where it points, and how late it answers.
//
// The field of view is a rectangle in display points, which a test can state exactly; a real pen sees a disc of some
// forty points. A flash inside it gives one light pulse.
#pragma once

#include <cstdint>

#include "emulators/core/time.hpp"

namespace sightline::type340 {

struct LightPen {
  std::uint16_t left = 0;  // points, all borders included
  std::uint16_t bottom = 0;
  std::uint16_t right = 0;
  std::uint16_t top = 0;
  // Beam on -> light pulse. Flashes come no closer than 1.5 us, and one pulse is under way at a time: a longer delay
  // is taken as 1.499 us, a negative one as 0.
  core::Duration delay{100};

  [[nodiscard]] constexpr bool sees(std::uint16_t x, std::uint16_t y) const {
    return left <= x && x <= right && bottom <= y && y <= top;
  }
};

}  // namespace sightline::type340
