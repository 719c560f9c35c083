// The forms of read_grid.hpp in which places stand in the file without blank lines: points x y z in any order, and a
// table with its places in the first line and column.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/heights/read_text.hpp"

namespace sightline::scene {

// Of x, of y (our z) and of the heights, from 0.
using PointColumns = std::array<std::size_t, 3>;

// Columns as they were asked for, by the heading's names in any case or by number from 1.
[[nodiscard]] base::Result<PointColumns> columns_named(const HeightText& text, const std::vector<std::string>& names,
                                                       std::string_view source);

// Columns by what the heading calls them: x y and one more, x z and a name of heights, or lon lat and a name of heights. Else three
// columns whose first two repeat, as those of points on a grid do. None: it is not such a file.
[[nodiscard]] std::optional<PointColumns> columns_by_content(const HeightText& text);

// Points on a grid, in any order; a place without one is a hole. Its size is limited, its range not set.
[[nodiscard]] base::Result<HeightGrid> read_scattered(const HeightText& text, const PointColumns& columns, std::string_view source);

// Do first line and first column of a table rise or fall? Where its corner is empty, nothing else tells it from a matrix.
[[nodiscard]] bool is_table(const HeightText& text);
[[nodiscard]] base::Result<HeightGrid> read_table(const HeightText& text, std::string_view source);

}  // namespace sightline::scene
