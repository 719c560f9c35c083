// Computes exactly, and fast, which parts of the edges of a polyhedral scene are visible. For users who need a correct
// hidden-line drawing of closed polyhedra and sheets; faces may have holes.
//
// Rule: a point of an edge is hidden iff it is hidden in the limit from both sides of the image line of the
// edge by faces strictly nearer. Every edge is drawn. In perspective only what is in front of the eye is seen.
//
// Method: a face of a solid that is turned away hides nothing that a front face does not hide as well, and edges between
// two such faces are hidden by their own solid. The other faces go into a grid over the image, nearest first. Each edge
// is compared first with the face that hid the edge before it, then with the faces of the cells it crosses, nearest
// first, until it is wholly hidden or the remaining faces are behind it. Large numbers of edges are compared in image
// order. Signs of 64-bit integers decide which part of an edge a face hides; the ends of the part are fractions of 60
// over 60 bits, compared in 128. Cells are assigned in floating point and whole steps, both of which keep the order of
// exact quotients. The picture does not depend on the order of edges and faces, nor on the number of threads.
#pragma once

#include <cstdint>
#include <span>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/base/watch.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::exact {

// `chosen`, if given, lists in ascending order the scene's edges to draw, except those turned away. A chosen edge is not
// hidden by faces of the surfaces that it belongs to, because rounding may have moved them before it. Faces of solids
// that are turned to the eye, and faces of sheets, hide.

// Precondition: the eye is in no solid and on no face. Uses up to `jobs` threads. If the watch ends the work, the picture is empty.
[[nodiscard]] picture::LinePicture visible_edges(const EdgeMesh& mesh, const scene::PolyCamera& camera,
                                                 const picture::ChosenEdges* chosen = nullptr, unsigned jobs = 1,
                                                 const base::Watch& watch = {});
[[nodiscard]] picture::LinePicture visible_edges(const scene::PolyScene& scene,
                                                 const scene::PolyCamera& camera);

// Receives the steps of a search, in order. A search without a trace is compiled separately and has no cost for it.
class Trace {
 public:
  virtual ~Trace() = default;
  virtual void edge(const picture::LineEdge& edge) = 0;
  // Called after the edge is compared with a face (numbered over all bodies from 0), with what is left of the edge.
  virtual void compared(const picture::LineEdge& edge, std::uint32_t face, std::span<const picture::LinePiece> left) = 0;
  // Called with the visible pieces. `searched` is false if the edge is hidden by its own solid or behind the eye.
  virtual void result(const picture::LineEdge& edge, bool searched, std::span<const picture::LinePiece> seen) = 0;
};
[[nodiscard]] picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                 Trace& trace);

}  // namespace sightline::algorithms::exact
