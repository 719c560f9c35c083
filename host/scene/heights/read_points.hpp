// Reads the layout of read_grid.hpp in which a line is a point: x, y, height, and columns that are ignored.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/heights/read_grid.hpp"
#include "host/scene/heights/read_text.hpp"
#include "host/scene/heights/surface_net.hpp"

namespace sightline::scene {

// The columns of x, of y (our z) and of the heights, from 0.
using PointColumns = std::array<std::size_t, 3>;

// The columns that a person named: names of the heading, in any case, or numbers from 1.
[[nodiscard]] base::Result<PointColumns> columns_named(const HeightText& text, const std::vector<std::string>& names,
                                                       std::string_view source);

// The columns that the heading names: x and y, or longitude and latitude, with a name of heights or the only other column; or
// x, z and a name of heights. Empty if it names no coordinates. Coordinates without a column of heights are an error.
[[nodiscard]] base::Result<std::optional<PointColumns>> columns_of_heading(const HeightText& text, std::string_view source);

// Do the first two columns of three or more repeat as the places of a grid do? At least half of the grid's places have a line,
// and at most one line in ten is at the place of another.
[[nodiscard]] bool repeats_as_grid(const HeightText& text);

// Points over a grid, in any order; a place without a point is a hole. Points form a grid if at least a quarter of its places have
// a point and a third of the points have neighbours along both axes. Two points at one place count once if their heights are
// equal; otherwise they are an error. Points that form no grid are a net if blank lines separate them into blocks of equal length.
// Otherwise they are an error, unless the options ask for a triangulation. The range is not set. The note names ignored columns,
// holes and repeated points. `guessed`: an error also says how to read the file as a matrix.
[[nodiscard]] base::Result<HeightSurface> read_points(const HeightText& text, const PointColumns& columns, bool guessed,
                                                      const GridFileOptions& options, std::string_view source);

}  // namespace sightline::scene
