// Willis's priorities computed by an 8080 (host/programs/flight), as a face algorithm like those of the registry: a
// frame is sent to the emulated machine, and the pieces are painted in the order that it returns.
//
// The machine receives the pieces turned to the eye and the planes that separate touching pieces; in parallel
// projection, the depth of each. Scenes that do not fit are an error.
#pragma once

#include "host/algorithms/registry/faces.hpp"

namespace sightline::compare {

// Coordinates have 16 bits. Pairs of pieces that they put into another order than exact distances are counted
// (wrong_orders) and may show a wrong face.
[[nodiscard]] const registry::FaceAlgorithm& willis_on_8080();

}  // namespace sightline::compare
