// Grids of Golden Software's Surfer 6 (.grd): DSAA as text, DSBB in binary. Rows go from south to north.
//
//   DSAA   columns and rows, the least and the greatest x, y and height, then the heights, all as decimal numbers.
//   DSBB   columns and rows in 2 bytes each; the least and the greatest x, y and height as doubles; the heights as floats. Little-endian,
//          56 bytes before the heights.
//
// Source: Golden Software, Surfer User's Guide, appendix "Grid files". A height of 1.70141e38 or more is blanked: a hole.
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

// Does the file begin with these letters?
[[nodiscard]] bool is_surfer_text(std::string_view bytes, std::string_view source);
[[nodiscard]] bool is_surfer_binary(std::string_view bytes, std::string_view source);
// The grid without its range.
[[nodiscard]] base::Result<HeightGrid> read_surfer_text(std::string_view bytes, std::string_view source);
[[nodiscard]] base::Result<HeightGrid> read_surfer_binary(std::string_view bytes, std::string_view source);

}  // namespace sightline::scene
