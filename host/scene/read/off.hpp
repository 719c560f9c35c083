// Reading polyhedra from OFF, the Object File Format of Geomview.
//
// "OFF" (it may be missing), the numbers of vertices, faces and edges (the last is ignored and may be left out), the
// vertices, and the faces: how many vertices and which, from 0. # starts a comment. Each vertex and each face has a line
// of its own, or line ends are the same as blanks. Colours behind a face, which end with its line, are its material; passed
// over are the colours, normals and texture coordinates of COFF, NOFF, CNOFF and STOFF in every combination.
// Four-dimensional and n-dimensional variants (4OFF, nOFF) and binary files are refused by name.
// Source: Geomview Manual, "OFF Files".
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

[[nodiscard]] base::Result<PolyMesh> read_off(std::string_view text, std::string_view source, unsigned jobs = 1);

}  // namespace sightline::scene
