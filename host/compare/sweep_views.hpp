// Random views of a scene, for sweeps. View number k depends on the scene, the seed and k only, so sweeps can be
// divided and resumed anywhere.
//
// Scenes of polyhedra: the eye is in free space within twice the scene's bounds and looks at a random point of it,
// with any axis of the frame up. One view in eight is orthographic. Some coordinates of the eye are those of a
// vertex, so that the eye is often exactly in the plane of a face. Scenes of cells: the eye is inside a cell and
// looks along z, as in the program of 1971.
#pragma once

#include <cstdint>

#include "host/algorithms/skala/view.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

// `cells` may be null. The scene is a checked one with a vertex, and with a cell if `cells` is given (preconditions).
[[nodiscard]] scene::PolyCamera sweep_camera(const scene::PolyScene& scene, const scene::CellScene* cells,
                                             bool turned, std::uint64_t seed, std::uint64_t number);

// The directions of random views: as above; for a scene of cells, all directions, as for polyhedra; or parallel
// projection along random directions without y, as Plantinga's turns and the solid turning on the PDP-7 need.
enum class Directions { usual, all, level };
// The camera of a view. The preconditions are those of sweep_camera.
[[nodiscard]] scene::PolyCamera random_camera(const scene::PolyScene& scene, const scene::CellScene* cells, Directions directions,
                                              std::uint64_t seed, std::uint64_t number);

// The requested picture at a random integer rotation and an elevation of 10 to 80 degrees: the first that can be
// compared. View number k depends on the seed and k only.
[[nodiscard]] algorithms::skala::View random_height_view(const scene::HeightGrid& grid, algorithms::skala::View view, std::uint64_t seed,
                                                     std::uint64_t number);

}  // namespace sightline::compare
