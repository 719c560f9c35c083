// The parameter s of the point from + s (to - from) at which a visible interval begins or ends, for the image of
// an edge in space, in lowest terms.
#pragma once

#include <cstdint>
#include <optional>

#include "host/algorithms/montani_re/image.hpp"
#include "host/algorithms/montani_re/window.hpp"
#include "host/geometry/integer.hpp"
#include "host/geometry/interval_set.hpp"
#include "host/geometry/rational.hpp"

namespace sightline::algorithms::montani_re {

// p / (p - q): where on an edge a quantity vanishes that changes evenly from p to q, which differ. 62 bits
// over 62 hold it (precondition).
[[nodiscard]] geometry::Rational zero_between(geometry::Int128 p, geometry::Int128 q);

// The part of the edge before the eye whose image is neither to the west of one line nor to the east of
// another. Empty if that is a point or less.
[[nodiscard]] std::optional<geometry::Interval> part_between(const Image& image, std::uint32_t edge,
                                                             std::uint32_t west, std::uint32_t east);
[[nodiscard]] std::optional<geometry::Interval> part_within(const Image& image, std::uint32_t edge,
                                                            const Window& window);
// Where it has this ordinate; the edge is not horizontal in the image. The point is one where the edge meets
// another edge of the scene or a border of the window (precondition), so that 62 bits over 62 hold it.
[[nodiscard]] geometry::Rational parameter_at(const Image& image, std::uint32_t edge, const Ordinate& y);

}  // namespace sightline::algorithms::montani_re
