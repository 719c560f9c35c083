// Exact hidden-line views of the random boxes, with and without preparing the scene, and the oracle's view of the same scene
// as the slow baseline.
#include <benchmark/benchmark.h>

#include <cstddef>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline {
namespace {

void report(benchmark::State& state, const picture::LinePicture& picture) {
  state.counters["segments"] = static_cast<double>(picture.pieces.size());
}

void exact_view(benchmark::State& state) {
  const scene::PolyScene scene = scene::generate_boxes(static_cast<std::size_t>(state.range(0)));
  const algorithms::exact::EdgeMesh mesh = algorithms::exact::make_edge_mesh(scene);
  picture::LinePicture picture;
  for (auto _ : state) picture = algorithms::exact::visible_edges(mesh, scene.camera);
  report(state, picture);
}

void exact_layout_and_view(benchmark::State& state) {
  const scene::PolyScene scene = scene::generate_boxes(static_cast<std::size_t>(state.range(0)));
  picture::LinePicture picture;
  for (auto _ : state) picture = algorithms::exact::visible_edges(scene, scene.camera);
  report(state, picture);
}

void oracle_view(benchmark::State& state) {
  const scene::PolyScene scene = scene::generate_boxes(static_cast<std::size_t>(state.range(0)));
  picture::LinePicture picture;
  for (auto _ : state) picture = algorithms::oracle::visible_edges(scene, scene.camera);
  report(state, picture);
}

BENCHMARK(exact_view)
    ->Name("exact/view_of_boxes")
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(exact_layout_and_view)
    ->Name("exact/layout_and_view_of_boxes")
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(oracle_view)->Name("oracle/view_of_boxes")->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
