#include "host/scene/check/poly_scene.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <span>
#include <string>

#include "host/base/result.hpp"
#include "host/geometry/integer.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_shells.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/model/index_set.hpp"

namespace sightline::scene {

namespace {

using geometry::Point2;

// Where very many edges are side by side the work grows with their square: four million pairs that may meet,
// or sixteen times as many of which only the bounds are compared, are enough.
constexpr std::size_t effort_of_a_pair = 16;
constexpr std::size_t most_effort = std::size_t{1} << 26;

// The first triple of a ring's vertices that is not on a line.
struct Support {
  std::array<VertexIndex, 3> vertices{};
  geometry::Plane plane;
};

class FaceCheck {
 public:
  FaceCheck(const std::vector<PolyPoint>& vertices, const PolyFace& face, const std::string& place, Problems& problems)
      : vertices_(vertices), face_(face), place_(place), problems_(problems) {}

  bool run() {
    rings_.push_back(&face_.outline);
    for (const Ring& hole : face_.holes) rings_.push_back(&hole);
    for (std::size_t r = 0; r < rings_.size(); ++r) check_length(r);
    if (!good_) return false;
    const auto support = find_support(face_.outline);
    if (!support) {
      add("all vertices are on one line, expected an area");
      return false;
    }
    check_plane(*support);
    if (!good_) return false;
    const std::size_t axis = geometry::dominant_axis(support->plane.normal);
    for (const Ring* ring : rings_) {
      flat_.emplace_back();
      for (const VertexIndex v : *ring) flat_.back().push_back(geometry::flattened(vertices_[v], axis));
    }
    check_crossings();
    if (good_) check_nesting();
    return good_;
  }

 private:
  struct Segment {
    std::size_t ring;
    std::size_t from;  // to the next one of the ring
    Point2 low;        // its bounds
    Point2 high;
  };

  void add(std::string cause) {
    problems_.add(place_, std::move(cause));
    good_ = false;
  }

  static std::string ring_name(std::size_t ring) {
    return ring == 0 ? "the outline" : "hole " + std::to_string(ring - 1);
  }

  std::string vertex_name(VertexIndex v) const {
    return "vertex " + std::to_string(v) + " " + text_of(vertices_[v]);
  }

  std::string edge_name(const Segment& s) const {
    const Ring& ring = *rings_[s.ring];
    return std::to_string(ring[s.from]) + "-" + std::to_string(ring[(s.from + 1) % ring.size()]);
  }

  void check_length(std::size_t r) {
    const Ring& ring = *rings_[r];
    if (ring.size() < 3) {
      add(ring_name(r) + " has " + std::to_string(ring.size()) + " vertices, expected 3 or more");
      return;
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (vertices_[ring[i]] == vertices_[ring[(i + 1) % ring.size()]])
        add(ring_name(r) + " has " + vertex_name(ring[i]) + " twice in succession");
    }
  }

  [[nodiscard]] std::optional<Support> find_support(const Ring& ring) const {
    const PolyPoint& a = vertices_[ring[0]];
    const PolyPoint& b = vertices_[ring[1]];
    for (std::size_t i = 2; i < ring.size(); ++i) {
      const geometry::Plane plane = geometry::plane_through(a, b, vertices_[ring[i]]);
      if (!geometry::is_zero(plane.normal)) return Support{{ring[0], ring[1], ring[i]}, plane};
    }
    return std::nullopt;
  }

  void check_plane(const Support& support) {
    for (const Ring* ring : rings_) {
      for (const VertexIndex v : *ring) {
        if (support.plane.side(vertices_[v]) == 0) continue;
        const auto& on = support.vertices;
        add(vertex_name(v) + " is not in the plane of vertices " + std::to_string(on[0]) + ", " +
            std::to_string(on[1]) + " and " + std::to_string(on[2]));
        return;  // the others would only repeat it
      }
    }
  }

  void check_pair(const Segment& s, const Segment& t) {
    const auto& ring = flat_[s.ring];
    const Point2& a = ring[s.from];
    const Point2& b = ring[(s.from + 1) % ring.size()];
    const auto& other = flat_[t.ring];
    const Point2& c = other[t.from];
    const Point2& d = other[(t.from + 1) % other.size()];
    if (s.ring != t.ring) {
      if (geometry::segments_meet(a, b, c, d)) {
        add(ring_name(std::max(s.ring, t.ring)) + " meets " + ring_name(std::min(s.ring, t.ring)) +
            " (edges " + edge_name(s) + " and " + edge_name(t) + ")");
      }
      return;
    }
    // Of two edges in succession, one may only come back along the other.
    const bool s_first = (s.from + 1) % ring.size() == t.from;
    const bool t_first = (t.from + 1) % ring.size() == s.from;
    const bool crossing = s_first   ? geometry::on_segment(a, b, d) || geometry::on_segment(c, d, a)
                          : t_first ? geometry::on_segment(c, d, b) || geometry::on_segment(a, b, c)
                                    : geometry::segments_meet(a, b, c, d);
    if (crossing) {
      add(ring_name(s.ring) + " crosses or touches itself (edges " + edge_name(s) + " and " + edge_name(t) +
          ")");
    }
  }

