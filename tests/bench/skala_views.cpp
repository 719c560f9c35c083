// Skala's program on the emulated 8080: whole runs, from reset over the receipt of the commands to the halt,
// on the raster board and on a plotter; by themselves, the assembly of the program, the host computer's work
// and the native twin's. Items are T-states, where there are any.
#include <benchmark/benchmark.h>

#include <string>
#include <string_view>
#include <vector>

#include "host/guests/skala/guest.hpp"
#include "host/guests/skala/program.hpp"
#include "host/guests/skala/stream.hpp"
#include "host/guests/skala/twin/twin.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline {
namespace {

using harness::SkalaDevice;
using harness::SkalaPicture;

scene::HeightGrid grid_for(std::string_view function, SkalaPicture picture) {
  return scene::sample(*scene::height_function(function),
                       picture == SkalaPicture::contours ? scene::GridSize{33, 33} : scene::GridSize{33, 60});
}

harness::SkalaView view_of(SkalaPicture picture, SkalaDevice device) {
  harness::SkalaView view;
  view.picture = picture;
  view.device = device;
  view.rotation = 30;
  return view;
}

void assemble(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(harness::assemble_skala_program());
}

void pictures(benchmark::State& state, const std::string& function, SkalaPicture picture,
              SkalaDevice device) {
  const harness::SkalaProgram program = harness::assemble_skala_program();
  const auto stream = harness::skala_stream(grid_for(function, picture), view_of(picture, device));
  harness::SkalaGuestOptions options;
  options.device = device;
  std::int64_t t_states = 0;
  for (auto _ : state) {
    const auto result = harness::run_skala_guest(program, stream, options);
    if (result.status != harness::SkalaStatus::complete) return state.SkipWithError("the program stopped");
    t_states += result.total.count();
  }
  state.SetItemsProcessed(t_states);
}

void host_work(benchmark::State& state, SkalaPicture picture) {
  const scene::HeightGrid grid = grid_for("sinc", picture);
  const auto view = view_of(picture, SkalaDevice::ef9365);
  for (auto _ : state) benchmark::DoNotOptimize(harness::skala_stream(grid, view));
}

void twin(benchmark::State& state, SkalaPicture picture) {
  const auto stream = harness::skala_stream(grid_for("sinc", picture), view_of(picture, SkalaDevice::ef9365));
  for (auto _ : state) benchmark::DoNotOptimize(harness::run_skala_twin(stream));
}

BENCHMARK(assemble)->Name("skala_assembly")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, lines, "sinc", SkalaPicture::lines, SkalaDevice::ef9365)
    ->Name("skala_picture/sinc_lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, cosr, "cosr", SkalaPicture::lines, SkalaDevice::ef9365)
    ->Name("skala_picture/cosr_lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, surface, "sinc", SkalaPicture::surface, SkalaDevice::ef9365)
    ->Name("skala_picture/sinc_surface")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, contours, "sinc", SkalaPicture::contours, SkalaDevice::ef9365)
    ->Name("skala_picture/sinc_contours")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pictures, plot, "rogers", SkalaPicture::lines, SkalaDevice::calcomp)
    ->Name("skala_plot/rogers_lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(host_work, lines, SkalaPicture::lines)
    ->Name("skala_host/lines")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(host_work, contours, SkalaPicture::contours)
    ->Name("skala_host/contours")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(twin, lines, SkalaPicture::lines)->Name("skala_twin/lines")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(twin, contours, SkalaPicture::contours)
    ->Name("skala_twin/contours")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
