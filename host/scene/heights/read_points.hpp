// The layout of read_grid.hpp in which every line is a point: x, y, height and columns that are left out.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/heights/grid_options.hpp"
#include "host/scene/heights/read_text.hpp"
#include "host/scene/heights/surface_net.hpp"

namespace sightline::scene {

// Of x, of y (our z) and of the heights, from 0.
using PointColumns = std::array<std::size_t, 3>;

// Columns as they were asked for, by the heading's names in any case or by number from 1.
[[nodiscard]] base::Result<PointColumns> columns_named(const HeightText& text, const std::vector<std::string>& names,
                                                       std::string_view source);

// Columns by what the heading calls them: x and y, or longitude and latitude, and a name of heights or the only other column; or
// x, z and a name of heights. None: it names no places. Places and no column for the heights are an error.
[[nodiscard]] base::Result<std::optional<PointColumns>> columns_of_heading(const HeightText& text, std::string_view source);

// Do the first two columns of three or more repeat as the places of a grid do? At least half of the grid's places have a line,
// and at most one line in ten is at the place of another.
[[nodiscard]] bool repeats_as_grid(const HeightText& text);

// Points of a grid, in any order; a place without one is a hole. Points form a grid if at least a quarter of its places have
// one and a third of them have neighbours along both axes. Two of one height at one place count once, of two heights they are
// an error. Points that form no grid are a net if blank lines separate them into blocks of equal length, and otherwise an error,
// unless the options ask for a triangulation. The range is not set. The note has columns left out, holes and repeated points, as
// the end of a sentence. `guessed`: an error says how to say that the file is no list of points.
[[nodiscard]] base::Result<HeightSurface> read_points(const HeightText& text, const PointColumns& columns, bool guessed, const GridFileOptions& options,
                                                      std::string_view source);

}  // namespace sightline::scene
