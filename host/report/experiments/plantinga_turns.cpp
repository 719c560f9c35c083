#include "host/report/experiments/plantinga_turns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/table_1.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/report/experiments/clock.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::plantinga;
using Job = std::function<void()>;

constexpr int frames = 360;
constexpr double degree = std::numbers::pi / 180;
constexpr std::size_t side = 1024;  // pixels

// The cheapest display: a pixel a step of a line's longer side.
class Canvas {
 public:
  explicit Canvas(const native::RotationModel& model) : pixels_(side * side) {
    double reach = 1;
    for (const auto& v : model.vertices()) {
      reach = std::max({reach, std::hypot(static_cast<double>(v[0]), static_cast<double>(v[2])),
                        std::abs(static_cast<double>(v[1]))});
    }
    scale_ = 0.49 * static_cast<double>(side) / reach;
  }

  void draw(const std::vector<native::ImageLine>& lines) {
    for (const native::ImageLine& line : lines) {
      const double dx = (line.u1 - line.u0) * scale_;
      const double dy = (line.v1 - line.v0) * scale_;
      const int steps = static_cast<int>(std::max(std::abs(dx), std::abs(dy))) + 1;
      double x = static_cast<double>(side) / 2 + line.u0 * scale_;
      double y = static_cast<double>(side) / 2 + line.v0 * scale_;
      for (int i = 0; i <= steps; ++i, x += dx / steps, y += dy / steps)
        pixels_[(static_cast<std::size_t>(y) % side) * side + static_cast<std::size_t>(x) % side] = 255;
    }
  }

 private:
  std::vector<std::uint8_t> pixels_;
  double scale_ = 1;
};

// What all jobs on one model share. A list that was just made or read fits its graph: no step fails.
class Turntable {
 public:
  Turntable(const native::RotationModel& model, const native::EventList& list)
      : graph_(list), frame_(model), canvas_(model) {}

  void turn() { static_cast<void>(graph_.turn_to(angle_)); }
  void image() {
    turn();
    frame_.visible(graph_, angle_, lines_);
  }
  void space() {
    turn();
    frame_.visible_in_space(graph_, angle_, space_lines_);
  }
  void wire() { frame_.wire(angle_, lines_); }
  void image_drawn() {
    image();
    canvas_.draw(lines_);
  }
  void wire_drawn() {
    wire();
    canvas_.draw(lines_);
  }
  void step_forward() { static_cast<void>(graph_.step_forward()); }

  // 360 times.
  [[nodiscard]] Job rotation(double step, void (Turntable::*frame)()) {
    return [this, step, frame] {
      for (int i = 0; i < frames; ++i) {
        angle_ = std::remainder(angle_ + step * degree, 2 * std::numbers::pi);
        (this->*frame)();
      }
    };
  }

 private:
  native::EdgeStructureGraph graph_;
  native::FrameMaker frame_;
  Canvas canvas_;
  double angle_ = 0;
  std::vector<native::ImageLine> lines_;
  std::vector<native::SpaceLine> space_lines_;
};

TurnModel turn_model(const StudiedModel& studied) {
  const auto row = native::table_1_row(studied.name, studied.model, studied.list, 0);
  return {.model = studied.name,
          .vertices = row.vertices,
          .edges = row.edges,
          .faces = row.faces,
          .events = row.events,
          .groups = row.directions,
          .kb = row.kilobytes,
          .per_edge = row.events_per_edge,
          .most = row.most_events_per_edge,
          .times = studied.times,
          .from_cache = studied.from_cache};
}

TurnFrames turn_frames(const StudiedModel& studied, int rounds) {
  Turntable table(studied.model, studied.list);
  const std::array<std::pair<double TurnFrames::*, Job>, 10> jobs{{
      {&TurnFrames::image_2_ns, table.rotation(2, &Turntable::image)},
      {&TurnFrames::image_6_ns, table.rotation(6, &Turntable::image)},
      {&TurnFrames::image_30_ns, table.rotation(30, &Turntable::image)},
      {&TurnFrames::space_2_ns, table.rotation(2, &Turntable::space)},
      {&TurnFrames::space_30_ns, table.rotation(30, &Turntable::space)},
      {&TurnFrames::steps_ns, table.rotation(2, &Turntable::turn)},
      {&TurnFrames::wire_ns, table.rotation(2, &Turntable::wire)},
      {&TurnFrames::image_drawn_ns, table.rotation(2, &Turntable::image_drawn)},
      {&TurnFrames::wire_drawn_ns, table.rotation(2, &Turntable::wire_drawn)},
      {&TurnFrames::event_ns, table.rotation(0, &Turntable::step_forward)},
  }};
  std::vector<Job> work;
  for (const auto& [member, job] : jobs) work.push_back(job);
  const auto times = median_nanoseconds(work, rounds);
  TurnFrames row;
  row.model = studied.name;
  for (std::size_t i = 0; i < jobs.size(); ++i) row.*jobs[i].first = times[i] / frames;
  return row;
}

double frame_nanoseconds(const native::RotationModel& model, const native::EventList& list, double step, int rounds) {
  Turntable table(model, list);
  const std::array jobs{table.rotation(step, &Turntable::image)};
  return median_nanoseconds(jobs, rounds).front() / frames;
}

void add_tolerances(std::vector<ToleranceTimes>& rows, const StudiedModel& studied, int rounds) {
  for (const double degrees : plantinga_tolerances) {
    native::BuildOptions options;
    options.tolerance = degrees * degree;
    const auto begun = std::chrono::steady_clock::now();
    const auto list = *native::build_event_list(studied.model, options);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    rows.push_back({studied.name, degrees, taken.count(), frame_nanoseconds(studied.model, list, 2, rounds)});
  }
}

void add_steps(std::vector<StepTimes>& rows, const StudiedModel& studied, int rounds) {
  for (const double degrees : plantinga_steps)
    rows.push_back({studied.name, degrees, frame_nanoseconds(studied.model, studied.list, degrees, rounds)});
}

TurnBaseline baseline_of(const StudiedModel& studied) {
  native::FrameMaker frame(studied.model);
  std::vector<native::ImageLine> lines;
  const std::array<Job, 2> jobs{[&] {
                                  for (int i = 0; i < frames; ++i) frame.wire(i * degree, lines);
                                },
                                [&] {
                                  static_cast<void>(native::visible_edges(studied.model, {3, 5}));
                                }};
  const auto times = median_nanoseconds(jobs, 9);
  return {studied.name, times[0] / frames, times[1]};
}

}  // namespace

PlantingaTurns measure_plantinga_turns(const Context& context) {
  PlantingaTurns measured;
  const auto turned = plantinga_turned_models(context);
  for (const std::string_view name : plantinga_models_of(context)) {
    context.progress(fmt::format("events of {}", name));
    const StudiedModel studied = study_model(context, name);
    measured.models.push_back(turn_model(studied));
    if (!context.host_times) continue;
    context.progress(fmt::format("frames of {}", name));
    measured.frames.push_back(turn_frames(studied, context.full ? 15 : 5));
    if (std::find(turned.begin(), turned.end(), name) == turned.end()) continue;
    const int rounds = context.full ? 31 : 9;
    add_tolerances(measured.tolerances, studied, rounds);
    add_steps(measured.steps, studied, rounds);
    measured.baselines.push_back(baseline_of(studied));
  }
  return measured;
}

}  // namespace sightline::report
