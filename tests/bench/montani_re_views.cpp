// Montani and Re's algorithm: a view in object space (exact), and in stripes of a pixel on a raster of 1024,
// of boxes and of towns. MEASURED.md has the exponents fitted to these.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <variant>

#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/scene/generate_scene.hpp"

namespace sightline {
namespace {

namespace native = algorithms::montani_re;

scene::PolyScene scene_of(const benchmark::State& state) {
  const auto size = static_cast<std::size_t>(state.range(1));
  return state.range(0) == 0 ? scene::generate_boxes(size) : scene::generate_town(size);
}

void exact_view(benchmark::State& state) {
  const scene::PolyScene scene = scene_of(state);
  native::LineView view;
  for (auto _ : state) view = std::get<native::LineView>(native::visible_edges(scene, scene.camera));
  state.counters["segments"] = static_cast<double>(view.picture.pieces.size());
  state.counters["relations"] = static_cast<double>(view.counts.relations);
}

// All of the image of the scene on 1024 pixels.
native::StripeFrame frame_of(const native::FaceSet& set, const scene::PolyCamera& camera) {
  std::array<double, 2> low{};
  std::array<double, 2> high{};
  for (const native::Face& face : set.faces) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], face.low[axis].approximate);
      high[axis] = std::max(high[axis], face.high[axis].approximate);
    }
  }
  native::StripeFrame frame{{}, {}, 1024, 1024};
  const auto unit = native::pixels_a_unit(camera, 1);
  const double size = std::max((high[0] - low[0]) * unit[0], (high[1] - low[1]) * unit[1]);
  frame.scale = native::pixels_a_unit(camera, 1024 / size);
  for (std::size_t axis = 0; axis < 2; ++axis) frame.centre[axis] = -low[axis] * frame.scale[axis];
  return frame;
}

// Relations and list, then the raster: as a whole, since that is a view.
void stripes_view(benchmark::State& state) {
  const scene::PolyScene scene = scene_of(state);
  native::StripeRaster raster;
  for (auto _ : state) {
    const auto faces = native::faces_of(scene, scene.camera);
    const auto& set = std::get<native::FaceSet>(faces);
    const native::ListedFaces listed = native::listed_faces(set);
    raster =
        native::raster_by_difference(set.image, listed.list, listed.faces, frame_of(set, scene.camera), 16);
  }
  state.counters["sides"] = static_cast<double>(raster.sides);
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const std::int64_t size : {100, 1000, 10000}) bench->Args({0, size});
  for (const std::int64_t size : {100, 1000, 10000}) bench->Args({1, size});
  bench->ArgNames({"town", "n"})->Unit(benchmark::kMillisecond);
}

BENCHMARK(exact_view)->Name("montani_re/exact_view")->Apply(sizes);
BENCHMARK(stripes_view)->Name("montani_re/view_in_stripes_of_a_pixel")->Apply(sizes);

}  // namespace
}  // namespace sightline
