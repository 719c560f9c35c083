// The faces of a scene as convex pieces, cut along lines of their own edges.
//
// The line of an edge is where the face's plane is crossed by the plane through the edge parallel to an axis,
// the one along which the face's normal is longest: its normal is an edge's direction turned, below 2^19, its
// offset below 2^39.
#pragma once

#include <vector>

#include "host/scene/cells/builder.hpp"
#include "host/scene/cells/bsp/polygon.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct FacePiece {
  PlanePolygon polygon;
  bool sheet = false;
  bool turned = false;  // the face looks to where its plane is negative
};

// Of a checked scene, in the order of bodies and faces. The pieces of a face do not overlap. Convex faces are
// one piece.
[[nodiscard]] std::vector<FacePiece> face_pieces(const PolyScene& scene, CellComplexBuilder& builder);

}  // namespace sightline::scene
