// See house_beside.hpp.
#include "host/scene/generate/house_beside.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "host/scene/generate/scene.hpp"

namespace sightline::scene {
namespace {

void add_moved(PolyScene& scene, PolyScene part, std::int32_t along_x) {
  const auto first = static_cast<VertexIndex>(scene.vertices.size());
  for (PolyPoint& vertex : part.vertices) {
    vertex[0] += along_x;
    scene.vertices.push_back(vertex);
  }
  const auto move = [first](Ring& ring) {
    for (VertexIndex& vertex : ring) vertex += first;
  };
  for (PolyBody& body : part.bodies) {
    for (PolyFace& face : body.faces) {
      move(face.outline);
      for (auto& hole : face.holes) move(hole);
    }
    scene.bodies.push_back(std::move(body));
  }
}

PolyScene box_around_house() {
  constexpr std::int32_t low = -big_room;
  constexpr auto high = static_cast<std::int32_t>(house_rooms + 1) * big_room;
  constexpr std::int32_t top = 120;
  PolyScene scene;
  scene.vertices = {{low, low, 0},   {high, low, 0},   {high, high, 0},   {low, high, 0},
                    {low, low, top}, {high, low, top}, {high, high, top}, {low, high, top}};
  PolyBody& box = scene.bodies.emplace_back();
  box.name = "box around the house";
  box.sheet = true;
  constexpr std::array<std::array<VertexIndex, 4>, 6> faces{
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  for (const auto& face : faces) box.faces.push_back({{face.begin(), face.end()}, {}});
  return scene;
}

}  // namespace

PolyScene generate_house_beside(std::size_t rooms) {
  PolyScene scene = generate_big_rooms(house_rooms);
  scene.name = "house beside " + std::to_string(rooms);
  scene.camera.eye = {5 * big_room + 97, 2 * big_room + 103, 70};
  add_moved(scene, box_around_house(), 0);
  add_moved(scene, generate_big_rooms(rooms), building_beside_house);
  return scene;
}

}  // namespace sightline::scene
