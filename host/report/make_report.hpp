// Runs experiments and makes of their records what the data files say.
#pragma once

#include <string_view>
#include <vector>

#include "host/report/document.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

// The blocks of one chapter; runs the experiments that it takes records of.
[[nodiscard]] Outcome<std::vector<Block>> make_chapter(std::string_view name, const Context& context);

}  // namespace sightline::report
