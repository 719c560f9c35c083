// Random numbers for generated scenes: the upper 31 bits of a linear congruential generator, so that a seed
// gives the same scene on every platform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sightline::scene {

class SceneRandom {
 public:
  explicit SceneRandom(std::uint64_t seed) : state_(seed) {}

  // 0 .. n - 1, n at most 2^31.
  [[nodiscard]] std::int32_t mod(std::uint64_t n) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::int32_t>((state_ >> 33) % n);
  }

  // 0 .. n - 1 in random order.
  [[nodiscard]] std::vector<std::size_t> shuffled(std::size_t n) {
    std::vector<std::size_t> order(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = i;
    for (std::size_t i = n; i-- > 1;) std::swap(order[i], order[static_cast<std::size_t>(mod(i + 1))]);
    return order;
  }

 private:
  std::uint64_t state_;
};

}  // namespace sightline::scene
