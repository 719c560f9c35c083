// What must be so of single scenes among the hard cases of Plantinga, Seales and Dyer; the text says what was
// found instead.
#pragma once

#include <optional>
#include <string>

#include "host/report/hard_cases/plantinga.hpp"

namespace sightline::harness::report {

using TurnFault = std::optional<std::string>;

// Of every scene: between every two events the structures are those of hidden-line removal from scratch, the
// turn ends where it began, and back again.
[[nodiscard]] TurnFault turn_fault(const TurnedScene& turned);
// P9: no level edge ends in a T-junction with one of the same height.
[[nodiscard]] TurnFault level_edges_never_cross(const TurnedScene& turned);
// P15: the four faces edge-on, and nothing else.
[[nodiscard]] TurnFault four_faces_edge_on(const TurnedScene& turned);
// P16: no edge ends in a T-junction with the sheet.
[[nodiscard]] TurnFault level_sheet_hides_nothing(const TurnedScene& turned);
// P18: for every event at which an edge gets or loses a piece there is one whose direction is its mirror
// image. (Of equal crossings the least edge is named, and that is not the same edge in the mirror.)
[[nodiscard]] TurnFault mirrored_events(const TurnedScene& turned);
// P20: frames 30 degrees apart forwards and backwards, and half a turn at once.
[[nodiscard]] TurnFault large_steps(const TurnedScene& turned);
// P21: from before the common plane of the fronts these are always seen whole.
[[nodiscard]] TurnFault fronts_always_seen(const TurnedScene& turned);
// P22: in the paper's Table 1 all rows but Grid agree with themselves.
[[nodiscard]] TurnFault only_grid_disagrees();

}  // namespace sightline::harness::report
