// The visible part of an isolated edge, one that bounds no region: the edge less the parts that lie behind
// a face: behind its inside, or exactly behind its outline, which is drawn in its place.
#pragma once

#include <cstdint>

#include "host/algorithms/montani_re/faces.hpp"
#include "host/geometry/interval_set.hpp"

namespace sightline::algorithms::montani_re {

// In the set's window, if it has one; nothing on its borders. A face through the edge does not hide it.
[[nodiscard]] geometry::IntervalSet seen_of_isolated_edge(const FaceSet& set, std::uint32_t line);

}  // namespace sightline::algorithms::montani_re
