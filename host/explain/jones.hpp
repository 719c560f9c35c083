// The lesson of Jones's search (host/algorithms/jones): from cell to cell through portals, with the mask that is left.
#pragma once

#include "host/explain/explain.hpp"

namespace sightline::explain {

[[nodiscard]] base::Result<Lesson> explain_jones(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                 const scene::CellComplex* complex);

}  // namespace sightline::explain
