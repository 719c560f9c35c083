#include "host/report/experiments/experiments.hpp"

#include <array>

namespace sightline::report {

namespace {

constexpr std::array experiments{
    Experiment{"skala-pictures", &skala_pictures},
};

}  // namespace

std::span<const Experiment> all_experiments() {
  return experiments;
}

}  // namespace sightline::report
