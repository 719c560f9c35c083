// All that the page has of pictures: scenes, the algorithms that draw them, their lessons, and the two programs of the
// papers put on their machines.
#pragma once

#include "host/live/web/workbench.hpp"

namespace sightline::live::web {

// The answer to a request of this file's kind; null if it is none: lists, firmware, scene, draw, explain, jones, sight, skala, cost.
[[nodiscard]] Json studio_answer(Workbench& workbench, std::string_view what, const Json& request);

}  // namespace sightline::live::web
