// Native Jones: views of a street and of random boxes in open space, where every cell sees most others, with the search
// statistics.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <utility>

#include "host/algorithms/jones/visible_edges.hpp"
#include "host/scene/cells/bsp/decompose.hpp"
#include "host/scene/cells/grid/decompose.hpp"
#include "host/scene/generate/house_beside.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline {
namespace {

using algorithms::jones::PreparedComplex;
using algorithms::jones::View;
using algorithms::jones::Walker;

// A thousand boxes are too many for the grid.
scene::CellComplex complex_of(const scene::PolyScene& scene) {
  auto complex = scene::decompose_grid(scene);
  if (!complex.has_value()) complex = scene::decompose_bsp(scene);
  return std::move(*complex);
}

void look_at(benchmark::State& state, const scene::PolyScene& scene) {
  const scene::CellComplex complex = complex_of(scene);
  const PreparedComplex prepared(complex);
  Walker walker(prepared);
  View view;
  for (auto _ : state) view = *walker.visible_edges(scene.camera);
  state.counters["cells"] = static_cast<double>(complex.cells.size());
  state.counters["visits"] = static_cast<double>(view.counts.visits);
  state.counters["openings"] = static_cast<double>(view.counts.openings_tested);
  state.counters["lines"] = static_cast<double>(view.counts.lines_clipped);
  state.counters["fragments"] = static_cast<double>(view.counts.fragments);
  state.counters["segments"] = static_cast<double>(view.picture.pieces.size());
}

void street(benchmark::State& state) {
  look_at(state, scene::poly_scene_of(*scene::load_cell_scene("street4")));
}
void boxes(benchmark::State& state) {
  look_at(state, scene::generate_boxes(static_cast<std::size_t>(state.range(0))));
}
// From within the corner room: the hidden part grows. The visible lines on the few cells above the rooms, which have no
// ceilings, grow as well.
void rooms(benchmark::State& state) {
  scene::PolyScene scene = scene::generate_big_rooms(static_cast<std::size_t>(state.range(0)));
  scene.camera.eye = {90, 110, 70};
  look_at(state, scene);
}

// The same view from a closed house next to a building of `size` rooms per side.
void house(benchmark::State& state) {
  look_at(state, scene::generate_house_beside(static_cast<std::size_t>(state.range(0))));
}

BENCHMARK(street)->Name("jones_native/view_of_street4")->Unit(benchmark::kMicrosecond);
BENCHMARK(boxes)
    ->Name("jones_native/view_of_boxes")
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(rooms)
    ->Name("jones_native/view_of_big_rooms")
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(house)
    ->Name("jones_native/view_of_house_beside")
    ->Arg(3)
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace sightline
