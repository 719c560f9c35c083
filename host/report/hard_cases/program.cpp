#include "host/report/hard_cases/program.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>

#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/compare/lines.hpp"
#include "host/geometry/box.hpp"
#include "host/guests/jones/guest.hpp"
#include "host/guests/jones/program.hpp"
#include "host/guests/jones/twin/arithmetic.hpp"
#include "host/guests/jones/twin/twin.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/scene/cells/grid/decompose.hpp"

namespace sightline::harness::report {

namespace {

namespace oracle = algorithms::oracle;

constexpr double wrong_from = 1;  // points

// Of a picture that came to an end: wrong lengths, cells looked at, and how often.
Cell judged(const JonesHardCase& hard, guests::jones::Status status, const picture::LineMetrics& metrics,
            std::uint64_t cells, std::uint64_t visits) {
  std::string text;
  const auto add = [&text](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (status != guests::jones::Status::complete)
    add(fmt::format("stops with \"{}\"", guests::jones::name(status)));
  if (metrics.extra_far > wrong_from) add(fmt::format("{:.1f} points too much", metrics.extra_far));
  if (metrics.missing_far > wrong_from) add(fmt::format("{:.1f} points missing", metrics.missing_far));
  if (hard.cells && cells != *hard.cells) add(fmt::format("cells {}, not {}", cells, *hard.cells));
  if (hard.visits && visits != *hard.visits) add(fmt::format("visits {}, not {}", visits, *hard.visits));
  if (text.empty()) return Verdict{true, "right"};
  return Verdict{false, "differs: " + text};
}

struct Truth {
  compare::CellReference reference;
  std::map<std::uint32_t, compare::AxisLine> vectors;
};

std::optional<Truth> truth_of(const JonesHardCase& hard, const scene::CellScene& scene,
                              const guests::jones::Program& program) {
  const auto matter = oracle::Matter::of(scene);
  if (!matter) return std::nullopt;
  oracle::Window window;
  window.scale = hard.scale;
  window.near = guests::jones::near_z;
  const auto lines = matter->real_lines();
  const geometry::Point& eye = scene.default_view;
  return Truth{compare::CellReference(lines, oracle::visible_lines(*matter, lines, eye, window), eye, window),
               compare::lines_of_vectors(program.scene)};
}

guests::jones::View twin_view(const guests::jones::Program& program, std::int32_t scale) {
  const std::vector<core::Word18>& words = program.core;
  guests::jones::Parameters parameters = guests::jones::default_parameters(words, program.labels.scene);
  parameters.scale = scale;
  return guests::jones::run(words, program.labels.scene, parameters);
}

Cell guest_cell(const JonesHardCase& hard, const guests::jones::Program& program,
                const guests::jones::View& twin, const Truth& truth) {
  guests::jones::GuestOptions options;
  options.scale = hard.scale;
  options.views = 1;
  options.display = false;
  const guests::jones::GuestRun run = guests::jones::run_guest(program, options);
  if (run.views.empty()) return Verdict{false, "differs: no view within the limit of time"};
  const guests::jones::GuestView& guest = run.views.front();
  if (guest.status != twin.status || guest.display_file != twin.display_file)
    return Verdict{false, "differs: not its twin's display file"};
  const auto metrics = picture::line_metrics(truth.reference.lines(),
                                             compare::display_pieces(twin, truth.vectors, truth.reference));
  return judged(hard, guest.status, metrics, guest.distinct_cells, guest.visits);
}

}  // namespace

std::pair<Cell, Cell> run_programs(const JonesHardCase& hard, const scene::CellScene& scene) {
  const auto assembled = guests::jones::assemble_program(scene, {});
  if (!assembled) {
    const Cell cell = Verdict{hard.machine_rejects, "refuses: " + assembled.error().message()};
    return {cell, cell};
  }
  const auto& program = *assembled;
  const auto truth = truth_of(hard, scene, program);
  if (!truth) return {Verdict{false, "beyond the oracle"}, Verdict{false, "beyond the oracle"}};
  const guests::jones::View twin = twin_view(program, hard.scale);
  const auto metrics = picture::line_metrics(truth->reference.lines(),
                                             compare::twin_pieces(twin, truth->vectors, truth->reference));
  return {guest_cell(hard, program, twin, *truth),
          judged(hard, twin.status, metrics, twin.counts.distinct_cells, twin.counts.visits)};
}

std::string why_no_machine(const scene::PolyScene& scene) {
  if (const auto error = scene::why_no_grid(scene)) return error->message();
  for (const scene::PolyPoint& vertex : scene.vertices) {
    for (const std::int32_t coordinate : vertex) {
      if (std::abs(coordinate) >= geometry::coordinate_limit)
        return fmt::format("found the coordinate {}, the program's are below {}", coordinate,
                           geometry::coordinate_limit);
    }
  }
  return "the scene has no cells";
}

}  // namespace sightline::harness::report
