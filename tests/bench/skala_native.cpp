// Skala's method, native, on the largest grid: the cost of finding the visible parts, and of writing the SVG as well.
// Items are points of the grid.
#include <benchmark/benchmark.h>

#include "host/algorithms/skala/draw.hpp"
#include "host/algorithms/skala/surface.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline {
namespace {

using algorithms::skala::Family;
using algorithms::skala::View;

View view_of(Family family) {
  View view;
  view.family = family;
  view.rotation = 30;
  return view;
}

scene::HeightGrid sinc() {
  return sample(*scene::height_function("sinc"), scene::largest_grid);
}

void count(benchmark::State& state, const scene::HeightGrid& grid) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * grid.heights.size()));
}

// The part of `lines` before any visibility test.
void projection(benchmark::State& state) {
  const scene::HeightGrid grid = sinc();
  for (auto _ : state) {
    const algorithms::skala::Surface surface(grid, view_of(Family::along_x), Family::along_x);
    benchmark::DoNotOptimize(surface.at(0, 0));
  }
  count(state, grid);
}

void lines(benchmark::State& state, Family family) {
  const scene::HeightGrid grid = sinc();
  for (auto _ : state) benchmark::DoNotOptimize(draw(grid, view_of(family)).points.data());
  count(state, grid);
}

void lines_and_svg(benchmark::State& state, Family family) {
  const scene::HeightGrid grid = sinc();
  for (auto _ : state) benchmark::DoNotOptimize(svg_of(draw(grid, view_of(family)), {}, "sinc").data());
  count(state, grid);
}

BENCHMARK(projection)->Name("skala_native/projection")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lines, x, Family::along_x)
    ->Name("skala_native/lines_along_x")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lines, both, Family::both)->Name("skala_native/lines_both")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lines_and_svg, x, Family::along_x)
    ->Name("skala_native/svg_along_x")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lines_and_svg, both, Family::both)
    ->Name("skala_native/svg_both")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
