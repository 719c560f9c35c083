// The order cells of a model as the machine holds them: planes, each as two points mirrored in it, and what is on their sides
// (firmware/i8080/flight/SPECIFICATION.md, section 2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/algorithms/willis/model.hpp"

namespace sightline::programs::flight {

using Place = std::uint8_t;  // 0: nothing; 1 to 127: a cell; 128 + i: plane i, from 1

struct CellPlane {
  // In units of willis's lattice; first that on the side the normal points to.
  std::array<std::array<double, 3>, 2> points{};
  std::array<Place, 3> places{};  // on that side, in the plane, on the other
};

struct Cells {
  std::vector<CellPlane> planes;
  std::size_t cells = 1;        // that have pieces
  std::vector<Place> of_piece;  // as the model has them
};

inline constexpr std::size_t most_planes = 126;
inline constexpr std::size_t most_cells = 127;

// Planes that have pieces of the model on one side only are left out. Without planes `of_piece` is empty. Places have no meaning where there are
// more planes or cells than that.
[[nodiscard]] Cells cells_of(const algorithms::willis::Model& model);

}  // namespace sightline::programs::flight
