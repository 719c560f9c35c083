// Turns a solid on the page's PDP-7 (firmware/pdp7/turn).
#pragma once

#include <string_view>

#include "host/live/web/workbench.hpp"

namespace sightline::live::web {

// Answers the requests turn and turn_sight; null for any other.
[[nodiscard]] Json turning_answer(Workbench& workbench, std::string_view what, const Json& request);

}  // namespace sightline::live::web
