// Measures times of repeated work on this computer.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace sightline::report {

// The CPU time of each job in this thread, in nanoseconds: the median of `rounds` rounds (at least 1). Time of other
// programs is not counted. Jobs are interleaved: every round runs each of them once, so that a computer that slows
// down for a while slows all of them, and a job does not find its own data in the cache. One additional round at the
// start is not counted.
[[nodiscard]] std::vector<double> median_nanoseconds(std::span<const std::function<void()>> jobs, int rounds);

}  // namespace sightline::report
