// See decompose.hpp.
#include "host/scene/cells/decompose.hpp"

#include <utility>

#include "host/base/result.hpp"
#include "host/scene/cells/bsp/decompose.hpp"
#include "host/scene/cells/grid/decompose.hpp"

namespace sightline::scene {
namespace {

base::Result<Compartments> with_method(base::Result<CellComplex> complex, CompartmentMethod method) {
  if (!complex) return std::move(complex.error());
  return Compartments{std::move(*complex), method};
}

}  // namespace

base::Result<Compartments> compartments_of(const PolyScene& scene, CompartmentMethod method) {
  if (method != CompartmentMethod::bsp) {
    auto complex = compartment_grid(scene);
    if (method == CompartmentMethod::grid || complex.has_value())
      return with_method(std::move(complex), CompartmentMethod::grid);
  }
  return with_method(compartment_bsp(scene), CompartmentMethod::bsp);
}

base::Result<CellComplex> compartment(const PolyScene& scene, CompartmentMethod method) {
  auto result = compartments_of(scene, method);
  if (!result) return std::move(result.error());
  return std::move(*result).complex;
}

}  // namespace sightline::scene
