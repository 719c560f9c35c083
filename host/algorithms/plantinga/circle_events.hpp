// The visual events of a full turn about any axis, in parallel projection or perspective.
//
// An event is not an exact direction here, as in event_list.hpp, but an enclosure: all its changes happen within it, most often
// 10^-14 radians wide, and nothing changes between two enclosures, where the visible pieces are exact. Within one,
// `passed_at` reports no view; a user of `list`, such as `spin`, gets the view before the enclosure.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/eye_circle.hpp"
#include "host/base/result.hpp"

namespace sightline::algorithms::plantinga {

struct CircleEvents {
  std::vector<Enclosure> enclosures;  // ascending; the last one may reach through pi
  EventList list;                     // the same events; the direction of each is the upper end of its enclosure, rounded

  // The number of events passed at an angle in (-pi, pi]; nullopt within `place_error` of an enclosure.
  [[nodiscard]] std::optional<std::size_t> passed_at(double angle) const;
};

// Preconditions: why_not(model, circle) is empty; no tolerance and no trace in the options. The error says which limit was
// reached.
[[nodiscard]] base::Result<CircleEvents> build_circle_events(const RotationModel& model, const EyeCircle& circle,
                                                             const BuildOptions& options = {});

}  // namespace sightline::algorithms::plantinga
