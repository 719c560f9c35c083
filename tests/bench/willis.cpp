// Willis: building models, ordering frames, and the priority display's time for a picture of 512 by 512.
#include <benchmark/benchmark.h>

#include <cstddef>

#include "host/algorithms/registry/willis_display.hpp"
#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline {
namespace {

namespace willis = algorithms::willis;

willis::Model town_model(std::size_t size) {
  auto model = willis::make_model(scene::generate_town(size));
  return std::move(*model);
}

void report(benchmark::State& state, const willis::Model& model) {
  state.counters["surfaces"] = static_cast<double>(model.surfaces);
  state.counters["pieces"] = static_cast<double>(model.pieces.size());
  state.counters["residual"] = static_cast<double>(model.residual.size());
}

// 167 buildings are 1,002 surfaces.
void uncluster(benchmark::State& state) {
  const scene::PolyScene scene = scene::generate_town(static_cast<std::size_t>(state.range(0)));
  const bool plan = state.range(1) != 0;
  willis::ModelOptions options;
  options.plan = plan;
  for (auto _ : state) {
    auto model = willis::make_model(scene, options);
    benchmark::DoNotOptimize(model);
  }
  report(state, *willis::make_model(scene, options));
}

void order_frame(benchmark::State& state) {
  const scene::PolyScene scene = scene::generate_town(static_cast<std::size_t>(state.range(0)));
  const willis::Model model = town_model(static_cast<std::size_t>(state.range(0)));
  willis::Frames frames(model);
  for (auto _ : state) benchmark::DoNotOptimize(frames.order(scene.camera));
  report(state, model);
  state.counters["time_a_piece"] =
      benchmark::Counter(static_cast<double>(model.pieces.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void display_frame(benchmark::State& state) {
  const scene::PolyScene scene = scene::generate_town(static_cast<std::size_t>(state.range(0)));
  const willis::Model model = town_model(static_cast<std::size_t>(state.range(0)));
  const willis::ImageWindow window = willis::window_around(scene, scene.camera, 512, 512);
  willis::Frames frames(model);
  willis::FrameSpans spans;
  registry::WillisDisplay display;
  for (auto _ : state) {
    willis::make_spans(model, frames.order(scene.camera), scene.camera, window, spans);
    benchmark::DoNotOptimize(registry::show_on_display(spans, display));
  }
  state.counters["frames_a_second"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["spans"] = static_cast<double>(spans.spans.size());
}

BENCHMARK(uncluster)
    ->Name("willis/uncluster_town")
    ->Args({17, 0})
    ->Args({167, 0})
    ->Args({1667, 0})
    ->Args({167, 1})
    ->ArgNames({"buildings", "plan"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(order_frame)->Name("willis/order_frame")->Arg(17)->Arg(167)->Unit(benchmark::kMicrosecond);
BENCHMARK(display_frame)->Name("willis/display_frame")->Arg(17)->Arg(167)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
