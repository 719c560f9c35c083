// Random views of a scene, for sweeps: view number k depends on the scene, the seed and k, and on nothing
// else, so that sweeps can be divided and continued anywhere.
//
// Scenes of polyhedra: the eye is in free space within twice the scene's bounds, looking at a random point of
// it, any axis of the frame up; one view in eight is orthographic. A coordinate of the eye is now and then
// that of a vertex, so that the eye is often exactly in the plane of a face. Scenes of cells: the eye is in
// the inside of a cell and looks along z, as the program of 1971 does.
#pragma once

#include <cstdint>

#include "host/algorithms/skala/view.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

// `cells` may be null. The scene is a checked one with a vertex, and a cell if there are cells
// (preconditions).
[[nodiscard]] scene::PolyCamera sweep_camera(const scene::PolyScene& scene, const scene::CellScene* cells,
                                             bool turned, std::uint64_t seed, std::uint64_t number);

// Which way random views of a scene look: as above; a scene of cells in all directions, as polyhedra; in parallel projection along
// random directions without y, as Plantinga's turns and the solid turning on the PDP-7 need them.
enum class Directions { usual, all, level };
// The camera of a view. The preconditions are those of sweep_camera.
[[nodiscard]] scene::PolyCamera random_camera(const scene::PolyScene& scene, const scene::CellScene* cells, Directions directions,
                                              std::uint64_t seed, std::uint64_t number);

// The picture asked for, rotated by any whole angle and seen from 10 to 80 degrees: the first such that can be compared. View number k
// depends on the seed and k alone.
[[nodiscard]] algorithms::skala::View random_height_view(const scene::HeightGrid& grid, algorithms::skala::View view, std::uint64_t seed,
                                                     std::uint64_t number);

}  // namespace sightline::compare
