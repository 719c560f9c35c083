// The lesson of the method of Plantinga, Seales and Dyer (host/algorithms/plantinga): the events of a full turn.
#pragma once

#include "host/explain/explain.hpp"

namespace sightline::explain {

[[nodiscard]] base::Result<Lesson> explain_plantinga(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                     const scene::CellComplex* complex);

}  // namespace sightline::explain
