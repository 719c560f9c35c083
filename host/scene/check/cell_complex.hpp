// Checks that a cell complex is valid and belongs to this scene. Every test is exact, on integers.
//
// Checked: all numbers are within their arrays; vertices and edges are the scene's; every opening is on the
// low side's and the high side's bounds and listed by its cells, once; its sides go round counterclockwise,
// each with a length, and its corners are on both closures; an opening to `outside` lies on the outer box;
// every cell has an inside; lines are on their cell's closure. When all that is so: if everything is parallel
// to the axes, cells and solids fill the outer box (volume); and, at seeded random places, a free point is
// inside exactly one cell and a point of a solid in none, and where a ray from there leaves its cell it meets
// exactly one opening or a face of the scene. There are fewer places the larger the complex is (about 50
// million comparisons in all, at least 10 places).
//
// Not checked: that no part of an edge is missing.
#pragma once

#include <cstdint>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/check/cell_scene.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// What is wrong (at most most_scene_errors), named by cell or opening from 0; empty if nothing is. The scene
// is a checked one; the complex may be anything.
[[nodiscard]] std::vector<base::Error> check_complex(const CellComplex& complex, const PolyScene& scene,
                                                     std::uint64_t seed = 1);

}  // namespace sightline::scene
