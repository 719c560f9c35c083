// Converts points between a scene's grid and the unit of the file that it came from, which is what users read
// and write.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// n steps in the unit of the file, as the nearest double.
[[nodiscard]] double steps_in_file(std::int64_t n, double step);

// One coordinate of a point of the scene, as writers write it.
[[nodiscard]] double file_coordinate(const PolyScene& scene, const PolyPoint& p, std::size_t axis);
[[nodiscard]] std::array<double, 3> file_point(const PolyScene& scene, const PolyPoint& p);
// "x,y,z", each the shortest text that reads as the same number.
[[nodiscard]] std::string file_point_text(const PolyScene& scene, const PolyPoint& p);

// The millimetres in a unit by its name in a file (PolyImportReport::unit); 1 for any other name.
[[nodiscard]] double millimetres(std::string_view unit);

// The nearest point of the scene's grid; empty if that is not within poly_coordinate_limit.
[[nodiscard]] std::optional<PolyPoint> grid_point(const PolyScene& scene, const std::array<double, 3>& in_file);

}  // namespace sightline::scene
