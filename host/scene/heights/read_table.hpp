// The layout of read_grid.hpp in which the first line has the places along x and the first column those along y.
#pragma once

#include <span>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/heights/read_text.hpp"

namespace sightline::scene {

// Do first line and first column rise or fall, but for the corner?
[[nodiscard]] bool has_places(const HeightLine& first, std::span<const HeightLine> others);

// They do, and the corner is no number, or the number of the other columns, as gnuplot's manual has it (gnuplot ignores it); or the
// places along both axes are three or more at equal distances, and the corner does not continue both.
[[nodiscard]] bool is_table(const HeightLine& first, std::span<const HeightLine> others);

// The grid without its range.
[[nodiscard]] base::Result<HeightGrid> read_table(const HeightLine& first, std::span<const HeightLine> others, std::string_view source);

}  // namespace sightline::scene
