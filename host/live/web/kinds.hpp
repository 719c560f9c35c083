// What a file of the page is: by its content, and where that says nothing by the ending of its name.
#pragma once

#include <string_view>

#include "host/live/web/workbench.hpp"

namespace sightline::live::web {

// The answer to a request of this file's kind; null if it is none: kind.
[[nodiscard]] Json kinds_answer(Workbench& workbench, std::string_view what, const Json& request);

}  // namespace sightline::live::web
