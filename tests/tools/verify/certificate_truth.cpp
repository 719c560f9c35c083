#include "tests/tools/verify/certificate_truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <vector>

#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/geometry/interval_set.hpp"
#include "host/geometry/wide_integer.hpp"
#include "host/scene/check/poly_shells.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::tests {
namespace {

using geometry::IntervalSet;
using geometry::Rational;
using geometry::Vector3;
using scene::PolyPoint;

constexpr std::uint32_t no_face = ~0U;

struct Claim {
  std::array<bool, 2> sides{};  // left, right
  Rational low;
  Rational high;
  std::uint32_t face = no_face;  // behind the eye
};

struct Edge {
  picture::LineEdge ends;
  bool between_vertices = true;  // otherwise the ends are faces
  std::array<std::array<std::string, 4>, 2> points;  // of an intersection
  std::vector<std::uint32_t> surfaces;
  std::string reason;  // "turned" or "point"
  std::vector<Claim> claims;
};

struct Certificate {
  scene::PolyScene scene;
  scene::PolyCamera camera;
  std::vector<Edge> edges;
};

Rational rational(const std::string& text) {
  const std::size_t bar = text.find('/');
  return {std::stoll(text.substr(0, bar)), std::stoll(text.substr(bar + 1))};
}

Certificate read(std::string_view text) {
  Certificate result;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    const auto point = [&words] {
      PolyPoint p{};
      words >> p[0] >> p[1] >> p[2];
      return p;
    };
    if (word == "view") {
      words >> word;
      result.camera.perspective = word == "perspective";
    } else if (word == "eye") {
      result.camera.eye = point();
    } else if (word == "forward") {
      result.camera.forward = point();
    } else if (word == "rightward") {
      result.camera.right = point();
    } else if (word == "upward") {
      result.camera.up = point();
    } else if (word == "vertex") {
      result.scene.vertices.push_back(point());
    } else if (word == "solid" || word == "sheet") {
      result.scene.bodies.push_back({"", word == "sheet", {}});
    } else if (word == "face") {
      std::uint32_t surface = 0;
      words >> surface;
      result.scene.surface_of.push_back(surface);
      scene::PolyFace face;
      scene::Ring* ring = &face.outline;
      while (words >> word) {
        if (word == "/") ring = &face.holes.emplace_back();
        else ring->push_back(static_cast<scene::VertexIndex>(std::stoul(word)));
      }
      result.scene.bodies.back().faces.push_back(face);
    } else if (word == "edge" || word == "wire" || word == "intersection") {
      Edge edge;
      words >> edge.ends.from >> edge.ends.to;
      edge.between_vertices = word != "intersection";
      if (word == "wire") result.scene.wires.push_back({edge.ends.from, edge.ends.to});
      if (!edge.between_vertices)
        for (auto& p : edge.points)
          for (std::string& digits : p) words >> digits;
      words >> word;  // "on"
      for (std::uint32_t surface = 0; words >> surface;) edge.surfaces.push_back(surface);
      result.edges.push_back(edge);
    } else if (word == "turned" || word == "point") {
      result.edges.back().reason = word;
    } else if (word == "left" || word == "right" || word == "both") {
      std::string low;
      std::string high;
      words >> low >> high;
      Claim claim{{word != "right", word != "left"}, rational(low), rational(high)};
      std::string face;
      words >> face;
      if (face != "behind") claim.face = static_cast<std::uint32_t>(std::stoul(face));
      result.edges.back().claims.push_back(claim);
    }
  }
  return result;
}

std::int64_t determinant(const Vector3& a, const Vector3& b, const Vector3& c) { return geometry::dot(geometry::cross(a, b), c); }

// The oracle's answer for a scene of one wire, the first two vertices.
IntervalSet seen_of_wire(scene::PolyScene scene, const scene::PolyCamera& camera) {
  scene.wires = {{0, 1}};
  IntervalSet seen;
  for (const picture::LinePiece& piece : algorithms::oracle::visible_edges(scene, camera).pieces)
    if (piece.edge == picture::LineEdge{0, 1}) seen.unite(piece.low, piece.high);
  return seen;
}

const scene::PolyFace& face_of(const scene::PolyScene& scene, std::uint32_t number) {
  std::size_t body = 0;
  while (number >= scene.bodies[body].faces.size()) number -= static_cast<std::uint32_t>(scene.bodies[body++].faces.size());
  return scene.bodies[body].faces[number];
}

