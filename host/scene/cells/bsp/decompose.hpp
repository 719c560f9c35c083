// Cuts the free space around general polyhedra into convex cells by a BSP tree: the automatic decomposition
// that Jones (1971) called highly desirable and left open.
//
// The box around the scene, grown by 1, is split by planes of faces until no face passes through the inside
// of a part. The parts are convex; they are the leaves of the tree. The polygon between two parts, the
// portal, is kept and split with them, so each portal finally separates two leaves. The part of a portal
// between free leaves that no sheet covers is an opening. A leaf is solid if a path from outside to it enters
// more solids than it leaves, counted at portals, so bodies may touch, overlap or contain each other.
//
// Everything is exact. A splitting plane is the plane of a face or passes through an edge of a face parallel
// to an axis (faces.hpp). Points are intersections of three planes and are never rounded. Leaves of any size
// are kept.
//
// Left out: other splitting planes, and any use of the camera's position.
//
// Growth: scenes of many small bodies give a constant number of cells per body and take about n log n time
// (boxes 10, 100, 1000, 10000: 51, 506, 5311, about 55000 cells with 6 openings each). Where long faces cross
// each other's planes, cells and time grow with n^2, and with n^3 if planes cross everywhere: a limit on the
// number of leaves stops it.
#pragma once

#include <cstddef>

#include "host/base/result.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct BspOptions {
  std::size_t most_leaves = 4'000'000;  // free and solid together; exceeding it is an error
  bool join = true;                     // merge free leaves whose union is convex
};

// The scene is a checked one. The same scene and options give the same complex, cell for cell. The surface of
// the outer box is free: it has openings to `outside`. An error names the limit that was exceeded.
[[nodiscard]] base::Result<CellComplex> decompose_bsp(const PolyScene& scene, const BspOptions& options = {});

}  // namespace sightline::scene
