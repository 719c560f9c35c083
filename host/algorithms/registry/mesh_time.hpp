// Estimates how long an algorithm takes for a mesh, so that a command can warn before it spends minutes.
#pragma once

#include "host/scene/model/poly_scene.hpp"

namespace sightline::registry {

// The number of faces that the plane of a face cuts, averaged over 128 faces: about the square root of the number of
// faces for round bodies, about that number if long faces cross each other's planes.
[[nodiscard]] double faces_cut_by_planes(const scene::PolyScene& scene);

// The time of one view, preparation included, on a computer of 2020. `seconds` was measured with a bumpy sphere of 70,000
// faces (tests/bench/MEASURED.md). The time grows with the square of the number of faces or, if `by_planes`, with that
// number times the root of faces_cut_by_planes. `seconds` = 0: seconds for all meshes.
struct MeshTime {
  double seconds = 0;
  bool by_planes = false;

  [[nodiscard]] double seconds_for(const scene::PolyScene& scene) const;
};

}  // namespace sightline::registry
