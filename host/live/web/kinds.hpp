// Finds the kind of a file on the page by its content, or else by its extension.
#pragma once

#include <string_view>

#include "host/live/web/workbench.hpp"

namespace sightline::live::web {

// Answers the request kind; null for any other.
[[nodiscard]] Json kinds_answer(Workbench& workbench, std::string_view what, const Json& request);

}  // namespace sightline::live::web