// Everything is doubled about the eye, so that a side of the covering triangle is exactly halfway between the eye and the edge.
bool hides(const Certificate& certificate, const Edge& edge, const Claim& claim, bool left) {
  scene::PolyCamera camera = certificate.camera;
  camera.eye = {};
  scene::PolyScene alone;
  const auto doubled = [&](scene::VertexIndex v) {
    const Vector3 d = geometry::difference(certificate.scene.vertices[v], certificate.camera.eye);
    return PolyPoint{static_cast<std::int32_t>(2 * d[0]), static_cast<std::int32_t>(2 * d[1]), static_cast<std::int32_t>(2 * d[2])};
  };
  alone.vertices = {doubled(edge.ends.from), doubled(edge.ends.to)};
  scene::PolyFace face = face_of(certificate.scene, claim.face);
  const auto renumber = [&](scene::Ring& ring) {
    for (scene::VertexIndex& v : ring) {
      alone.vertices.push_back(doubled(v));
      v = static_cast<scene::VertexIndex>(alone.vertices.size() - 1);
    }
  };
  renumber(face.outline);
  for (scene::Ring& hole : face.holes) renumber(hole);
  const auto first = static_cast<scene::VertexIndex>(alone.vertices.size());
  const PolyPoint& f = camera.forward;
  for (std::size_t end = 0; end < 2; ++end) {
    PolyPoint p = alone.vertices[end];
    for (std::size_t a = 0; a < 3; ++a) p[a] = camera.perspective ? p[a] / 2 : p[a] - f[a];
    alone.vertices.push_back(p);
  }
  const Vector3 a = geometry::vector_of(alone.vertices[first]);
  const Vector3 b = geometry::vector_of(alone.vertices[first + 1]);
  for (std::size_t axis = 0; axis < 6; ++axis) {
    PolyPoint third = alone.vertices[first];
    third[axis % 3] += axis < 3 ? 10 : -10;
    const Vector3 c = geometry::vector_of(third);
    const auto from_a = [&a](const Vector3& p) { return Vector3{p[0] - a[0], p[1] - a[1], p[2] - a[2]}; };
    const std::int64_t side =
        camera.perspective ? determinant(a, b, c) : determinant(geometry::vector_of(f), from_a(b), from_a(c));
    if (left ? side >= 0 : side <= 0) continue;
    alone.vertices.push_back(third);
    break;
  }
  if (alone.vertices.size() != first + 3) return false;
  alone.bodies = {{"", true, {face}}, {"", true, {{{first, first + 1, first + 2}, {}}}}};
  IntervalSet seen = seen_of_wire(alone, camera);
  seen.intersect(claim.low, claim.high);
  return seen.empty();
}

// The area of a face as a vector, twice.
Vector3 area_of(const scene::PolyScene& scene, const scene::PolyFace& face) {
  Vector3 area{};
  std::vector<scene::Ring> rings{face.outline};
  rings.insert(rings.end(), face.holes.begin(), face.holes.end());
  for (const scene::Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto part = geometry::cross(geometry::vector_of(scene.vertices[ring[i]]),
                                        geometry::vector_of(scene.vertices[ring[(i + 1) % ring.size()]]));
      for (std::size_t a = 0; a < 3; ++a) area[a] += part[a];
    }
  }
  return area;
}

// Whether the sum of a surface's faces is turned to the eye, seen from the first corner of its largest face.
bool is_turned_to_eye(const Certificate& certificate, std::uint32_t surface) {
  const scene::PolyScene& scene = certificate.scene;
  Vector3 sum{};
  geometry::Int128 largest = 0;
  scene::VertexIndex on = 0;
  std::size_t number = 0;
  for (const scene::PolyBody& body : scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      if (scene.surface_of[number++] != surface) continue;
      const Vector3 area = area_of(scene, face);
      geometry::Int128 size = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        sum[a] += area[a];
        size += geometry::Int128{area[a]} * area[a];
      }
      if (size > largest) {
        largest = size;
        on = face.outline[0];
      }
    }
  }
  const auto sight = certificate.camera.perspective ? geometry::difference(scene.vertices[on], certificate.camera.eye)
                                                    : geometry::vector_of(certificate.camera.forward);
  return geometry::dot(sum, sight) < 0;
}

