// The facing test of a model as the machine holds it: the directions across which the pieces lie. Opposite normals share a
// direction, so a town of boxes has three (firmware/i8080/flight/SPECIFICATION.md, section 5).
#pragma once

#include <cstdint>
#include <vector>

#include "host/algorithms/willis/model.hpp"

namespace sightline::programs::flight {

struct Direction {
  struct Piece {
    std::uint32_t number = 0;  // in the model, from 0
    bool along = true;         // it faces the side to which `normal` points
  };
  algorithms::willis::Vector3 normal{};  // without a common divisor
  std::vector<Piece> pieces;
};

// Every piece is in one direction. A piece without a normal is in one whose normal is zero.
[[nodiscard]] std::vector<Direction> directions_of(const algorithms::willis::Model& model);

}  // namespace sightline::programs::flight
