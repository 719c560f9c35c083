// See decompose.hpp.
#include "host/scene/cells/decompose.hpp"

#include <utility>

#include "host/base/result.hpp"
#include "host/scene/cells/bsp/decompose.hpp"
#include "host/scene/cells/grid/decompose.hpp"

namespace sightline::scene {
namespace {

base::Result<Decomposition> with_method(base::Result<CellComplex> complex, DecompositionMethod method) {
  if (!complex) return std::move(complex.error());
  return Decomposition{std::move(*complex), method};
}

}  // namespace

base::Result<Decomposition> decomposition_of(const PolyScene& scene, DecompositionMethod method) {
  if (method != DecompositionMethod::bsp) {
    auto complex = decompose_grid(scene);
    if (method == DecompositionMethod::grid || complex.has_value())
      return with_method(std::move(complex), DecompositionMethod::grid);
  }
  return with_method(decompose_bsp(scene), DecompositionMethod::bsp);
}

base::Result<CellComplex> decompose(const PolyScene& scene, DecompositionMethod method) {
  auto result = decomposition_of(scene, method);
  if (!result) return std::move(result.error());
  return std::move(*result).complex;
}

}  // namespace sightline::scene