  // A sweep along the first flat axis over the edges of all rings.
  void check_crossings() {
    std::vector<Segment> segments;
    for (std::size_t r = 0; r < flat_.size(); ++r) {
      for (std::size_t i = 0; i < flat_[r].size(); ++i) {
        const Point2& from = flat_[r][i];
        const Point2& to = flat_[r][(i + 1) % flat_[r].size()];
        segments.push_back({r,
                            i,
                            {std::min(from[0], to[0]), std::min(from[1], to[1])},
                            {std::max(from[0], to[0]), std::max(from[1], to[1])}});
      }
    }
    std::stable_sort(segments.begin(), segments.end(),
                     [](const Segment& s, const Segment& t) { return s.low[0] < t.low[0]; });
    std::size_t effort = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const Segment& s = segments[i];
      for (std::size_t j = i + 1; j < segments.size() && segments[j].low[0] <= s.high[0]; ++j) {
        const Segment& t = segments[j];
        const bool apart = s.high[1] < t.low[1] || t.high[1] < s.low[1];
        effort += apart ? 1 : effort_of_a_pair;
        if (effort > most_effort) return add("has too many edges side by side to be checked");
        if (apart) continue;
        if (problems_.full()) return;
        check_pair(s, t);
      }
    }
  }

  // The rings are simple and do not meet.
  void check_nesting() {
    const bool counterclockwise = geometry::doubled_area(flat_[0]) > 0;
    for (std::size_t r = 1; r < flat_.size(); ++r) {
      if (geometry::locate_in_ring(flat_[0], flat_[r][0]) < 0) add(ring_name(r) + " is outside the outline");
      if ((geometry::doubled_area(flat_[r]) > 0) == counterclockwise)
        add(ring_name(r) + " turns the same way as the outline, expected the other way");
      for (std::size_t other = 1; other < flat_.size(); ++other) {
        if (other != r && geometry::locate_in_ring(flat_[other], flat_[r][0]) > 0)
          add(ring_name(r) + " is inside " + ring_name(other));
      }
    }
  }

  const std::vector<PolyPoint>& vertices_;
  const PolyFace& face_;
  const std::string& place_;
  Problems& problems_;
  bool good_ = true;
  std::vector<const Ring*> rings_;
  std::vector<std::vector<Point2>> flat_;
};

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

// Closed, and facing outwards. The body is a solid whose faces are in order.
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

constexpr std::int32_t camera_vector_limit = 1 << 15;

bool within(const PolyPoint& p, std::int32_t limit) {
  return std::all_of(p.begin(), p.end(), [&](std::int32_t c) { return -limit < c && c < limit; });
}

std::string below(std::int32_t limit) {
  return ", expected coordinates " + std::to_string(1 - limit) + ".." + std::to_string(limit - 1);
}

bool check_coordinates(const PolyScene& scene, Problems& problems) {
  bool good = true;
  for (std::size_t v = 0; v < scene.vertices.size() && !problems.full(); ++v) {
    if (within(scene.vertices[v], poly_coordinate_limit)) continue;
    problems.add("vertex", v, "found " + text_of(scene.vertices[v]) + below(poly_coordinate_limit));
    good = false;
  }
  return good;
}

void check_camera(const PolyCamera& camera, Problems& problems) {
  if (!within(camera.eye, poly_coordinate_limit))
    problems.add("camera", "the eye is " + text_of(camera.eye) + below(poly_coordinate_limit));
  struct Direction {
    const char* name;
    const PolyPoint& vector;
  };
  const Direction directions[] = {{"forward", camera.forward}, {"right", camera.right}, {"up", camera.up}};
  for (const Direction& d : directions) {
    const auto vector = geometry::vector_of(d.vector);
    if (geometry::is_zero(vector)) problems.add("camera", std::string(d.name) + " is zero");
    if (!within(d.vector, camera_vector_limit))
      problems.add("camera", std::string(d.name) + " is " + text_of(d.vector) + below(camera_vector_limit));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Direction& a = directions[i];
    const Direction& b = directions[(i + 1) % 3];
    if (geometry::dot(geometry::vector_of(a.vector), geometry::vector_of(b.vector)) != 0)
      problems.add("camera", std::string(a.name) + " and " + b.name + " are not orthogonal");
  }
}

// Marks what is used; false for a vertex that does not exist.
bool check_references(const PolyScene& scene, std::vector<bool>& used, Problems& problems) {
  bool good = true;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const PolyBody& body = scene.bodies[b];
    if (body.faces.empty()) problems.add(body_place(scene, b), "has no faces");
    for (std::size_t f = 0; f < body.faces.size() && !problems.full(); ++f) {
      const auto mark = [&](std::span<const VertexIndex> ring) {
        for (const VertexIndex v : ring) {
          if (v < used.size()) {
            used[v] = true;
            continue;
          }
          problems.add(face_place(scene, b, f),
                       "names vertex " + std::to_string(v) + ", of " + std::to_string(used.size()));
          good = false;
        }
      };
      mark(body.faces[f].outline);
      for (const auto& hole : body.faces[f].holes) mark(hole);
    }
  }
  for (std::size_t w = 0; w < scene.wires.size() && !problems.full(); ++w) {
    for (const VertexIndex v : scene.wires[w]) {
      if (v < used.size()) {
        used[v] = true;
        continue;
      }
      problems.add("wire", w, "names vertex " + std::to_string(v) + ", of " + std::to_string(used.size()));
      good = false;
    }
    if (scene.wires[w][0] == scene.wires[w][1])
      problems.add("wire", w, "joins vertex " + std::to_string(scene.wires[w][0]) + " to itself");
  }
  return good && !problems.full();
}

}  // namespace

