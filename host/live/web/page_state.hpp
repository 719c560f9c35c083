// Answers all requests to the page's module. The C interface uses it, and a native build that is compared with the module.
#pragma once

#include <string_view>

#include "host/live/web/flying.hpp"
#include "host/live/web/workbench.hpp"

namespace sightline::live::web {

struct PageState {
  Workbench workbench;
  Flying flying;

  // See Workbench::answer.
  [[nodiscard]] Json answer(std::string_view request);
};

}  // namespace sightline::live::web
