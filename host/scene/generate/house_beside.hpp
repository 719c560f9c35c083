// A small closed house beside a building of any size. The building is not visible from the house's rooms, so
// the cost of a view from there must not depend on its size.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

inline constexpr std::size_t house_rooms = 8;                // a side
inline constexpr std::int32_t big_room = 200;                // the side of a room of generate_big_rooms
inline constexpr std::int32_t building_beside_house = 2200;  // where the building begins along x

// The house is generate_big_rooms(house_rooms) in a closed box, one room's width larger on every side and as
// high as the rooms. The camera looks along x from one of the rooms. The building is
// generate_big_rooms(rooms), moved along x. Vertices and bodies of the house come first, so its picture is
// the same for every size of the building, 1..1000.
[[nodiscard]] PolyScene generate_house_beside(std::size_t rooms);

}  // namespace sightline::scene
