// Montani and Re's algorithm in object space: the exactly visible parts of the edges of a polyhedral scene.
//
// An edge is drawn where it bounds what is seen of one of its faces. Where an edge lies exactly behind the
// outline of a nearer face, only that outline is drawn: the pictures of `exact` and of this algorithm are
// then equal as sets of points (picture::image_set), else by ==. Lines that bound no region are added to
// those of the regions (isolated_edges.hpp). Where a face reaches from before the eye to behind it, the pyramids
// of pyramids.hpp are drawn one by one and their pieces joined.
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

// The scene is a checked one (precondition). An error names faces that pass through each other.
[[nodiscard]] base::Result<LineView> visible_edges(const scene::PolyScene& scene,
                                                   const scene::PolyCamera& camera, Trace* trace = nullptr);

// The own sides and horizontal edges of the regions and what is seen of isolated edges, as pieces of the edges of
// the set.
[[nodiscard]] picture::LinePicture edges_of_regions(const FaceSet& set,
                                                    const std::vector<TrapezoidPcs>& regions);

}  // namespace sightline::algorithms::montani_re
