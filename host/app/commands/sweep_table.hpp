// What a sweep ends with: of each method how often it is right, how wrong it is, how long it takes, and how to see its worst view.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "host/compare/sweep.hpp"

namespace sightline::app {

// The command that shows a method's picture of a view, measured.
using ViewCommand = std::function<std::string(std::string_view method, std::uint64_t view)>;

[[nodiscard]] std::string sweep_text(const compare::SweepTable& table, const ViewCommand& command);

}  // namespace sightline::app
