// The requests that turn a solid on the page's PDP-7.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "emulators/core/word.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/programs/turn/program.hpp"
#include "host/programs/turn/screen_view.hpp"
#include "host/programs/turn/tape.hpp"
#include "host/live/web/requests.hpp"

namespace sightline::live::web {
namespace {

namespace turn = programs::turn;
constexpr std::uint32_t angles = 1U << 18;

turn::Memory memory_of(const Json& request) {
  return text_of(request, "memory") == "32k" ? turn::Memory::words_32k : turn::Memory::words_8k;
}

// The number of pictures per emulated second, measured from the first ones.
double pictures_a_second(MachineSession& session, const turn::Labels& labels) {
  constexpr std::int64_t begun = 100'000'000;
  constexpr std::int64_t ended = 800'000'000;
  constexpr std::uint64_t most = 10'000'000;
  static_cast<void>(session.run(begun, most));
  const std::uint32_t from = session.machine().word(labels.angle);
  static_cast<void>(session.run(ended, most));
  const std::uint32_t passed = (session.machine().word(labels.angle) - from) % angles;
  return passed / (static_cast<double>(ended - begun) / 1e9);
}

// Makes a PDP-7 with the model in core and its tape in the reader; a start at the label `start` reads the tape.
Json make_turn(Workbench& workbench, const Json& request) {
  auto loaded = scene_named(workbench, text_of(request, "scene"));
  if (!loaded) return error_answer(loaded.error().message());
  const auto tape = turn::make_tape(loaded->scene, memory_of(request), !flag_of(request, "level"));
  if (!tape) return error_answer(tape.error().message());
  const turn::Program program = turn::assemble_program(flag_of(request, "eae", true), tape->memory);
  std::vector<core::Word18> words = program.core;
  const std::uint32_t base = turn::model_base(tape->memory);
  words.resize(std::max(words.size(), base + tape->words.size()));
  std::copy(tape->words.begin(), tape->words.end(), words.begin() + static_cast<std::ptrdiff_t>(base));
  words[program.labels.count] = core::Word18(static_cast<std::uint32_t>(tape->words.size()));
  words[program.labels.checksum] = turn::checksum(tape->words);
  CoreProgram core{{{}, program.labels.begin}, program.eae, Json::object(), program.symbols};
  for (std::uint32_t at = 0; at < words.size(); ++at) core.image.words.emplace_back(at, words[at].value());
  workbench.put_file(".turn.tape", turn::punch(*tape));
  core.options = Json{{"--reader", ".turn.tape"}};
  if (tape->memory == turn::Memory::words_32k) core.options["--memory"] = "32k";

  // With an angle step of 1, the angle is the number of pictures.
  const Json trial = make_pdp7(workbench, ".turn.oct", core, 1);
  MachineSession* const tried = session_of(workbench, trial);
  if (tried == nullptr) return trial;
  const double rate = pictures_a_second(*tried, program.labels);
  static_cast<void>(workbench.answer(Json{{"do", "drop"}, {"id", *trial.find("id")}}));

  const double seconds = std::clamp(number_of(request, "seconds", 8), 0.5, 600.0);
  const auto step = static_cast<std::uint32_t>(std::clamp(std::round(angles / (seconds * std::max(rate, 1.0))), 1.0, 32767.0));
  const auto switches = static_cast<std::uint32_t>(std::clamp(number_of(request, "switches", step), 0.0, 262143.0));
  Json made = make_pdp7(workbench, ".turn.oct", core, switches);
  made["step"] = step;
  made["pictures_a_second"] = rate;
  made["edges"] = tape->edges;
  made["events"] = tape->events;
  made["words"] = program.words + tape->layout.model() + tape->layout.display_files;
  Json labels = Json::object();
  for (const auto& [name, at] : {std::pair{"start", program.labels.start}, {"begin", program.labels.begin}, {"angle", program.labels.angle},
                                 {"status", program.labels.status}, {"file", program.labels.file}})
    labels[name] = at;
  made["labels"] = std::move(labels);
  return made;
}

// The exact visible lines at an angle of the machine, accurate to 1/30,000 radian, in points of the Type 340: [x0, y0, x1, y1].
Json turn_sight(Workbench& workbench, const Json& request) {
  auto loaded = scene_named(workbench, text_of(request, "scene"));
  if (!loaded) return error_answer(loaded.error().message());
  const auto standing = turn::stand_on_axis(loaded->scene, !flag_of(request, "level"));
  if (!standing) return error_answer(standing.error().message());
  const auto angle = static_cast<std::uint32_t>(std::clamp(number_of(request, "angle", 0), 0.0, double{angles - 1}));
  const auto view = hidden_lines::visible_edges(*standing, turn::ScreenView::camera(angle));
  if (!view) return error_answer(view.error().message());
  const turn::ScreenView screen(*standing);
  Json lines = Json::array();
  for (const auto& piece : view->picture.pieces) {
    const auto& from = standing->vertices[piece.edge.from];
    const auto& to = standing->vertices[piece.edge.to];
    Json line = Json::array();
    for (const double t : {piece.low.to_double(), piece.high.to_double()}) {
      std::array<double, 3> point{};
      for (std::size_t a = 0; a < 3; ++a) point[a] = from[a] + (to[a] - from[a]) * t;
      for (const double coordinate : screen.place(point, angle)) line.push_back(coordinate);
    }
    lines.push_back(std::move(line));
  }
  return Json{{"lines", std::move(lines)}};
}

}  // namespace

Json turning_answer(Workbench& workbench, std::string_view what, const Json& request) {
  if (what == "turn") return make_turn(workbench, request);
  if (what == "turn_sight") return turn_sight(workbench, request);
  return {};
}

}  // namespace sightline::live::web
