// The exactly visible parts of the edges of a polyhedral scene: the reference for general scenes.
//
// Rule: a point of an edge is hidden iff it is hidden in the limit from both sides of the image line of the
// edge. A face hides a point from one side iff the sight line to it, moved a little to that side, passes the
// inside of the face strictly nearer than the point; so a face through the point does not hide it, a face
// seen edge-on hides nothing, and an edge exactly behind the common edge of two front faces is hidden. Every
// edge of edges_of is drawn. In perspective only what is before the eye (forward . d >= 0) is seen, and an
// edge whose image is a point is not.
//
// Method: each edge is cut where its image crosses that of any face's edge and where it meets the plane of
// any face; between two cuts nothing changes, and one point is tested against every face by counting the
// edges a ray in the image crosses. Slow and simple: edges x cuts x faces.
//
// Sizes, coordinates below 2^18: cuts are fractions of 60 over 60 bits, a point between two of them 61 over
// 61, a test at that point 122 bits. Ends of crossings are fractions of 80 over 61 bits: cuts of these have 184 over 185, a
// point between 186, a test there 372.
#pragma once

#include "host/picture/edge_choice.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::oracle {

// The scene is a checked one, the eye in no solid and on no face (preconditions).
[[nodiscard]] picture::LinePicture visible_edges(const scene::PolyScene& scene,
                                                 const scene::PolyCamera& camera);

// Of edges chosen: these alone and none that is turned away; one is not hidden by faces of the surfaces at it.
// Faces of solids that are turned away hide nothing here, as in a scene without surfaces they hide nothing that
// a nearer one does not.
[[nodiscard]] picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                 const picture::ChosenEdges& chosen);

}  // namespace sightline::algorithms::oracle
