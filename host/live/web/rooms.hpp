// All that can be asked of the page's module: by its C interface, and by a native build that is compared with it.
#pragma once

#include <string_view>

#include "host/live/web/flying.hpp"
#include "host/live/web/workbench.hpp"

namespace sightline::live::web {

struct Rooms {
  Workbench workbench;
  Flying flying;

  // The answer to a request in JSON, as Workbench::answer has it.
  [[nodiscard]] Json answer(std::string_view request);
};

}  // namespace sightline::live::web
