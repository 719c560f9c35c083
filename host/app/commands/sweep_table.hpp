// The table at the end of a sweep: for each method, the number of right views, its error, its time, and the command that shows its
// worst view.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "host/compare/sweep.hpp"

namespace sightline::app {

// Returns the command that compares a view by a method.
using ViewCommand = std::function<std::string(std::string_view method, std::uint64_t view)>;

[[nodiscard]] std::string sweep_text(const compare::SweepTable& table, const ViewCommand& command);

}  // namespace sightline::app
