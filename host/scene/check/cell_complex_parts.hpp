// The parts of check_complex. Each expects that those before it found nothing.
#pragma once

#include <cstdint>

#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/check/problems.hpp"

namespace sightline::scene {

void check_complex_numbers(const CellComplex& complex, const PolyScene& scene, Problems& problems);
void check_complex_openings(const CellComplex& complex, Problems& problems);
void check_complex_cells(const CellComplex& complex, Problems& problems);
void check_complex_lines(const CellComplex& complex, Problems& problems);
void check_complex_volume(const CellComplex& complex, const PolyScene& scene, Problems& problems);
void check_complex_places(const CellComplex& complex, const PolyScene& scene, std::uint64_t seed,
                          Problems& problems);

}  // namespace sightline::scene
