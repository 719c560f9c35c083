// glTF 1 and 2 (text and GLB) and 3MF: read by the library assimp, in a process of its own, because a damaged file may
// crash it or keep it at work without an end. A build without assimp says how to get one that has it.
//
// Node and build transforms are applied; each node with meshes is a body. What a glTF file refers to is read from its own
// folder alone. Not read: lines and points, skins and morph targets (a mesh is as it was modelled), extensions that a file
// requires and that change its geometry, except Draco's compression.
// Source: Khronos, glTF 2.0 Specification; 3MF Consortium, 3D Manufacturing Format Core Specification 1.3.
#pragma once

#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

enum class AssimpFormat { gltf, glb, threemf };

// Whether a text is a JSON object with a member "asset": what every glTF file has and no other scene.
[[nodiscard]] bool is_gltf(std::string_view text);

// `folder`: where buffers that a glTF file names are; empty: there are none, the file came from standard input. Errors
// have a byte where the frame of the file is damaged, a line and column where its JSON is, or the name of the part; else
// what assimp says of it. More than 60 seconds of processor time, 4 GB of memory or 100 million corners are errors.
[[nodiscard]] base::Result<PolyMesh> read_by_assimp(std::string_view bytes, std::string_view source, AssimpFormat format,
                                                    const std::string& folder);

}  // namespace sightline::scene
