// Reads the layout of read_grid.hpp whose first line has the places along x and whose first column has those along y.
#pragma once

#include <span>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/heights/read_text.hpp"

namespace sightline::scene {

// Whether the first line and the first column rise or fall, the corner apart.
[[nodiscard]] bool has_places(const HeightLine& first, std::span<const HeightLine> others);

// Whether, in addition, the corner is no number or the number of the other columns, as in gnuplot's manual (gnuplot ignores it); or
// the places along both axes are equidistant, three or more, and the corner does not continue both rows of places.
[[nodiscard]] bool is_table(const HeightLine& first, std::span<const HeightLine> others);

// The grid without its range.
[[nodiscard]] base::Result<HeightGrid> read_table(const HeightLine& first, std::span<const HeightLine> others, std::string_view source);

}  // namespace sightline::scene
