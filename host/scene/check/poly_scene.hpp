// Checks that a PolyScene is valid. Every test is exact, on integers.
//
// Checked: there is a face or a wire; coordinates and the eye are below poly_coordinate_limit; the camera's vectors are
// orthogonal, not zero and below 2^15; no two vertices are equal, each is used; the ends of a wire differ; every outline and hole is a
// simple ring of three or more vertices with an area, touching itself nowhere, in one plane; holes lie inside
// their outline, turn the other way, and touch neither it nor each other; a solid's edges belong to two of
// its faces that pass them in opposite directions; its shells enclose a volume and face outwards, or inwards
// if they lie in another one. Not checked: whether bodies or faces cross each other in space, and whether the
// eye is inside a solid.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/check/cell_scene.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// Everything that is wrong (at most most_scene_errors), named by body, face and vertex from 0; empty if
// nothing is. Faces are checked when their vertices exist and are within the limit, solids when their faces
// are in order.
[[nodiscard]] std::vector<base::Error> check_poly_scene(const PolyScene& scene);

// Two parts of this check. Finds indices without a vertex, vertices that no face or wire has, and those that are the same point as an
// earlier one, `same_as` of them (the vertex itself if there is none). False: there is an index without a vertex, or no more is added.
bool check_vertices(const PolyScene& scene, std::span<const VertexIndex> same_as, Problems& problems);
// The rings of one face, whose vertices exist and are within the limit. False if anything was found.
bool check_face(const std::vector<PolyPoint>& vertices, const PolyFace& face, const std::string& place, Problems& problems);

// Whether a ring of three or more vertices, all in one plane and not on a line, is simple and touches itself
// nowhere; false, too, for one with too many edges side by side to be checked.
[[nodiscard]] bool is_simple_face(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> ring);

// Whether a ring is a triangle with an area, or four vertices in one plane that turn the same way at each of them: simple. Most faces
// are, and this is faster than is_simple_face; false says nothing.
[[nodiscard]] bool is_plainly_in_order(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> ring);

// How errors name things.
[[nodiscard]] inline std::string body_place(const PolyScene& scene, std::size_t body) {
  const std::string& name = scene.bodies[body].name;
  return "body " + std::to_string(body) + (name.empty() ? "" : " \"" + name + "\"");
}

[[nodiscard]] inline std::string face_place(const PolyScene& scene, std::size_t body, std::size_t face) {
  return body_place(scene, body) + ", face " + std::to_string(face);
}

}  // namespace sightline::scene