bool check_vertices(const PolyScene& scene, std::span<const VertexIndex> same_as, Problems& problems) {
  std::vector<bool> used(scene.vertices.size(), false);
  if (!check_references(scene, used, problems)) return false;
  for (std::size_t v = 0; v < used.size() && !problems.full(); ++v)
    if (!used[v]) problems.add("vertex", v, scene.wires.empty() ? "is not used by any face" : "is not used by any face or wire");
  for (std::size_t v = 0; v < used.size() && !problems.full(); ++v)
    if (same_as[v] != v)
      problems.add("vertex", v, "is the same point " + text_of(scene.vertices[v]) + " as vertex " + std::to_string(same_as[v]));
  return true;
}

bool check_face(const std::vector<PolyPoint>& vertices, const PolyFace& face, const std::string& place, Problems& problems) {
  return FaceCheck(vertices, face, place, problems).run();
}

bool is_plainly_in_order(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> ring) {
  if (ring.size() != 3 && ring.size() != 4) return false;
  const auto at = [&](std::size_t i) -> const PolyPoint& { return vertices[ring[i]]; };
  const geometry::Vector3 along = geometry::difference(at(1), at(0));
  const geometry::Vector3 across = geometry::difference(at(2), at(0));
  const geometry::Vector3 normal = geometry::cross(along, across);
  const std::size_t axis = geometry::dominant_axis(normal);
  if (normal[axis] == 0) return false;
  if (ring.size() == 3) return true;
  const geometry::Vector3 back = geometry::difference(at(3), at(0));
  if (geometry::dot(normal, back) != 0) return false;
  const auto turns = [&](const geometry::Vector3& a, const geometry::Vector3& b) {
    const std::int64_t turn = geometry::cross(a, b)[axis];
    return normal[axis] > 0 ? turn > 0 : turn < 0;
  };
  return turns(across, back) && turns(along, back) && turns(geometry::difference(at(2), at(1)), geometry::difference(at(3), at(2)));
}

bool is_simple_face(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> ring) {
  if (ring.size() == 3) return true;
  Problems problems;
  return check_face(vertices, {{ring.begin(), ring.end()}, {}}, "", problems);
}

std::vector<base::Error> check_poly_scene(const PolyScene& scene) {
  Problems problems;
  if (scene.bodies.empty() && scene.wires.empty()) problems.add("bodies", "expected at least one body, found none");
  check_camera(scene.camera, problems);
  const bool within_limits = check_coordinates(scene, problems);
  if (!check_vertices(scene, equal_points(scene.vertices), problems)) return problems.take();
  for (std::size_t b = 0; b < scene.bodies.size() && within_limits; ++b) {
    bool good = !scene.bodies[b].faces.empty();
    for (std::size_t f = 0; f < scene.bodies[b].faces.size() && !problems.full(); ++f) {
      const PolyFace& face = scene.bodies[b].faces[f];
      if (face.holes.empty() && is_plainly_in_order(scene.vertices, face.outline)) continue;
      good = check_face(scene.vertices, face, face_place(scene, b, f), problems) && good;
    }
    if (good && !scene.bodies[b].sheet && !problems.full()) check_poly_solid(scene, b, problems);
  }
  return problems.take();
}

}  // namespace sightline::scene
