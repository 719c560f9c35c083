// Willis's priorities as an 8080 computes them (host/programs/flight), as an algorithm of faces beside those of the registry: a frame is sent to the
// emulated machine, and the pieces are shown in the order that comes back.
//
// The machine is given the pieces that are turned to the eye, and the planes that keep apart what touches; in parallel projection the depth of each.
// Left out: scenes of which it does not hold that. That is an error.
#pragma once

#include "host/algorithms/registry/faces.hpp"

namespace sightline::compare {

// Coordinates have 16 bits: pairs of pieces that they put into another order than exact distances are counted (wrong_orders), and may show a
// wrong face.
[[nodiscard]] const registry::FaceAlgorithm& willis_on_8080();

}  // namespace sightline::compare
