#include "host/programs/turn/turn.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace sightline::programs::turn {

namespace {

constexpr double whole_turn = 1 << 18;
constexpr double turn_time = 8;  // seconds

double seconds_of(core::Duration time) { return static_cast<double>(time.count()) / 1e9; }

Summary summary_of(const std::vector<Picture>& pictures) {
  Summary sum;
  double time = 0;
  double worst = 0;
  double waiting = 0;
  double passes = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Picture& picture = pictures[i];
    sum.junctions_mean += picture.junctions;
    sum.lines_mean += picture.lines;
    ++sum.pictures;
    // The first picture has no beginning; the second does not wait, and the display does not wait for it.
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

std::string difference_of(const Picture& picture, const TwinPicture& twin) {
  if (picture.angle != twin.angle) return fmt::format("angle {:06o}, the twin's {:06o}", picture.angle, twin.angle);
  if (picture.wire != twin.wire || picture.status != twin.status)
    return fmt::format("status {}, the twin's {}", static_cast<int>(picture.status), static_cast<int>(twin.status));
  const auto& a = picture.display_file;
  const auto& b = twin.display_file;
  const auto [here, there] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (here == a.end() && there == b.end()) return "";
  const auto word = [](auto at, const auto& words) {
    return at == words.end() ? std::string("none") : fmt::format("{:06o}", at->value());
  };
  return fmt::format("angle {:06o}: word {} of the display file is {}, the twin's {}", picture.angle, here - a.begin(),
                     word(here, a), word(there, b));
}

base::Result<Pictures> run_pictures(const Program& program, const Tape& tape, const PicturesOrder& order) {
  Machine machine(program, tape, {.strokes = order.strokes, .torn_stores = order.check});
  std::optional<Twin> twin;
  if (order.check) twin.emplace(tape.words, model_base(tape.memory));
  const auto differs = [](const std::string& what) {
    return base::difference("internal error: a picture on the PDP-7 is not the one its native twin computes: " + what);
  };
  Pictures run;
  for (std::uint32_t i = 0; i < order.pictures; ++i) {
    const std::uint32_t switches = order.switches(i);
    Picture picture;
    if (!machine.next(switches, picture)) return base::program_failed("the machine makes no more pictures");
    if (twin) {
      TwinPicture expected;
      if (!twin->next(switches, expected)) return differs("the twin makes no picture");
      if (const std::string difference = difference_of(picture, expected); !difference.empty())
        return differs(fmt::format("picture {}: {}", i, difference));
    }
    if (!order.display_files) picture.display_file.clear();
    for (ShownPass& pass : picture.shown) run.shown.push_back(std::move(pass));
    picture.shown.clear();
    run.pictures.push_back(std::move(picture));
  }
  if (machine.torn_stores() != 0)
    return differs(fmt::format("{} stores into a display file that is being shown", machine.torn_stores()));
  run.summary = summary_of(run.pictures);
  return run;
}

base::Result<std::uint32_t> step_for(const Program& program, const Tape& tape, double seconds, bool wire) {
  std::uint32_t step = 1U << 10U;
  for (int round = 0; round < 2; ++round) {
    PicturesOrder order;
    order.pictures = std::min(pictures_of_turn(step), 400U);
    const std::uint32_t switches = step | (wire ? wire_switch : 0U);
    order.switches = [switches](std::uint32_t) { return switches; };
    const auto turned = run_pictures(program, tape, order);
    if (!turned) return turned.error();
    const double rate = turned->summary.frames_per_second_mean;
    if (rate <= 0) return step;
    step = std::clamp(static_cast<std::uint32_t>(std::lround(whole_turn / (seconds * rate))), 1U, speed_mask);
  }
  return step;
}

std::uint32_t pictures_of_turn(std::uint32_t step) { return static_cast<std::uint32_t>(std::ceil(whole_turn / step)) + 1; }

double Outcome::cost_against_wire_frame() const {
  return wire.summary.frames_per_second_mean / hidden.summary.frames_per_second_mean;
}

double Outcome::turn_seconds() const { return whole_turn / (step * hidden.summary.frames_per_second_mean); }

base::Result<Outcome> run(const Tape& tape, const Order& order) {
  const Program program = assemble_program(order.eae, tape.memory);
  const auto step = step_for(program, tape, turn_time, false);
  if (!step) return step.error();
  Outcome outcome;
  outcome.program_words = program.words;
  outcome.core_words = program.words + tape.layout.model() + tape.layout.display_files;
  outcome.step = *step;
  for (const std::uint32_t wire : {0U, wire_switch}) {
    PicturesOrder of_kind;
    of_kind.pictures = order.pictures != 0 ? order.pictures : pictures_of_turn(*step);
    of_kind.switches = [switches = *step | wire](std::uint32_t) { return switches; };
    of_kind.strokes = order.strokes;
    of_kind.check = order.check;
    auto pictures = run_pictures(program, tape, of_kind);
    if (!pictures) return pictures.error();
    (wire != 0 ? outcome.wire : outcome.hidden) = std::move(*pictures);
  }
  return outcome;
}

}  // namespace sightline::programs::turn
