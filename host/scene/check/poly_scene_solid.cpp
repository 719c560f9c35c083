// Closed solids that face outwards. See poly_scene.hpp.
#include <algorithm>
#include <string>

#include "host/geometry/integer.hpp"
#include "host/scene/check/poly_scene_parts.hpp"
#include "host/scene/check/poly_shells.hpp"

namespace sightline::scene {
namespace {

// A connected part of a solid's surface.
struct Shell {
  geometry::Int128 volume = 0;  // six times
  PolyPoint low{};
  PolyPoint high{};
  std::size_t first_face = 0;
};

void add_face(const PolyScene& scene, const PolyFace& face, Shell& shell) {
  shell.volume += enclosed_volume(scene.vertices, face);
  for (const VertexIndex v : face.outline) {
    for (std::size_t a = 0; a < 3; ++a) {
      shell.low[a] = std::min(shell.low[a], scene.vertices[v][a]);
      shell.high[a] = std::max(shell.high[a], scene.vertices[v][a]);
    }
  }
}

std::vector<Shell> shells_of(const PolyScene& scene, const PolyBody& body,
                             const std::vector<FaceEdge>& edges) {
  const std::vector<std::size_t> shell_of = connected_faces(body, edges);
  std::vector<Shell> shells;
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    const PolyPoint& start = scene.vertices[body.faces[f].outline[0]];
    if (shell_of[f] == shells.size()) shells.push_back({0, start, start, f});
    add_face(scene, body.faces[f], shells[shell_of[f]]);
  }
  return shells;
}

bool inside(const Shell& inner, const Shell& outer) {
  bool result = true;
  for (std::size_t a = 0; a < 3; ++a)
    result = result && outer.low[a] < inner.low[a] && inner.high[a] < outer.high[a];
  return result;
}

bool check_closed(const PolyScene& scene, std::size_t body, const std::vector<FaceEdge>& edges,
                  Problems& problems) {
  bool good = true;
  for (std::size_t i = 0; i < edges.size() && !problems.full();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].same_edge(edges[i])) ++end;
    const std::string name = "edge " + std::to_string(edges[i].low) + "-" + std::to_string(edges[i].high);
    const std::string place = face_place(scene, body, edges[i].face);
    if (end - i != 2) {
      problems.add(place, name + " belongs to " + std::to_string(end - i) +
                              (end - i == 1 ? " face" : " faces") + " of the solid, expected 2");
      good = false;
    } else if (edges[i].upwards == edges[i + 1].upwards) {
      problems.add(place, name + " is passed in the same direction by face " +
                              std::to_string(edges[i + 1].face) + ", expected opposite directions");
      good = false;
    }
    i = end;
  }
  return good;
}

}  // namespace

void check_poly_solid(const PolyScene& scene, std::size_t body, Problems& problems) {
  const std::vector<FaceEdge> edges = face_edges(scene.bodies[body]);
  if (!check_closed(scene, body, edges, problems)) return;
  const std::vector<Shell> shells = shells_of(scene, scene.bodies[body], edges);
  for (const Shell& shell : shells) {
    const std::string place = face_place(scene, body, shell.first_face);
    if (shell.volume == 0) {
      problems.add(place, "is part of a surface that encloses nothing");
    } else if (shell.volume < 0 && std::none_of(shells.begin(), shells.end(), [&](const Shell& outer) {
                 return outer.volume > 0 && inside(shell, outer);
               })) {
      problems.add(place,
                   "is part of a surface turned inside out, expected outlines counterclockwise from outside");
    }
  }
}

}  // namespace sightline::scene
