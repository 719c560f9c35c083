// 3MF: an archive of models in XML, as slicers and CAD programs write it.
//
// Build items and components are placed by their transforms; each copy of a mesh is a body. Parts of the production extension
// are read (slicers keep each object in a part of its own). Left out, and noted: items that are not to be printed, objects of
// the types support, solidsupport and other (slicers keep modifiers as such), modifiers of PrusaSlicer, beams. Not read:
// colours, materials, pictures.
// Source: 3MF Consortium, 3D Manufacturing Format Core Specification 1.3 and Production Extension 1.1.2.
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

// Errors name the part of the archive and the object, face or vertex in it, or the line where the XML is damaged. More than
// 1 GB of models, 100 million corners, a million copies or 100 levels of components are errors.
[[nodiscard]] base::Result<PolyMesh> read_three_mf(std::string_view bytes, std::string_view source);

}  // namespace sightline::scene
