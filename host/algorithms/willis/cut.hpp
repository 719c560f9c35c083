// Cuts a surface in two, exactly.
#pragma once

#include <array>
#include <optional>

#include "host/algorithms/willis/surface.hpp"

namespace sightline::algorithms::willis {

// Two pieces, separated by a chord whose ends are corners or middles of edges: the chord for which the greater diameter
// of the pieces is least, and among equals the lesser one, too. A wall in plan is halved. A middle that is not on the
// lattice is moved to the nearest lattice point of the edge; nullopt if there is none.
[[nodiscard]] std::optional<std::array<Surface, 2>> halve(const Surface& s);

// The pieces before and behind a plane that has corners of the surface on both sides; nullopt if a new corner would not
// be on the lattice.
[[nodiscard]] std::optional<std::array<Surface, 2>> cut_by(const Surface& s, const SurfacePlane& plane);

}  // namespace sightline::algorithms::willis
