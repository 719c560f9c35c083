// Montani and Re's algorithm: a view in object space (exact), in stripes of a pixel on a raster of 1024, and by `exact`, of
// boxes and of towns of 100, 1000 and 10000 faces, interleaved in one run; and their growth with the number of faces, compared
// with the paper's claim, N Y. Y is the number of faces that a face overlaps in X.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <array>
#include <cstddef>
#include <string_view>

#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/report/experiments/montani_re_growth.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline {
namespace {

// Repeated views by the exact algorithm alone.
void exact_view(benchmark::State& state) {
  const auto size = static_cast<std::size_t>(state.range(1));
  const scene::PolyScene scene =
      state.range(0) == 0 ? scene::generate_boxes(size) : scene::generate_town(size);
  std::size_t segments = 0;
  for (auto _ : state) {
    const auto drawn = algorithms::montani_re::visible_edges(scene, scene.camera);
    segments = drawn->picture.pieces.size();
  }
  state.counters["segments"] = static_cast<double>(segments);
}

void growth(benchmark::State& state, std::string_view family) {
  constexpr std::array<std::size_t, 3> sizes{100, 1000, 10000};
  constexpr int rounds = 3;
  report::Records records;
  for (auto _ : state) {
    records.clear();
    report::add_montani_re_growth(records, family, sizes, rounds, [](std::string_view) {});
  }
  const auto number = [&](const char* set, std::size_t row, std::string_view key) {
    return records.at(set).at(row, key).number().value_or(0);
  };
  for (std::size_t row = 0; row < sizes.size(); ++row)
    for (const char* const build : {"exact_build", "stripes", "exact"})
      state.counters[fmt::format("{}_{}_ms", build, sizes[row])] =
          number("views", row, fmt::format("{}_ms", build));
  state.SetLabel(
      fmt::format("growth with faces: exact build N^{:.2f}, stripes of a pixel N^{:.2f}, exact N^{:.2f}; "
                  "the paper's N Y is N^{:.2f}",
                  number("exponents", 0, "exact_build"), number("exponents", 0, "stripes"),
                  number("exponents", 0, "exact"), number("exponents", 0, "pairs")));
}

BENCHMARK(exact_view)
    ->Name("montani_re/exact_view")
    ->ArgsProduct({{0, 1}, {100, 1000}})
    ->ArgNames({"town", "n"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(growth, boxes, "boxes")
    ->Name("montani_re/growth/boxes")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(growth, town, "town")
    ->Name("montani_re/growth/town")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace sightline
