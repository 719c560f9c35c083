// Faces given by hand, seen along +z in orthographic projection: X to the right, Y up, smaller Z is nearer.
#pragma once

#include <vector>

#include "host/algorithms/montani_re/visible_regions.hpp"

namespace sightline::algorithms::montani_re {

using PlaneFace = std::vector<std::vector<Vertex>>;  // outline, holes

inline FaceSet face_set(const std::vector<PlaneFace>& faces) {
  FaceSetBuilder builder(false);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    Rings rings;
    for (const auto& ring : faces[f]) {
      auto& numbers = rings.emplace_back();
      for (const Vertex& v : ring) numbers.push_back(builder.add_vertex(v));
    }
    builder.add_face(rings, f, 0);
  }
  return builder.take();
}

inline std::vector<double> areas_of(const FaceSet& set, const VisibleRegions& seen) {
  std::vector<double> areas;
  for (const TrapezoidPcs& region : seen.regions) areas.push_back(area(set.image, region));
  return areas;
}

// A rectangle in the plane z.
inline PlaneFace rectangle(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1,
                           std::int64_t z) {
  return {{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}};
}

}  // namespace sightline::algorithms::montani_re
