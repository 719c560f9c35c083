// Decomposition by grid: boxes, whose grid is large, and a building, whose grid is not. Items are cells.
#include <benchmark/benchmark.h>

#include <cstdint>

#include "host/scene/cells/grid/decompose.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline {
namespace {

void cut(benchmark::State& state, const scene::PolyScene& scene) {
  std::size_t cells = 0;
  for (auto _ : state) cells += scene::decompose_grid(scene)->cells.size();
  state.SetItemsProcessed(static_cast<std::int64_t>(cells));
}

void boxes(benchmark::State& state) {
  cut(state, scene::generate_boxes(static_cast<std::size_t>(state.range(0))));
}

// Size: rooms per side.
void building(benchmark::State& state) {
  cut(state, scene::generate_big_rooms(static_cast<std::size_t>(state.range(0))));
}

BENCHMARK(boxes)->Name("decompose_grid/boxes")->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(building)
    ->Name("decompose_grid/building")
    ->Arg(10)
    ->Arg(32)
    ->Arg(100)
    ->Arg(316)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
