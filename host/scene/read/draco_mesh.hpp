// Triangles compressed by Draco, as glTF has them: read by libdraco, where the program was built with it.
// Source: Google, Draco Bitstream Specification 2.2; Khronos, KHR_draco_mesh_compression.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::scene {

struct DracoMesh {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::uint32_t> corners;  // three per triangle; every index is below vertices.size()
};

// `attribute`: the unique id of the positions. Errors have neither file nor place: damage, more than `most_faces`, more faces
// than so few bytes can hold (100 per byte, beyond a million), or a program without libdraco.
[[nodiscard]] base::Result<DracoMesh> read_draco(std::string_view bytes, std::uint32_t attribute, std::size_t most_faces);

}  // namespace sightline::scene
