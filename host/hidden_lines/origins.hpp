// Where the edges of a scene come from: their bodies, and their faces and vertices in the numbers of the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/hidden_lines/hidden_lines.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/edge_table.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::hidden_lines {

// Of one scene; and of the same scene with more crossings, which is then given.
class Origins {
 public:
  explicit Origins(const scene::PolyScene& scene) : firsts_(scene::first_face_numbers(scene)), edges_(scene) {}

  // The body of an edge. For an edge of several bodies, and for a line in which two bodies cross, it is the first of them;
  // for a wire it is the number of bodies.
  [[nodiscard]] std::size_t body_of(const picture::LineEdge& edge, const scene::PolyScene& scene) const;
  // Adds the faces at the edge to `all`.
  [[nodiscard]] DrawnEdge drawn_edge(const picture::LineEdge& edge, const scene::PolyScene& scene, std::vector<std::uint32_t>& all) const;

 private:
  [[nodiscard]] std::size_t body_of_face(std::uint32_t face) const;

  std::vector<std::uint32_t> firsts_;  // number of each body's first face
  scene::EdgeTable edges_;
};

}  // namespace sightline::hidden_lines
