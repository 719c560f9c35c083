// See decompose.hpp.
#include "host/scene/cells/decompose.hpp"

#include <utility>

#include "host/scene/cells/bsp/decompose.hpp"
#include "host/scene/cells/grid/decompose.hpp"

namespace sightline::scene {
namespace {

std::variant<Compartments, SceneError> with_method(std::variant<CellComplex, SceneError> complex,
                                                   CompartmentMethod method) {
  if (auto* error = std::get_if<SceneError>(&complex)) return std::move(*error);
  return Compartments{std::get<CellComplex>(std::move(complex)), method};
}

}  // namespace

std::variant<Compartments, SceneError> compartments_of(const PolyScene& scene, CompartmentMethod method) {
  if (method != CompartmentMethod::bsp) {
    auto complex = compartment_grid(scene);
    if (method == CompartmentMethod::grid || std::holds_alternative<CellComplex>(complex))
      return with_method(std::move(complex), CompartmentMethod::grid);
  }
  return with_method(compartment_bsp(scene), CompartmentMethod::bsp);
}

std::variant<CellComplex, SceneError> compartment(const PolyScene& scene, CompartmentMethod method) {
  auto result = compartments_of(scene, method);
  if (auto* error = std::get_if<SceneError>(&result)) return std::move(*error);
  return std::get<Compartments>(std::move(result)).complex;
}

}  // namespace sightline::scene
