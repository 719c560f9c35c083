// Where on an edge something is seen to begin or end: the parameter s of the point from + s (to - from) of
// the edge in space whose image is given, in lowest terms.
#pragma once

#include <cstdint>

#include "host/algorithms/montani_re/image.hpp"
#include "host/geometry/rational.hpp"

namespace sightline::algorithms::montani_re {

// Where the image of the edge crosses another line. Not between 0 and 1 if it does so beyond an end.
[[nodiscard]] geometry::Rational parameter_at_line(const Image& image, std::uint32_t edge,
                                                   std::uint32_t other);
// Where it has this ordinate; the edge is not horizontal in the image. The point is one where the edge meets
// another edge of the scene (precondition), so that 62 bits over 62 hold it.
[[nodiscard]] geometry::Rational parameter_at(const Image& image, std::uint32_t edge, const Ordinate& y);

}  // namespace sightline::algorithms::montani_re
