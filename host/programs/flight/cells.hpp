// The order cells of a model as the machine holds them: planes, each given by two points mirrored in it, and the place on
// each side (firmware/i8080/flight/SPECIFICATION.md, section 2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/algorithms/willis/model.hpp"

namespace sightline::programs::flight {

using Place = std::uint8_t;  // 0: nothing; 1 to 127: a cell; 128 + i: plane i, from 1

struct CellPlane {
  // In units of willis's lattice; first the point on the side to which the normal points.
  std::array<std::array<double, 3>, 2> points{};
  std::array<Place, 3> places{};  // on that side, in the plane, on the other
};

struct Cells {
  std::vector<CellPlane> planes;
  std::size_t cells = 1;        // those that have pieces
  std::vector<Place> of_piece;  // in the order of the model's pieces
};

inline constexpr std::size_t most_planes = 126;
inline constexpr std::size_t most_cells = 127;

// Planes with pieces of the model on only one side are left out. Without planes `of_piece` is empty. If there are more
// planes or cells than these limits, places have no meaning.
[[nodiscard]] Cells cells_of(const algorithms::willis::Model& model);

}  // namespace sightline::programs::flight
