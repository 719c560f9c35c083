// PLplot's plot3d on the grid of `skala_native/lines_both`, with both families of lines, into its null device: the cost of
// hidden lines of a surface there. Built only where PLplot is installed (Debian: libplplot-dev). CPU time of the whole call,
// compared with draw(): projection, comparison and the drawing in memory.
#include <benchmark/benchmark.h>
#include <plplot.h>

#include <vector>

#include "host/scene/heights/function.hpp"

namespace sightline {
namespace {

class NullDevice {
 public:
  NullDevice() {
    plsdev("null");
    plsfnam("/dev/null");
    plinit();
  }
  NullDevice(const NullDevice&) = delete;
  NullDevice& operator=(const NullDevice&) = delete;
  ~NullDevice() { plend(); }
};

void plot3d_both(benchmark::State& state) {
  const scene::HeightGrid grid = sample(*scene::height_function("sinc"), scene::largest_grid);
  // Indexed by x first.
  std::vector<std::vector<PLFLT>> heights(grid.points(), std::vector<PLFLT>(grid.slices()));
  std::vector<const PLFLT*> rows;
  for (std::size_t x = 0; x < grid.points(); ++x) {
    for (std::size_t z = 0; z < grid.slices(); ++z) heights[x][z] = grid.height(x, z);
    rows.push_back(heights[x].data());
  }
  const NullDevice device;
  for (auto _ : state) {
    state.PauseTiming();
    pladv(0);
    plvpor(0, 1, 0, 1);
    plwind(-1.5, 1.5, -1.5, 1.5);
    constexpr PLFLT elevation = 30;
    constexpr PLFLT rotation = 30;
    plw3d(1, 1, 0.6, -1, 1, -1, 1, grid.range.low, grid.range.high, elevation, rotation);
    state.ResumeTiming();
    plot3d(grid.x.data(), grid.z.data(), rows.data(), static_cast<PLINT>(grid.points()),
           static_cast<PLINT>(grid.slices()), DRAW_LINEXY, 0);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * grid.heights.size()));
}

BENCHMARK(plot3d_both)->Name("plplot/plot3d_both")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
