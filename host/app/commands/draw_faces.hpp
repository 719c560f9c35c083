// `sightline draw ALGORITHM SCENE` for the algorithms that say which face is seen at each point: a picture of
// filled faces, of their outlines, or a flight as animated PNG.
#pragma once

#include "host/algorithms/registry/faces.hpp"
#include "host/app/command_line.hpp"

namespace sightline::app {

// The algorithm is one of the table's, which does not end.
void add_draw_faces(const Command& command, const harness::FaceAlgorithm& algorithm);

}  // namespace sightline::app
