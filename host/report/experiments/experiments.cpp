#include "host/report/experiments/experiments.hpp"

#include <array>

namespace sightline::report {

namespace {

constexpr std::array experiments{
    // Long ones first: they run on several processors.
    Experiment{"jones-numbers", &jones_numbers},
    Experiment{"hard-cases", &hard_cases},
    Experiment{"skala-accuracy", &skala_accuracy},
    Experiment{"jones-accuracy", &jones_accuracy},
    Experiment{"willis-order", &willis_order},
    Experiment{"willis-flight", &willis_flight},
    Experiment{"cross-check", &cross_check},
    Experiment{"jones-views", &jones_views},
    Experiment{"plantinga-accuracy", &plantinga_accuracy},
    Experiment{"plantinga-pdp7", &plantinga_pdp7},
    Experiment{"skala-pictures", &skala_pictures},
    Experiment{"montani-re-8080", &montani_re_8080},
    Experiment{"montani-re-tables", &montani_re_tables},
    Experiment{"plantinga-turns", &plantinga_turns, true},
    Experiment{"jones-unseen", &jones_unseen, true},
    Experiment{"montani-re-growth", &montani_re_growth, true},
    Experiment{"montani-re-stripes", &montani_re_stripes, true},
    Experiment{"willis-times", &willis_times, true},
};

}  // namespace

std::span<const Experiment> all_experiments() {
  return experiments;
}

}  // namespace sightline::report
