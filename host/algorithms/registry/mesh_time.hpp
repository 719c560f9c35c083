// How long an algorithm takes for a mesh: what a user is told before minutes are spent.
#pragma once

#include "host/scene/model/poly_scene.hpp"

namespace sightline::registry {

// How many faces the plane of a face cuts, on average over 128 of them: of the order of the root of their number for round
// bodies, of their number itself where long faces cross each other's planes.
[[nodiscard]] double faces_cut_by_planes(const scene::PolyScene& scene);

// Of one view on a computer of 2020, preparation included, measured with a bumpy sphere of 70,000 faces
// (tests/bench/MEASURED.md): `seconds`, and in proportion to the square of the number of faces, or, by planes, to the
// number of faces times the root of faces_cut_by_planes. 0: seconds for all meshes.
struct MeshTime {
  double seconds = 0;
  bool by_planes = false;

  [[nodiscard]] double seconds_for(const scene::PolyScene& scene) const;
};

}  // namespace sightline::registry
