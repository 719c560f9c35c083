// Jones's program on the emulated machine: two views of a scene, from START on, with the EAE and the display; separately, the
// assembly of the program with the scene. Items are PDP-7 instructions, or words of core for the assembly.
#include <benchmark/benchmark.h>

#include <string>

#include "host/programs/jones/jones.hpp"
#include "host/programs/jones/program.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline {
namespace {

namespace jones = programs::jones;

// Returns nullptr after reporting the error to the benchmark.
template <class Good, class Result>
const Good* good(benchmark::State& state, const Result& result) {
  if (result) return &*result;
  state.SkipWithError(result.error().message().c_str());
  return nullptr;
}

void assemble(benchmark::State& state, const std::string& name) {
  const auto read = scene::read_cell_scene(*scene::builtin_scene_text(name), name);
  const auto* scene = good<scene::CellScene>(state, read);
  if (scene == nullptr) return;
  std::int64_t words = 0;
  for (auto _ : state) {
    const auto assembled = jones::assemble_program(*scene);
    const auto* program = good<jones::Program>(state, assembled);
    if (program == nullptr) return;
    words += static_cast<std::int64_t>(program->core.size());
  }
  state.SetItemsProcessed(words);
}

void views(benchmark::State& state, const std::string& name) {
  const auto read = scene::read_cell_scene(*scene::builtin_scene_text(name), name);
  const auto* scene = good<scene::CellScene>(state, read);
  if (scene == nullptr) return;
  const auto prepared = jones::Prepared::of(*scene);
  const auto* program = good<jones::Prepared>(state, prepared);
  if (program == nullptr) return;
  std::int64_t instructions = 0;
  for (auto _ : state) instructions += static_cast<std::int64_t>(program->run()->instructions);
  state.SetItemsProcessed(instructions);
}

BENCHMARK_CAPTURE(assemble, street4, "street4")
    ->Name("jones_assembly/street4")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assemble, roberts, "roberts")
    ->Name("jones_assembly/roberts")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(views, street4, "street4")->Name("jones_views/street4")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(views, roberts, "roberts")->Name("jones_views/roberts")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
