// A scene of general polyhedra: closed solids and open sheets with planar faces, in integer coordinates.
//
// Data of single algorithms is elsewhere (cells and openings: cell_scene.hpp; heights:
// host/scene/heights/grid.hpp). A PolyScene may be invalid. check_poly_scene
// (host/scene/check/poly_scene.hpp) tells; everything that draws expects a checked one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/scene/model/ring.hpp"

namespace sightline::scene {

// Every |coordinate| is below this, so that the predicates of host/geometry fit 128 bits (differences 19
// bits, normals 40, plane values at points 60, parameters along an edge 60 over 60).
inline constexpr std::int32_t poly_coordinate_limit = 1 << 18;

using PolyPoint = std::array<std::int32_t, 3>;

// The position of a scene in its file, in steps; 64 bits, because a part may be far from 0. It and the
// absolute coordinates are below 2^53 in magnitude, so each is exact as a double.
using PolyOrigin = std::array<std::int64_t, 3>;

// A planar region: counterclockwise outline seen from outside, clockwise holes.
struct PolyFace {
  Ring outline;
  std::vector<Ring> holes;

  friend bool operator==(const PolyFace&, const PolyFace&) = default;
};

// A closed polyhedron; or, as a sheet, a set of faces without thickness that are visible from both sides.
struct PolyBody {
  std::string name;  // may be empty
  bool sheet = false;
  std::vector<PolyFace> faces;

  friend bool operator==(const PolyBody&, const PolyBody&) = default;
};

// The view of a scene. forward, right and up are orthogonal integer vectors of any length, each component
// below 2^15. The image of a point p at d = p - eye is x = (right.d / |right|) / (forward.d / |forward|), y
// likewise with up. Orthographic: without the division, and the eye is only the origin of the image.
struct PolyCamera {
  bool perspective = true;
  PolyPoint eye{};
  PolyPoint forward{0, 0, 1};
  PolyPoint right{1, 0, 0};
  PolyPoint up{0, 1, 0};

  friend bool operator==(const PolyCamera&, const PolyCamera&) = default;
};

// A line between two vertices, a side of a face or not: faces hide it, and it hides nothing.
using PolyWire = std::array<VertexIndex, 2>;

// A surface: faces of a mesh that are coplanar to the accuracy of the file's numbers. Their rounded vertices
// cannot show that. Edges are selected, and faces towards the eye recognised, by its normal
// (host/picture/edge_choice.hpp).
struct PolySurface {
  std::array<double, 3> normal{};  // in the coordinates of the file, outwards, of length 1

  friend bool operator==(const PolySurface&, const PolySurface&) = default;
};

// The point where the line through two vertices meets a plane: (q a - p b) / (a - b). It is exact; its
// coordinates have at most 80 over 61 bits.
struct CutPoint {
  VertexIndex p = 0;
  VertexIndex q = 0;
  std::int64_t a = 0;  // value of the plane at p, below 2^60
  std::int64_t b = 0;  // value at q, different from a

  friend bool operator==(const CutPoint&, const CutPoint&) = default;
};

// A line in which two faces cross, or one that is drawn on a face: the intersection of the plane of face_a
// with that of face_b, or with one of PolyScene::cut_planes, in the direction of the cross product of their
// normals.
struct PolyCrossing {
  VertexIndex from = 0;      // two vertices of no face, the ends rounded to the grid; they identify the line
  VertexIndex to = 0;        // from + 1
  std::uint32_t face_a = 0;  // counted over all bodies from 0
  std::uint32_t face_b = 0;  // face_a if the line is drawn on one face
  std::uint32_t plane = 0;   // if so, an index into cut_planes
  std::array<CutPoint, 2> ends{};

