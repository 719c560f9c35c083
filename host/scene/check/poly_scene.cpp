// Vertices, camera and references. See poly_scene.hpp.
#include "host/scene/check/poly_scene.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <string>

#include "host/base/result.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_scene_parts.hpp"

namespace sightline::scene {
namespace {

constexpr std::int32_t camera_vector_limit = 1 << 15;

bool within(const PolyPoint& p, std::int32_t limit) {
  return std::all_of(p.begin(), p.end(), [&](std::int32_t c) { return -limit < c && c < limit; });
}

std::string below(std::int32_t limit) {
  return ", expected coordinates " + std::to_string(1 - limit) + ".." + std::to_string(limit - 1);
}

bool check_coordinates(const PolyScene& scene, Problems& problems) {
  bool good = true;
  for (std::size_t v = 0; v < scene.vertices.size() && !problems.full(); ++v) {
    if (within(scene.vertices[v], poly_coordinate_limit)) continue;
    problems.add("vertex", v, "found " + text_of(scene.vertices[v]) + below(poly_coordinate_limit));
    good = false;
  }
  return good;
}

void check_camera(const PolyCamera& camera, Problems& problems) {
  if (!within(camera.eye, poly_coordinate_limit))
    problems.add("camera", "the eye is " + text_of(camera.eye) + below(poly_coordinate_limit));
  struct Direction {
    const char* name;
    const PolyPoint& vector;
  };
  const Direction directions[] = {{"forward", camera.forward}, {"right", camera.right}, {"up", camera.up}};
  for (const Direction& d : directions) {
    const auto vector = geometry::vector_of(d.vector);
    if (geometry::is_zero(vector)) problems.add("camera", std::string(d.name) + " is zero");
    if (!within(d.vector, camera_vector_limit))
      problems.add("camera", std::string(d.name) + " is " + text_of(d.vector) + below(camera_vector_limit));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Direction& a = directions[i];
    const Direction& b = directions[(i + 1) % 3];
    if (geometry::dot(geometry::vector_of(a.vector), geometry::vector_of(b.vector)) != 0)
      problems.add("camera", std::string(a.name) + " and " + b.name + " are not orthogonal");
  }
}

// Marks what is used; false for a vertex that does not exist.
bool check_references(const PolyScene& scene, std::vector<bool>& used, Problems& problems) {
  bool good = true;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const PolyBody& body = scene.bodies[b];
    if (body.faces.empty()) problems.add(body_place(scene, b), "has no faces");
    for (std::size_t f = 0; f < body.faces.size() && !problems.full(); ++f) {
      const auto mark = [&](const std::vector<VertexIndex>& ring) {
        for (const VertexIndex v : ring) {
          if (v < used.size()) {
            used[v] = true;
            continue;
          }
          problems.add(face_place(scene, b, f),
                       "names vertex " + std::to_string(v) + ", of " + std::to_string(used.size()));
          good = false;
        }
      };
      mark(body.faces[f].outline);
      for (const auto& hole : body.faces[f].holes) mark(hole);
    }
  }
  return good && !problems.full();
}

void check_vertices(const PolyScene& scene, const std::vector<bool>& used, Problems& problems) {
  for (std::size_t v = 0; v < used.size() && !problems.full(); ++v)
    if (!used[v]) problems.add("vertex", v, "is not used by any face");
  std::vector<VertexIndex> order(scene.vertices.size());
  std::iota(order.begin(), order.end(), VertexIndex{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](VertexIndex a, VertexIndex b) { return scene.vertices[a] < scene.vertices[b]; });
  for (std::size_t i = 1; i < order.size() && !problems.full(); ++i) {
    const PolyPoint& point = scene.vertices[order[i]];
    if (point == scene.vertices[order[i - 1]]) {
      problems.add("vertex", order[i],
                   "is the same point " + text_of(point) + " as vertex " + std::to_string(order[i - 1]));
    }
  }
}

}  // namespace

std::vector<base::Error> check_poly_scene(const PolyScene& scene) {
  Problems problems;
  if (scene.bodies.empty()) problems.add("bodies", "expected at least one body, found none");
  check_camera(scene.camera, problems);
  const bool within_limits = check_coordinates(scene, problems);
  std::vector<bool> used(scene.vertices.size(), false);
  if (!check_references(scene, used, problems)) return problems.take();
  check_vertices(scene, used, problems);
  for (std::size_t b = 0; b < scene.bodies.size() && within_limits; ++b) {
    bool good = !scene.bodies[b].faces.empty();
    for (std::size_t f = 0; f < scene.bodies[b].faces.size() && !problems.full(); ++f)
      good = check_poly_face(scene, b, f, problems) && good;
    if (good && !scene.bodies[b].sheet && !problems.full()) check_poly_solid(scene, b, problems);
  }
  return problems.take();
}

}  // namespace sightline::scene
