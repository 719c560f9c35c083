// Draws a scene in stripes on the page's 8080 (firmware/i8080/stripes).
#pragma once

#include <string_view>

#include "host/live/web/workbench.hpp"

namespace sightline::live::web {

// Answers the request stripes; null for any other.
[[nodiscard]] Json stripes_answer(Workbench& workbench, std::string_view what, const Json& request);

}  // namespace sightline::live::web
