// Times of this computer for work that is done again and again.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace sightline::report {

// Nanoseconds of the processor that each job takes in this thread, the median of `rounds` rounds (at least
// 1): what other programs do meanwhile is not counted. Jobs are interleaved: every round does each of them
// once, so that a computer that slows down for a while slows all of them, and a job does not find its own
// data in the cache. One round goes before that is not counted.
[[nodiscard]] std::vector<double> median_nanoseconds(std::span<const std::function<void()>> jobs, int rounds);

}  // namespace sightline::report
