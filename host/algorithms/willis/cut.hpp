// Cutting a surface in two, exactly.
#pragma once

#include <array>
#include <optional>

#include "host/algorithms/willis/surface.hpp"

namespace sightline::algorithms::willis {

// Two pieces, the chord between them from corner to corner or to the middle of an edge: of all such chords
// the one that makes the greater of the pieces' diameters least, of equals the lesser one, too. A wall in
// plan is halved. A middle that is not on the lattice is moved to the nearest point of the edge that is;
// empty if no such point exists.
[[nodiscard]] std::optional<std::array<Surface, 2>> halved(const Surface& s);

// The pieces before and behind a plane that has corners of the surface on both sides. Empty if they would
// have a corner that is not on the lattice.
[[nodiscard]] std::optional<std::array<Surface, 2>> cut_by(const Surface& s, const SurfacePlane& plane);

}  // namespace sightline::algorithms::willis
