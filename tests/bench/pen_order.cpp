// The pen order of short lines all over a sheet.
#include "host/picture/pen_order.hpp"

#include <benchmark/benchmark.h>

#include <random>

namespace {

using namespace sightline::picture;

void bench_pen_order(benchmark::State& state) {
  std::mt19937 random(1);
  const auto place = [&] { return static_cast<float>(random() % 200'000) / 1000; };
  VectorDrawing drawing;
  drawing.width = drawing.height = 200;
  drawing.layers = {{"visible", {0, 0, 0}}};
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    const DrawingPoint from{place(), place()};
    drawing.lines.push_back({0, static_cast<std::uint32_t>(drawing.points.size()), 2});
    drawing.points.insert(drawing.points.end(), {from, {from.x + place() / 50, from.y + place() / 50}});
  }
  for (auto _ : state) benchmark::DoNotOptimize(in_pen_order(drawing, {200, 200, 0, 0.2}).lines.data());
}
BENCHMARK(bench_pen_order)->Name("pen_order/lines")->Arg(1000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
