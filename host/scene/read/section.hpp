// What is left of a scene when the part on one side of a plane is taken away, with the solids closed where the plane cut them.
//
// Planes are those where x, y or z has one value. Which vertices are taken away is decided by their coordinates in the unit of the file;
// where an edge meets the plane is computed in doubles, and all vertices are rounded once to the grid of the new scene, as those of a file.
// A face that lies in the plane is replaced by the cut. A sheet is cut and stays open; a solid whose rest touches itself along an edge
// becomes a sheet. Sheets and wires in the plane are removed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

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
  // PolyScene::material_of of the faces that lie in the planes; of every second body it is one more.
  std::uint32_t cut_material = 0;
  std::vector<std::string> notes;  // about cut faces that are left out
};

// The planes are applied one after the other. A plane of a scene that was rounded is rounded to its grid. The new grid has room for
// `options.eye`, as in import_poly. A camera in perspective whose eye has no place in the new grid becomes a parallel one.
// Error bad_input: nothing is left. The source has no crossings (precondition).
[[nodiscard]] base::Result<Section> section_of(const LoadedScene& source, std::span<const SectionPlane> planes,
                                               const PolyImportOptions& options = {});

}  // namespace sightline::scene
