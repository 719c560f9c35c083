// The sections of a snapshot and their fields, as the machines' visit_state names them.
#pragma once

#include <string>

namespace sightline::manual {

[[nodiscard]] std::string snapshot_pdp7();
[[nodiscard]] std::string snapshot_i8080();

}  // namespace sightline::manual
