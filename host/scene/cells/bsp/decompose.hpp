// Free space around general polyhedra cut into convex cells by a BSP tree: the automatic decomposition
// that Jones (1971) called highly desirable and left open.
//
// The box around the scene, grown by 1, is split by planes of faces until no face passes through the inside
// of a part. The parts, which are convex, are the cells. Every wall between two parts is kept as a polygon
// while they are split further ("portal"), so that in the end each portal parts two leaves; what no sheet
// covers of a portal between free leaves is an opening. A leaf is solid if a path from outside to it enters
// more solids than it leaves, counted at portals, so bodies may touch, overlap or lie in each other.
//
// Everything is exact. Planes are those of faces, or pass through an edge of a face parallel to an axis
// (faces.hpp); points are the meetings of three planes and never rounded. Leaves of any size
// are kept.
//
// Left out: splitting planes other than those of faces; anything that looks at where an eye may be.
//
// Growth: scenes of many small bodies give a constant number of cells a body and take of the order of n log n
// (boxes 10, 100, 1000, 10000: 51, 506, 5311, about 55000 cells with 6 openings each). Where long faces cross
// each other's planes cells and time grow with n^2 and, if planes cross everywhere, n^3: a limit on leaves
// stops it.
#pragma once

#include <cstddef>

#include "host/base/result.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct BspOptions {
  std::size_t most_leaves = 4'000'000;  // free and solid; more is an error
  bool join = true;                     // join free leaves whose union is convex
};

// Of a checked scene. The same scene and options give the same complex, cell for cell. The outer box's own
// surface is free: openings to `outside`. An error names the limit that was met.
[[nodiscard]] base::Result<CellComplex> decompose_bsp(const PolyScene& scene, const BspOptions& options = {});

}  // namespace sightline::scene
