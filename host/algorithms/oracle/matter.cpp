#include "host/algorithms/oracle/matter.hpp"

#include <algorithm>

namespace sightline::algorithms::oracle {

using geometry::other_axes;

std::optional<Matter> Matter::of(const scene::CellScene& scene) {
  const auto empty = [](const auto& shape) { return shape.empty(); };
  if (scene.outer.empty() || std::any_of(scene.solids.begin(), scene.solids.end(), empty) ||
      std::any_of(scene.walls.begin(), scene.walls.end(), empty)) {
    return std::nullopt;
  }
  Matter matter;
  std::size_t units = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    auto& grid = matter.grid_[a];
    const auto add = [&](const geometry::Box& box) {
      for (const std::int32_t c : {box.low[a], box.high[a]}) {
        if (scene.outer.span(a).contains(c)) grid.push_back(c);
      }
    };
    add(scene.outer);
    for (const auto& solid : scene.solids) add(solid);
    for (const auto& wall : scene.walls) add(wall.bounds());
    std::sort(grid.begin(), grid.end());
    grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
    units *= grid.size();
    if (units > most_units) return std::nullopt;
  }
  matter.solid_.resize(units);
  for (auto& faces : matter.walled_) faces.resize(units);
  for (const auto& solid : scene.solids) matter.fill(solid);
  for (const auto& wall : scene.walls) matter.cover(wall);
  return matter;
}

std::size_t Matter::index(const std::array<int, 3>& unit) const {
  std::size_t i = 0;
  for (std::size_t a = 0; a < 3; ++a) i = i * grid_[a].size() + static_cast<std::size_t>(unit[a]);
  return i;
}

std::array<int, 2> Matter::units_within(std::size_t axis, geometry::Span span) const {
  const auto at = [&](std::int32_t c) {
    return static_cast<int>(std::lower_bound(grid_[axis].begin(), grid_[axis].end(), c) -
                            grid_[axis].begin());
  };
  return {at(span.low), std::min(at(span.high), units(axis))};
}

void Matter::fill(const geometry::Box& solid) {
  std::array<std::array<int, 2>, 3> range;
  for (std::size_t a = 0; a < 3; ++a) range[a] = units_within(a, solid.span(a));
  for (int x = range[0][0]; x < range[0][1]; ++x) {
    for (int y = range[1][0]; y < range[1][1]; ++y) {
      for (int z = range[2][0]; z < range[2][1]; ++z) solid_[index({x, y, z})] = true;
    }
  }
}

void Matter::cover(const geometry::Rectangle& wall) {
  if (!geometry::Span{grid_[wall.axis].front(), grid_[wall.axis].back()}.contains(wall.at)) return;
  const auto [u, v] = other_axes(wall.axis);
  const auto us = units_within(u, wall.sides[0]);
  const auto vs = units_within(v, wall.sides[1]);
  std::array<int, 3> unit{};
  unit[wall.axis] = units_within(wall.axis, {wall.at, wall.at})[0];
  for (unit[u] = us[0]; unit[u] < us[1]; ++unit[u]) {
    for (unit[v] = vs[0]; unit[v] < vs[1]; ++unit[v]) walled_[wall.axis][index(unit)] = true;
  }
}

bool Matter::solid(const std::array<int, 3>& unit) const {
  for (std::size_t a = 0; a < 3; ++a) {
    if (unit[a] < 0 || unit[a] >= units(a)) return true;
  }
  return solid_[index(unit)];
}

bool Matter::opaque_face(std::size_t axis, const std::array<int, 3>& unit) const {
  std::array<int, 3> below = unit;
  --below[axis];
  return solid(unit) || solid(below) || walled_[axis][index(unit)];
}

// `edge` is the unit along `axis` and the grid line numbers on the other two axes.
std::array<bool, 4> Matter::features(std::size_t axis, const std::array<int, 3>& edge) const {
  const auto [u, v] = other_axes(axis);
  // The quadrants around the edge in order; between two consecutive ones is a face.
  constexpr std::array<std::array<int, 2>, 4> round{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::array<std::array<int, 3>, 4> quadrant;
  for (std::size_t k = 0; k < 4; ++k) {
    quadrant[k] = edge;
    quadrant[k][u] += round[k][0] - 1;
    quadrant[k][v] += round[k][1] - 1;
  }
  const std::array<bool, 4> opaque{opaque_face(u, quadrant[1]), opaque_face(v, quadrant[2]),
                                   opaque_face(u, quadrant[2]), opaque_face(v, quadrant[3])};
  std::array<bool, 4> result{};
  if (std::find(opaque.begin(), opaque.end(), true) == opaque.end()) return result;
  for (std::size_t k = 0; k < 4; ++k) {
    if (solid(quadrant[k])) continue;
    std::size_t free_quadrants = 1;
    for (std::size_t next = k; !opaque[next % 4]; ++next) ++free_quadrants;
    for (std::size_t next = k + 3; !opaque[next % 4]; --next) ++free_quadrants;
    const auto number = static_cast<std::size_t>(round[k][0] + 2 * round[k][1]);
    result[number] = free_quadrants != 2;
  }
  return result;
}

std::vector<RealLine> Matter::real_lines() const {
  std::vector<RealLine> lines;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [u, v] = other_axes(axis);
    std::array<int, 3> edge{};
    for (edge[u] = 0; edge[u] <= units(u); ++edge[u]) {
      for (edge[v] = 0; edge[v] <= units(v); ++edge[v]) {
        std::array<bool, 4> last{};
        for (edge[axis] = 0; edge[axis] < units(axis); ++edge[axis]) {
          const auto feature = features(axis, edge);
          geometry::Point from;
          for (std::size_t a = 0; a < 3; ++a) from[a] = grid_[a][static_cast<std::size_t>(edge[a])];
          if (feature != std::array<bool, 4>{}) {
            if (feature != last) lines.push_back({axis, {edge[u], edge[v]}, from, from, feature});
            lines.back().to[axis] = grid_[axis][static_cast<std::size_t>(edge[axis]) + 1];
          }
          last = feature;
        }
      }
    }
  }
  return lines;
}

}  // namespace sightline::algorithms::oracle
