// Generated scenes, each with the camera used for measurements: random boxes, towns, triangles and bricks,
// rooms with doors and hatches, and grids of cubes. The same family, size and seed give the same scene,
// vertex for vertex.
//
// boxes, edgeon: one box in each of n shuffled cells of 1000, K = ceil(cbrt n) cells a side, never touching;
//   the camera of edgeon is exactly in the plane of a face.
// touch, aligned: n^3 cubes of 1000 that share faces, or of 500 in the middle of their cells; eye on the diagonal.
// town: buildings on the ground y = 0, G = ceil(sqrt n) plots a side.
// triangles: one in each of n cells.
// bricks: small boxes at small coordinates that may touch but not overlap: the degenerate family. A brick for
//   which 1000 tries find no place is left out.
// rooms: n x n rooms of 1000 x 1000 x 600 with walls without thickness, one sheet; edges between coplanar walls
//   are kept.
// big_rooms: the same, all lengths divided by 5 (and rounded down).
// corridors: n >= 2 rooms in a row along z, a door in each wall between them; corridors 8 and 32 are the
//   built-in scenes of that name.
// prisms: n turned rectangular houses of one height on the ground y = 0, 35 on a square of 20000 (more than 35:
//   on several such squares), at least a gap of 50 apart: the town with which Willis measured splitting. The
//   camera is at its edge, below the tops of the walls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// Sizes are at least 1 (corridors: 2). They keep every coordinate and the eye below poly_coordinate_limit
// (largest_generated_size). Bricks have no such limit; their size is at most 1000.
[[nodiscard]] PolyScene generate_boxes(std::size_t n, std::uint64_t seed = 1);
[[nodiscard]] PolyScene generate_edgeon(std::size_t n, std::uint64_t seed = 1);
[[nodiscard]] PolyScene generate_touch(std::size_t n);
[[nodiscard]] PolyScene generate_aligned(std::size_t n);
[[nodiscard]] PolyScene generate_town(std::size_t n, std::uint64_t seed = 1);
[[nodiscard]] PolyScene generate_triangles(std::size_t n, std::uint64_t seed = 1);
[[nodiscard]] PolyScene generate_bricks(std::size_t n, std::uint64_t seed = 1);
[[nodiscard]] PolyScene generate_rooms(std::size_t n, std::uint64_t seed = 1);
[[nodiscard]] PolyScene generate_big_rooms(std::size_t n, std::uint64_t seed = 1);
[[nodiscard]] PolyScene generate_corridors(std::size_t n);
inline constexpr std::int32_t prism_block = 20000;
inline constexpr std::size_t prisms_in_block = 35;
// The gap is at most 1/100 of a block, so that there is room for 35. (The other published town has 25 with a
// gap of 160.)
[[nodiscard]] PolyScene generate_prisms(std::size_t n, std::uint64_t seed = 1, std::int32_t gap = 50);

// Every family by name, in the order above.
[[nodiscard]] std::vector<std::string_view> generator_names();
// 0 if the family is unknown.
[[nodiscard]] std::size_t largest_generated_size(std::string_view family);
// An unknown family, or a size that is 0 or too large, is an error that lists the families and sizes.
[[nodiscard]] base::Result<PolyScene> generate_scene(std::string_view family, std::size_t size,
                                                     std::uint64_t seed = 1);

}  // namespace sightline::scene
