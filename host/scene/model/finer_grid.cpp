// See finer_grid.hpp.
#include "host/scene/model/finer_grid.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <numeric>

#include "host/geometry/predicates.hpp"

namespace sightline::scene {
namespace {

std::int64_t reach_of(const PolyPoint& p) {
  return std::max({std::abs(std::int64_t{p[0]}), std::abs(std::int64_t{p[1]}), std::abs(std::int64_t{p[2]})});
}

// A normal without common factor whose first coordinate that is not 0 is positive, and the plane's distance along it.
std::array<std::int64_t, 4> reduced_plane(const PolyScene& scene, const PolyFace& face) {
  geometry::Vector3 normal{};
  const auto& ring = face.outline;
  for (std::size_t i = 0; i < ring.size() && geometry::is_zero(normal); ++i) {
    normal = geometry::normal_of(scene.vertices[ring[i]], scene.vertices[ring[(i + 1) % ring.size()]],
                                 scene.vertices[ring[(i + 2) % ring.size()]]);
  }
  std::int64_t divisor = std::gcd(std::gcd(normal[0], normal[1]), normal[2]);
  if (divisor == 0) divisor = 1;
  for (const std::int64_t c : normal) {
    if (c == 0) continue;
    if (c < 0) divisor = -divisor;
    break;
  }
  for (std::int64_t& c : normal) c /= divisor;
  return {normal[0], normal[1], normal[2], geometry::dot(normal, geometry::vector_of(scene.vertices[ring[0]]))};
}

}  // namespace

std::int32_t finest_factor(const PolyScene& scene, std::span<const PolyCamera> cameras) {
  std::int64_t vertices = 1;
  std::int64_t eyes = reach_of(scene.camera.eye);
  std::int64_t origin = reach_of(scene.origin);
  for (const PolyPoint& p : scene.vertices) vertices = std::max(vertices, reach_of(p));
  for (const PolyCamera& camera : cameras) eyes = std::max(eyes, reach_of(camera.eye));
  constexpr std::int64_t most_origin = std::int64_t{1} << 30;
  std::int32_t factor = 1;
  while (vertices * 2 * factor <= poly_coordinate_limit / 2 && eyes * 2 * factor < poly_coordinate_limit &&
         origin * 2 * factor < most_origin)
    factor *= 2;
  return factor;
}

PolyScene on_finer_grid(PolyScene scene, std::int32_t factor) {
  for (PolyPoint& p : scene.vertices)
    for (std::int32_t& c : p) c *= factor;
  for (std::int32_t& c : scene.origin) c *= factor;
  scene.camera = on_finer_grid(scene.camera, factor);
  scene.step /= factor;
  return scene;
}

PolyCamera on_finer_grid(PolyCamera camera, std::int32_t factor) {
  for (std::int32_t& c : camera.eye) c *= factor;
  return camera;
}

void number_planes(PolyScene& scene) {
  std::map<std::array<std::int64_t, 4>, std::uint32_t> numbers;
  scene.surface_of.clear();
  for (const PolyBody& body : scene.bodies) {
    for (const PolyFace& face : body.faces) {
      const auto next = static_cast<std::uint32_t>(numbers.size());
      scene.surface_of.push_back(numbers.emplace(reduced_plane(scene, face), next).first->second);
    }
  }
}

}  // namespace sightline::scene
