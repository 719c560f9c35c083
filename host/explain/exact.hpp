// The lesson of `exact` (host/algorithms/exact): each edge is compared with the faces that may hide it.
#pragma once

#include "host/explain/explain.hpp"

namespace sightline::explain {

[[nodiscard]] base::Result<Lesson> explain_exact(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                 const scene::CellComplex* complex);

}  // namespace sightline::explain
