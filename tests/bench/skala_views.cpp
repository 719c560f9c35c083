// Skala's program on the emulated 8080: whole runs, from reset through the receipt of the commands to the halt, on the raster
// board and on a plotter; separately, the assembly of the program, the host computer's work and the native twin. Items are
// T-states where there are any.
#include <benchmark/benchmark.h>

#include <string>
#include <string_view>
#include <vector>

#include "host/programs/skala/machine.hpp"
#include "host/programs/skala/program.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/programs/skala/twin/twin.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline {
namespace {

using programs::skala::Device;
using algorithms::skala::Subject;

scene::HeightGrid grid_for(std::string_view function, algorithms::skala::Subject picture) {
  return scene::sample(*scene::height_function(function), picture == algorithms::skala::Subject::contours
                                                              ? scene::GridSize{33, 33}
                                                              : scene::GridSize{33, 60});
}

algorithms::skala::View view_of(algorithms::skala::Subject picture) {
  algorithms::skala::View view;
  view.subject = picture;
  view.silhouette = picture == Subject::contours;
  view.rotation = 30;
  return view;
}

void assemble(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(programs::skala::assemble_program());
}

void pictures(benchmark::State& state, const std::string& function, algorithms::skala::Subject picture,
              programs::skala::Device device) {
  const programs::skala::Program& program = programs::skala::resident_program();
  const auto stream = programs::skala::stream_of(grid_for(function, picture), view_of(picture), {device});
  programs::skala::MachineOptions options;
  options.device = device;
  std::int64_t t_states = 0;
  for (auto _ : state) {
    const auto result = programs::skala::run_machine(program, stream, options);
    if (result.status != programs::skala::Status::complete) return state.SkipWithError("the program stopped");
    t_states += result.total.count();
  }
  state.SetItemsProcessed(t_states);
}

void host_work(benchmark::State& state, algorithms::skala::Subject picture) {
  const scene::HeightGrid grid = grid_for("sinc", picture);
  const auto view = view_of(picture);
  for (auto _ : state) benchmark::DoNotOptimize(programs::skala::stream_of(grid, view));
}

void twin(benchmark::State& state, algorithms::skala::Subject picture) {
  const auto stream =
      programs::skala::stream_of(grid_for("sinc", picture), view_of(picture));
  for (auto _ : state) benchmark::DoNotOptimize(programs::skala::run_twin(stream));
}

BENCHMARK(assemble)->Name("skala_assembly")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, lines, "sinc", algorithms::skala::Subject::lines, programs::skala::Device::ef9365)
    ->Name("skala_picture/sinc_lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, cosr, "cosr", algorithms::skala::Subject::lines, programs::skala::Device::ef9365)
    ->Name("skala_picture/cosr_lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, surface, "sinc", algorithms::skala::Subject::surface,
                  programs::skala::Device::ef9365)
    ->Name("skala_picture/sinc_surface")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, contours, "sinc", algorithms::skala::Subject::contours,
                  programs::skala::Device::ef9365)
    ->Name("skala_picture/sinc_contours")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, plot, "rogers", algorithms::skala::Subject::lines, programs::skala::Device::calcomp)
    ->Name("skala_plot/rogers_lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(host_work, lines, algorithms::skala::Subject::lines)
    ->Name("skala_host/lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(host_work, contours, algorithms::skala::Subject::contours)
    ->Name("skala_host/contours")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(twin, lines, algorithms::skala::Subject::lines)
    ->Name("skala_twin/lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(twin, contours, algorithms::skala::Subject::contours)
    ->Name("skala_twin/contours")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