std::string check_turned(const Certificate& certificate, const Edge& edge) {
  std::size_t faces = 0;
  std::size_t number = 0;
  for (const scene::PolyBody& body : certificate.scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      const std::uint32_t surface = certificate.scene.surface_of[number++];
      std::vector<scene::Ring> rings{face.outline};
      rings.insert(rings.end(), face.holes.begin(), face.holes.end());
      bool has_edge = false;
      for (const scene::Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto [low, high] = std::minmax(ring[i], ring[(i + 1) % ring.size()]);
          has_edge = has_edge || (low == edge.ends.from && high == edge.ends.to);
        }
      }
      if (!has_edge) continue;
      ++faces;
      if (body.sheet) return "turned edge of a sheet";
      if (!scene::is_closed(scene::face_edges(body))) return "turned edge of an open solid";
      if (is_turned_to_eye(certificate, surface)) return "turned edge with a face that is turned to the eye";
    }
  }
  return faces > 0 ? "" : "turned edge without a face";
}

bool is_point(const Certificate& certificate, const Edge& edge) {
  const Vector3 a = geometry::difference(certificate.scene.vertices[edge.ends.from], certificate.camera.eye);
  const Vector3 b = geometry::difference(certificate.scene.vertices[edge.ends.to], certificate.camera.eye);
  const Vector3 along{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Vector3 across = certificate.camera.perspective ? geometry::cross(a, b)
                                                        : geometry::cross(geometry::vector_of(certificate.camera.forward), along);
  return geometry::is_zero(across);
}

using geometry::Int128;

Int128 whole(const std::string& digits) {
  Int128 value = 0;
  for (const char digit : digits)
    if (digit != '-') value = 10 * value + (digit - '0');
  return digits.starts_with('-') ? -value : value;
}

// The end of an intersection as the point where a side of one of its faces meets the plane of the other one.
std::optional<scene::CutPoint> cut_point(const scene::PolyScene& scene, const Edge& edge, const std::array<std::string, 4>& end) {
  using Wide = geometry::WideInteger<125>;
  for (const auto& [f, g] : {std::pair{edge.ends.from, edge.ends.to}, {edge.ends.to, edge.ends.from}}) {
    const scene::PolyFace& face = face_of(scene, f);
    const scene::PolyFace& other = face_of(scene, g);
    const Vector3 normal = area_of(scene, other);
    const std::int64_t offset = geometry::dot(normal, geometry::vector_of(scene.vertices[other.outline[0]]));
    std::vector<scene::Ring> rings{face.outline};
    rings.insert(rings.end(), face.holes.begin(), face.holes.end());
    for (const scene::Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        scene::CutPoint cut{ring[i], ring[(i + 1) % ring.size()], 0, 0};
        cut.a = geometry::dot(normal, geometry::vector_of(scene.vertices[cut.p])) - offset;
        cut.b = geometry::dot(normal, geometry::vector_of(scene.vertices[cut.q])) - offset;
        if (cut.a == cut.b) continue;
        bool same = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Int128 at = Int128{scene.vertices[cut.q][axis]} * cut.a - Int128{scene.vertices[cut.p][axis]} * cut.b;
          same = same && (Wide(at) * Wide(whole(end[3])) - Wide(whole(end[axis])) * Wide(Int128{cut.a} - cut.b)).sign() == 0;
        }
        if (same) return cut;
      }
    }
  }
  return std::nullopt;
}

// What an edge's claims leave over.
IntervalSet claimed_of(const Edge& edge) {
  if (!edge.reason.empty()) return {};
  std::array<IntervalSet, 2> left{IntervalSet(0, 1), IntervalSet(0, 1)};
  for (const Claim& claim : edge.claims)
    for (std::size_t side = 0; side < 2; ++side)
      if (claim.sides[side]) left[side].subtract(claim.low, claim.high);
  for (const geometry::Interval& interval : left[1].intervals()) left[0].unite(interval.low, interval.high);
  return left[0];
}

IntervalSet pieces_of(const picture::LinePicture& seen, const picture::LineEdge& edge) {
  IntervalSet pieces;
  for (const picture::LinePiece& piece : seen.pieces)
    if (piece.edge == edge) pieces.unite(piece.low, piece.high);
  return pieces;
}

