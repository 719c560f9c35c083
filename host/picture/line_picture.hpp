// The exactly visible parts of the edges of a polyhedral scene, in a form that can be compared between line algorithms.
//
// An edge is a pair of consecutive vertices of an outline or a hole of a face, or a wire; it is listed once, the lower
// vertex first. A piece is a closed interval of s for the point from + s (to - from). Law: pieces ascend by (from, to,
// low), pieces of one edge do not touch, and each has a positive length. Two pictures of equal visibility are therefore
// equal by ==. Edges that coincide in space or in the image keep their own pieces; line_picture_image.hpp merges them.
#pragma once

#include <compare>
#include <vector>

#include "host/geometry/rational.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

struct LineEdge {
  scene::VertexIndex from = 0;
  scene::VertexIndex to = 0;  // greater than from

  friend bool operator==(const LineEdge&, const LineEdge&) = default;
  friend std::strong_ordering operator<=>(const LineEdge&, const LineEdge&) = default;
};

struct LinePiece {
  LineEdge edge;
  geometry::Rational low;
  geometry::Rational high;

  friend bool operator==(const LinePiece&, const LinePiece&) = default;
};

struct LinePicture {
  std::vector<LinePiece> pieces;

  friend bool operator==(const LinePicture&, const LinePicture&) = default;
};

// All edges of a scene, ascending. A side from a vertex to itself is left out.
[[nodiscard]] std::vector<LineEdge> edges_of(const scene::PolyScene& scene);

// Seams are edges at which the visible surface does not bend, such as the diagonals of a triangulated face or the joint
// of two boxes side by side.
//
// The faces that meet in an edge divide the space about it into sectors, and the eye is in one of them. The edge is a
// seam for this eye iff the faces on both sides of that sector are in one plane. So the same edge may be a seam from
// above and a feature from below. If the eye is in the plane of one of the faces, it is in two sectors, and both must be
// flat.
//
// Faces of any bodies meet in an edge iff it is a side of each: both ends are at the same two points. Not recognized: an
// edge that is only a part of another.

// The picture without its seams. Precondition: it is a picture of this scene from this camera.
[[nodiscard]] LinePicture without_seams(const LinePicture& picture, const scene::PolyScene& scene,
                                        const scene::PolyCamera& camera);

}  // namespace sightline::picture
