// Computes exactly the visible parts of the edges of a polyhedral scene: the reference for general scenes.
//
// Rule: a point of an edge is hidden iff it is hidden in the limit from both sides of the image line of the edge. A face
// hides a point from one side iff the sight line to it, moved a little to that side, passes through the inside of the
// face strictly nearer than the point. So a face through the point does not hide it, a face seen edge-on hides nothing,
// and an edge exactly behind the common edge of two front faces is hidden. Every edge of edges_of is drawn. In
// perspective only what is in front of the eye (forward . d >= 0) is seen; an edge whose image is a point is not.
//
// Method: each edge is cut where its image crosses the image of a face's edge and where it meets the plane of a face.
// Between two cuts nothing changes, so one point is tested against every face, by counting the edges that a ray in the
// image crosses. Slow and simple: edges x cuts x faces.
//
// Sizes, with coordinates below 2^18: cuts are fractions of 60 over 60 bits, a point between two of them 61 over 61, a
// test at that point 122 bits. Ends of crossings are fractions of 80 over 61 bits: their cuts have 184 over 185, a point
// between two cuts 186, a test there 372.
#pragma once

#include "host/picture/edge_choice.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::oracle {

// Preconditions: the scene is checked, the eye is in no solid and on no face.
[[nodiscard]] picture::LinePicture visible_edges(const scene::PolyScene& scene,
                                                 const scene::PolyCamera& camera);

// Draws only the chosen edges, and of these none that is turned away. An edge is not hidden by faces of the surfaces that
// it belongs to. Faces of solids that are turned away hide nothing here; in a scene without surfaces this makes no
// difference, because a nearer face hides the same.
[[nodiscard]] picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                 const picture::ChosenEdges& chosen);

}  // namespace sightline::algorithms::oracle
