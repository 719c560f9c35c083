// See sweep_views.hpp.
#include "host/compare/sweep_views.hpp"

#include <algorithm>
#include <vector>

#include "host/compare/heights.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

namespace {

// splitmix64 (Steele, Lea and Flood 2014): consecutive seeds give unrelated numbers.
class ViewRandom {
 public:
  ViewRandom(std::uint64_t seed, std::uint64_t number) : state_(seed) { state_ = next() ^ number; }

  // 0 .. n - 1; n is far below 2^64, so the bias is negligible.
  std::uint64_t below(std::uint64_t n) { return next() % n; }
  // Both ends included.
  std::int32_t between(std::int64_t low, std::int64_t high) {
    return static_cast<std::int32_t>(
        low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1)));
  }

 private:
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

constexpr int most_tries = 1000;
constexpr std::uint64_t one_orthographic_in = 8;
constexpr std::uint64_t one_vertex_coordinate_in = 8;
constexpr std::uint64_t one_along_axis_in = 4;

scene::PolyPoint random_eye(const scene::PolyScene& scene, ViewRandom& random) {
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  const std::int64_t room = bounds.half_size();
  constexpr std::int64_t limit = scene::poly_coordinate_limit - 1;
  scene::PolyPoint eye{};
  for (std::size_t a = 0; a < 3; ++a) {
    eye[a] = random.between(std::max(-limit, bounds.low[a] - room), std::min(limit, bounds.high[a] + room));
    const std::uint64_t vertex = random.below(scene.vertices.size() * one_vertex_coordinate_in);
    if (vertex < scene.vertices.size()) eye[a] = scene.vertices[vertex][a];
  }
  return eye;
}

scene::PolyCamera poly_camera(const scene::PolyScene& scene, ViewRandom& random) {
  scene::SceneFrame frame = scene::frame_of(scene.camera);
  frame.vertical = random.below(3);
  frame.downwards = random.below(2) == 1;
  const bool perspective = random.below(one_orthographic_in) != 0;
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  for (int i = 0; i < most_tries; ++i) {
    const scene::PolyPoint eye = random_eye(scene, random);
    scene::PolyPoint direction{};
    for (std::size_t a = 0; a < 3; ++a) direction[a] = random.between(bounds.low[a], bounds.high[a]) - eye[a];
    if (direction == scene::PolyPoint{}) continue;
    const scene::PolyCamera camera = scene::aimed_camera(frame, eye, direction, perspective);
    if (!scene::eye_error(scene, camera)) return camera;
  }
  // There are only solids wherever an eye may be.
  scene::PolyCamera camera = scene::three_quarter_camera(frame, scene);
  camera.perspective = camera.perspective && !scene::eye_error(scene, camera);
  return camera;
}

// Cells one unit thick have no integer point inside.
scene::PolyCamera cell_camera(const scene::CellScene& cells, ViewRandom& random) {
  scene::PolyCamera camera;
  camera.eye = cells.default_view;
  for (int i = 0; i < most_tries; ++i) {
    scene::PolyPoint eye{};
    for (std::size_t a = 0; a < 3; ++a) eye[a] = random.between(cells.outer.low[a], cells.outer.high[a]);
    const auto inside = [&](const scene::Cell& cell) {
      bool strictly = true;
      for (std::size_t a = 0; a < 3; ++a)
        strictly = strictly && cell.box.low[a] < eye[a] && eye[a] < cell.box.high[a];
      return strictly;
    };
    if (std::none_of(cells.cells.begin(), cells.cells.end(), inside)) continue;
    camera.eye = eye;
    break;
  }
  return camera;
}

// The same eye, looking in any direction.
scene::PolyCamera turned_camera(const scene::PolyScene& scene, const scene::CellScene& cells,
                                const scene::PolyPoint& eye, ViewRandom& random) {
  const bool perspective = random.below(one_orthographic_in) != 0;
  scene::PolyPoint direction{};
  if (random.below(one_along_axis_in) == 0) {
    direction[random.below(3)] = random.below(2) == 0 ? 1 : -1;
  } else {
    for (std::size_t a = 0; a < 3; ++a)
      direction[a] = random.between(cells.outer.low[a], cells.outer.high[a]) - eye[a];
  }
  if (direction == scene::PolyPoint{}) direction[2] = 1;
  return scene::aimed_camera(scene::frame_of(scene.camera), eye, direction, perspective);
}

}  // namespace

scene::PolyCamera sweep_camera(const scene::PolyScene& scene, const scene::CellScene* cells, bool turned,
                               std::uint64_t seed, std::uint64_t number) {
  ViewRandom random(seed, number);
  if (cells == nullptr) return poly_camera(scene, random);
  const scene::PolyCamera camera = cell_camera(*cells, random);
  return turned ? turned_camera(scene, *cells, camera.eye, random) : camera;
}

scene::PolyCamera random_camera(const scene::PolyScene& scene, const scene::CellScene* cells, Directions directions, std::uint64_t seed,
                                std::uint64_t number) {
  if (directions != Directions::level) return sweep_camera(scene, cells, directions == Directions::all, seed, number);
  ViewRandom random(seed, number);
  constexpr std::int32_t most = 1000;
  const std::int32_t x = random.between(-most, most);
  std::int32_t z = random.between(-most, most);
  if (x == 0 && z == 0) z = 1;
  scene::SceneFrame frame = scene::frame_of(scene.camera);
  frame.vertical = 1;
  return scene::aimed_camera(frame, scene::bounds_of(scene).middle(), {x, 0, z}, false);
}

algorithms::skala::View random_height_view(const scene::HeightGrid& grid, algorithms::skala::View view, std::uint64_t seed, std::uint64_t number) {
  ViewRandom random(seed, number);
  const algorithms::skala::View asked = view;
  for (int i = 0; i < most_tries; ++i) {
    view.rotation = random.between(0, 359);
    view.elevation = random.between(10, 80);
    if (!why_not_comparable(grid, view)) return view;
  }
  return asked;
}

}  // namespace sightline::compare
