// The last steps of the lesson of Plantinga, Seales and Dyer (1990): what the paper leaves to "a coordinate transformation" and to
// "relatively minor modifications", turns about a slanted axis, from above and in perspective.
#pragma once

#include "host/explain/turn_stage.hpp"

namespace sightline::explain {

// Nothing for a scene of many edges, or of coordinates too large for such a turn. `circle`: the number of the sheet with the circle.
void add_other_turns(const pl::RotationModel& model, const TurnStage& stage, std::size_t circle, Steps& steps);

}  // namespace sightline::explain
