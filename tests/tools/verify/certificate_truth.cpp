#include "tests/tools/verify/certificate_truth.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>
#include <vector>

#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/geometry/interval_set.hpp"
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
  bool between_vertices = true;
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
      for (int skipped = 0; !edge.between_vertices && skipped < 8; ++skipped) words >> word;
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
    const std::int64_t side = camera.perspective ? determinant(a, b, c) : determinant(geometry::vector_of(f), geometry::difference(alone.vertices[first + 1], alone.vertices[first]), geometry::difference(third, alone.vertices[first]));
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

std::string check_turned(const Certificate& certificate, const Edge& edge) {
  std::size_t faces = 0;
  for (const scene::PolyBody& body : certificate.scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      std::vector<const scene::Ring*> rings{&face.outline};
      for (const scene::Ring& hole : face.holes) rings.push_back(&hole);
      bool has_edge = false;
      Vector3 normal{};
      for (const scene::Ring* ring : rings) {
        for (std::size_t i = 0; i < ring->size(); ++i) {
          const scene::VertexIndex p = (*ring)[i];
          const scene::VertexIndex q = (*ring)[(i + 1) % ring->size()];
          has_edge = has_edge || (std::min(p, q) == edge.ends.from && std::max(p, q) == edge.ends.to);
          const Vector3 part = geometry::cross(geometry::vector_of(certificate.scene.vertices[p]), geometry::vector_of(certificate.scene.vertices[q]));
          for (std::size_t a = 0; a < 3; ++a) normal[a] += part[a];
        }
      }
      if (!has_edge) continue;
      ++faces;
      const auto sight = certificate.camera.perspective ? geometry::difference(certificate.scene.vertices[face.outline[0]], certificate.camera.eye)
                                                        : geometry::vector_of(certificate.camera.forward);
      if (body.sheet) return "turned edge of a sheet";
      if (!scene::is_closed(scene::face_edges(body))) return "turned edge of an open solid";
      if (geometry::dot(normal, sight) < 0) return "turned edge with a face that is turned to the eye";
    }
  }
  return faces > 0 ? "" : "turned edge without a face";
}

bool is_point(const Certificate& certificate, const Edge& edge) {
  const Vector3 a = geometry::difference(certificate.scene.vertices[edge.ends.from], certificate.camera.eye);
  const Vector3 b = geometry::difference(certificate.scene.vertices[edge.ends.to], certificate.camera.eye);
  const Vector3 along{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Vector3 across = certificate.camera.perspective ? geometry::cross(a, b) : geometry::cross(geometry::vector_of(certificate.camera.forward), along);
  return geometry::is_zero(across);
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
    std::array<IntervalSet, 2> left{IntervalSet(0, 1), IntervalSet(0, 1)};
    for (const Claim& claim : edge.claims) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (!claim.sides[side]) continue;
        left[side].subtract(claim.low, claim.high);
        if (claim.face != no_face && !hides(certificate, edge, claim, side == 0)) return name + "face " + std::to_string(claim.face) + " does not hide its interval";
      }
    }
    IntervalSet claimed = edge.reason.empty() ? left[0] : IntervalSet();
    if (edge.reason.empty())
      for (const geometry::Interval& interval : left[1].intervals()) claimed.unite(interval.low, interval.high);
    IntervalSet true_set;
    for (const picture::LinePiece& piece : seen.pieces)
      if (piece.edge == edge.ends) true_set.unite(piece.low, piece.high);
    if (!(claimed == true_set)) {
      std::string found = name + "claimed";
      for (const auto& i : claimed.intervals()) found += " " + std::to_string(i.low.to_double()) + ".." + std::to_string(i.high.to_double());
      found += ", seen by the oracle";
      for (const auto& i : true_set.intervals()) found += " " + std::to_string(i.low.to_double()) + ".." + std::to_string(i.high.to_double());
      return found;
    }
  }
  return {};
}

}  // namespace sightline::tests
