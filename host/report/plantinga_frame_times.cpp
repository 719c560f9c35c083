#include "host/report/plantinga_frame_times.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numbers>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/report/experiments/clock.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::plantinga;

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

// What all jobs on one model share.
struct Turntable {
  Turntable(const native::RotationModel& model, const native::EventList& list)
      : graph(list), frame(model), canvas(model) {}

  native::EdgeStructureGraph graph;
  native::FrameMaker frame;
  Canvas canvas;
  double angle = 0;
  std::vector<native::ImageLine> lines;
  std::vector<native::SpaceLine> space_lines;
};

// A list that was just made or read fits its graph: no step fails.
std::function<void()> rotation(Turntable& table, double step, void (*frame)(Turntable&)) {
  return [&table, step, frame] {
    for (int i = 0; i < frames; ++i) {
      table.angle = std::remainder(table.angle + step * degree, 2 * std::numbers::pi);
      frame(table);
    }
  };
}

void turn(Turntable& table) {
  static_cast<void>(table.graph.turn_to(table.angle));
}
void image(Turntable& table) {
  turn(table);
  table.frame.visible(table.graph, table.angle, table.lines);
}
void space(Turntable& table) {
  turn(table);
  table.frame.visible_in_space(table.graph, table.angle, table.space_lines);
}
void wire(Turntable& table) {
  table.frame.wire(table.angle, table.lines);
}

}  // namespace

PlantingaFrameTimes measure_frames(const StudiedModel& studied, int rounds) {
  Turntable table(studied.model, studied.list);
  const std::vector<std::function<void()>> jobs{rotation(table, 2, image),
                                                rotation(table, 6, image),
                                                rotation(table, 30, image),
                                                rotation(table, 2, space),
                                                rotation(table, 30, space),
                                                rotation(table, 2, turn),
                                                rotation(table, 2, wire),
                                                rotation(table, 2,
                                                         [](Turntable& t) {
                                                           image(t);
                                                           t.canvas.draw(t.lines);
                                                         }),
                                                rotation(table, 2,
                                                         [](Turntable& t) {
                                                           wire(t);
                                                           t.canvas.draw(t.lines);
                                                         }),
                                                [&table] {
                                                  for (int i = 0; i < frames; ++i)
                                                    static_cast<void>(table.graph.step_forward());
                                                }};
  auto times = median_nanoseconds(jobs, rounds);
  for (double& time : times) time /= frames;
  return {
      {times[0], times[1], times[2]}, {times[3], times[4]}, times[5], times[6], times[7], times[8], times[9]};
}

double frame_nanoseconds(const native::RotationModel& model, const native::EventList& list, double step,
                         int rounds) {
  Turntable table(model, list);
  const std::vector<std::function<void()>> jobs{rotation(table, step, image)};
  return median_nanoseconds(jobs, rounds).front() / frames;
}

}  // namespace sightline::harness::report
