// Hard cases with a parameter: one search for the first value at which a build fails.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/compare/hard_cases/manifest.hpp"

namespace sightline::compare {

// What became of one value.
struct Trial {
  std::optional<std::string> fault;  // none: right
  std::optional<double> measure;     // what was found, as a number: an error, a count
  std::optional<double> shown;       // the parameter as people know it; none: the value
};

struct SearchResult {
  std::vector<std::pair<double, Trial>> tried;  // in the order of the values
  std::optional<std::size_t> first;             // of `tried`: the first failure
};

// Tries values from easy to hard until one fails. bisect: every value after one that fails is known to fail,
// too; steps are doubled up to a failure, and halved back to the first one.
[[nodiscard]] SearchResult find_first_failure(const std::vector<double>& values, bool bisect,
                                              const std::function<Trial(double value)>& attempt);

struct FamilyResult {
  std::string build;
  SearchResult search;
  bool as_recorded = true;  // fails first where the manifest says, or nowhere as it says
};

// A result for each build, in their order. The error names a generator or a build that there is not.
[[nodiscard]] base::Result<std::vector<FamilyResult>> run_family(const Family& family);

}  // namespace sightline::compare
