// Finds exactly the first face that a single sight line meets: the reference for pictures of faces, pixel by pixel, and
// for the visibility of a point.
//
// A sight line meets a face where it crosses the face's plane strictly ahead of the eye, inside the outline and in no
// hole. A face along the line is not met. A line exactly through a side of a face counts as being on one side of it,
// always the same one, so that of two faces with a common side one is met. Slow and simple: all faces for every line.
//
// Sizes, with coordinates of vertices below 2^18: sides of the line and distances are below 2^63 for lines from points
// below 2^18 along directions below 2^20, and from points below 2^21 along directions below 2^15.
#pragma once

#include <cstddef>
#include <optional>

#include "host/geometry/predicates.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::oracle {

struct FaceHit {
  std::size_t body = 0;
  std::size_t face = 0;

  friend bool operator==(const FaceHit&, const FaceHit&) = default;
};

struct SightLine {
  scene::PolyPoint from{};
  geometry::Vector3 along{};  // of any length except zero
};

// The face met first; of faces met at the same point, the first in the scene's order. Precondition: the scene is checked.
[[nodiscard]] std::optional<FaceHit> nearest_face(const scene::PolyScene& scene, const SightLine& line);

// Whether the sight line meets both faces at the same point.
[[nodiscard]] bool hit_at_same_point(const scene::PolyScene& scene, const SightLine& line, const FaceHit& first, const FaceHit& second);

// Whether no face is met strictly between the eye and the point.
[[nodiscard]] bool sees(const scene::PolyScene& scene, const scene::PolyPoint& eye,
                        const scene::PolyPoint& point);

}  // namespace sightline::algorithms::oracle
