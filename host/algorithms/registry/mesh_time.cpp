#include "host/algorithms/registry/mesh_time.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/geometry/predicates.hpp"

namespace sightline::registry {

double faces_cut_by_planes(const scene::PolyScene& scene) {
  std::vector<const scene::Ring*> outlines;
  for (const scene::PolyBody& body : scene.bodies)
    for (const scene::PolyFace& face : body.faces) outlines.push_back(&face.outline);
  if (outlines.empty()) return 0;
  constexpr std::size_t most = 128;
  const std::size_t step = (outlines.size() + most - 1) / most;
  std::size_t cut = 0;
  std::size_t planes = 0;
  for (std::size_t i = 0; i < outlines.size(); i += step, ++planes) {
    const auto& ring = *outlines[i];
    const scene::PolyPoint& on = scene.vertices[ring[0]];
    const auto normal = geometry::normal_of(on, scene.vertices[ring[1]], scene.vertices[ring[2]]);
    for (const auto* outline : outlines) {
      bool before = false;
      bool beyond = false;
      for (const scene::VertexIndex v : *outline) {
        const std::int64_t side = geometry::dot(normal, geometry::difference(scene.vertices[v], on));
        before = before || side < 0;
        beyond = beyond || side > 0;
      }
      cut += before && beyond ? 1U : 0U;
    }
  }
  return static_cast<double>(cut) / static_cast<double>(planes);
}

double MeshTime::seconds_for(const scene::PolyScene& scene) const {
  if (seconds == 0) return 0;
  constexpr double measured = 70'000;
  constexpr double measured_cuts = 640;
  const double faces = static_cast<double>(face_count(scene)) / measured;
  return seconds * faces * (by_planes ? std::sqrt(faces_cut_by_planes(scene) / measured_cuts) : faces);
}

}  // namespace sightline::registry
