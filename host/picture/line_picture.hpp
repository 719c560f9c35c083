// The exactly visible parts of the edges of a polyhedral scene: the picture by which line algorithms are compared.
//
// An edge is a pair of vertices that follow each other on the outline or a hole of some face, or a wire, named
// once, the lower vertex first. A piece is a closed interval of s, the point being from + s (to - from). Law: pieces
// ascend by (from, to, low), pieces of one edge do not touch, and each has a positive length; two pictures of
// the same visibility are therefore equal by ==. Edges that coincide in space or in the image keep their own
// pieces; line_picture_image.hpp merges them.
#pragma once

#include <compare>
#include <vector>

#include "host/geometry/rational.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

struct LineEdge {
  scene::VertexIndex from = 0;
  scene::VertexIndex to = 0;  // above from

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

// All edges of a scene, ascending. Steps from a vertex to itself are left out.
[[nodiscard]] std::vector<LineEdge> edges_of(const scene::PolyScene& scene);

// Which edges are seams: lines where the surface one looks at does not bend, such as the diagonals of a
// triangulated face or the joint of two boxes side by side.
//
// The faces that meet in an edge part the space about it into sectors. The eye looks through one of them; the
// edge is a seam for this eye iff the faces to both sides of that sector lie in one plane. So the same edge
// may be a seam from above and a feature from below. If the eye is in the plane of one of the faces it looks
// through two sectors, and both must be flat.
//
// Faces meet in an edge iff they have it as a side, of whatever body: both ends at the same two points. Left
// out: edges of which one is only a part of the other.

// The picture, which is one of this scene from this camera, without its seams.
[[nodiscard]] LinePicture without_seams(const LinePicture& picture, const scene::PolyScene& scene,
                                        const scene::PolyCamera& camera);

}  // namespace sightline::picture
