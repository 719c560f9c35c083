#include "host/report/experiments/experiments.hpp"

#include <array>

namespace sightline::report {

namespace {

constexpr std::array experiments{
    // Long ones first: they run on several processors.
    OldExperiment{"hard-cases", &hard_cases},
    OldExperiment{"willis-order", &willis_order},
    OldExperiment{"willis-flight", &willis_flight},
    OldExperiment{"cross-check", &cross_check},
    OldExperiment{"plantinga-accuracy", &plantinga_accuracy},
    OldExperiment{"plantinga-pdp7", &plantinga_pdp7},
    OldExperiment{"montani-re-8080", &montani_re_8080},
    OldExperiment{"montani-re-tables", &montani_re_tables},
    OldExperiment{"plantinga-turns", &plantinga_turns, true},
    OldExperiment{"montani-re-growth", &montani_re_growth, true},
    OldExperiment{"montani-re-stripes", &montani_re_stripes, true},
    OldExperiment{"willis-times", &willis_times, true},
};

}  // namespace

std::span<const OldExperiment> all_experiments() {
  return experiments;
}

}  // namespace sightline::report
