// Checks that a CellScene is valid. Every test is exact, on integers.
//
// Checked: nothing empty or outside the outer box; cells, solids overlap nowhere; cells and solids fill the
// outer box (volume); no wall goes through a cell; every opening lies in the high face of its first cell and
// the low face of its second; its ring is its rectangle; its vectors go once round the ring, none of them 0
// or outside -16384..16383; every point of every cell face is either opaque (outer box, solid or wall) or in
// exactly one opening; lines are parallel to an axis and on their cell's boundary; the default view is in a
// cell. Not checked: whether a line is missing (the visibility oracle derives its own).
#pragma once

#include <cstddef>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::scene {

// No more than this many errors are looked for.
inline constexpr std::size_t most_scene_errors = 100;

// What is wrong, named by cell, opening, wall or solid number; empty if nothing is. Faces are only looked at
// when nothing else is wrong, because one misplaced box would be reported again by every face around it.
[[nodiscard]] std::vector<base::Error> check_scene(const CellScene& scene);

}  // namespace sightline::scene
