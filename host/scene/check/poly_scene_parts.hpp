// The parts of check_poly_scene.
#pragma once

#include <cstddef>
#include <string>

#include "host/scene/model/poly_scene.hpp"
#include "host/scene/check/problems.hpp"

namespace sightline::scene {

[[nodiscard]] inline std::string body_place(const PolyScene& scene, std::size_t body) {
  const std::string& name = scene.bodies[body].name;
  return "body " + std::to_string(body) + (name.empty() ? "" : " \"" + name + "\"");
}

[[nodiscard]] inline std::string face_place(const PolyScene& scene, std::size_t body, std::size_t face) {
  return body_place(scene, body) + ", face " + std::to_string(face);
}

// One face's rings. Its vertices exist and are within the limit. False if anything was found.
bool check_poly_face(const PolyScene& scene, std::size_t body, std::size_t face, Problems& problems);

// Closed, and facing outwards. The body is a solid whose faces are in order.
void check_poly_solid(const PolyScene& scene, std::size_t body, Problems& problems);

}  // namespace sightline::scene
