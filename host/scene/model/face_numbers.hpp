// The faces of a scene numbered over all its bodies, from 1, as pictures of faces have them: 0 is no face.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

[[nodiscard]] inline std::size_t face_count(const PolyScene& scene) {
  std::size_t faces = 0;
  for (const PolyBody& body : scene.bodies) faces += body.faces.size();
  return faces;
}

// The number of each body's first face; the others follow in the body's order.
[[nodiscard]] inline std::vector<std::uint32_t> first_face_numbers(const PolyScene& scene) {
  std::vector<std::uint32_t> firsts;
  std::uint32_t next = 1;
  for (const PolyBody& body : scene.bodies) {
    firsts.push_back(next);
    next += static_cast<std::uint32_t>(body.faces.size());
  }
  return firsts;
}

}  // namespace sightline::scene
