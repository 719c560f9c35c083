// The lesson of Willis's method (host/algorithms/willis): boundaries, clusters, cuts and priorities by distance.
#pragma once

#include "host/explain/explain.hpp"

namespace sightline::explain {

[[nodiscard]] base::Result<Lesson> explain_willis(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                  const scene::CellComplex* complex);

}  // namespace sightline::explain
