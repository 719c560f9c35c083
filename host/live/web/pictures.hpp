// Requests about pictures: scenes, the algorithms that draw them, their lessons, and the programs of Jones and Skala on their
// machines.
#pragma once

#include "host/live/web/workbench.hpp"

namespace sightline::live::web {

// Answers the requests lists, firmware, scene, draw, explain, jones, sight, skala and cost; null for any other.
[[nodiscard]] Json pictures_answer(Workbench& workbench, std::string_view what, const Json& request);

}  // namespace sightline::live::web
