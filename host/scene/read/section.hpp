// What is left of a scene when the part on one side of a plane is taken away, with the solids closed where the plane cut them.
//
// Planes are those where x, y or z has one value. Which vertices are taken away is decided by their coordinates in the unit of the file;
// where an edge meets the plane is computed in doubles, and all vertices are rounded once to the grid of the new scene, as those of a file.
// A face that lies in the plane is replaced by the cut. A sheet is cut and stays open; a solid whose rest touches itself along an edge
// becomes one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "host/base/result.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::scene {

struct SectionPlane {
  std::size_t axis = 0;     // 0, 1, 2 = x, y, z
  double at = 0;            // in the unit of the file
  bool keep_above = false;  // keeps the vertices whose coordinate is larger; otherwise those whose coordinate is smaller
};

struct Section {
  LoadedScene loaded;              // a mesh, with the names of the bodies, the materials and the camera of the source
  std::uint32_t cut_material = 0;  // PolyScene::material_of of the faces that lie in the planes
};

// The planes are taken one after the other. `options.eye` is a place the new grid has to have room for, as in import_poly.
// Error bad_input: nothing is left. The source has no crossings (precondition).
[[nodiscard]] base::Result<Section> section_of(const LoadedScene& source, std::span<const SectionPlane> planes,
                                               const PolyImportOptions& options = {});

}  // namespace sightline::scene
