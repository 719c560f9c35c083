// Skala's program on the emulated 8080: whole runs, from reset over the receipt of the commands to the halt,
// on the raster board and on a plotter; by themselves, the assembly of the program, the host computer's work
// and the native twin's. Items are T-states, where there are any.
#include <benchmark/benchmark.h>

#include <string>
#include <string_view>
#include <vector>

#include "host/programs/skala/guest.hpp"
#include "host/programs/skala/program.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/programs/skala/twin/twin.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline {
namespace {

using programs::skala::Device;
using programs::skala::PictureKind;

scene::HeightGrid grid_for(std::string_view function, programs::skala::PictureKind picture) {
  return scene::sample(*scene::height_function(function), picture == programs::skala::PictureKind::contours
                                                              ? scene::GridSize{33, 33}
                                                              : scene::GridSize{33, 60});
}

programs::skala::View view_of(programs::skala::PictureKind picture, programs::skala::Device device) {
  programs::skala::View view;
  view.picture = picture;
  view.device = device;
  view.rotation = 30;
  return view;
}

void assemble(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(programs::skala::assemble_program());
}

void pictures(benchmark::State& state, const std::string& function, programs::skala::PictureKind picture,
              programs::skala::Device device) {
  const programs::skala::Program program = programs::skala::assemble_program();
  const auto stream = programs::skala::stream_of(grid_for(function, picture), view_of(picture, device));
  programs::skala::GuestOptions options;
  options.device = device;
  std::int64_t t_states = 0;
  for (auto _ : state) {
    const auto result = programs::skala::run_guest(program, stream, options);
    if (result.status != programs::skala::Status::complete) return state.SkipWithError("the program stopped");
    t_states += result.total.count();
  }
  state.SetItemsProcessed(t_states);
}

void host_work(benchmark::State& state, programs::skala::PictureKind picture) {
  const scene::HeightGrid grid = grid_for("sinc", picture);
  const auto view = view_of(picture, programs::skala::Device::ef9365);
  for (auto _ : state) benchmark::DoNotOptimize(programs::skala::stream_of(grid, view));
}

void twin(benchmark::State& state, programs::skala::PictureKind picture) {
  const auto stream =
      programs::skala::stream_of(grid_for("sinc", picture), view_of(picture, programs::skala::Device::ef9365));
  for (auto _ : state) benchmark::DoNotOptimize(programs::skala::run_twin(stream));
}

BENCHMARK(assemble)->Name("skala_assembly")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, lines, "sinc", programs::skala::PictureKind::lines, programs::skala::Device::ef9365)
    ->Name("skala_picture/sinc_lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, cosr, "cosr", programs::skala::PictureKind::lines, programs::skala::Device::ef9365)
    ->Name("skala_picture/cosr_lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, surface, "sinc", programs::skala::PictureKind::surface,
                  programs::skala::Device::ef9365)
    ->Name("skala_picture/sinc_surface")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, contours, "sinc", programs::skala::PictureKind::contours,
                  programs::skala::Device::ef9365)
    ->Name("skala_picture/sinc_contours")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, plot, "rogers", programs::skala::PictureKind::lines, programs::skala::Device::calcomp)
    ->Name("skala_plot/rogers_lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(host_work, lines, programs::skala::PictureKind::lines)
    ->Name("skala_host/lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(host_work, contours, programs::skala::PictureKind::contours)
    ->Name("skala_host/contours")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(twin, lines, programs::skala::PictureKind::lines)
    ->Name("skala_twin/lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(twin, contours, programs::skala::PictureKind::contours)
    ->Name("skala_twin/contours")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
