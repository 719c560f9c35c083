#include "host/report/experiments/clock.hpp"

#include <time.h>

#include <algorithm>
#include <cstddef>

namespace sightline::report {

namespace {

// CPU time of this thread.
double processor_nanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

}  // namespace

std::vector<double> median_nanoseconds(std::span<const std::function<void()>> jobs, int rounds) {
  std::vector<std::vector<double>> times(jobs.size());
  for (int round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const double begun = processor_nanoseconds();
      jobs[i]();
      const double taken = processor_nanoseconds() - begun;
      if (round > 0) times[i].push_back(taken);
    }
  }
  std::vector<double> medians;
  for (auto& of_job : times) {
    const auto middle = of_job.begin() + static_cast<std::ptrdiff_t>(of_job.size() / 2);
    std::nth_element(of_job.begin(), middle, of_job.end());
    medians.push_back(*middle);
  }
  return medians;
}

}  // namespace sightline::report