  friend bool operator==(const PolyCrossing&, const PolyCrossing&) = default;
};

struct PolyScene {
  std::string name;
  std::vector<PolyPoint> vertices;
  std::vector<PolyBody> bodies;
  PolyCamera camera;   // the default view
  double step = 1;     // length of one unit in the file it came from (a file of floats is quantised once)
  PolyOrigin origin{};  // added to a vertex before the multiplication by step
  // For a mesh; otherwise these three are empty. For each face, counted over all bodies from 0, the numbers
  // of its surface and of its material (empty if all have the same).
  std::vector<PolySurface> surfaces = {};
  std::vector<std::uint32_t> surface_of = {};
  std::vector<std::uint32_t> material_of = {};
  bool materials_are_colours = false;  // of single faces, as in scans and plots: borders between them are not edges of the part
  // Lines where faces cross, for drawing (with_crossings in host/scene/check/crossings.hpp); empty in a
  // checked scene. Their vertices are the last ones, in the same order.
  std::vector<PolyCrossing> crossings = {};
  std::vector<geometry::Plane> cut_planes = {};  // normals below 2^39, values at vertices and eyes below 2^60
  std::vector<PolyWire> wires = {};              // belong to no body; a scene may consist of wires only
  // For a mesh: pairs of a wire and a surface in whose plane it lies. Faces of that surface do not hide the
  // wire, although both were rounded. Ascending.
  std::vector<std::array<std::uint32_t, 2>> wires_on = {};
  // For a mesh: of each face, and of each vertex before those of crossings, the number in the file, from 0.
  // A face of the file may have become several. Of vertices that became one, one is named. Empty: the same numbers.
  std::vector<std::uint32_t> face_in_file = {};
  std::vector<std::uint32_t> vertex_in_file = {};

  friend bool operator==(const PolyScene&, const PolyScene&) = default;
};

// The crossing that the vertex is an end of; null if there is none.
[[nodiscard]] inline const PolyCrossing* crossing_at(const PolyScene& scene, VertexIndex vertex) {
  if (scene.crossings.empty() || vertex < scene.crossings.front().from) return nullptr;
  return &scene.crossings[(vertex - scene.crossings.front().from) / 2];
}

// The scene without its wires and without the vertices that are then unused. The scene has no crossings
// (precondition).
[[nodiscard]] PolyScene without_wires(PolyScene scene);

// Faces are numbered over all bodies from 1, as in item buffers; 0 is no face.

[[nodiscard]] inline std::size_t face_count(const PolyScene& scene) {
  std::size_t faces = 0;
  for (const PolyBody& body : scene.bodies) faces += body.faces.size();
  return faces;
}

// The number of a face, counted from 0, in the file that the scene came from, also from 0.
[[nodiscard]] inline std::uint32_t face_in_file(const PolyScene& scene, std::uint32_t face) {
  return face < scene.face_in_file.size() ? scene.face_in_file[face] : face;
}

// The number of each body's first face; its other faces follow in order.
[[nodiscard]] inline std::vector<std::uint32_t> first_face_numbers(const PolyScene& scene) {
  std::vector<std::uint32_t> firsts;
  std::uint32_t next = 1;
  for (const PolyBody& body : scene.bodies) {
    firsts.push_back(next);
    next += static_cast<std::uint32_t>(body.faces.size());
  }
  return firsts;
}

// The box around all vertices of a scene of polyhedra.

struct PolyBounds {
  PolyPoint low{};
  PolyPoint high{};

  // Rounded towards zero.
  [[nodiscard]] PolyPoint middle() const {
    PolyPoint p{};
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = static_cast<std::int32_t>((std::int64_t{low[a]} + high[a]) / 2);
    return p;
  }
  // Half of the longest side, rounded up, at least 1.
  [[nodiscard]] std::int64_t half_size() const {
    std::int64_t half = 1;
    for (std::size_t a = 0; a < 3; ++a) half = std::max(half, (std::int64_t{high[a]} - low[a] + 1) / 2);
    return half;
  }
  [[nodiscard]] bool contain(const PolyPoint& p) const {
    bool inside = true;
    for (std::size_t a = 0; a < 3; ++a) inside = inside && low[a] <= p[a] && p[a] <= high[a];
    return inside;
  }
};

// For a scene without vertices, the point 0, 0, 0.
[[nodiscard]] inline PolyBounds bounds_of(const PolyScene& scene) {
  if (scene.vertices.empty()) return {};
  PolyBounds bounds{scene.vertices[0], scene.vertices[0]};
  for (const PolyPoint& p : scene.vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      bounds.low[a] = std::min(bounds.low[a], p[a]);
      bounds.high[a] = std::max(bounds.high[a], p[a]);
    }
  }
  return bounds;
}

}  // namespace sightline::scene
