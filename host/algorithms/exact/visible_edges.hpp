// Exactly which parts of the edges of a polyhedral scene are visible, fast: for users who need a correct
// hidden-line drawing of closed polyhedra and sheets, faces with holes included.
//
// Rule: a point of an edge is hidden iff it is hidden in the limit from both sides of the image line of the
// edge by faces strictly nearer; every edge counts; in perspective only what is before the eye is seen.
//
// Method: faces of solids that look away hide nothing that a face in front does not, and edges between such
// faces are hidden by their own solid. The others go into a grid over the image, nearest first; each edge is
// compared with the face that hid the one before, and then with the faces of the cells it crosses, nearest first,
// until it is hidden altogether or the faces begin behind it. Many edges are compared in the order of the image.
// What a face hides of an edge follows from the signs of integers of 64 bits; its ends are fractions of 60 over
// 60 bits, compared in 128. Which faces a cell has is decided in floating point and whole steps, both of which keep
// the order of exact quotients. The picture depends neither on the order of edges and faces nor on threads.
#pragma once

#include <cstdint>
#include <span>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::exact {

// Of edges chosen (an ascending choice of the scene's) these alone are drawn, and none that is turned away;
// one is not hidden by faces of the surfaces at it, which rounding may have moved before it. What is hidden is
// then: by faces of solids that are turned to the eye, and by faces of sheets.

// The eye is in no solid and on no face (precondition). On so many threads.
[[nodiscard]] picture::LinePicture visible_edges(const EdgeMesh& mesh, const scene::PolyCamera& camera,
                                                 const picture::ChosenEdges* chosen = nullptr, unsigned jobs = 1);
[[nodiscard]] picture::LinePicture visible_edges(const scene::PolyScene& scene,
                                                 const scene::PolyCamera& camera);

// Hears what a search does, in order. A search without one is compiled apart and pays nothing for it.
class Trace {
 public:
  virtual ~Trace() = default;
  virtual void edge(const picture::LineEdge& edge) = 0;
  // After the edge was compared with a face, counted over all bodies from 0: what is left of it.
  virtual void compared(const picture::LineEdge& edge, std::uint32_t face, std::span<const picture::LinePiece> left) = 0;
  // What is seen of it. Not `searched`: its own solid hides it, or it is behind the eye.
  virtual void result(const picture::LineEdge& edge, bool searched, std::span<const picture::LinePiece> seen) = 0;
};
[[nodiscard]] picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                 Trace& trace);

}  // namespace sightline::algorithms::exact
