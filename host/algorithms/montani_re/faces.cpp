#include "host/algorithms/montani_re/faces.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "host/algorithms/montani_re/edges_behind_sheets.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/poly_triangulate.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Int128;

ImageNumber number(std::int64_t numerator, std::int64_t denominator) {
  return {numerator, denominator, static_cast<double>(numerator) / static_cast<double>(denominator)};
}

std::array<Int128, 3> normal_of(const Image& image, const Rings& rings) {
  std::array<Int128, 3> normal{};
  const Vertex& about = image.vertices()[rings[0][0]];
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex& v = image.vertices()[ring[i]];
      const Vertex& w = image.vertices()[ring[i + 1 == ring.size() ? 0 : i + 1]];
      const std::array<Int128, 3> p{v.x - about.x, v.y - about.y, v.z - about.z};
      const std::array<Int128, 3> q{w.x - about.x, w.y - about.y, w.z - about.z};
      for (std::size_t k = 0; k < 3; ++k)
        normal[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
    }
  }
  return normal;
}

// Positive if the outer side of a face is turned from the eye, 0 if the face is edge-on.
std::int64_t turned_away(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                         const scene::PolyFace& face) {
  const geometry::Vector3 normal = scene::ring_normal(scene.vertices, face.outline);
  const geometry::Vector3 sight = camera.perspective
                                      ? geometry::difference(scene.vertices[face.outline[0]], camera.eye)
                                      : geometry::vector_of(camera.forward);
  return geometry::dot(normal, sight);
}

enum class Place { before, behind, across };

Place place_of(const scene::PolyScene& scene, const scene::PolyCamera& camera, const scene::PolyFace& face) {
  if (!camera.perspective) return Place::before;
  std::size_t behind = 0;
  for (const scene::VertexIndex v : face.outline) {
    const geometry::Vector3 d = geometry::difference(scene.vertices[v], camera.eye);
    if (geometry::dot(geometry::vector_of(camera.forward), d) <= 0) ++behind;
  }
  return behind == 0 ? Place::before : behind == face.outline.size() ? Place::behind : Place::across;
}

std::string name_of(std::size_t body, std::size_t face) {
  return "face " + std::to_string(face) + " of body " + std::to_string(body);
}

std::string reaches_behind(std::size_t body, std::size_t face) {
  return name_of(body, face) +
         " reaches from before the eye to behind it: its image has no end, which stripes cannot hold";
}

}  // namespace

int compare(const ImageNumber& a, const ImageNumber& b) {
  if (a.approximate != b.approximate) return a.approximate < b.approximate ? -1 : 1;
  const Int128 left = Int128{a.numerator} * b.denominator;
  const Int128 right = Int128{b.numerator} * a.denominator;
  return (left > right ? 1 : 0) - (left < right ? 1 : 0);
}

std::uint32_t FaceSetBuilder::line_between(std::uint32_t v, std::uint32_t w) {
  if (!set_.image.distinct_images(v, w)) return none;
  const std::uint32_t from = std::min(v, w);
  const std::uint32_t to = std::max(v, w);
  if (lines_at_.size() <= from) lines_at_.resize(from + std::size_t{1});
  for (const KnownLine& known : lines_at_[from]) {
    if (known.to == to) return known.line;
  }
  const std::uint32_t line = set_.image.add_line(from, to);
  lines_at_[from].push_back({to, line});
  set_.edges.push_back({from, to});
  return line;
}

void FaceSetBuilder::measure(Face& face) const {
  bool first = true;
  for (const std::uint32_t v : face.vertices) {
    const Vertex& p = set_.image.vertices()[v];
    const std::array<ImageNumber, 2> at{number(p.x, set_.image.weight(v)), number(p.y, set_.image.weight(v))};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (first || compare(at[axis], face.low[axis]) < 0) face.low[axis] = at[axis];
      if (first || compare(at[axis], face.high[axis]) > 0) face.high[axis] = at[axis];
    }
    face.nearest = first ? p.z : std::min(face.nearest, p.z);
    face.farthest = first ? p.z : std::max(face.farthest, p.z);
    first = false;
  }
}

bool FaceSetBuilder::add_face(const Rings& rings, std::uint32_t body, std::uint32_t index) {
  Face face;
  face.body = body;
  face.index = index;
  face.normal = normal_of(set_.image, rings);
  const Vertex& p = set_.image.vertices()[rings[0][0]];
  face.offset = face.normal[0] * p.x + face.normal[1] * p.y + face.normal[2] * p.z;
  // The eye is at the origin in perspective, at z = -infinity else.
  const Int128 turned = set_.image.perspective() ? face.offset : face.normal[2];
  if (turned == 0) {
    ++set_.edge_on;
    return false;
  }
  if (turned < 0) {
    for (Int128& part : face.normal) part = -part;
    face.offset = -face.offset;
  }
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t next = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (ring[i] == next) continue;
      face.vertices.push_back(ring[i]);
      const std::uint32_t line = line_between(ring[i], next);
      if (line != none) face.lines.push_back(line);
    }
  }
  measure(face);
  face.pcs = trapezoid_pcs(set_.image, face.lines);
  set_.faces.push_back(std::move(face));
  return true;
}

FaceSet FaceSetBuilder::take() {
  return std::move(set_);
}

std::optional<std::string> why_not_view(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const scene::PolyBody& body = scene.bodies[b];
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
      const std::int64_t turned = turned_away(scene, camera, body.faces[f]);
      if (body.sheet ? turned == 0 : turned >= 0) {
        if (body.sheet) return name_of(b, f) + ", of a sheet, is seen edge-on: stripes do not hold a line";
        continue;
      }
      if (place_of(scene, camera, body.faces[f]) == Place::across) return reaches_behind(b, f);
    }
  }
  return edge_behind_sheet(scene, camera);
}

std::variant<FaceSet, scene::SceneError> faces_of(const scene::PolyScene& scene,
                                                  const scene::PolyCamera& camera) {
  FaceSetBuilder builder(camera.perspective);
  const geometry::Vector3 forward = geometry::vector_of(camera.forward);
  for (const scene::PolyPoint& point : scene.vertices) {
    const geometry::Vector3 d = geometry::difference(point, camera.eye);
    builder.add_vertex({geometry::dot(geometry::vector_of(camera.right), d),
                        geometry::dot(geometry::vector_of(camera.up), d), geometry::dot(forward, d)});
  }
  for (std::uint32_t b = 0; b < scene.bodies.size(); ++b) {
    const scene::PolyBody& body = scene.bodies[b];
    for (std::uint32_t f = 0; f < body.faces.size(); ++f) {
      const scene::PolyFace& face = body.faces[f];
      if (!body.sheet && turned_away(scene, camera, face) >= 0) continue;
      const Place place = place_of(scene, camera, face);
      if (place == Place::behind) continue;
      if (place == Place::across) return scene::SceneError{"", "montani-re", reaches_behind(b, f)};
      Rings rings{face.outline};
      rings.insert(rings.end(), face.holes.begin(), face.holes.end());
      builder.add_face(rings, b, f);
    }
  }
  return builder.take();
}

}  // namespace sightline::algorithms::montani_re
