// Hard cases of cells and openings with a parameter. Every build is tried with value after value, from easy
// to hard, until it fails.
#include <fmt/core.h>

#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/guests/jones/guest.hpp"
#include "host/guests/jones/precision/precision.hpp"
#include "host/guests/jones/program.hpp"
#include "host/guests/jones/twin/twin.hpp"
#include "host/report/hard_cases/corridor.hpp"
#include "host/report/hard_cases/jones.hpp"
#include "host/scene/cells/from_cell_scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::harness::report {

namespace {

using guests::jones::Precision;

constexpr geometry::Span wide{-20, 20};

struct Family {
  std::string_view id;
  std::string_view parameter;
  std::string_view input;
  std::vector<std::int32_t> values;  // from easy to hard
  std::size_t machine_values = 0;    // the first so many of them a program can be given
  scene::CellScene (*scene)(std::int32_t value);
};

scene::CellScene nested(std::int32_t count) {
  std::vector<Portal> portals;
  for (std::int32_t i = 1; i <= count; ++i) portals.push_back({100 * i, wide, wide});
  return corridor(portals, 100 * (count + 1));
}

scene::CellScene grazing(std::int32_t count) {
  std::vector<Portal> portals;
  for (std::int32_t i = 1; i <= count; ++i) portals.push_back({100 * i, {i, 40}, wide});
  return corridor(portals, 100 * (count + 1));
}

scene::CellScene tiny_window(std::int32_t z) {
  return corridor({{z, {0, 1}, {0, 1}}}, z + 100);
}

scene::CellScene near_portal(std::int32_t z) {
  return corridor({{z, {-8190, 8190}, {-4000, 4000}}}, 100, 16000);
}

std::vector<Family> families() {
  Family depth{"J8", "depth, cells", "nested portals |x|, |y| <= 20 at z = 100 i", {}, 0, nested};
  for (std::int32_t k = 1; k <= 40; ++k) depth.values.push_back(k);
  depth.machine_values = depth.values.size();
  depth.values.insert(depth.values.end(), {100, 1000, 2600});
  Family ray{"J7", "portals on the ray", "portals x from i to 40, |y| <= 20 at z = 100 i", {}, 0, grazing};
  for (std::int32_t k = 1; k <= 39; ++k) ray.values.push_back(k);
  ray.machine_values = ray.values.size();
  Family window{"J11", "distance z", "a portal of 1 by 1 at z", {}, 0, tiny_window};
  for (std::int32_t z = 32; z <= 1 << 17; z *= 2) window.values.push_back(z);
  window.machine_values = 10;
  Family approach{"J12", "distance z", "a portal |x| <= 8190, |y| <= 4000 at z", {}, 0, near_portal};
  approach.values = {64, 32, 16, 8, 4, 3, 2, 1};
  approach.machine_values = approach.values.size();
  return {depth, ray, window, approach};
}

// What goes wrong; nothing: all the corridor's cells are visited, and no more.
using Trial = std::function<std::optional<std::string>(const scene::CellScene&)>;

std::optional<std::string> fault(guests::jones::Status status, std::uint64_t cells,
                                 const scene::CellScene& scene) {
  if (status != guests::jones::Status::complete) return std::string(guests::jones::name(status));
  if (cells == scene.cells.size()) return std::nullopt;
  return fmt::format("cells {}, not {}", cells, scene.cells.size());
}

std::optional<std::string> try_program(const scene::CellScene& scene) {
  const auto assembled = guests::jones::assemble_program(scene, {});
  if (!assembled) return assembled.error().message();
  guests::jones::GuestOptions options;
  options.views = 1;
  options.display = false;
  const guests::jones::GuestRun run = guests::jones::run_guest(*assembled, options);
  if (run.views.empty()) return "no view within the limit of time";
  return fault(run.views.front().status, run.views.front().distinct_cells, scene);
}

Trial in_arithmetic(const Precision& precision) {
  return [precision](const scene::CellScene& scene) -> std::optional<std::string> {
    const auto made = guests::jones::scene_in_core(scene, scene.default_view);
    if (!made) return made.error().message();
    const auto& core = made->core;
    const auto view =
        guests::jones::run_precisely(core, 0, guests::jones::default_parameters(core, 0), precision);
    return fault(view.status, view.counts.distinct_cells, scene);
  };
}

std::optional<std::string> try_native(const scene::CellScene& scene) {
  const scene::PolyScene poly = scene::poly_scene_of(scene);
  const auto result = algorithms::jones::visible_edges(scene::complex_of(scene, poly), poly.camera);
  if (!result) return result.error().message();
  const auto& view = *result;
  if (view.picture != algorithms::exact::visible_edges(poly, poly.camera)) return "not the picture of exact";
  if (view.counts.mask_sides > 4) return fmt::format("a mask of {} sides", view.counts.mask_sides);
  return fault(guests::jones::Status::complete, view.counts.cells, scene);
}

std::vector<Precision> precisions() {
  std::vector<Precision> all;
  for (const int bits : {12, 14, 16, 18, 24, 36})
    all.push_back({guests::jones::NumberKind::fixed_point, bits, 1, false});
  for (const int fraction : {0, 2, 3})
    all.push_back({guests::jones::NumberKind::fixed_point, 18, fraction, false});
  all.push_back({guests::jones::NumberKind::fixed_point, 18, 1, true});
  all.push_back({guests::jones::NumberKind::fixed_point, 36, 8, false});
  all.push_back({guests::jones::NumberKind::single_float, 0, 0, false});
  all.push_back({guests::jones::NumberKind::double_float, 0, 0, false});
  return all;
}

void add_row(Table& table, const Family& family, const std::string& build, const Trial& trial,
             std::size_t values) {
  std::vector<Cell> row{std::string(family.id), std::string(family.parameter), std::string(family.input),
                        build};
  for (std::size_t i = 0; i < values; ++i) {
    if (auto wrong = trial(family.scene(family.values[i]))) {
      row.insert(row.end(), {std::int64_t{family.values[i]}, Verdict{false, std::move(*wrong)}});
      table.rows.push_back(std::move(row));
      return;
    }
  }
  row.insert(row.end(), {Cell(), Verdict{true, fmt::format("none up to {}", family.values[values - 1])}});
  table.rows.push_back(std::move(row));
}

}  // namespace

Outcome<Table> jones_families(const Context& context) {
  Table table;
  table.id = "hard-cases-jones-first-failures";
  table.title = "Jones: with a parameter, the first value at which each build fails";
  table.columns = {{"case", "Case", "", false},
                   {"parameter", "Parameter", "", false},
                   {"input", "Input", "", false},
                   {"build", "Build", "", false},
                   {"first_failure", "First failure", "", false},
                   {"what", "What happens", "", false}};
  for (const Family& family : families()) {
    context.progress(fmt::format("hard case {}: first failures", family.id));
    add_row(table, family, "program on the PDP-7", try_program, family.machine_values);
    for (const Precision& precision : precisions())
      add_row(table, family, "twin, " + guests::jones::name(precision), in_arithmetic(precision),
              family.machine_values);
    add_row(table, family, "native Jones", try_native, family.values.size());
  }
  table.notes = {
      "A corridor 100 wide and high (J12: 32,000) from z = -100, the eye at the origin. A build fails when "
      "it does not visit every cell, stops, or does not take the scene; native Jones also when its picture "
      "is not that of exact. Twins keep the limits of the machine's core: 8192 words for the scene alone, "
      "without the program, a mask stack of 450 words. Coordinates of the program's scenes end at 32767, "
      "those of native ones at 262143."};
  return table;
}

}  // namespace sightline::harness::report
