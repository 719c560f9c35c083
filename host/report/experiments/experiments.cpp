#include "host/report/experiments/experiments.hpp"

#include <array>

namespace sightline::report {

namespace {

constexpr std::array experiments{
    // Long ones first: they run on several processors.
    OldExperiment{"jones-numbers", &jones_numbers},
    OldExperiment{"hard-cases", &hard_cases},
    OldExperiment{"skala-accuracy", &skala_accuracy},
    OldExperiment{"jones-accuracy", &jones_accuracy},
    OldExperiment{"skala-pictures", &skala_pictures},
    OldExperiment{"jones-unseen", &jones_unseen, true},
};

}  // namespace

std::span<const OldExperiment> all_experiments() {
  return experiments;
}

}  // namespace sightline::report
