// The lesson of Plantinga, Seales and Dyer's method (host/algorithms/plantinga): the events of a full turn.
#pragma once

#include "host/explain/explain.hpp"

namespace sightline::explain {

[[nodiscard]] base::Result<Lesson> explain_plantinga(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                     const scene::CellComplex* complex);

}  // namespace sightline::explain
