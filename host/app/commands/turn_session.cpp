#include "host/app/commands/turn_session.hpp"

#include <fmt/core.h>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/algorithms/plantinga/turning_scene.hpp"
#include "host/app/command.hpp"
#include "host/app/outputs.hpp"

namespace sightline::app {

namespace {

namespace turn = guests::turn;
namespace plantinga = algorithms::plantinga;

constexpr double turn_time = 8;  // seconds

[[noreturn]] void refuse(base::Error error, const std::string& source) {
  error.file = source;
  throw Failure(ExitCode::bad_input, error.message());
}

turn::TurnRun run_at(const turn::Session& session, const std::string& source, std::uint32_t pictures,
                     std::uint32_t switches, bool keep_strokes) {
  turn::RunOptions options;
  options.pictures = pictures;
  options.keep_strokes = keep_strokes;
  options.switches = [switches](std::uint32_t) { return switches; };
  turn::TurnRun run = session.run(options);
  if (!run.difference.empty())
    throw Failure(ExitCode::differs,
                  fmt::format("{}: internal error: a picture on the PDP-7 is not the one its native twin computes: {}",
                              source, run.difference));
  if (run.stopped) throw Failure(ExitCode::guest_failed, fmt::format("{}: the machine makes no more pictures", source));
  return run;
}

}  // namespace

turn::Tape turn_tape(const scene::PolyScene& scene, const std::string& source, bool large, bool tilted) {
  auto standing = turn::stand_on_axis(scene, tilted);
  if (!standing) refuse(standing.error(), source);
  const plantinga::RotationModel model(*standing);
  if (model.edges().size() > plantinga::most_turned_edges)
    refuse({.found = fmt::format("{} edges", model.edges().size()),
            .expected = fmt::format("at most {}", plantinga::most_turned_edges)},
           source);
  auto list = plantinga::build_event_list(model);
  if (!list) refuse(list.error(), source);
  auto tape = turn::encode(model, *list, large ? turn::Memory::words_32k : turn::Memory::words_8k);
  if (!tape) refuse(tape.error(), source);
  return std::move(*tape);
}

void write_turn_tape(const scene::PolyScene& scene, const std::string& source, bool large, const std::string& path) {
  Output output(path);
  output.write(turn::punch(turn_tape(scene, source, large)));
  output.commit();
}

double TurnMeasure::cost_against_wire_frame() const {
  return wire.summary.frames_per_second_mean / hidden.summary.frames_per_second_mean;
}

double TurnMeasure::turn_seconds() const {
  return (1 << 18) / (step * hidden.summary.frames_per_second_mean);
}

TurnMeasure measure_turn(const turn::Session& session, const std::string& source, std::uint32_t pictures,
                         bool keep_strokes) {
  TurnMeasure measure;
  measure.step = session.step_for(turn_time, false);
  const std::uint32_t count = pictures != 0 ? pictures : turn::Session::pictures_of_turn(measure.step);
  measure.hidden = run_at(session, source, count, measure.step, keep_strokes);
  measure.wire = run_at(session, source, count, measure.step | turn::wire_switch, keep_strokes);
  return measure;
}

}  // namespace sightline::app
