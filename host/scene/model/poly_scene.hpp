// A scene of general polyhedra: closed solids and open sheets with planar faces, in integer coordinates.
//
// Left out: what only one algorithm needs (cells and openings: cell_scene.hpp; heights: host/scene/heights/grid.hpp). A
// PolyScene as such promises nothing: check_poly_scene (host/scene/check/poly_scene.hpp) says whether it is a possible scene,
// and everything that draws expects a checked one.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sightline::scene {

// Every |coordinate| is less than this, so that the predicates of host/geometry fit 128 bits (differences 19
// bits, normals 40, a point against a plane 60, parameters along an edge 60 over 60).
inline constexpr std::int32_t poly_coordinate_limit = 1 << 18;

using PolyPoint = std::array<std::int32_t, 3>;
using VertexIndex = std::uint32_t;

// A planar region: counterclockwise outline seen from outside, clockwise holes.
struct PolyFace {
  std::vector<VertexIndex> outline;
  std::vector<std::vector<VertexIndex>> holes;

  friend bool operator==(const PolyFace&, const PolyFace&) = default;
};

// A closed polyhedron, or, as a sheet, a set of faces without thickness that are seen from both sides.
struct PolyBody {
  std::string name;  // may be empty
  bool sheet = false;
  std::vector<PolyFace> faces;

  friend bool operator==(const PolyBody&, const PolyBody&) = default;
};

// How a scene is looked at. forward, right and up are orthogonal integer vectors of any length, each
// component below 2^15. The image of a point p at d = p - eye is x = (right.d / |right|) / (forward.d /
// |forward|), y likewise with up; orthographic: without the division, and the eye is only the origin of the
// image.
struct PolyCamera {
  bool perspective = true;
  PolyPoint eye{};
  PolyPoint forward{0, 0, 1};
  PolyPoint right{1, 0, 0};
  PolyPoint up{0, 1, 0};

  friend bool operator==(const PolyCamera&, const PolyCamera&) = default;
};

struct PolyScene {
  std::string name;
  std::vector<PolyPoint> vertices;
  std::vector<PolyBody> bodies;
  PolyCamera camera;   // the default view
  double step = 1;     // what one unit stands for in the file it came from (a float file is quantised once)
  PolyPoint origin{};  // added to a vertex before the multiplication by step

  friend bool operator==(const PolyScene&, const PolyScene&) = default;
};

}  // namespace sightline::scene
