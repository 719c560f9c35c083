// Hard cases with a parameter: finds the first value at which a build fails.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/compare/hard_cases/manifest.hpp"

namespace sightline::compare {

// The result of one value.
struct Trial {
  std::optional<std::string> fault;  // empty if right
  std::optional<double> measure;     // the result as a number: an error, a count
  std::optional<double> shown;       // the parameter in its usual unit; empty: the value itself
};

struct SearchResult {
  std::vector<std::pair<double, Trial>> tried;  // in the order of the values
  std::optional<std::size_t> first;             // index into `tried`: the first failure
};

// Tries values from easy to hard until one fails. With `bisect`, every value after a failing one is known to fail,
// too: steps are doubled up to a failure and then halved back to the first one.
[[nodiscard]] SearchResult find_first_failure(const std::vector<double>& values, bool bisect,
                                              const std::function<Trial(double value)>& attempt);

struct FamilyResult {
  std::string build;
  SearchResult search;
  bool as_recorded = true;  // first failure, or none, as in the manifest
};

// One result per build, in their order. The error names an unknown generator or build.
[[nodiscard]] base::Result<std::vector<FamilyResult>> run_family(const Family& family);

}  // namespace sightline::compare
