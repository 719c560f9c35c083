// Part 5 of the report: all algorithms held against each other on the common scenes
// (host/compare/cross_check.hpp), as one matrix of pairs and scenes, with what does not apply and why, and
// the pictures.
#pragma once

#include <span>
#include <vector>

#include "host/compare/cross_check.hpp"
#include "host/report/report.hpp"

namespace sightline::harness::report {

[[nodiscard]] Outcome<Section> all_against_each_other(const Context& context);

// The matrix of some scenes: how each pair agrees on each, or that it does not.
struct AgreedScene {
  compare::CommonScene scene;
  compare::SceneCrossCheck agreement;
};
[[nodiscard]] Table agreement_matrix(std::span<const AgreedScene> scenes);
// Every cell that failed, with its first difference.
[[nodiscard]] Table agreement_failures(std::span<const AgreedScene> scenes);

}  // namespace sightline::harness::report
