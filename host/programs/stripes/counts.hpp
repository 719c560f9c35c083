// How the work on a picture of stripes went.
#pragma once

#include <array>
#include <cstdint>

namespace sightline::programs::stripes {

struct Counts {
  std::array<std::uint32_t, 7> decided_by{};  // pairs by the test that decided; 4 and 5 together with the coplanar ones in 4
  std::uint32_t relations = 0;
  std::uint32_t deleted = 0;           // relations on cycles of faces that have nothing in common
  std::uint32_t cuts = 0;              // faces cut by another
  std::uint32_t silhouette_most = 0;   // toggles in a line of the silhouette
  std::uint32_t face_most = 0;         // of a face
  std::uint32_t dots = 0;              // shown
  std::uint32_t links = 0;             // drawn by the pen

  friend bool operator==(const Counts&, const Counts&) = default;
};

}  // namespace sightline::programs::stripes
