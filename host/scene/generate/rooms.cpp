// Rooms with doors and hatches. See scene.hpp.
#include <string>

#include "host/scene/generate/random.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::scene {

namespace {

// A wall stands along one axis of the ground plan. It shares its corners with adjacent walls by index, so
// that a building of a million rooms needs no search for equal points.
class Building {
 public:
  Building(std::size_t rooms, std::int32_t divisor, std::uint64_t seed)
      : rooms_(rooms), divisor_(divisor), random_(seed) {
    const std::int32_t pitch = 1000 / divisor_;
    for (std::size_t i = 0; i <= rooms_; ++i) {
      for (std::size_t j = 0; j <= rooms_; ++j) {
        for (const std::int32_t z : {0, 600 / divisor_}) {
          scene_.vertices.push_back(
              {pitch * static_cast<std::int32_t>(i), pitch * static_cast<std::int32_t>(j), z});
        }
      }
    }
    scene_.bodies.emplace_back();
    scene_.bodies[0].name = "walls";
    scene_.bodies[0].sheet = true;
  }

  PolyScene build() {
    for (std::size_t i = 0; i <= rooms_; ++i)
      for (std::size_t j = 0; j < rooms_; ++j) add_wall(i, j, 1, i == rooms_);
    for (std::size_t j = 0; j <= rooms_; ++j)
      for (std::size_t i = 0; i < rooms_; ++i) add_wall(i, j, 0, j == 0 || j == rooms_);
    const auto m = static_cast<std::int32_t>(rooms_);
    scene_.camera = {true,
                     {-1500 / divisor_, (500 * m + 37) / divisor_, 350 / divisor_},
                     {1, 0, 0},
                     {0, -1, 0},
                     {0, 0, 1}};
    return std::move(scene_);
  }

 private:
  [[nodiscard]] VertexIndex corner(std::size_t i, std::size_t j, bool top) const {
    return static_cast<VertexIndex>((i * (rooms_ + 1) + j) * 2 + (top ? 1 : 0));
  }

  // The point `along` the wall's axis from the corner `low`, and `z` up.
  VertexIndex add_point(VertexIndex low, std::size_t axis, std::int32_t along, std::int32_t z) {
    PolyPoint p = scene_.vertices[low];
    p[axis] += along / divisor_;
    p[2] = z / divisor_;
    scene_.vertices.push_back(p);
    return static_cast<VertexIndex>(scene_.vertices.size() - 1);
  }

  void add_wall(std::size_t i, std::size_t j, std::size_t axis, bool solid) {
    const std::size_t next_i = i + (axis == 0 ? 1 : 0);
    const std::size_t next_j = j + (axis == 1 ? 1 : 0);
    const VertexIndex low = corner(i, j, false);
    PolyFace face;
    face.outline = {low, corner(next_i, next_j, false), corner(next_i, next_j, true), corner(i, j, true)};
    if (!solid) {
      const std::int32_t kind = random_.mod(4);
      const std::int32_t from = 100 + random_.mod(500);
      const std::int32_t to = from + 200;
      if (kind == 1 || kind == 2) {
        const VertexIndex door[] = {add_point(low, axis, from, 0), add_point(low, axis, from, 450),
                                    add_point(low, axis, to, 450), add_point(low, axis, to, 0)};
        face.outline.insert(face.outline.begin() + 1, std::begin(door), std::end(door));
      } else if (kind == 3) {
        face.holes.push_back({add_point(low, axis, from, 200), add_point(low, axis, from, 400),
                              add_point(low, axis, to, 400), add_point(low, axis, to, 200)});
      }
    }
    scene_.bodies[0].faces.push_back(std::move(face));
  }

  std::size_t rooms_;
  std::int32_t divisor_;
  SceneRandom random_;
  PolyScene scene_;
};

}  // namespace

PolyScene generate_rooms(std::size_t n, std::uint64_t seed) {
  PolyScene scene = Building(n, 1, seed).build();
  scene.name = "rooms " + std::to_string(n) + " seed " + std::to_string(seed);
  return scene;
}

PolyScene generate_big_rooms(std::size_t n, std::uint64_t seed) {
  PolyScene scene = Building(n, 5, seed).build();
  scene.name = "big_rooms " + std::to_string(n) + " seed " + std::to_string(seed);
  return scene;
}

// Rooms in a row. See scene.hpp.

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
