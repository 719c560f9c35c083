#include "host/report/hard_cases/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <variant>

#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/geometry/box.hpp"
#include "host/compare/lines.hpp"
#include "host/guests/jones/guest.hpp"
#include "host/guests/jones/program.hpp"
#include "host/guests/jones/twin/twin.hpp"
#include "host/guests/jones/twin/arithmetic.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/scene/cells/grid/decompose.hpp"

namespace sightline::harness::report {

namespace {

namespace oracle = algorithms::oracle;

constexpr double wrong_from = 1;  // points

// Of a picture that came to an end: wrong lengths, cells looked at, and how often.
Cell judged(const JonesHardCase& hard, jones::Status status, const picture::LineMetrics& metrics,
            std::uint64_t cells, std::uint64_t visits) {
  std::string text;
  const auto add = [&text](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (status != jones::Status::complete) add(fmt::format("stops with \"{}\"", jones::name(status)));
  if (metrics.extra_far > wrong_from) add(fmt::format("{:.1f} points too much", metrics.extra_far));
  if (metrics.missing_far > wrong_from) add(fmt::format("{:.1f} points missing", metrics.missing_far));
  if (hard.cells && cells != *hard.cells) add(fmt::format("cells {}, not {}", cells, *hard.cells));
  if (hard.visits && visits != *hard.visits) add(fmt::format("visits {}, not {}", visits, *hard.visits));
  if (text.empty()) return Verdict{true, "right"};
  return Verdict{false, "differs: " + text};
}

struct Truth {
  CellReference reference;
  std::map<std::uint32_t, AxisLine> vectors;
};

std::optional<Truth> truth_of(const JonesHardCase& hard, const scene::CellScene& scene,
                              const jones::Program& program) {
  const auto matter = oracle::Matter::of(scene);
  if (!matter) return std::nullopt;
  oracle::Window window;
  window.scale = hard.scale;
  window.near = jones::near_z;
  const auto lines = matter->real_lines();
  const geometry::Point& eye = scene.default_view;
  return Truth{CellReference(lines, oracle::visible_lines(*matter, lines, eye, window), eye, window),
               lines_of_vectors(program.scene)};
}

jones::View twin_view(const jones::Program& program, std::int32_t scale) {
  std::vector<core::Word18> words(jones::core_words);
  for (const auto& [address, word] : program.core) words.at(address) = word;
  jones::Parameters parameters = jones::default_parameters(words, program.labels.scene);
  parameters.scale = scale;
  return jones::run(words, program.labels.scene, parameters);
}

Cell guest_cell(const JonesHardCase& hard, const jones::Program& program, const jones::View& twin,
                const Truth& truth) {
  jones::GuestOptions options;
  options.scale = hard.scale;
  options.views = 1;
  options.display = false;
  const jones::GuestRun run = jones::run_guest(program, options);
  if (run.views.empty()) return Verdict{false, "differs: no view within the limit of time"};
  const jones::GuestView& guest = run.views.front();
  if (guest.status != twin.status || guest.display_file != twin.display_file)
    return Verdict{false, "differs: not its twin's display file"};
  const auto metrics =
      picture::line_metrics(truth.reference.lines(), display_pieces(twin, truth.vectors, truth.reference));
  return judged(hard, guest.status, metrics, guest.distinct_cells, guest.visits);
}

}  // namespace

std::pair<Cell, Cell> run_programs(const JonesHardCase& hard, const scene::CellScene& scene) {
  const auto assembled = jones::assemble_program(scene, {});
  if (const auto* const error = std::get_if<scene::SceneError>(&assembled)) {
    const Cell cell = Verdict{hard.machine_rejects, "refuses: " + error->message()};
    return {cell, cell};
  }
  const auto& program = std::get<jones::Program>(assembled);
  const auto truth = truth_of(hard, scene, program);
  if (!truth) return {Verdict{false, "beyond the oracle"}, Verdict{false, "beyond the oracle"}};
  const jones::View twin = twin_view(program, hard.scale);
  const auto metrics =
      picture::line_metrics(truth->reference.lines(), twin_pieces(twin, truth->vectors, truth->reference));
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
