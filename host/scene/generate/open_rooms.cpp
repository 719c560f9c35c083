// See open_rooms.hpp.
#include "host/scene/generate/open_rooms.hpp"

#include <string>
#include <vector>

#include "host/scene/generate/random.hpp"

namespace sightline::scene {
namespace {

using geometry::Point;
using geometry::Span;

constexpr std::int32_t side = 400;
constexpr std::int32_t height = 300;
constexpr std::int32_t door_width = 40;
constexpr std::int32_t door_height = 210;
constexpr std::size_t up = 1;

// A wall between the rooms `cells`, perpendicular to `axis` (0 or 2) at `place`. It starts at `low` on the
// other axis of the ground.
struct Wall {
  std::array<std::size_t, 2> cells{};
  std::size_t axis = 0;
  std::int32_t place = 0;
  std::int32_t low = 0;

  [[nodiscard]] std::size_t along() const { return 2 - axis; }
  [[nodiscard]] Point point(std::int32_t at, std::int32_t y) const {
    Point p{};
    p[axis] = place;
    p[along()] = low + at;
    p[up] = y;
    return p;
  }
  // Between `from` and `to` along the wall, `bottom` and `top`. A rectangle gives the lower of its two axes
  // first.
  [[nodiscard]] geometry::Rectangle rectangle(Span at, Span y) const {
    const Span moved{low + at.low, low + at.high};
    if (axis == 0) return {axis, place, {y, moved}};
    return {axis, place, {moved, y}};
  }
};

// The spans of a wall's doors along it.
std::vector<Span> doors_of(std::size_t count) {
  std::vector<Span> doors;
  const auto n = static_cast<std::int32_t>(count);
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t middle = (2 * i + 1) * side / (2 * n);
    doors.push_back({middle - door_width / 2, middle + door_width / 2});
  }
  return doors;
}

void add_wall(const Wall& wall, std::size_t count, CellScene& scene) {
  const std::vector<Span> doors = doors_of(count);
  if (doors.empty()) {
    scene.walls.push_back(wall.rectangle({0, side}, {0, height}));
  } else {
    scene.walls.push_back(wall.rectangle({0, side}, {door_height, height}));
    std::int32_t from = 0;
    for (const Span& door : doors) {
      scene.walls.push_back(wall.rectangle({from, door.low}, {0, door_height}));
      from = door.high;
    }
    scene.walls.push_back(wall.rectangle({from, side}, {0, door_height}));
  }
  for (const Span& door : doors) {
    Opening opening;
    opening.cells = wall.cells;
    opening.place = wall.rectangle(door, {0, door_height});
    opening.ring = {wall.point(door.low, 0), wall.point(door.high, 0), wall.point(door.high, door_height),
                    wall.point(door.low, door_height)};
    // The threshold is not a line: the floor continues through the door.
    opening.vectors = {{false, wall.along(), door_width},
                       {true, up, door_height},
                       {true, wall.along(), -door_width},
                       {true, up, -door_height}};
    scene.openings.push_back(std::move(opening));
  }
  // The foot of a wall, seen from both rooms, is interrupted by the doors; its top is not.
  for (const std::size_t cell : wall.cells) {
    std::vector<Line>& lines = scene.cells[cell].lines;
    std::int32_t from = 0;
    for (const Span& door : doors) {
      lines.push_back({wall.point(from, 0), wall.point(door.low, 0)});
      from = door.high;
    }
    lines.push_back({wall.point(from, 0), wall.point(side, 0)});
    lines.push_back({wall.point(0, height), wall.point(side, height)});
  }
}

}  // namespace

std::size_t walls_between_rooms(std::size_t rooms) {
  return 2 * rooms * (rooms - 1);
}

CellScene generate_open_rooms(std::size_t rooms, std::size_t doors, std::uint64_t seed) {
  const auto n = static_cast<std::int32_t>(rooms);
  CellScene scene;
  scene.name =
      "rooms " + std::to_string(rooms) + " doors " + std::to_string(doors) + " seed " + std::to_string(seed);
  scene.outer = {{0, 0, 0}, {side * n, height, side * n}};
  scene.default_view = {side * (n / 2) + 170, 150, 30};
  std::vector<Wall> walls;
  for (std::int32_t k = 0; k < n; ++k) {
    for (std::int32_t i = 0; i < n; ++i) {
      const Point low{side * i, 0, side * k};
      const Point high{side * (i + 1), height, side * (k + 1)};
      Cell& cell = scene.cells.emplace_back(Cell{{low, high}, {}});
      for (const std::int32_t x : {low[0], high[0]})
        for (const std::int32_t z : {low[2], high[2]}) cell.lines.push_back({{x, 0, z}, {x, height, z}});
      const std::size_t number = scene.cells.size() - 1;
      if (i + 1 < n) walls.push_back({{number, number + 1}, 0, high[0], low[2]});
      if (k + 1 < n) walls.push_back({{number, number + rooms}, 2, high[2], low[0]});
      // Outer walls have no doors: their foot and top are whole.
      for (const std::int32_t y : {0, height}) {
        if (i == 0) cell.lines.push_back({{low[0], y, low[2]}, {low[0], y, high[2]}});
        if (i + 1 == n) cell.lines.push_back({{high[0], y, low[2]}, {high[0], y, high[2]}});
        if (k == 0) cell.lines.push_back({{low[0], y, low[2]}, {high[0], y, low[2]}});
        if (k + 1 == n) cell.lines.push_back({{low[0], y, high[2]}, {high[0], y, high[2]}});
      }
    }
  }
  if (walls.empty()) return scene;
  std::vector<std::size_t> counts(walls.size(), doors / walls.size());
  const std::vector<std::size_t> order = SceneRandom(seed).shuffled(walls.size());
  for (std::size_t i = 0; i < doors % walls.size(); ++i) ++counts[order[i]];
  for (std::size_t i = 0; i < walls.size(); ++i) add_wall(walls[i], counts[i], scene);
  return scene;
}

}  // namespace sightline::scene
