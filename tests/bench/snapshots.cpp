// Saving and restoring a whole machine: the limit is 1 ms for a PDP-7 of 8K words and for an 8080 with a raster board, so that
// a monitor can take snapshots while a program runs.
#include <benchmark/benchmark.h>

#include <memory>
#include <string_view>
#include <utility>

#include "host/machines/i8080.hpp"
#include "host/machines/pdp7.hpp"
#include "host/live/snapshot.hpp"
#include "tests/host/machines/i8080_setup.hpp"

namespace sightline {
namespace {


std::unique_ptr<machines::Machine> pdp7_machine() {
  machines::Pdp7Setup setup;
  setup.display = type340::Options{};
  setup.reader_tape = machines::Bytes(20'000, 0377);
  return machines::make_pdp7(std::move(setup)).value();
}

std::unique_ptr<machines::Machine> i8080_machine() {
  machines::I8080Setup setup;
  test::attach(setup, "ef9365");
  return machines::make_i8080(std::move(setup));
}

void save(benchmark::State& state, std::string_view name, const std::unique_ptr<machines::Machine>& machine) {
  std::size_t bytes = 0;
  for (auto _ : state) bytes = live::save_snapshot(name, *machine).size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
void restore(benchmark::State& state, std::string_view name, const std::unique_ptr<machines::Machine>& machine) {
  const machines::Bytes snapshot = live::save_snapshot(name, *machine);
  for (auto _ : state) {
    if (!live::restore_snapshot(name, *machine, snapshot, "bench")) state.SkipWithError("refused");
  }
}
BENCHMARK_CAPTURE(save, pdp7, "pdp7", pdp7_machine());
BENCHMARK_CAPTURE(save, i8080_ef9365, "i8080", i8080_machine());
BENCHMARK_CAPTURE(restore, pdp7, "pdp7", pdp7_machine());
BENCHMARK_CAPTURE(restore, i8080_ef9365, "i8080", i8080_machine());

}  // namespace
}  // namespace sightline
