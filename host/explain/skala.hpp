// The lesson of Skala's method (host/algorithms/skala): slices from the foreground to the background and two masks.
#pragma once

#include "host/explain/explain.hpp"

namespace sightline::explain {

[[nodiscard]] base::Result<Lesson> explain_skala(const scene::HeightGrid& grid, double rotation, double elevation);

}  // namespace sightline::explain
