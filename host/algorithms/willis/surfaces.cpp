#include "host/algorithms/willis/surfaces.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "host/base/result.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::algorithms::willis {

namespace {

using scene::Ring;

class FacePieces {
 public:
  FacePieces(const scene::PolyScene& scene, const scene::PolyFace& face) : scene_(scene) {
    // The area vector of a long ring exceeds the limit of the predicates; only its direction matters.
    const Vector3 area = scene::ring_normal(scene.vertices, face.outline);
    axis_ = geometry::dominant_axis(area);
    positive_ = area[axis_] > 0;
    plane_ = plane_of(face.outline);
  }

  [[nodiscard]] const SurfacePlane& plane() const { return plane_; }

  // nullopt if the face has too many corners.
  [[nodiscard]] std::optional<std::vector<Ring>> convex(const scene::PolyFace& face) const {
    if (face.holes.empty() && is_convex(face.outline)) return std::vector<Ring>{without_rows(face.outline)};
    const auto triangles = scene::triangulate(scene_.vertices, face);
    if (!triangles) return std::nullopt;
    std::vector<Ring> rings;
    for (const auto& triangle : *triangles) rings.emplace_back(triangle.begin(), triangle.end());
    join(rings);
    for (Ring& ring : rings) ring = without_rows(ring);
    return rings;
  }

 private:
  [[nodiscard]] const scene::PolyPoint& at(std::size_t i, const Ring& ring) const {
    return scene_.vertices[ring[i % ring.size()]];
  }

  // The turn at corner i of the ring.
  [[nodiscard]] int turn(const Ring& ring, std::size_t i) const {
    const int sign = geometry::sign(geometry::turn(geometry::flattened(at(i, ring), axis_),
                                                   geometry::flattened(at(i + 1, ring), axis_),
                                                   geometry::flattened(at(i + 2, ring), axis_)));
    return positive_ ? sign : -sign;
  }

  [[nodiscard]] bool is_convex(const Ring& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (turn(ring, i) < 0) return false;
    return true;
  }

  [[nodiscard]] Ring without_rows(const Ring& ring) const {
    Ring corners;
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (turn(ring, i) != 0) corners.push_back(ring[(i + 1) % ring.size()]);
    return corners;
  }

  // The plane through a corner at which the ring turns.
  [[nodiscard]] SurfacePlane plane_of(const Ring& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int here = turn(ring, i);
      if (here == 0) continue;
      Vector3 normal = geometry::normal_of(at(i, ring), at(i + 1, ring), at(i + 2, ring));
      if (here < 0) normal = geometry::negated(normal);
      return {normal, geometry::dot(normal, geometry::vector_of(at(0, ring)))};
    }
    return {};
  }

  // Joins rings at common edges as long as the result is convex.
  void join(std::vector<Ring>& rings) const {
    for (std::size_t a = 0; a < rings.size(); ++a) {
      for (std::size_t b = a + 1; b < rings.size();) {
        auto joined = joined_at_edge(rings[a], rings[b]);
        if (joined && is_convex(*joined)) {
          rings[a] = std::move(*joined);
          rings.erase(rings.begin() + static_cast<std::ptrdiff_t>(b));
          b = a + 1;
        } else {
          ++b;
        }
      }
    }
  }

  [[nodiscard]] static std::optional<Ring> joined_at_edge(const Ring& a, const Ring& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        if (a[i] != b[(j + 1) % b.size()] || a[(i + 1) % a.size()] != b[j]) continue;
        Ring ring;
        for (std::size_t k = 1; k <= a.size(); ++k) ring.push_back(a[(i + k) % a.size()]);
        for (std::size_t k = 2; k < b.size(); ++k) ring.push_back(b[(j + k) % b.size()]);
        return ring;
      }
    }
    return std::nullopt;
  }

  const scene::PolyScene& scene_;
  std::size_t axis_ = 0;
  bool positive_ = true;
  SurfacePlane plane_;
};

