// Tiles of the Shuttle Radar Topography Mission (.hgt): a square of one degree, 1201 by 1201 or 3601 by 3601 heights in metres.
//
// Heights are big-endian integers of 16 bits, -32768 for a hole, in rows from north to south, each from west to east. The first and
// the last row and column lie on the border. The file's name has the south-west corner: N47E011.hgt. Without such a name the places
// count from 0 to 1.
// Source: USGS, "SRTM Topography" (SRTM_Topo.pdf), section 2.
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

// Does the name end in .hgt, or is it a binary file of one of the two sizes?
[[nodiscard]] bool is_hgt_grid(std::string_view bytes, std::string_view source);
// The grid without its range.
[[nodiscard]] base::Result<HeightGrid> read_hgt_grid(std::string_view bytes, std::string_view source);

}  // namespace sightline::scene
