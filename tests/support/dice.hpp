// Seeded numbers for tests.
#pragma once

#include <cstdint>
#include <random>

namespace sightline::programs::jones {

// Uniform enough, and the same on every library.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  std::int32_t operator()(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(engine_() % (static_cast<std::uint32_t>(high - low) + 1));
  }

 private:
  std::mt19937 engine_;
};

}  // namespace sightline::programs::jones
