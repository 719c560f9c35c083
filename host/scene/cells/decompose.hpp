// Cuts a scene of polyhedra into cells, by a grid or by a BSP tree.
#pragma once

#include "host/base/result.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

enum class DecompositionMethod {
  automatic,  // by grid if the scene allows it (why_no_grid), else by BSP
  grid,       // boxes grown in a grid (host/scene/cells/grid/decompose.hpp); faces parallel to the axes only
  bsp,        // convex cells of a BSP over the faces' planes (host/scene/cells/bsp/decompose.hpp)
};

struct Decomposition {
  CellComplex complex;
  DecompositionMethod method = DecompositionMethod::grid;  // the one used
};

// The scene is a checked one. An error says why the method does not apply.
[[nodiscard]] base::Result<Decomposition> decomposition_of(
    const PolyScene& scene, DecompositionMethod method = DecompositionMethod::automatic);

// The complex alone.
[[nodiscard]] base::Result<CellComplex> decompose(
    const PolyScene& scene, DecompositionMethod method = DecompositionMethod::automatic);

}  // namespace sightline::scene
