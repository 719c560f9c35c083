// A small closed house beside a building of any size: what the house's rooms show must cost the same, however
// large the building that is not seen from them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

inline constexpr std::size_t house_rooms = 8;                // a side
inline constexpr std::int32_t big_room = 200;                // the side of a room of generate_big_rooms
inline constexpr std::int32_t building_beside_house = 2200;  // where the building begins along x

// The house is generate_big_rooms(house_rooms) in a box without an opening, one room's width larger on every
// side and as high as the rooms; the camera looks along x from within one of them. The building is
// generate_big_rooms(rooms), moved along x. Vertices and bodies of the house come first, so that its picture
// is the same whatever the building's size, 1 .. 1000.
[[nodiscard]] PolyScene generate_house_beside(std::size_t rooms);

}  // namespace sightline::scene
