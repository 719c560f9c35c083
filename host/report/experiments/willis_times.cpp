// Willis's method as it was meant to run: a model is made once, its frames go to the priority display. Times
// of this computer.
//
//   display  its rate
//   frames   a scene each: its model, and a frame of 512 by 512 points from the scene's own camera
//   models   times of the models of willis-order
#include <fmt/core.h>

#include <functional>
#include <list>
#include <utility>

#include "host/algorithms/registry/willis_display.hpp"
#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/willis_scenes.hpp"

namespace sightline::report {

namespace {

namespace willis = algorithms::willis;
namespace display = devices::priority_display;

// Stays where it is: frames point into the model.
struct Flight {
  explicit Flight(WillisScene of)
      : scene(std::move(of)),
        model(scene.model()),
        window(willis::window_around(scene.scene, scene.scene.camera, display::columns, display::lines)),
        frames(model) {}
  Flight(const Flight&) = delete;
  Flight& operator=(const Flight&) = delete;

  std::size_t order() { return frames.order(scene.scene.camera).size(); }
  void fly() {
    willis::make_spans(model, frames.order(scene.scene.camera), scene.scene.camera, window, spans);
    (void)registry::displayed(spans, shown);
  }

  WillisScene scene;
  willis::Model model;
  willis::ImageWindow window;
  willis::Frames frames;
  willis::FrameSpans spans;
  registry::WillisDisplay shown;
};

void add_frame(RowSet& frames, Flight& flight) {
  flight.fly();
  const willis::Model& model = flight.model;
  frames.add({{"scene", flight.scene.title()},
              {"surfaces", model.surfaces},
              {"tests", model.tests},
              {"clusters", model.clusters},
              {"pieces", model.pieces.size()},
              {"order_cells", model.cells.cells},
              {"left_over", model.residual.size()},
              {"distances", flight.order()},
              {"spans", flight.spans.spans.size()},
              {"points_covered", flight.shown.device.counts().points},
              {"prepare_ms", {}},
              {"order_us", {}},
              {"frame_ms", {}}});
}

void time_frames(RowSet& rows, std::list<Flight>& flights, int rounds) {
  std::vector<std::function<void()>> jobs;
  for (Flight& flight : flights) {
    jobs.emplace_back([&flight] { (void)flight.scene.model(); });
    jobs.emplace_back([&flight] { (void)flight.order(); });
    jobs.emplace_back([&flight] { flight.fly(); });
  }
  const auto times = median_nanoseconds(jobs, rounds);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    rows.set(row, "prepare_ms", times[3 * row] / 1e6);
    rows.set(row, "order_us", times[3 * row + 1] / 1e3);
    rows.set(row, "frame_ms", times[3 * row + 2] / 1e6);
  }
}

void time_models(RowSet& rows, int rounds) {
  const std::vector<WillisScene> scenes = willis_order_scenes();
  std::list<willis::Model> models;
  std::list<willis::Frames> frames;
  std::vector<std::function<void()>> jobs;
  std::vector<std::pair<const WillisScene*, WillisModelKind>> timed;
  for (const WillisScene& scene : scenes) {
    for (const WillisModelKind& kind : willis_model_kinds()) {
      timed.emplace_back(&scene, kind);
      willis::Frames& of_model = frames.emplace_back(models.emplace_back(scene.model(kind.options())));
      jobs.emplace_back([&scene, kind] { (void)scene.model(kind.options()); });
      jobs.emplace_back([&scene, &of_model] { (void)of_model.order(scene.scene.camera); });
    }
  }
  const auto times = median_nanoseconds(jobs, rounds);
  for (std::size_t i = 0; i < timed.size(); ++i) {
    const auto& [scene, kind] = timed[i];
    rows.add({{"scene", scene->title()},
              {"boundary", kind.boundary()},
              {"rule90", kind.rule90()},
              {"depth", kind.depth},
              {"prepare_us", times[2 * i] / 1e3},
              {"order_us", times[2 * i + 1] / 1e3}});
  }
}

}  // namespace

Records willis_times(const Context& context) {
  Records records;
  records["display"].add({{"frames_per_s", 1e9 / static_cast<double>(display::frame.count())},
                          {"scan_lines", display::frame / display::line},
                          {"line_us", static_cast<double>(display::line.count()) / 1e3},
                          {"shown_lines", display::lines},
                          {"frame_ms", static_cast<double>(display::frame.count()) / 1e6}});
  records["models"] = RowSet({"scene", "boundary", "rule90", "depth", "prepare_us", "order_us"});
  std::vector<WillisScene> scenes{
      {"prisms-35", scene::generate_prisms(35), true}, prisms_in_space(),
      {"boxes-30", scene::generate_boxes(30), false},  {"touch-3", scene::generate_touch(3), false},
      {"rooms-3", scene::generate_rooms(3), false},    {"town-35", scene::generate_town(35), false},
      {"town-167", scene::generate_town(167), true},   {"town-167", scene::generate_town(167), false}};
  if (context.full) scenes.push_back({"town-1667", scene::generate_town(1667), false});
  std::list<Flight> flights;
  for (WillisScene& scene : scenes) {
    context.progress(fmt::format("Willis: {}", scene.title()));
    add_frame(records["frames"], flights.emplace_back(std::move(scene)));
  }
  if (!context.host_times) return records;
  context.progress("Willis, timed");
  time_frames(records["frames"], flights, context.full ? 31 : 5);
  time_models(records["models"], context.full ? 9 : 3);
  return records;
}

}  // namespace sightline::report
