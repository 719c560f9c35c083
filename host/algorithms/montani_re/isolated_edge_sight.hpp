// Computes the visible part of an isolated edge, which bounds no region: the edge without the parts behind the inside of
// a face, or exactly behind a face's outline, which is drawn instead.
#pragma once

#include <cstdint>

#include "host/algorithms/montani_re/faces.hpp"
#include "host/geometry/interval_set.hpp"

namespace sightline::algorithms::montani_re {

// Considers only the set's window, if it has one; an edge on its border is never seen. A face through the edge does not
// hide it.
[[nodiscard]] geometry::IntervalSet seen_of_isolated_edge(const FaceSet& set, std::uint32_t line);

}  // namespace sightline::algorithms::montani_re
