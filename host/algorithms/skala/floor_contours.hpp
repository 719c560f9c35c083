// Contours on the floor of the box below a surface: a map of the surface, hidden where the surface is before it.
#pragma once

#include <cstdint>
#include <vector>

#include "host/algorithms/skala/coverage.hpp"
#include "host/algorithms/skala/surface.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::algorithms::skala {

struct FloorContours {
  double floor = -1;           // normalised height
  std::vector<double> levels;  // ascending
  std::uint32_t first_layer = 0;  // of the lowest level
};

// Adds them to a drawing of 255 x 255 units. `coverage` is null if the surface hides nothing of the floor, as seen from
// below.
void add_floor_contours(const scene::HeightGrid& grid, const Surface& surface, const FloorContours& contours, const Coverage* coverage,
                        int columns, picture::VectorDrawing& drawing);

}  // namespace sightline::algorithms::skala
