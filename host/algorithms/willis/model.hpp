// A model whose surfaces can be ordered by distance. It is what Willis (1977) computes once, when the model is created,
// so that a frame needs only one distance per surface.
//
// Surfaces that touch are separated by order cells. Within a cell, the larger surface of every cluster of two is cut,
// until there is no cluster left or a limit is reached. Clusters that remain are listed in `residual`: for these pairs,
// distance may give the wrong order from some viewpoints.
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
  int depth = 30;             // cuts of one surface; the lattice allows only 12 halvings of an edge
  int touching_depth = 4;     // the same for surfaces that touch their partner, for which no number of cuts would suffice
  std::int32_t smallest = 0;  // surfaces of at most this diameter, in scene units, are not cut
  std::size_t pieces = 1'000'000;
  // For a scene: pairs of pieces whose boundaries are compared, counted after each round of cuts. A scene that needs more
  // is rejected.
  std::size_t tests = std::numeric_limits<std::size_t>::max();
};

struct ModelOptions {
  PairRules rules{};
  bool order_cells = true;
  // The paper's plan view: walls only, eyes at any height between their feet and their tops. Distances are measured in
  // plan, so heights do not make surfaces longer.
  bool plan = false;
  std::size_t vertical = 1;  // the vertical axis, for plan
  Limits limits{};
};

enum class ResidualReason {
  depth,     // the limit of cuts
  size,      // the smallest size
  pieces,    // the limit of pieces
  lattice,   // the larger surface cannot be halved at lattice points
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
  std::size_t surfaces = 0;  // before any cut
  std::size_t clusters = 0;  // pairs, before any cut
  std::size_t tests = 0;     // pairs of which one can obscure the other and whose boundaries were compared
  bool plan = false;
  std::size_t vertical = 1;
};

// Precondition: the scene is checked. Errors: those of surfaces_of and walls_of; more tests than the limit.
class Trace;  // trace.hpp; may be null
[[nodiscard]] base::Result<Model> make_model(const scene::PolyScene& scene, const ModelOptions& options = {}, Trace* trace = nullptr);
// The same for surfaces, whatever faces they belong to.
[[nodiscard]] Model make_model(std::vector<Surface> surfaces, const ModelOptions& options = {}, Trace* trace = nullptr);

// The residual by faces of the scene: for each pair of faces one line, without a line end, with the reason.
[[nodiscard]] std::vector<std::string> residual_lines(const Model& model, const scene::PolyScene& scene);

}  // namespace sightline::algorithms::willis
