// Measures time on this computer.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace sightline::compare {

inline constexpr double enough_seconds = 0.1;

// The median, in seconds, of as many runs as take `seconds` together: at least three, so that one delayed run is not
// the median, and at most twenty. If `seconds` is 0, the time of one run.
template <class Run>
[[nodiscard]] double median_seconds(Run&& run, double seconds = enough_seconds) {
  constexpr std::size_t most = 20;
  const std::chrono::duration<double> enough{seconds};
  std::vector<double> times;
  std::chrono::duration<double> all{0};
  const std::size_t least = seconds > 0 ? 3 : 1;
  while (times.size() < most && (times.size() < least || all < enough)) {
    const auto start = std::chrono::steady_clock::now();
    run();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    times.push_back(time.count());
    all += time;
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace sightline::compare
