// Rooms of one storey in a square, all alike, with so many doors in the walls between them: scenes of cells
// for the program of 1971, whose openness is the variable.
//
// A room is 400 x 300 x 400 (x, y, z), a wall between two rooms has 0 to most_doors doors of 40 x 210 side by
// side in even steps. The same size, doors and seed give the same scene.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/scene/model/cell_scene.hpp"

namespace sightline::scene {

inline constexpr std::size_t most_doors = 8;

// 2 * rooms * (rooms - 1).
[[nodiscard]] std::size_t walls_between_rooms(std::size_t rooms);

// rooms x rooms rooms, 1 <= rooms <= 40; `doors` in all walls together, at most most_doors in each: as evenly
// as possible, the walls that have one more than others by lot. Preconditions: the bounds.
[[nodiscard]] CellScene generate_open_rooms(std::size_t rooms, std::size_t doors, std::uint64_t seed = 1);

}  // namespace sightline::scene