Surface other_side(Surface s) {
  std::reverse(s.points.begin(), s.points.end());
  s.plane = {geometry::negated(s.plane.normal), -s.plane.offset};
  return s;
}

base::Error error_at(std::size_t body, std::size_t face, std::string message) {
  return {"", "body " + std::to_string(body) + " face " + std::to_string(face), std::move(message)};
}

// The wall over its plan; nullopt if the face is not a rectangle with vertical sides.
std::optional<Surface> wall_of(const scene::PolyScene& scene, const Ring& corners, const SurfacePlane& plane,
                               std::size_t vertical) {
  if (corners.size() != 4 || plane.normal[vertical] != 0) return std::nullopt;
  const auto corner = [&](std::size_t i) { return scene.vertices[corners[i % 4]]; };
  Surface wall;
  wall.plane = plane;
  wall.low = wall.high = corner(0)[vertical];
  for (std::size_t i = 1; i < 4; ++i) {
    wall.low = std::min(wall.low, corner(i)[vertical]);
    wall.high = std::max(wall.high, corner(i)[vertical]);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    scene::PolyPoint here = corner(i);
    scene::PolyPoint next = corner(i + 1);
    const std::int32_t height = here[vertical];
    if (height != wall.low && height != wall.high) return std::nullopt;
    const bool level = height == next[vertical];
    here[vertical] = next[vertical] = 0;
    if (level == (here == next)) return std::nullopt;
    if (level && height == wall.low) wall.points = {on_lattice(here), on_lattice(next)};
  }
  return wall;
}

}  // namespace

base::Result<std::vector<Surface>> surfaces_of(const scene::PolyScene& scene) {
  std::vector<Surface> surfaces;
  std::uint32_t number = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    for (std::size_t f = 0; f < scene.bodies[b].faces.size(); ++f, ++number) {
      const FacePieces pieces(scene, scene.bodies[b].faces[f]);
      const auto rings = pieces.convex(scene.bodies[b].faces[f]);
      if (!rings) return error_at(b, f, "too many corners to be cut into convex pieces");
      for (const Ring& ring : *rings) {
        Surface surface;
        for (const scene::VertexIndex v : ring) surface.points.push_back(on_lattice(scene.vertices[v]));
        surface.plane = pieces.plane();
        surface.face = number;
        surface.body = static_cast<std::uint32_t>(b);
        surfaces.push_back(std::move(surface));
        if (scene.bodies[b].sheet) surfaces.push_back(other_side(surfaces.back()));
      }
    }
  }
  return surfaces;
}

base::Result<std::vector<Surface>> walls_of(const scene::PolyScene& scene, std::size_t vertical) {
  std::vector<Surface> walls;
  std::uint32_t number = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    for (std::size_t f = 0; f < scene.bodies[b].faces.size(); ++f, ++number) {
      const FacePieces pieces(scene, scene.bodies[b].faces[f]);
      const Vector3& normal = pieces.plane().normal;
      if (normal[(vertical + 1) % 3] == 0 && normal[(vertical + 2) % 3] == 0) continue;
      const auto rings = pieces.convex(scene.bodies[b].faces[f]);
      auto wall = rings && rings->size() == 1 ? wall_of(scene, rings->front(), pieces.plane(), vertical)
                                              : std::nullopt;
      if (!wall) return error_at(b, f, "in plan every face must be level or a rectangle with two vertical sides");
      wall->face = number;
      wall->body = static_cast<std::uint32_t>(b);
      walls.push_back(std::move(*wall));
      if (scene.bodies[b].sheet) walls.push_back(other_side(walls.back()));
    }
  }
  return walls;
}

std::vector<FacePlace> face_places(const scene::PolyScene& scene) {
  std::vector<FacePlace> places;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (std::size_t f = 0; f < scene.bodies[b].faces.size(); ++f) places.push_back({b, f});
  return places;
}

}  // namespace sightline::algorithms::willis
