// Tables 1 and 2 of Plantinga, Seales and Dyer (1990) for the six models here: the events of a full turn, how long
// it takes to find them, and how long frames of a turning model take on this computer.
//
//   models      a model each: sizes, events, times of their construction (wall clock)
//   frames      a model each: medians of rotations of 360 frames as the paper's, on one core
//   tolerances  what an angle tolerance saves: a model and tolerance each
//   steps       a frame for so many degrees from frame to frame: a model and step each
//   baselines   a wire frame, and hidden-line removal from scratch: a model each
//
// Without host times only `models` has values; frames, tolerances, steps and baselines have no rows.
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
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/plantinga_models.hpp"

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

void add_model(RowSet& models, const StudiedModel& studied) {
  const auto row = native::table_1_row(studied.name, studied.model, studied.list, 0);
  Value one_core;
  Value all_cores;
  if (studied.times) {
    one_core = studied.times->one_core_s;
    all_cores = studied.times->all_cores_s;
  }
  models.add({{"model", studied.name},
              {"vertices", row.vertices},
              {"edges", row.edges},
              {"faces", row.faces},
              {"events", row.events},
              {"groups", row.directions},
              {"kb", row.kilobytes},
              {"per_edge", row.events_per_edge},
              {"most", row.most_events_per_edge},
              {"one_core_s", one_core},
              {"all_cores_s", all_cores},
              {"kept", studied.from_cache ? 1 : 0}});
}

void add_frames(RowSet& rows, const StudiedModel& studied, int rounds) {
  Turntable table(studied.model, studied.list);
  const std::array<std::pair<std::string_view, Job>, 10> jobs{{
      {"image_2_ns", table.rotation(2, &Turntable::image)},
      {"image_6_ns", table.rotation(6, &Turntable::image)},
      {"image_30_ns", table.rotation(30, &Turntable::image)},
      {"space_2_ns", table.rotation(2, &Turntable::space)},
      {"space_30_ns", table.rotation(30, &Turntable::space)},
      {"steps_ns", table.rotation(2, &Turntable::turn)},
      {"wire_ns", table.rotation(2, &Turntable::wire)},
      {"image_drawn_ns", table.rotation(2, &Turntable::image_drawn)},
      {"wire_drawn_ns", table.rotation(2, &Turntable::wire_drawn)},
      {"event_ns", table.rotation(0, &Turntable::step_forward)},
  }};
  std::vector<Job> work;
  for (const auto& [key, job] : jobs) work.push_back(job);
  const auto times = median_nanoseconds(work, rounds);
  NamedValues row{{"model", studied.name}};
  for (std::size_t i = 0; i < jobs.size(); ++i) row.emplace_back(jobs[i].first, times[i] / frames);
  row.emplace_back("step_ratio", times[2] / times[0]);
  row.emplace_back("ratio", times[0] / times[6]);
  row.emplace_back("ratio_drawn", times[7] / times[8]);
  rows.add(row);
}

double frame_nanoseconds(const native::RotationModel& model, const native::EventList& list, double step, int rounds) {
  Turntable table(model, list);
  const std::array jobs{table.rotation(step, &Turntable::image)};
  return median_nanoseconds(jobs, rounds).front() / frames;
}

void add_tolerances(RowSet& rows, const StudiedModel& studied, int rounds) {
  for (const double degrees : plantinga_tolerances) {
    native::BuildOptions options;
    options.tolerance = degrees * degree;
    const auto begun = std::chrono::steady_clock::now();
    const auto list = *native::build_event_list(studied.model, options);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    rows.add({{"model", studied.name},
              {"degrees", degrees},
              {"prepare_s", taken.count()},
              {"frame_ns", frame_nanoseconds(studied.model, list, 2, rounds)}});
  }
}

void add_steps(RowSet& rows, const StudiedModel& studied, int rounds) {
  for (const double degrees : plantinga_steps)
    rows.add({{"model", studied.name},
              {"degrees", degrees},
              {"frame_ns", frame_nanoseconds(studied.model, studied.list, degrees, rounds)}});
}

void add_baselines(RowSet& rows, const StudiedModel& studied) {
  native::FrameMaker frame(studied.model);
  std::vector<native::ImageLine> lines;
  const std::array<Job, 2> jobs{[&] {
                                  for (int i = 0; i < frames; ++i) frame.wire(i * degree, lines);
                                },
                                [&] {
                                  static_cast<void>(native::visible_edges(studied.model, {3, 5}));
                                }};
  const auto times = median_nanoseconds(jobs, 9);
  rows.add({{"model", studied.name}, {"wire_ns", times[0] / frames}, {"scratch_ns", times[1]}});
}

}  // namespace

Records plantinga_turns(const Context& context) {
  Records records;
  records["frames"] = RowSet({"model", "image_2_ns", "image_6_ns", "image_30_ns", "space_2_ns", "space_30_ns", "steps_ns",
                              "wire_ns", "image_drawn_ns", "wire_drawn_ns", "event_ns", "step_ratio", "ratio",
                              "ratio_drawn"});
  records["tolerances"] = RowSet({"model", "degrees", "prepare_s", "frame_ns"});
  records["steps"] = RowSet({"model", "degrees", "frame_ns"});
  records["baselines"] = RowSet({"model", "wire_ns", "scratch_ns"});
  const auto turned = plantinga_turned_models(context);
  for (const std::string_view name : plantinga_models_of(context)) {
    context.progress(fmt::format("events of {}", name));
    const StudiedModel studied = study_model(context, name);
    add_model(records["models"], studied);
    if (!context.host_times) continue;
    context.progress(fmt::format("frames of {}", name));
    add_frames(records["frames"], studied, context.full ? 15 : 5);
    if (std::find(turned.begin(), turned.end(), name) == turned.end()) continue;
    const int rounds = context.full ? 31 : 9;
    add_tolerances(records["tolerances"], studied, rounds);
    add_steps(records["steps"], studied, rounds);
    add_baselines(records["baselines"], studied);
  }
  return records;
}

}  // namespace sightline::report
