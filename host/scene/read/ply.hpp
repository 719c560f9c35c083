// PLY, the Stanford polygon format: text, or binary in either byte order.
//
// Read are x, y and z of the element "vertex", the list vertex_indices (or vertex_index) of the elements "face" and
// "tristrips", and the red, green and blue of faces as materials that are colours. All other elements and properties are
// passed over; elements are named in PolyMesh::notes.
// Source: G. Turk, The PLY Polygon File Format (1994).
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

// Errors have a line, or in binary a byte.
[[nodiscard]] base::Result<PolyMesh> read_ply(std::string_view bytes, std::string_view source);

}  // namespace sightline::scene
