// How long an algorithm takes for a mesh: what a user is told before minutes are spent.
#pragma once

#include <cmath>
#include <cstddef>

namespace sightline::registry {

// Of one view on a computer of 2020, preparation included: `seconds` with 70,000 faces, and with others by this power of
// their number. 0: seconds for all meshes. Measured with a bumpy sphere (tests/bench/MEASURED.md); where long faces cross
// each other's planes it takes longer.
struct MeshTime {
  double seconds = 0;
  double power = 1;

  [[nodiscard]] double seconds_for(std::size_t faces) const {
    constexpr double measured = 70'000;
    return seconds * std::pow(static_cast<double>(faces) / measured, power);
  }
};

}  // namespace sightline::registry
