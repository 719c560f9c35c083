// The form of read_grid.hpp in which every line is a point: x y z, with blank lines between curves.
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/heights/read_text.hpp"

namespace sightline::scene {

// Three fields on every line, and a blank line between at least two of them.
[[nodiscard]] bool is_point_data(const HeightText& text);

// The grid without its range. Its size is only limited from below.
[[nodiscard]] base::Result<HeightGrid> read_points(const HeightText& text, std::string_view source);

}  // namespace sightline::scene
