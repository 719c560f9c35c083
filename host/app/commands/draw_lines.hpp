// `sightline draw ALGORITHM SCENE` for the algorithms that draw scenes of polyhedra as lines.
#pragma once

#include "host/algorithms/registry/lines.hpp"
#include "host/app/command_line.hpp"

namespace sightline::app {

// The algorithm is one of the table's, which does not end.
void add_draw_lines(const Command& command, const harness::LineAlgorithm& algorithm);

}  // namespace sightline::app
