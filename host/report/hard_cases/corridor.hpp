// Corridors for cases with a parameter: rooms one behind the other along z, with a wall without thickness and
// a portal in it between any two.
#pragma once

#include <cstdint>
#include <vector>

#include "host/scene/model/cell_scene.hpp"

namespace sightline::harness::report {

// Strictly inside its wall.
struct Portal {
  std::int32_t z = 0;
  geometry::Span x;
  geometry::Span y;
};

// From z = -100 to `end`, |x| and |y| up to `half`; portals ascend, between the two. The eye is at the
// origin. Coordinates may be beyond what a file of such a scene can hold.
[[nodiscard]] scene::CellScene corridor(const std::vector<Portal>& portals, std::int32_t end,
                                        std::int32_t half = 50);

}  // namespace sightline::harness::report
