#include "host/algorithms/oracle/sight_oracle.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::algorithms::oracle {
namespace {

using geometry::Int128;
using geometry::Vector3;

// Where the line crosses a face's plane: numerator / denominator times the direction.
struct Distance {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;  // positive

  [[nodiscard]] bool less(const Distance& other) const {
    return Int128{numerator} * other.denominator < Int128{other.numerator} * denominator;
  }
};

class Meetings {
 public:
  Meetings(const scene::PolyScene& scene, const SightLine& line)
      : scene_(scene), eye_(line.from), direction_(line.along) {
    Vector3 aside{};
    aside[(geometry::dominant_axis(direction_) + 1) % 3] = 1;
    across_ = geometry::cross(direction_, aside);
  }

  [[nodiscard]] std::optional<Distance> with(const scene::PolyFace& face) const {
    const Vector3 normal = scene::ring_normal(scene_.vertices, face.outline);
    std::int64_t along = geometry::dot(normal, direction_);
    std::int64_t ahead = geometry::dot(normal, geometry::difference(scene_.vertices[face.outline[0]], eye_));
    if (along < 0) {
      along = -along;
      ahead = -ahead;
    }
    if (along == 0 || ahead <= 0) return std::nullopt;
    bool inside = passes(face.outline);
    for (const auto& hole : face.holes) inside = inside && !passes(hole);
    if (!inside) return std::nullopt;
    return Distance{ahead, along};
  }

 private:
  // Whether the line passes through the inside of the ring: as seen along the line, an odd number of sides crosses the
  // half-plane on one side of it.
  [[nodiscard]] bool passes(std::span<const scene::VertexIndex> ring) const {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector3 p = geometry::difference(scene_.vertices[ring[i]], eye_);
      const Vector3 q = geometry::difference(scene_.vertices[ring[i + 1 == ring.size() ? 0 : i + 1]], eye_);
      const bool p_above = geometry::dot(across_, p) > 0;
      const bool q_above = geometry::dot(across_, q) > 0;
      if (p_above == q_above) continue;
      const std::int64_t turn = geometry::dot(geometry::cross(p, q), direction_);
      if (q_above ? turn > 0 : turn < 0) inside = !inside;
    }
    return inside;
  }

  const scene::PolyScene& scene_;
  const scene::PolyPoint eye_;
  const Vector3 direction_;
  Vector3 across_;  // normal of a plane that contains the line
};

}  // namespace

std::optional<FaceHit> nearest_face(const scene::PolyScene& scene, const SightLine& line) {
  const Meetings meetings(scene, line);
  std::optional<FaceHit> nearest;
  Distance least;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    for (std::size_t f = 0; f < scene.bodies[b].faces.size(); ++f) {
      const auto distance = meetings.with(scene.bodies[b].faces[f]);
      if (!distance || (nearest && !distance->less(least))) continue;
      nearest = FaceHit{b, f};
      least = *distance;
    }
  }
  return nearest;
}

bool hit_at_same_point(const scene::PolyScene& scene, const SightLine& line, const FaceHit& first, const FaceHit& second) {
  const Meetings meetings(scene, line);
  const auto one = meetings.with(scene.bodies[first.body].faces[first.face]);
  const auto other = meetings.with(scene.bodies[second.body].faces[second.face]);
  return one && other && !one->less(*other) && !other->less(*one);
}

bool sees(const scene::PolyScene& scene, const scene::PolyPoint& eye, const scene::PolyPoint& point) {
  const Meetings meetings(scene, {eye, geometry::difference(point, eye)});
  for (const scene::PolyBody& body : scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      const auto distance = meetings.with(face);
      if (distance && distance->numerator < distance->denominator) return false;
    }
  }
  return true;
}

}  // namespace sightline::algorithms::oracle
