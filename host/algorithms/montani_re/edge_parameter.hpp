// Computes the parameter s, in lowest terms, of the point from + s (to - from) of an edge in space at which a visible
// interval of its image begins or ends.
#pragma once

#include <cstdint>
#include <optional>

#include "host/algorithms/montani_re/image.hpp"
#include "host/algorithms/montani_re/window.hpp"
#include "host/geometry/integer.hpp"
#include "host/geometry/interval_set.hpp"
#include "host/geometry/rational.hpp"

namespace sightline::algorithms::montani_re {

// p / (p - q): where on an edge a linear quantity vanishes that is p at its start and q at its end, p != q. Precondition:
// the result fits 62 bits over 62.
[[nodiscard]] geometry::Rational zero_between(geometry::Int128 p, geometry::Int128 q);

// The part of the edge in front of the eye whose image is neither to the west of the line `west` nor to the east of the line
// `east`. nullopt if it is empty or a point.
[[nodiscard]] std::optional<geometry::Interval> part_between(const Image& image, std::uint32_t edge,
                                                             std::uint32_t west, std::uint32_t east);
[[nodiscard]] std::optional<geometry::Interval> part_within(const Image& image, std::uint32_t edge,
                                                            const Window& window);
// The parameter at which the edge, which is not horizontal in the image, has this ordinate. Precondition: the edge meets
// another edge of the scene or a border of the window there, so that the result fits 62 bits over 62.
[[nodiscard]] geometry::Rational parameter_at(const Image& image, std::uint32_t edge, const Ordinate& y);

}  // namespace sightline::algorithms::montani_re
