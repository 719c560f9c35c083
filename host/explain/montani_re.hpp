// The lesson of Montani and Re's algorithm (host/algorithms/montani_re): stripes, six tests, two lists and subtraction.
#pragma once

#include "host/explain/explain.hpp"

namespace sightline::explain {

[[nodiscard]] base::Result<Lesson> explain_montani_re(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                      const scene::CellComplex* complex);

}  // namespace sightline::explain
