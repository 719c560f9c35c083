// STL, the triangles of 3-D printers: text or binary.
//
// A file with room for the triangles that byte 80 counts is binary: the header of a binary file may begin with "solid",
// too, and the bytes of a text would count 100 million triangles or more. What comes after the triangles is passed over
// and named in PolyMesh::notes. In a text blanks and line ends are the same, but for the name of a solid, which ends with
// its line; a missing "endsolid" is named in the notes.
// Read are the vertices, one for each point, and which solid of a text they are of; the normals, the name in a
// binary header and the two bytes after each triangle are passed over. z is upwards.
// Source: 3D Systems, StereoLithography Interface Specification (1989).
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

// Whether the length is that of as many triangles as the header says.
[[nodiscard]] bool is_binary_stl(std::string_view bytes);
// The same, or longer.
[[nodiscard]] bool begins_as_binary_stl(std::string_view bytes);

// Errors have a line and column, or a byte.
[[nodiscard]] base::Result<PolyMesh> read_stl(std::string_view bytes, std::string_view source, unsigned jobs = 1);

}  // namespace sightline::scene
