// The events that building a model reports to a listener. Each is for work done at most once per piece.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "host/algorithms/willis/order_cells.hpp"
#include "host/algorithms/willis/surface.hpp"

namespace sightline::algorithms::willis {

class Trace {
 public:
  virtual ~Trace() = default;
  // The surfaces after they are divided into order cells, and the cells.
  virtual void surfaces(std::span<const Surface> pieces, const OrderCells& cells) = 0;
  // The current clusters: pairs of pieces.
  virtual void clusters(std::span<const Surface> pieces, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) = 0;
  // The larger surface of a cluster is cut: one half keeps its number, the other gets the number `second`.
  virtual void cut(std::uint32_t piece, const std::array<Surface, 2>& halves, std::uint32_t second) = 0;
};

}  // namespace sightline::algorithms::willis
