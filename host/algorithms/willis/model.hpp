// A model whose surfaces can be put in order by distance: what Willis (1977) computes once, when the model is
// created, so that a frame needs no more than one distance for each surface.
//
// Surfaces that touch are kept apart by order cells; within a cell, of every cluster of two the larger
// surface is cut, until there is no cluster left or a limit is reached. What could not be separated is
// listed: for those pairs, from some viewpoints, distance may give the wrong order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/willis/boundary.hpp"
#include "host/algorithms/willis/order_cells.hpp"
#include "host/algorithms/willis/surface.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

struct Limits {
  int depth = 30;             // cuts of one surface; the lattice allows 12 halvings of an edge anyway
  int touching_depth = 4;     // of surfaces that touch their partner: no number of cuts would do
  std::int32_t smallest = 0;  // surfaces of at most this diameter, in scene units, are not cut
  std::size_t pieces = 1'000'000;
  // Of a scene: pairs of pieces whose boundaries are compared, counted after each round of cuts. Beyond it the scene is refused.
  std::size_t tests = std::numeric_limits<std::size_t>::max();
};

struct ModelOptions {
  PairRules rules{};
  bool order_cells = true;
  // The paper's plan view: walls only, eyes at any height between their feet and their tops. Distances are
  // measured in plan, so that heights make no surface longer.
  bool plan = false;
  std::size_t vertical = 1;  // axis, for plan
  Limits limits{};
};

enum class ResidualReason {
  depth,     // the limit of cuts
  size,      // the smallest size
  pieces,    // the limit of pieces
  lattice,   // the larger surface has no middle left on the lattice
  touching,  // the larger surface touches or crosses another one, and no order cell separates the two
};

[[nodiscard]] std::string_view name_of(ResidualReason reason);

struct Residual {
  std::uint32_t first = 0;  // pieces
  std::uint32_t second = 0;
  ResidualReason reason = ResidualReason::depth;
};

struct Model {
  std::vector<Surface> pieces;
  OrderCells cells;
  std::vector<Residual> residual;
  std::size_t surfaces = 0;  // before anything was cut
  std::size_t clusters = 0;  // pairs, before anything was cut for them
  std::size_t tests = 0;     // pairs of which one can obscure the other and whose boundaries were looked at
  bool plan = false;
  std::size_t vertical = 1;
};

// The scene is a checked one (precondition). Errors: as surfaces_of and walls_of; more tests than the limit.
class Trace;  // trace.hpp; null: nobody watches
[[nodiscard]] base::Result<Model> make_model(const scene::PolyScene& scene, const ModelOptions& options = {}, Trace* trace = nullptr);
// The same of surfaces, whatever they are faces of.
[[nodiscard]] Model make_model(std::vector<Surface> surfaces, const ModelOptions& options = {}, Trace* trace = nullptr);

// The residual by faces of the scene, each pair of faces once, with what was in the way: one line each
// without a line end.
[[nodiscard]] std::vector<std::string> residual_lines(const Model& model, const scene::PolyScene& scene);

}  // namespace sightline::algorithms::willis
