// `sightline draw ALGORITHM SCENE` for the algorithms that draw scenes of polyhedra as lines.
#pragma once

#include "host/app/command.hpp"
#include "host/algorithms/registry/lines.hpp"

namespace sightline::app {

// The algorithm is one of the table's, which does not end.
void add_draw_lines(CLI::App& command, const harness::LineAlgorithm& algorithm, ExitCode& exit_code);

}  // namespace sightline::app
