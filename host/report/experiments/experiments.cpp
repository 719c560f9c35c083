#include "host/report/experiments/experiments.hpp"

#include <array>

namespace sightline::report {

namespace {

constexpr std::array experiments{
    // Long ones first: they run on several processors.
    OldExperiment{"hard-cases", &hard_cases},
};

}  // namespace

std::span<const OldExperiment> all_experiments() {
  return experiments;
}

}  // namespace sightline::report
