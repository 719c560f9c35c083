// Cuts the faces of a scene into convex pieces, along lines of their own edges.
//
// The line of an edge is the intersection of the face's plane with the plane through the edge parallel to an
// axis, the one along which the face's normal is longest. The normal of that second plane is the edge's
// direction turned by 90 degrees: components below 2^19, offset below 2^39.
#pragma once

#include <vector>

#include "host/scene/cells/builder.hpp"
#include "host/scene/cells/bsp/polygon.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct FacePiece {
  PlanePolygon polygon;
  bool sheet = false;
  bool turned = false;  // the face looks to the negative side of its plane
};

// The scene is a checked one. Pieces are in the order of bodies and faces. The pieces of a face do not
// overlap. A convex face is one piece.
[[nodiscard]] std::vector<FacePiece> face_pieces(const PolyScene& scene, CellComplexBuilder& builder);

}  // namespace sightline::scene
