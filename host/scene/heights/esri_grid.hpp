// ASCII grids of ESRI (.asc): keys and values in any order, then the rows from north to south.
//
// Source: Esri, ArcGIS documentation, "Esri ASCII raster format". A height belongs to the middle of its cell: half a cell from
// xllcorner, at xllcenter. GDAL's keys dx and dy instead of cellsize, and its nan for a hole, are read, too.
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

// Does the file begin with a line of a key and its value?
[[nodiscard]] bool is_esri_grid(std::string_view bytes, std::string_view source);
// The grid without its range.
[[nodiscard]] base::Result<HeightGrid> read_esri_grid(std::string_view bytes, std::string_view source);

}  // namespace sightline::scene
