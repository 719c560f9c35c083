// Finds enclosures of all angles at which the structure of one edge may change as the eye goes round its circle, and few
// others. The kinds are those of edge_candidates.hpp; the forms are those of eye_circle.hpp.
//
// An enclosure is found in doubles with bounds for every rounding error, so it is certain, but not exact: roots that are too
// near to be told apart share one. Nothing depends on that but the number of events: a structure is only computed between
// enclosures, exactly. Within one, no structure is known.
#pragma once

#include <vector>

#include "host/algorithms/plantinga/candidate_filter.hpp"
#include "host/algorithms/plantinga/eye_circle.hpp"

namespace sightline::algorithms::plantinga {

// Sorted, and at least nearest_enclosures apart, so that there is a place between any two.
inline constexpr double nearest_enclosures = 0x1p-26;
[[nodiscard]] std::vector<Enclosure> candidates_of(const RotationModel& model, const ConvexParts& parts, const EyeCircle& circle,
                                                   EdgeIndex edge, const std::vector<Occluder>& occluders);

// Encloses the angles from low to high at which s = n / d is the same for two pairs of forms: three edges meet. False, and
// nothing is found, if doubles cannot tell whether s is the same everywhere.
struct CircleRatio {
  CircleForm n;
  CircleForm d;
};
[[nodiscard]] bool append_meetings(const CircleRatio& first, const CircleRatio& second, double low, double high, std::vector<Enclosure>& found);

}  // namespace sightline::algorithms::plantinga
