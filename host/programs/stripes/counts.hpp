// Counts of the work on a picture of stripes.
#pragma once

#include <array>
#include <cstdint>

namespace sightline::programs::stripes {

struct Counts {
  std::array<std::uint32_t, 7> decided_by{};  // pairs by the deciding test; 4 and 5 are counted together with coplanar pairs in 4
  std::uint32_t relations = 0;
  std::uint32_t deleted = 0;           // relations deleted from cycles of faces that have nothing in common
  std::uint32_t cuts = 0;              // faces cut by another
  std::uint32_t silhouette_most = 0;   // toggles in a line of the silhouette
  std::uint32_t face_most = 0;         // toggles in a line of a face
  std::uint32_t dots = 0;              // shown
  std::uint32_t links = 0;             // drawn by the pen

  friend bool operator==(const Counts&, const Counts&) = default;
};

}  // namespace sightline::programs::stripes
