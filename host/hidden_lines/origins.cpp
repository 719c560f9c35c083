// See origins.hpp.
#include "host/hidden_lines/origins.hpp"

#include <algorithm>
#include <array>

#include "host/scene/model/face_cut.hpp"
#include "host/scene/model/file_units.hpp"

namespace sightline::hidden_lines {
namespace {

// It is not on the grid.
std::array<double, 3> end_of_crossing(scene::VertexIndex vertex, const scene::PolyScene& scene) {
  std::array<double, 3> place = scene::place_of(scene, vertex);
  for (std::size_t a = 0; a < 3; ++a) place[a] = (place[a] + static_cast<double>(scene.origin[a])) * scene.step;
  return place;
}

}  // namespace

std::size_t Origins::body_of(const picture::LineEdge& edge, const scene::PolyScene& scene) const {
  if (const scene::PolyCrossing* const crossing = scene::crossing_at(scene, edge.from)) return body_of_face(crossing->face_a);
  const auto uses = edges_.uses(edges_.find(edge.from, edge.to));
  return uses.empty() ? scene.bodies.size() : body_of_face(uses.front().face);
}

DrawnEdge Origins::drawn_edge(const picture::LineEdge& edge, const scene::PolyScene& scene, std::vector<std::uint32_t>& all) const {
  DrawnEdge drawn;
  drawn.edge = edge;
  const std::size_t body = body_of(edge, scene);
  if (body < scene.bodies.size()) drawn.body = static_cast<std::uint32_t>(body);
  drawn.first_face = static_cast<std::uint32_t>(all.size());
  if (const scene::PolyCrossing* const crossing = scene::crossing_at(scene, edge.from)) {
    drawn.ends = {end_of_crossing(edge.from, scene), end_of_crossing(edge.to, scene)};
    for (const std::uint32_t face : {crossing->face_a, crossing->face_b}) all.push_back(scene::face_in_file(scene, face));
  } else {
    for (std::size_t e = 0; e < 2; ++e) {
      const scene::VertexIndex vertex = e == 0 ? edge.from : edge.to;
      drawn.ends[e] = scene::file_point(scene, scene.vertices[vertex]);
      drawn.vertices[e] = vertex < scene.vertex_in_file.size() ? scene.vertex_in_file[vertex] : vertex;
    }
    for (const scene::EdgeTable::Use& use : edges_.uses(edges_.find(edge.from, edge.to))) all.push_back(scene::face_in_file(scene, use.face));
  }
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(drawn.first_face);
  std::sort(first, all.end());
  all.erase(std::unique(first, all.end()), all.end());
  drawn.face_count = static_cast<std::uint32_t>(all.size()) - drawn.first_face;
  return drawn;
}

std::size_t Origins::body_of_face(std::uint32_t face) const {
  return static_cast<std::size_t>(std::upper_bound(firsts_.begin(), firsts_.end(), face + 1) - firsts_.begin()) - 1;
}

}  // namespace sightline::hidden_lines
