// The part of check_complex about random places: where cells lie. It expects that nothing else is wrong.
#pragma once

#include <cstdint>

#include "host/scene/check/problems.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

void check_complex_places(const CellComplex& complex, const PolyScene& scene, std::uint64_t seed, Problems& problems);

}  // namespace sightline::scene
