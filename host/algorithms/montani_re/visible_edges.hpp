// Montani and Re's algorithm in object space: the exactly visible parts of the edges of a polyhedral scene.
//
// An edge is drawn where it bounds the visible region of one of its faces. If an edge lies exactly behind the outline of
// a nearer face, only that outline is drawn; then the pictures of `exact` and of this algorithm are equal as sets of
// points (picture::image_set), otherwise by ==. Lines that bound no region are added (isolated_edges.hpp). If a face is
// partly in front of and partly behind the eye, the pyramids of pyramids.hpp are drawn one by one and their pieces joined.
#pragma once

#include <vector>

#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/base/result.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::montani_re {

struct LineView {
  picture::LinePicture picture;
  RegionCounts counts;
};

// Precondition: the scene is checked. The error names faces that pass through each other.
[[nodiscard]] base::Result<LineView> visible_edges(const scene::PolyScene& scene,
                                                   const scene::PolyCamera& camera, Trace* trace = nullptr);

// The own sides and horizontal edges of the regions, and the visible parts of isolated edges, as pieces of the set's
// edges.
[[nodiscard]] picture::LinePicture edges_of_regions(const FaceSet& set,
                                                    const std::vector<TrapezoidPcs>& regions);

}  // namespace sightline::algorithms::montani_re
