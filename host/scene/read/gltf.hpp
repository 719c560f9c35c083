// glTF 1 and 2 as text, and GLB 2.
//
// Node transforms are applied; each node with triangles is a body. What a file refers to is read from its own folder alone. Not
// read, and noted: lines and points, skins and morph targets (a mesh is as it was modelled), instances of
// EXT_mesh_gpu_instancing. Refused: extensions that a file requires and that change its geometry, except quantization and
// Draco's compression.
// Source: Khronos, glTF 2.0 Specification 2.0.1 and glTF 1.0 Specification.
#pragma once

#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

// `folder`: where buffers that the file names are; empty: there are none, the file came from standard input. Errors have a byte
// where the frame of a GLB is damaged, a line and column where its JSON is, or a path in that: "accessors[3].count". More than
// 100 million corners are an error.
[[nodiscard]] base::Result<PolyMesh> read_gltf(std::string_view text, std::string_view source, const std::string& folder);
[[nodiscard]] base::Result<PolyMesh> read_glb(std::string_view bytes, std::string_view source, const std::string& folder);

}  // namespace sightline::scene
