// The movements of a plotter as the lines its pen left on the paper.
#pragma once

#include <span>
#include <vector>

#include "host/guests/skala/twin/twin.hpp"
#include "host/picture/pen_path.hpp"

namespace sightline::guests::skala {

// One path from each lowering of the pen to its lifting, in order; straight runs keep only their ends.
[[nodiscard]] std::vector<picture::PenPath> pen_paths(std::span<const PlotterMove> moves);

}  // namespace sightline::guests::skala
