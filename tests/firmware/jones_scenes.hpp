// Scenes made by hand for Jones's program, each for one property. None of them is checked for validity.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "host/scene/model/cell_scene.hpp"

namespace sightline::programs::jones {

inline scene::CellScene one_cell(geometry::Point eye, geometry::Box box, std::vector<scene::Line> lines) {
  scene::CellScene scene;
  scene.name = "one cell";
  scene.outer = box;
  scene.default_view = eye;
  scene.cells.push_back({box, std::move(lines)});
  return scene;
}

// Short lines side by side on a wall, each four display words.
inline scene::CellScene many_lines(std::int32_t count) {
  std::vector<scene::Line> lines;
  for (std::int32_t i = 0; i < count; ++i) lines.push_back({{100, 2 * i, 400}, {150, 2 * i, 400}});
  return one_cell({200, count, 5}, {{0, 0, 0}, {400, 2 * count, 400}}, std::move(lines));
}

// A row of doorways whose left sides lie on one ray through the eye: none is occluded by those before it.
inline scene::CellScene grazing_doorways_scene(std::int32_t count) {
  scene::CellScene scene = one_cell({200, 200, 0}, {{0, 0, -10}, {400, 400, 100}}, {});
  for (std::int32_t i = 1; i <= count; ++i) {
    scene.cells.push_back({{{0, 0, 100 * i}, {400, 400, 100 * (i + 1)}}, {}});
    scene::Opening door;
    const auto cell = static_cast<std::size_t>(i);
    door.cells = {cell - 1, cell};
    door.ring = {{200 + i, 180, 100 * i}};
    door.vectors = {{false, 0, 80 - i}, {false, 1, 40}, {false, 0, i - 80}, {false, 1, -40}};
    scene.openings.push_back(door);
  }
  return scene;
}

// One opening with a staircase outline: 2 steps + 2 corners.
inline scene::CellScene stairs(std::int32_t steps) {
  scene::CellScene scene = one_cell({200, 200, 0}, {{0, 0, -10}, {400, 400, 100}}, {});
  scene.cells.push_back({{{0, 0, 100}, {400, 400, 200}}, {}});
  scene::Opening opening;
  opening.cells = {0, 1};
  opening.ring = {{180, 180, 100}};
  opening.vectors = {{true, 0, 40}, {true, 1, 40}};
  for (std::int32_t i = 0; i < steps; ++i) {
    const std::int32_t rest = i + 1 < steps ? -2 : 2 * (steps - 1) - 40;
    opening.vectors.push_back({true, 0, rest});
    opening.vectors.push_back({true, 1, rest});
  }
  scene.openings.push_back(opening);
  return scene;
}

}  // namespace sightline::programs::jones
