// Rooms one behind the other. See scene.hpp.
#include <string>

#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::scene {

PolyScene generate_corridors(std::size_t n) {
  constexpr std::int32_t width = 400;
  constexpr std::int32_t height = 300;
  constexpr std::int32_t spacing = 400;
  constexpr std::int32_t door_width = 110;
  constexpr std::int32_t door_height = 210;
  CellScene corridor;
  corridor.name = "corridor" + std::to_string(n);
  corridor.default_view = {140, 150, 30};
  for (std::int32_t i = 1; i < static_cast<std::int32_t>(n); ++i) {
    const std::int32_t left = 40 + 30 * (3 * i % 5);
    const std::int32_t right = left + door_width;
    const auto wall = [&](geometry::Span x, geometry::Span y) {
      corridor.walls.push_back({2, spacing * i, {x, y}});
    };
    const geometry::Span beside_door{0, door_height};
    const geometry::Span above_door{door_height, height};
    wall({0, left}, beside_door);
    wall({0, left}, above_door);
    wall({left, right}, above_door);
    wall({right, width}, beside_door);
    wall({right, width}, above_door);
  }
  return poly_scene_of(corridor);
}

}  // namespace sightline::scene