// Intervals shorter than the tolerance do not count.
bool equal_up_to_rounding(const IntervalSet& one, const IntervalSet& other) {
  constexpr double tolerance = 1e-15;
  const auto long_ones = [](const IntervalSet& set) {
    std::vector<std::array<double, 2>> result;
    for (const geometry::Interval& i : set.intervals()) {
      const double low = i.low.to_double();
      const double high = i.high.to_double();
      if (!result.empty() && low - result.back()[1] < 4 * tolerance) result.back()[1] = high;
      else if (high - low > 4 * tolerance) result.push_back({low, high});
    }
    return result;
  };
  const auto a = long_ones(one);
  const auto b = long_ones(other);
  bool equal = a.size() == b.size();
  for (std::size_t i = 0; equal && i < a.size(); ++i)
    for (std::size_t end = 0; end < 2; ++end) equal = equal && std::abs(a[i][end] - b[i][end]) <= tolerance;
  return equal;
}

// The oracle sees intersections as lines of the scene. One that does not end at sides of its faces is not judged.
std::string check_intersections(const Certificate& certificate) {
  scene::PolyScene scene = certificate.scene;
  picture::ChosenEdges chosen;
  std::vector<const Edge*> edges;
  for (const Edge& edge : certificate.edges) {
    if (edge.between_vertices || edge.reason == "turned") continue;
    const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
    scene::PolyCrossing crossing{first, first + 1, edge.ends.from, edge.ends.to};
    const std::array cuts{cut_point(certificate.scene, edge, edge.points[0]), cut_point(certificate.scene, edge, edge.points[1])};
    if (!cuts[0] || !cuts[1]) continue;
    crossing.ends = {*cuts[0], *cuts[1]};
    scene.vertices.insert(scene.vertices.end(), 2, {});
    scene.crossings.push_back(crossing);
    chosen.edges.push_back({crossing.from, crossing.to});
    chosen.kinds.push_back(picture::EdgeKind::intersection);
    chosen.turned_away.push_back(0);
    chosen.surfaces.insert(chosen.surfaces.end(), edge.surfaces.begin(), edge.surfaces.end());
    chosen.first_surface.push_back(static_cast<std::uint32_t>(chosen.surfaces.size()));
    edges.push_back(&edge);
  }
  const picture::LinePicture seen = algorithms::oracle::visible_edges(scene, certificate.camera, chosen);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (!equal_up_to_rounding(claimed_of(*edges[e]), pieces_of(seen, chosen.edges[e])))
      return "the visible intervals of an intersection are not those of the oracle";
  return {};
}

}  // namespace

std::string falsehood_in(std::string_view text) {
  const Certificate certificate = read(text);
  picture::ChosenEdges chosen;
  for (const Edge& edge : certificate.edges) {
    if (!edge.between_vertices) continue;
    chosen.edges.push_back(edge.ends);
    chosen.kinds.push_back(picture::EdgeKind::crease);
    chosen.turned_away.push_back(0);
    chosen.surfaces.insert(chosen.surfaces.end(), edge.surfaces.begin(), edge.surfaces.end());
    chosen.first_surface.push_back(static_cast<std::uint32_t>(chosen.surfaces.size()));
  }
  const picture::LinePicture seen = algorithms::oracle::visible_edges(certificate.scene, certificate.camera, chosen);
  for (const Edge& edge : certificate.edges) {
    if (!edge.between_vertices) continue;
    const std::string name = "edge " + std::to_string(edge.ends.from) + " " + std::to_string(edge.ends.to) + ": ";
    if (edge.reason == "turned") {
      if (const std::string wrong = check_turned(certificate, edge); !wrong.empty()) return name + wrong;
      continue;
    }
    if ((edge.reason == "point") != is_point(certificate, edge)) return name + "a point, or not";
    for (const Claim& claim : edge.claims)
      for (std::size_t side = 0; side < 2; ++side)
        if (claim.sides[side] && claim.face != no_face && !hides(certificate, edge, claim, side == 0))
          return name + "face " + std::to_string(claim.face) + " does not hide its interval";
    if (!(claimed_of(edge) == pieces_of(seen, edge.ends))) return name + "the visible intervals are not those of the oracle";
  }
  return check_intersections(certificate);
}

}  // namespace sightline::tests
