// Plantinga, Seales and Dyer's rotation of the six models: preprocessing on all cores and on one, an on-line frame compared with
// a wire frame, as positions alone and drawn as pixels, and events per second.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <numbers>
#include <string>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/table_1.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline {
namespace {

namespace native = algorithms::plantinga;

constexpr std::array<const char*, 6> names{"squares", "grid", "objects", "bars", "tori", "spring"};

native::RotationModel model_of(std::size_t which) {
  const auto text = scene::builtin_scene_text(names[which]);
  if (!text) std::abort();
  return native::RotationModel(scene::read_poly(*text, names[which], scene::PolyFormat::off)->scene);
}

struct Turned {
  explicit Turned(std::size_t which) : model(model_of(which)), list(*native::build_event_list(model)) {}
  native::RotationModel model;
  native::EventList list;
};

const Turned& turned_model(std::size_t which) {
  static std::map<std::size_t, std::unique_ptr<Turned>> made;
  auto& one = made[which];
  if (!one) one = std::make_unique<Turned>(which);
  return *one;
}

void preprocessing(benchmark::State& state) {
  const auto which = static_cast<std::size_t>(state.range(0));
  const native::RotationModel model = model_of(which);
  native::BuildOptions options;
  options.threads = static_cast<unsigned>(state.range(1));
  native::Table1Row row;
  for (auto _ : state) {
    row = native::table_1_row(names[which], model, *native::build_event_list(model, options), 0);
  }
  state.SetLabel(names[which]);
  state.counters["changes"] = static_cast<double>(row.events);
  state.counters["directions"] = static_cast<double>(row.directions);
  state.counters["a_edge"] = row.events_per_edge;
  state.counters["most"] = static_cast<double>(row.most_events_per_edge);
  state.counters["bytes_a_change"] = row.kilobytes * 1024 / static_cast<double>(row.events);
}

// Draws lines as the cheapest display would: one pixel per step of the longer axis, 1024 across.
std::size_t draw(const std::vector<native::ImageLine>& lines, double scale,
                 std::vector<std::uint8_t>& pixels) {
  std::size_t lit = 0;
  for (const native::ImageLine& line : lines) {
    const double dx = (line.u1 - line.u0) * scale;
    const double dy = (line.v1 - line.v0) * scale;
    const int steps = static_cast<int>(std::max(std::abs(dx), std::abs(dy))) + 1;
    double x = 512 + line.u0 * scale;
    double y = 512 + line.v0 * scale;
    for (int i = 0; i <= steps; ++i, x += dx / steps, y += dy / steps) {
      pixels[(static_cast<std::size_t>(y) & 1023U) * 1024 + (static_cast<std::size_t>(x) & 1023U)] = 255;
      ++lit;
    }
  }
  return lit;
}

double scale_of(const native::RotationModel& model) {
  double reach = 1;
  for (const auto& v : model.vertices()) {
    for (const std::int64_t c : v) reach = std::max(reach, std::abs(static_cast<double>(c)));
  }
  return 350 / reach;
}

// range(1): 0 visible, 1 wire; range(2): 1 with pixels. Frames 2 degrees apart.
void frame(benchmark::State& state) {
  const auto which = static_cast<std::size_t>(state.range(0));
  const Turned& one = turned_model(which);
  native::EdgeStructureGraph graph(one.list);
  native::FrameMaker frames(one.model);
  const double scale = scale_of(one.model);
  std::vector<native::ImageLine> lines;
  std::vector<std::uint8_t> pixels(1024 * 1024);
  double angle = 0;
  for (auto _ : state) {
    angle += 2 * std::numbers::pi / 180;
    if (state.range(1) != 0) {
      frames.wire(angle, lines);
    } else {
      graph.turn_to(angle);
      frames.visible(graph, angle, lines);
    }
    benchmark::DoNotOptimize(lines.data());
    if (state.range(2) != 0) benchmark::DoNotOptimize(draw(lines, scale, pixels));
  }
  state.SetLabel(std::string(names[which]) + (state.range(1) != 0 ? " wire" : " visible") +
                 (state.range(2) != 0 ? " drawn" : ""));
  state.counters["lines"] = static_cast<double>(lines.size());
}

void events(benchmark::State& state) {
  const auto which = static_cast<std::size_t>(state.range(0));
  const Turned& one = turned_model(which);
  native::EdgeStructureGraph graph(one.list);
  for (auto _ : state) benchmark::DoNotOptimize(graph.step_forward());
  state.SetLabel(names[which]);
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(preprocessing)
    ->Name("plantinga/preprocessing")
    ->ArgsProduct({{0, 1, 2, 3, 4, 5}, {0, 1}})
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);
BENCHMARK(frame)
    ->Name("plantinga/frame")
    ->ArgsProduct({{0, 1, 2, 3, 4, 5}, {0, 1}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(events)->Name("plantinga/events")->DenseRange(0, 5);

}  // namespace
}  // namespace sightline
