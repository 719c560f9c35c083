// Lines that other algorithms draw on a sheet though they belong to what stands behind it.
//
// A face through a point does not hide the point: so where a wall ends on the far side of another, in the
// midst of it, the line of contact counts as seen through the wall it touches. Regions have no such lines: a
// face shows its own outline only. Only sheets can be touched from behind.
#pragma once

#include <optional>
#include <string>

#include "host/scene/poly_scene.hpp"

namespace sightline::algorithms::montani_re {

// The first such line, in words; nothing if there is none. The scene is a checked one (precondition).
[[nodiscard]] std::optional<std::string> edge_behind_sheet(const scene::PolyScene& scene,
                                                           const scene::PolyCamera& camera);

}  // namespace sightline::algorithms::montani_re
