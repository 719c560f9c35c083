#include "host/programs/turn/session.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/algorithms/plantinga/turning_scene.hpp"

namespace sightline::programs::turn {

namespace {

constexpr double whole_turn = 1 << 18;
constexpr double turn_time = 8;  // seconds

double seconds_of(core::Duration time) { return static_cast<double>(time.count()) / 1e9; }

Summary summary_of(const TurnRun& run) {
  Summary sum;
  double time = 0;
  double worst = 0;
  double waiting = 0;
  double passes = 0;
  for (std::size_t i = 0; i < run.pictures.size(); ++i) {
    const GuestPicture& picture = run.pictures[i];
    sum.junctions_mean += run.twins[i].junctions_drawn;
    sum.lines_mean += run.twins[i].lines;
    ++sum.pictures;
    // The first picture has no beginning; the second one waits for nothing, or is waited for by nothing.
    if (i < 2) continue;
    const double one = seconds_of(picture.time);
    const double waited = seconds_of(picture.waiting);
    time += one;
    worst = std::max(worst, one);
    waiting += waited;
    sum.computing_worst = std::max(sum.computing_worst, one - waited);
    passes += picture.passes;
  }
  const double count = sum.pictures > 2 ? sum.pictures - 2 : 1;
  sum.junctions_mean /= std::max(1.0, static_cast<double>(sum.pictures));
  sum.lines_mean /= std::max(1.0, static_cast<double>(sum.pictures));
  if (time <= 0) return sum;
  sum.frames_per_second_mean = count / time;
  sum.frames_per_second_worst = 1 / worst;
  sum.computing_mean = (time - waiting) / count;
  sum.waiting_fraction = waiting / time;
  sum.refreshes_per_second = passes / time;
  return sum;
}

}  // namespace

std::string difference_of(const GuestPicture& guest, const Picture& twin) {
  if (guest.angle != twin.angle) return fmt::format("angle {:06o}, the twin's {:06o}", guest.angle, twin.angle);
  if (guest.wire != twin.wire || guest.status != twin.status)
    return fmt::format("status {}, the twin's {}", static_cast<int>(guest.status), static_cast<int>(twin.status));
  const auto& a = guest.display_file;
  const auto& b = twin.display_file;
  const auto [here, there] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (here == a.end() && there == b.end()) return "";
  const auto word = [](auto at, const auto& words) {
    return at == words.end() ? std::string("none") : fmt::format("{:06o}", at->value());
  };
  return fmt::format("angle {:06o}: word {} of the display file is {}, the twin's {}", guest.angle, here - a.begin(),
                     word(here, a), word(there, b));
}

Session::Session(const Tape& tape, bool eae) : tape_(tape), program_(assemble_program(eae, tape.memory)) {}

TurnRun Session::run(const RunOptions& options) const {
  Guest guest(program_, tape_, options.keep_strokes ? Guest::Strokes::kept : Guest::Strokes::dropped);
  Twin twin(tape_.words, model_base(tape_.memory));
  TurnRun run;
  std::size_t most = 0;
  for (std::uint32_t i = 0; i < options.pictures; ++i) {
    const std::uint32_t switches = options.switches(i);
    GuestPicture picture;
    Picture twins;
    if (!guest.next(switches, picture)) {
      run.stopped = true;
      break;
    }
    if (!twin.next(switches, twins) && run.difference.empty()) run.difference = "the twin makes no picture";
    if (run.difference.empty()) {
      run.difference = difference_of(picture, twins);
      if (!run.difference.empty()) run.difference = fmt::format("picture {}: {}", i, run.difference);
    }
    most = std::max(most, picture.display_file.size());
    if (!options.keep_files) {
      picture.display_file.clear();
      twins.display_file.clear();
    }
    for (ShownPass& pass : picture.shown) run.shown.push_back(std::move(pass));
    picture.shown.clear();
    run.pictures.push_back(std::move(picture));
    run.twins.push_back(std::move(twins));
  }
  if (guest.torn_stores() != 0 && run.difference.empty())
    run.difference = fmt::format("{} stores into a display file that is being shown", guest.torn_stores());
  run.summary = summary_of(run);
  run.summary.display_words_most = static_cast<std::uint32_t>(most);
  return run;
}

std::uint32_t Session::step_for(double seconds, bool wire) const {
  std::uint32_t step = 1U << 10U;
  for (int round = 0; round < 2; ++round) {
    RunOptions options;
    options.pictures = std::min(pictures_of_turn(step), 400U);
    const std::uint32_t switches = step | (wire ? wire_switch : 0U);
    options.switches = [switches](std::uint32_t) { return switches; };
    const TurnRun turned = run(options);
    const double rate = turned.summary.frames_per_second_mean;
    if (rate <= 0) return step;
    step = std::clamp(static_cast<std::uint32_t>(std::lround(whole_turn / (seconds * rate))), 1U, speed_mask);
  }
  return step;
}

std::uint32_t Session::pictures_of_turn(std::uint32_t step) {
  return static_cast<std::uint32_t>(std::ceil(whole_turn / step)) + 1;
}

base::Result<Tape> make_tape(const scene::PolyScene& scene, Memory memory, bool tilted) {
  namespace plantinga = algorithms::plantinga;
  const auto standing = stand_on_axis(scene, tilted);
  if (!standing) return standing.error();
  const plantinga::RotationModel model(*standing);
  if (model.edges().size() > plantinga::most_turned_edges) {
    return base::Error{.found = fmt::format("{} edges", model.edges().size()),
                       .expected = fmt::format("at most {}", plantinga::most_turned_edges)};
  }
  const auto list = plantinga::build_event_list(model);
  if (!list) return list.error();
  return encode(model, *list, memory);
}

double TurnMeasure::cost_against_wire_frame() const {
  return wire.summary.frames_per_second_mean / hidden.summary.frames_per_second_mean;
}

double TurnMeasure::turn_seconds() const { return whole_turn / (step * hidden.summary.frames_per_second_mean); }

TurnMeasure measure_turn(const Session& session, std::uint32_t pictures, bool keep_strokes) {
  TurnMeasure measure;
  measure.step = session.step_for(turn_time, false);
  const auto run_with = [&](std::uint32_t switches) {
    RunOptions options;
    options.pictures = pictures != 0 ? pictures : Session::pictures_of_turn(measure.step);
    options.keep_strokes = keep_strokes;
    options.switches = [switches](std::uint32_t) { return switches; };
    return session.run(options);
  };
  measure.hidden = run_with(measure.step);
  measure.wire = run_with(measure.step | wire_switch);
  return measure;
}

}  // namespace sightline::programs::turn
