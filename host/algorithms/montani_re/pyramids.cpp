#include "host/algorithms/montani_re/pyramids.hpp"

#include <algorithm>
#include <utility>

#include "host/algorithms/montani_re/isolated_edges.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::algorithms::montani_re {
namespace {

struct Pyramid {
  PyramidFrame frame;
  WindowBounds window;
};

// Straight ahead; right and left; up and down. z = 0 bounds the last four: nothing is seen there.
constexpr std::array<Pyramid, 5> pyramids{{{{{0, 1, 2}, false}, {{-2, -2}, {2, 2}, 1}},
                                           {{{2, 1, 0}, false}, {{0, -2}, {1, 2}, 1}},
                                           {{{2, 1, 0}, true}, {{0, -2}, {1, 2}, 1}},
                                           {{{2, 0, 1}, false}, {{0, -2}, {1, 2}, 1}},
                                           {{{2, 0, 1}, true}, {{0, -2}, {1, 2}, 1}}}};

// The face is edge-on, or its visible side is turned away from the eye.
bool turned_away(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                 const scene::PolyFace& face) {
  const geometry::Vector3 normal = scene::ring_normal(scene.vertices, face.outline);
  const geometry::Vector3 sight = camera.perspective
                                      ? geometry::difference(scene.vertices[face.outline[0]], camera.eye)
                                      : geometry::vector_of(camera.forward);
  return geometry::dot(normal, sight) >= 0;
}

// A face that may be seen and is not wholly behind the eye.
struct SeenFace {
  std::size_t body = 0;
  std::size_t index = 0;
  bool past_eye = false;  // partly behind the eye
};

// The part of a scene in front of the eye, in the camera's frame.
struct SeenScene {
  SeenScene(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
    const geometry::Vector3 right = geometry::vector_of(camera.right);
    const geometry::Vector3 up = geometry::vector_of(camera.up);
    const geometry::Vector3 forward = geometry::vector_of(camera.forward);
    vertices.reserve(scene.vertices.size());
    for (const scene::PolyPoint& point : scene.vertices) {
      const geometry::Vector3 d = geometry::difference(point, camera.eye);
      vertices.push_back({geometry::dot(right, d), geometry::dot(up, d), geometry::dot(forward, d)});
    }
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const scene::PolyBody& body = scene.bodies[b];
      for (std::size_t f = 0; f < body.faces.size(); ++f) {
        if (!body.sheet && turned_away(scene, camera, body.faces[f])) continue;
        const auto& outline = body.faces[f].outline;
        std::size_t behind = 0;
        for (const scene::VertexIndex v : outline) behind += camera.perspective && vertices[v][2] <= 0 ? 1 : 0;
        if (behind != outline.size()) faces.push_back({b, f, behind != 0});
      }
    }
  }

  [[nodiscard]] const SeenFace* past_eye() const {
    const auto found = std::find_if(faces.begin(), faces.end(), [](const SeenFace& face) { return face.past_eye; });
    return found == faces.end() ? nullptr : &*found;
  }

  std::vector<std::array<std::int64_t, 3>> vertices;
  std::vector<SeenFace> faces;
};

// A sum of Image is a determinant of vectors in the camera's frame (in orthographic views, of their images). It is a
// determinant of vectors in the scene times the determinant of the camera's vectors (in orthographic views, times the
// greatest common divisor of the components of right x up).
std::int64_t divisor_of(const scene::PolyCamera& camera) {
  const geometry::Vector3 normal = geometry::cross(geometry::vector_of(camera.right), geometry::vector_of(camera.up));
  const auto divisor =
      camera.perspective
          ? geometry::Int128{geometry::dot(geometry::vector_of(camera.forward), normal)}
          : geometry::common_divisor(geometry::common_divisor(geometry::Int128{normal[0]}, geometry::Int128{normal[1]}),
                                     geometry::Int128{normal[2]});
  return static_cast<std::int64_t>(divisor < 0 ? -divisor : divisor);
}

FaceSet make_set(const scene::PolyScene& scene, const scene::PolyCamera& camera, const SeenScene& seen,
                 const PyramidFrame& frame, const WindowBounds* window, const std::vector<picture::LineEdge>& isolated) {
  FaceSetBuilder builder(camera.perspective, divisor_of(camera));
  builder.reserve(seen.vertices.size(), seen.faces.size());
  for (const std::array<std::int64_t, 3>& p : seen.vertices) {
    const std::int64_t depth = p[frame.axes[2]];
    builder.add_vertex({p[frame.axes[0]], p[frame.axes[1]], frame.turned ? -depth : depth});
  }
  if (window != nullptr) builder.clip_to(*window);
  Rings rings;  // declared outside the loop to reuse its memory
  for (const SeenFace& one : seen.faces) {
    const scene::PolyFace& face = scene.bodies[one.body].faces[one.index];
    rings.resize(1 + face.holes.size());
    rings[0].assign(face.outline.begin(), face.outline.end());
    for (std::size_t h = 0; h < face.holes.size(); ++h) rings[h + 1].assign(face.holes[h].begin(), face.holes[h].end());
    builder.add_face(rings, static_cast<std::uint32_t>(one.body), static_cast<std::uint32_t>(one.index));
  }
  for (const picture::LineEdge& edge : isolated) builder.add_isolated_edge(edge.from, edge.to);
  return builder.take();
}

}  // namespace

bool before_eye(const scene::PolyScene& scene, const scene::PolyCamera& camera, scene::VertexIndex vertex) {
  return !camera.perspective || geometry::dot(geometry::vector_of(camera.forward),
                                              geometry::difference(scene.vertices[vertex], camera.eye)) > 0;
}

std::optional<std::array<std::size_t, 2>> face_past_eye(const scene::PolyScene& scene,
                                                        const scene::PolyCamera& camera) {
  if (!camera.perspective) return std::nullopt;
  const SeenScene seen(scene, camera);
  const SeenFace* face = seen.past_eye();
  if (face == nullptr) return std::nullopt;
  return std::array{face->body, face->index};
}

FaceSet faces_seen(const scene::PolyScene& scene, const scene::PolyCamera& camera, const PyramidFrame& frame,
                   const WindowBounds* window) {
  return make_set(scene, camera, SeenScene(scene, camera), frame, window, isolated_edges(scene, camera));
}

std::vector<FaceSet> faces_before_eye(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  std::vector<FaceSet> sets;
  const std::vector<picture::LineEdge> isolated = isolated_edges(scene, camera);
  const SeenScene seen(scene, camera);
  if (seen.past_eye() == nullptr) {
    sets.push_back(make_set(scene, camera, seen, {}, nullptr, isolated));
    return sets;
  }
  for (const Pyramid& pyramid : pyramids) {
    FaceSet set = make_set(scene, camera, seen, pyramid.frame, &pyramid.window, isolated);
    if (!set.faces.empty() || !set.isolated.empty()) sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace sightline::algorithms::montani_re
