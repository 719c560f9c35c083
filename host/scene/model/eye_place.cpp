// See eye_place.hpp.
#include "host/scene/model/eye_place.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/model/file_units.hpp"

namespace sightline::scene {

namespace {

using geometry::Point2;
using geometry::Vector3;

// Twice the area of the outline, as a vector; overflow of partial sums is harmless, the total fits.
Vector3 normal_of(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> outline) {
  std::array<std::uint64_t, 3> sum{};
  const PolyPoint& about = vertices[outline[0]];
  for (std::size_t i = 2; i < outline.size(); ++i) {
    const Vector3 part =
        geometry::normal_of(about, vertices[outline[i - 1]], vertices[outline[i]]);
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += static_cast<std::uint64_t>(part[axis]);
  }
  return {static_cast<std::int64_t>(sum[0]), static_cast<std::int64_t>(sum[1]),
          static_cast<std::int64_t>(sum[2])};
}

class FaceAndEye {
 public:
  FaceAndEye(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> outline, std::span<const Ring> holes, const PolyPoint& eye)
      : vertices_(vertices), outline_(outline), holes_(holes), eye_(eye), normal_(normal_of(vertices, outline)) {
    above_ = geometry::dot(normal_, geometry::difference(eye, vertices[outline[0]]));
  }

  [[nodiscard]] bool contains() const {
    if (above_ != 0) return false;
    const std::size_t axis = geometry::dominant_axis(normal_);
    if (locate(outline_, axis) < 0) return false;
    for (const auto& hole : holes_)
      if (locate(hole, axis) > 0) return false;
    return true;
  }

  // Whether the ray along +x from the eye, perturbed, crosses the face. The eye is not on the face.
  [[nodiscard]] bool stops_ray() const {
    if (geometry::sign(above_) * geometry::sign(normal_[0]) >= 0) return false;
    bool inside = surrounds(outline_);
    for (const auto& hole : holes_) inside = inside != surrounds(hole);
    return inside;
  }

 private:
  [[nodiscard]] int locate(std::span<const VertexIndex> ring, std::size_t axis) const {
    std::vector<Point2> flat;
    flat.reserve(ring.size());
    for (const VertexIndex v : ring) flat.push_back(geometry::flattened(vertices_[v], axis));
    return geometry::locate_in_ring(flat, geometry::flattened(eye_, axis));
  }

  // In the projection along x to (y, z). The point is at z + e and y - e^2.
  [[nodiscard]] bool surrounds(std::span<const VertexIndex> ring) const {
    const Point2 p = geometry::flattened(eye_, 0);
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 a = geometry::flattened(vertices_[ring[i]], 0);
      const Point2 b = geometry::flattened(vertices_[ring[i + 1 == ring.size() ? 0 : i + 1]], 0);
      if ((a[1] > p[1]) == (b[1] > p[1])) continue;
      // If the point is on the side's line, the perturbation decides: by z or, along a side parallel to z, by
      // y.
      std::int64_t left = geometry::turn(a, b, p);
      if (left == 0) left = std::int64_t{b[0]} - a[0];
      if (left == 0) left = std::int64_t{b[1]} - a[1];
      if ((left > 0) == (b[1] > a[1])) inside = !inside;
    }
    return inside;
  }

  const std::vector<PolyPoint>& vertices_;
  std::span<const VertexIndex> outline_;
  std::span<const Ring> holes_;
  const PolyPoint& eye_;
  Vector3 normal_;
  std::int64_t above_ = 0;  // value of the face's plane at the eye: distance times the normal's length
};

}  // namespace

EyePlace eye_place(const PolyScene& scene, const PolyPoint& eye) {
  EyePlace place;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const PolyBody& body = scene.bodies[b];
    bool inside = false;
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
      const FaceAndEye pair(scene.vertices, body.faces[f].outline, body.faces[f].holes, eye);
      if (pair.contains()) return {EyePlace::Kind::on_face, b, f};
      inside = inside != pair.stops_ray();
    }
    if (inside && !body.sheet && place.kind == EyePlace::Kind::free) place = {EyePlace::Kind::inside, b, 0};
  }
  return place;
}

bool ray_crosses(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> outline, const PolyPoint& from) {
  return FaceAndEye(vertices, outline, {}, from).stops_ray();
}

std::optional<base::Error> eye_error(const PolyScene& scene, const PolyCamera& camera) {
  if (!camera.perspective) return std::nullopt;
  const EyePlace place = eye_place(scene, camera.eye);
  if (place.kind == EyePlace::Kind::free) return std::nullopt;
  const std::string eye = "the eye " + file_point_text(scene, camera.eye) + " is ";
  if (place.kind == EyePlace::Kind::inside)
    return base::Error{"", body_place(scene, place.body),
                       eye + "inside this solid, expected it in free space"};
  return base::Error{"", face_place(scene, place.body, place.face),
                     eye + "on this face, expected it in free space"};
}

base::Result<std::size_t> locate(const CellScene& scene, const geometry::Point& point) {
  std::vector<std::size_t> around;
  for (std::size_t c = 0; c < scene.cells.size(); ++c) {
    if (scene.cells[c].box.contains(point)) around.push_back(c);
  }
  if (around.size() == 1) return around[0];
  if (around.empty()) {
    const std::string place = "point " + text_of(point);
    for (std::size_t s = 0; s < scene.solids.size(); ++s) {
      if (scene.solids[s].contains(point))
        return base::Error{"", place, "is inside solid " + std::to_string(s)};
    }
    const bool inside = scene.outer.contains(point);
    return base::Error{"", place, inside ? "is in no cell" : "is outside the outer box"};
  }
  for (const Opening& opening : scene.openings) {
    if (opening.place.bounds().contains(point)) return std::min(opening.cells[0], opening.cells[1]);
  }
  const auto looked_into = std::find_if(around.begin(), around.end(),
                                        [&](std::size_t c) { return point[2] < scene.cells[c].box.high[2]; });
  return looked_into == around.end() ? around[0] : *looked_into;
}

}  // namespace sightline::scene
