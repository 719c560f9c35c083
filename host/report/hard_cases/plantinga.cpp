// Running the hard cases of Plantinga, Seales and Dyer.
#include "host/report/hard_cases/plantinga.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/base/result.hpp"
#include "host/report/experiments/plantinga_models.hpp"
#include "host/report/hard_cases/hard_cases.hpp"
#include "host/report/hard_cases/plantinga_checks.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::plantinga;

struct Result {
  Cell events;     // exact
  Cell doubles;    // the same question in doubles
  Cell structure;  // of the turning scene
  Cell oracle;
};

constexpr std::string_view no_faces = "not applicable: edges without faces";

Cell wrong(std::string text) {
  return Verdict{false, std::move(text)};
}
Cell right(std::string text = "right") {
  return Verdict{true, std::move(text)};
}
Cell judged(const TurnFault& fault) {
  return fault ? wrong("differs: " + *fault) : right();
}

std::string text_of(const std::array<std::int64_t, 2>& direction) {
  return fmt::format("{}:{}", direction[0], direction[1]);
}

bool is_form(const EventLines& lines, const std::array<std::int64_t, 3>& expected) {
  const auto form = native::meeting_form(native::crossing_of(lines.edges[0], lines.edges[1]),
                                         native::crossing_of(lines.edges[0], lines.edges[2]));
  const native::QuadraticForm same{expected[0], expected[1], expected[2]};
  return form == same || form == native::QuadraticForm{-same.xx, -same.xz, -same.zz};
}

TurnFault events_fault(const PlantingaHardCase& hard, const EventLines& lines,
                       const std::vector<native::Direction>& events) {
  const auto among = [&](const std::array<std::int64_t, 2>& d) {
    return std::find(events.begin(), events.end(), native::rational_direction(d[0], d[1])) != events.end();
  };
  if (hard.form && !is_form(lines, *hard.form)) return "another quadratic";
  if (hard.not_there.empty() && events.size() != hard.directions)
    return fmt::format("{} directions, not {}", events.size(), hard.directions);
  for (const auto& direction : hard.there)
    if (!among(direction)) return fmt::format("none at {}", text_of(direction));
  for (const auto& direction : hard.not_there)
    if (among(direction)) return fmt::format("one at {}", text_of(direction));
  for (const double tangent : hard.tangents) {
    if (std::none_of(events.begin(), events.end(), [&](const native::Direction& event) {
          return std::abs(std::tan(event.angle) - tangent) < 1e-9;
        }))
      return fmt::format("none with tan theta = {}", tangent);
  }
  return std::nullopt;
}

Result run_lines(const PlantingaHardCase& hard) {
  const auto read = read_event_lines(hard_case_text(hard.file));
  if (!read) {
    const Cell cell = wrong("refused: " + read.error().message());
    return {cell, cell, cell, cell};
  }
  const auto& lines = *read;
  const auto events = events_of(lines, hard.whole_lines);
  const std::size_t near = event_count_in_doubles(lines, hard.whole_lines);
  const std::string none(no_faces);
  return {judged(events_fault(hard, lines, events)),
          near == events.size() ? right() : wrong(fmt::format("{} directions, not {}", near, events.size())),
          none, none};
}

// Pictures in directions of small whole numbers, fixed ones and any.
TurnFault picture_fault(const TurnedScene& turned) {
  std::vector<native::Sight> sights{{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {1, 1}, {4, -3}, {3, 4}};
  std::mt19937 random(1990);
  const auto part = [&random] { return static_cast<std::int64_t>(random() % 20001) - 10000; };
  while (sights.size() < 24) {
    const native::Sight sight{part(), part()};
    if (sight.x != 0 || sight.z != 0) sights.push_back(sight);
  }
  for (const native::Sight& sight : sights) {
    if (native::visible_edges(turned.model, sight) !=
        algorithms::oracle::visible_edges(turned.scene, native::camera_of(sight)))
      return fmt::format("not the oracle's picture along {}:{}", sight.x, sight.z);
  }
  return std::nullopt;
}

base::Result<TurnedScene> turn_scene(const PlantingaHardCase& hard) {
  auto read = scene::read_poly_json(hard_case_text(hard.file), hard.file);
  if (!read) return read.error();
  auto& scene = *read;
  if (const auto errors = scene::check_poly_scene(scene); !errors.empty()) return errors.front();
  native::RotationModel model(scene);
  auto built = native::build_event_list(model);
  if (!built) return built.error();
  return TurnedScene{std::move(scene), std::move(model), std::move(*built)};
}

Result run_scene(const PlantingaHardCase& hard) {
  const auto made = turn_scene(hard);
  if (!made) {
    const Cell cell = wrong("refused: " + made.error().message());
    return {cell, cell, cell, cell};
  }
  const auto& turned = *made;
  return {judged(hard.turn(turned)),
          std::string("not applicable: no arithmetic but the exact one has a turn"),
          judged(turn_fault(turned)), judged(picture_fault(turned))};
}

Outcome<Result> run_model(const Context& context, const PlantingaHardCase& hard) {
  StudiedModel studied = study_model(context, hard.model);
  const TurnedScene turned{plantinga_scene(hard.model), std::move(studied.model), std::move(studied.list)};
  const std::string none = "not applicable: too large; in the tests";
  return Result{judged(hard.turn(turned)), none, judged(large_steps(turned)), none};
}

}  // namespace

Outcome<Table> plantinga_cases(const Context& context) {
  Table table;
  table.id = "hard-cases-plantinga";
  table.title = "Plantinga, Seales and Dyer: events of a turn, P1 to P22";
  table.columns = {{"case", "Case", "", false},
                   {"input", "Input", "", false},
                   {"what", "What it is", "", false},
                   {"expected", "Expected", "", false},
                   {"checked", "Checked", "", false},
                   {"events", "Exact events", "", false},
                   {"doubles", "In doubles alone", "", false},
                   {"structure", "Structures", "against from scratch", false},
                   {"oracle", "Pictures", "against the oracle", false}};
  Context untimed = context;
  untimed.host_times = false;
  for (const PlantingaHardCase& hard : plantinga_hard_cases()) {
    context.progress(fmt::format("hard case {}", hard.id));
    Result result;
    if (hard.table != nullptr) {
      const std::string none = "not applicable: a table";
      result = {judged(hard.table()), none, none, none};
    } else if (!hard.model.empty()) {
      auto made = run_model(untimed, hard);
      if (!made) return std::move(made.error());
      result = std::move(*made);
    } else {
      result = hard.file.ends_with(".txt") ? run_lines(hard) : run_scene(hard);
    }
    table.rows.push_back({std::string(hard.id), std::string(hard.file.empty() ? hard.model : hard.file),
                          std::string(hard.what), std::string(hard.expected), std::string(hard.checked),
                          std::move(result.events), std::move(result.doubles), std::move(result.structure),
                          std::move(result.oracle)});
  }
  table.notes = {
      "Directions are X : Z, the sine to the cosine of theta; a direction and its opposite are two. Exact "
      "events are counted and compared as whole numbers and forms; in doubles alone the same formulas are "
      "computed with rounding, and how many different directions come out is compared. Structures: between "
      "every two events of a full turn the list's structure of every edge is that of hidden-line removal "
      "from scratch, and the turn, forwards and backwards, ends where it began (P18: at 27 places). "
      "Pictures: from scratch, along 24 directions, piece for piece."};
  return table;
}

}  // namespace sightline::harness::report
