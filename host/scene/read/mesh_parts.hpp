// The parts of a mesh: faces that a chain of edges with two faces joins. Which are solids, which lie in which, and which faces have
// to be turned. The rules are in poly_mend.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/scene/model/edge_table.hpp"
#include "host/scene/read/mended_mesh.hpp"

namespace sightline::scene {

inline constexpr std::uint32_t no_part = std::numeric_limits<std::uint32_t>::max();

struct Part {
  std::uint32_t body = 0;
  bool one_sided = false;
  bool closed = true;
  bool crowded = false;  // at an edge with three or more faces: a body of its own
  geometry::Int128 volume = 0;  // six times
  PolyPoint low{};
  PolyPoint high{};
  std::uint32_t first = 0;  // face
  std::uint32_t around = no_part;  // the smallest closed part that it lies in
  std::uint32_t depth = 0;      // how many it lies in

  [[nodiscard]] bool solid() const { return closed && !one_sided && volume != 0; }
  // Of a solid: its faces have to be turned.
  [[nodiscard]] bool inside_out() const { return solid() && (volume > 0) != (depth % 2 == 0); }
};

struct MeshParts {
  std::vector<Part> parts;
  std::vector<std::uint32_t> part_of;                     // of each piece
  std::vector<std::array<std::uint32_t, 2>> neighbours;  // MendResult::neighbours
};

// Turns the pieces of each part to agree with its first one, and measures the parts. `edges` are those of the pieces.
[[nodiscard]] MeshParts find_parts(MendedMesh& mesh, const EdgeTable& edges);

// Finds which solids lie in which, and turns each as it has to be.
void orient(MendedMesh& mesh, MeshParts& parts);

}  // namespace sightline::scene
