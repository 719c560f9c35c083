// The same view of the same rooms while a building beside them, of which nothing is seen, grows.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "host/algorithms/jones/visible_edges.hpp"
#include "host/report/report.hpp"

namespace sightline::harness::report {

// A house beside a building (scene::generate_house_beside), ready to be looked at. Stays where it is, since
// views point into it.
struct LoadedBuilding {
  LoadedBuilding(std::size_t rooms_a_side, scene::CellComplex cells, const scene::PolyCamera& in_house)
      : side(rooms_a_side),
        complex(std::move(cells)),
        prepared(complex),
        walker(prepared),
        camera(in_house) {}
  LoadedBuilding(const LoadedBuilding&) = delete;
  LoadedBuilding& operator=(const LoadedBuilding&) = delete;

  std::size_t side;
  scene::CellComplex complex;
  algorithms::jones::PreparedComplex prepared;
  algorithms::jones::Walker walker;
  scene::PolyCamera camera;
};

// Looks from the house of each in turn. An error if the views differ in more than time: in a piece of the
// picture or in anything that was counted.
[[nodiscard]] Outcome<Table> views_from_house(const std::vector<std::unique_ptr<LoadedBuilding>>& buildings,
                                              const Context& context);

}  // namespace sightline::harness::report
