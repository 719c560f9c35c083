// Boxes, cubes, towns, triangles and bricks. See scene.hpp.
#include <algorithm>
#include <array>
#include <string>

#include "host/geometry/predicates.hpp"
#include "host/scene/generate/random.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_builder.hpp"

namespace sightline::scene {
namespace {

constexpr std::int32_t pitch = 1000;

// The smallest k with k^power >= n.
std::size_t root_above(std::size_t n, unsigned power) {
  std::size_t k = 1;
  const auto reaches = [&] { return power == 2 ? k * k >= n : k * k * k >= n; };
  while (!reaches()) ++k;
  return k;
}

PolyPoint origin_of(std::size_t cell, std::size_t side) {
  return {pitch * static_cast<std::int32_t>(cell % side),
          pitch * static_cast<std::int32_t>(cell / side % side),
          pitch * static_cast<std::int32_t>(cell / (side * side))};
}

PolyCamera boxes_camera(std::size_t side) {
  const auto k = static_cast<std::int32_t>(side);
  return {true, {1800 * k, 1400 * k, 2200 * k}, {-13, -9, -17}, {-9, 13, 0}, {-221, -153, 250}};
}

std::string numbered_name(const char* kind, std::size_t n) {
  return kind + std::to_string(n);
}

std::string scene_name(const char* family, std::size_t n, std::uint64_t seed) {
  return std::string(family) + " " + std::to_string(n) + " seed " + std::to_string(seed);
}

PolyScene cubes(const char* family, std::size_t n, std::int32_t low, std::int32_t high) {
  PolyBuilder builder;
  for (std::size_t cell = 0; cell < n * n * n; ++cell) {
    const PolyPoint o = origin_of(cell, n);
    builder.add_box(numbered_name("cube ", cell), {o[0] + low, o[1] + low, o[2] + low},
                    {o[0] + high, o[1] + high, o[2] + high});
  }
  const std::int32_t eye = 1500 * static_cast<std::int32_t>(n);
  builder.scene().name = std::string(family) + " " + std::to_string(n);
  builder.scene().camera = {true, {eye, eye, eye}, {-1, -1, -1}, {-1, 1, 0}, {-1, -1, 2}};
  return builder.take();
}

struct Brick {
  PolyPoint low{};
  PolyPoint high{};
};

bool overlap(const Brick& a, const Brick& b) {
  bool common = true;
  for (std::size_t i = 0; i < 3; ++i)
    common = common && std::max(a.low[i], b.low[i]) < std::min(a.high[i], b.high[i]);
  return common;
}

}  // namespace

PolyScene generate_boxes(std::size_t n, std::uint64_t seed) {
  SceneRandom random(seed);
  const std::size_t side = root_above(n, 3);
  const auto cells = random.shuffled(side * side * side);
  PolyBuilder builder;
  builder.reserve(n, 8 * n);
  for (std::size_t k = 0; k < n; ++k) {
    PolyPoint low = origin_of(cells[k], side);
    PolyPoint high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] += 50 + random.mod(400);
      high[a] = low[a] + 100 + random.mod(400);
    }
    builder.add_box(numbered_name("box ", k), low, high);
  }
  builder.scene().name = scene_name("boxes", n, seed);
  builder.scene().camera = boxes_camera(side);
  return builder.take();
}

PolyScene generate_edgeon(std::size_t n, std::uint64_t seed) {
  PolyScene scene = generate_boxes(n, seed);
  std::int32_t plane = 0;
  for (const PolyFace& face : scene.bodies[n / 2].faces)
    for (const VertexIndex v : face.outline) plane = std::max(plane, scene.vertices[v][0]);
  scene.name = scene_name("edgeon", n, seed);
  const PolyPoint& eye = scene.camera.eye;
  scene.camera = {true, {plane, eye[1], eye[2]}, {0, -9, -17}, {-1, 0, 0}, {0, -17, 9}};
  return scene;
}

PolyScene generate_touch(std::size_t n) {
  return cubes("touch", n, 0, 1000);
}

PolyScene generate_aligned(std::size_t n) {
  return cubes("aligned", n, 250, 750);
}

PolyScene generate_town(std::size_t n, std::uint64_t seed) {
  SceneRandom random(seed);
  const std::size_t side = root_above(n, 2);
  const auto plots = random.shuffled(side * side);
  PolyBuilder builder;
  for (std::size_t k = 0; k < n; ++k) {
    PolyPoint low{pitch * static_cast<std::int32_t>(plots[k] % side), 0,
                  pitch * static_cast<std::int32_t>(plots[k] / side)};
    PolyPoint high{};
    for (const std::size_t a : {std::size_t{0}, std::size_t{2}}) {
      low[a] += 50 + random.mod(400);
      high[a] = low[a] + 100 + random.mod(400);
    }
    high[1] = 100 + random.mod(900);
    builder.add_box(numbered_name("building ", k), low, high);
  }
  builder.scene().name = scene_name("town", n, seed);
  builder.scene().camera = {
      true, {500 * static_cast<std::int32_t>(side), 400, -1500}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  return builder.take();
}

PolyScene generate_triangles(std::size_t n, std::uint64_t seed) {
  SceneRandom random(seed);
  const std::size_t side = root_above(n, 3);
  const auto cells = random.shuffled(side * side * side);
  PolyBuilder builder;
  for (std::size_t k = 0; k < n; ++k) {
    const PolyPoint origin = origin_of(cells[k], side);
    std::array<PolyPoint, 3> corners{};
    do {
      for (PolyPoint& corner : corners)
        for (std::size_t a = 0; a < 3; ++a) corner[a] = origin[a] + 10 + random.mod(980);
    } while (geometry::is_zero(geometry::normal_of(corners[0], corners[1], corners[2])));
    builder.add_sheet(numbered_name("triangle ", k), corners);
  }
  builder.scene().name = scene_name("triangles", n, seed);
  builder.scene().camera = boxes_camera(side);
  return builder.take();
}

PolyScene generate_bricks(std::size_t n, std::uint64_t seed) {
  constexpr int most_tries = 1000;
  SceneRandom random(seed);
  PolyBuilder builder;
  std::vector<Brick> bricks;
  for (std::size_t k = 0; k < n; ++k) {
    for (int tries = 0; tries < most_tries; ++tries) {
      Brick brick;
      for (std::size_t a = 0; a < 3; ++a) {
        brick.low[a] = random.mod(6);
        brick.high[a] = brick.low[a] + 1 + random.mod(3);
      }
      if (std::any_of(bricks.begin(), bricks.end(), [&](const Brick& b) { return overlap(b, brick); }))
        continue;
      builder.add_box(numbered_name("brick ", k), brick.low, brick.high);
      bricks.push_back(brick);
      break;
    }
  }
  builder.scene().name = scene_name("bricks", n, seed);
  builder.scene().camera = {true, {22, 26, 34}, {-2, -2, -3}, {-1, 1, 0}, {-3, -3, 4}};
  return builder.take();
}

}  // namespace sightline::scene
