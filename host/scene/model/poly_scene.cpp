// See poly_scene.hpp.
#include "host/scene/model/poly_scene.hpp"

#include <utility>

namespace sightline::scene {

PolyScene without_wires(PolyScene scene) {
  if (scene.wires.empty()) return scene;
  scene.wires.clear();
  scene.wires_on.clear();
  std::vector<bool> used(scene.vertices.size());
  const auto for_corners = [&scene](auto visit) {
    for (PolyBody& body : scene.bodies) {
      for (PolyFace& face : body.faces) {
        for (VertexIndex& v : face.outline) visit(v);
        for (auto& hole : face.holes)
          for (VertexIndex& v : hole) visit(v);
      }
    }
  };
  for_corners([&used](VertexIndex v) { used[v] = true; });
  std::vector<VertexIndex> number(scene.vertices.size());
  VertexIndex count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    number[v] = count;
    if (!used[v]) continue;
    if (!scene.vertex_in_file.empty()) scene.vertex_in_file[count] = scene.vertex_in_file[v];
    scene.vertices[count++] = scene.vertices[v];
  }
  scene.vertices.resize(count);
  if (!scene.vertex_in_file.empty()) scene.vertex_in_file.resize(count);
  for_corners([&number](VertexIndex& v) { v = number[v]; });
  return scene;
}

}  // namespace sightline::scene
