// One storey of equal rooms in a square, with a given number of doors in the walls between them: cell scenes
// for the program of 1971 whose openness is varied.
//
// A room is 400 x 300 x 400 (x, y, z). A wall between two rooms has 0 to most_doors doors of 40 x 210, evenly
// spaced. The same size, doors and seed give the same scene.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/scene/model/cell_scene.hpp"

namespace sightline::scene {

inline constexpr std::size_t most_doors = 8;

// 2 * rooms * (rooms - 1).
[[nodiscard]] std::size_t walls_between_rooms(std::size_t rooms);

// rooms x rooms rooms, 1 <= rooms <= 40. The walls have `doors` doors in all, at most most_doors each,
// distributed evenly; the seed decides which walls have one more than others. Preconditions: these bounds.
[[nodiscard]] CellScene generate_open_rooms(std::size_t rooms, std::size_t doors, std::uint64_t seed = 1);

}  // namespace sightline::scene
