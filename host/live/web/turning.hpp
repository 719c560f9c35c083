// A solid turning on the page's PDP-7 (firmware/pdp7/turn).
#pragma once

#include <string_view>

#include "host/live/web/workbench.hpp"

namespace sightline::live::web {

// The answer to a request of this file's kind; null if it is none: turn, turn_sight.
[[nodiscard]] Json turning_answer(Workbench& workbench, std::string_view what, const Json& request);

}  // namespace sightline::live::web
