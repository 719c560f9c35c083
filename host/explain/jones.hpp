// The lesson of Jones's search (host/algorithms/jones): from cell to cell through portals, each of which narrows the mask.
#pragma once

#include "host/explain/explain.hpp"

namespace sightline::explain {

[[nodiscard]] base::Result<Lesson> explain_jones(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                 const scene::CellComplex* complex);

}  // namespace sightline::explain
