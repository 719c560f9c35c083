// Numbers: P. J. Willis, "A real time hidden surface technique", The Computer Journal 20 (1977).
#include "host/report/timing/willis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <utility>

#include "host/algorithms/registry/willis_display.hpp"
#include "host/algorithms/willis/sight_lines.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/timing/paper_numbers.hpp"
#include "host/report/timing/willis_pictures.hpp"
#include "host/report/willis_scenes.hpp"

namespace sightline::harness::report {

namespace {

namespace willis = algorithms::willis;
namespace display = devices::priority_display;
using willis::BoundaryShape;

std::int64_t count_of(std::size_t value) {
  return static_cast<std::int64_t>(value);
}

// One scene: its model, and a frame of it on the display.
struct Flown {
  WillisScene scene;
  willis::Model model;
  willis::ImageWindow window;
  std::size_t distances = 0;  // surfaces turned to the eye
  std::size_t spans = 0;
  std::uint64_t covered = 0;  // points, as often as they are covered
  core::Duration scan{};      // of the visible lines
  std::optional<double> prepare_ns;
  std::optional<double> order_ns;
  std::optional<double> frame_ns;  // order, spans and the display's work
};

Flown fly(WillisScene scene) {
  Flown flown{std::move(scene), {}, {}, 0, 0, 0, {}, {}, {}, {}};
  flown.model = flown.scene.model();
  const scene::PolyCamera& camera = flown.scene.scene.camera;
  flown.window = willis::window_around(flown.scene.scene, camera, display::columns, display::lines);
  willis::Frames frames(flown.model);
  const auto order = frames.order(camera);
  flown.distances = order.size();
  willis::FrameSpans spans;
  willis::make_spans(flown.model, order, camera, flown.window, spans);
  flown.spans = spans.spans.size();
  WillisDisplay shown;
  (void)displayed(spans, shown);
  flown.covered = shown.device.counts().points;
  flown.scan = display::line * display::lines;
  return flown;
}

void take_times(std::list<Flown>& all, int rounds) {
  std::vector<std::function<void()>> jobs;
  std::vector<std::optional<double> Flown::*> kinds{&Flown::prepare_ns, &Flown::order_ns, &Flown::frame_ns};
  for (Flown& flown : all) {
    const scene::PolyCamera& camera = flown.scene.scene.camera;
    jobs.push_back([&flown] { (void)flown.scene.model(); });
    const auto frames = std::make_shared<willis::Frames>(flown.model);
    jobs.push_back([frames, &camera] { (void)frames->order(camera); });
    const auto spans = std::make_shared<willis::FrameSpans>();
    const auto shown = std::make_shared<WillisDisplay>();
    jobs.push_back([frames, spans, shown, &flown, &camera] {
      willis::make_spans(flown.model, frames->order(camera), camera, flown.window, *spans);
      (void)displayed(*spans, *shown);
    });
  }
  const auto times = median_nanoseconds(jobs, rounds);
  std::size_t i = 0;
  for (Flown& flown : all)
    for (const auto kind : kinds) flown.*kind = times[i++];
}

std::list<Flown> fly_all(const Context& context) {
  std::vector<WillisScene> scenes{
      {"prisms-35", scene::generate_prisms(35), true}, prisms_in_space(),
      {"boxes-30", scene::generate_boxes(30), false},  {"touch-3", scene::generate_touch(3), false},
      {"rooms-3", scene::generate_rooms(3), false},    {"town-35", scene::generate_town(35), false},
      {"town-167", scene::generate_town(167), true},   {"town-167", scene::generate_town(167), false}};
  if (context.full) scenes.push_back({"town-1667", scene::generate_town(1667), false});
  std::list<Flown> all;
  for (WillisScene& scene : scenes) {
    context.progress(fmt::format("Willis: {}", scene.title()));
    all.push_back(fly(std::move(scene)));
  }
  if (context.host_times) {
    context.progress("Willis, timed");
    take_times(all, context.full ? 31 : 9);
  }
  return all;
}

std::vector<PaperNumber> numbers(const std::list<Flown>& all) {
  std::size_t least = ~std::size_t{0};
  std::size_t most = 0;
  for (const Flown& flown : all) {
    least = std::min(least, flown.distances);
    most = std::max(most, flown.distances);
  }
  const Flown& town = all.back();
  const auto surfaces = static_cast<double>(town.model.surfaces);
  const auto frames = Real{1e9 / static_cast<double>(display::frame.count()), 0};
  const auto less = [](double part) { return Real{100 * (1 - part / willis::oval_area()), 2}; };
  const Cell circles = less(willis::two_circles_area());
  const Cell halves = less(willis::halves_ovals_area());
  const Cell oval = Real{willis::oval_area(), 4};
  return {
      {"abstract", "\"new frames may be calculated at a rate of 25 per second\"", frames, frames,
       "frames a second", "priority display, 625 lines of 64 us",
       "the same by construction: the display keeps its rate whatever it shows; what the computer takes for "
       "a frame is in the next table. No time of a program is given to compare"},
      {"introduction", "\"the number of visible surfaces will be in the hundreds\"", count_of(least),
       count_of(most), "surfaces", "pieces turned to the eye, scenes of the next table", "as meant"},
      {"introduction", "comparisons, \"N log2 N or N^2 being usual\"", count_of(town.model.tests),
       Real{surfaces * surfaces, 0}, "pairs",
       fmt::format("{}: boundaries tested, and N^2", town.scene.title()),
       "once, when the model is made; a frame has N distances and, as the display is given an order, a sort"},
      {"Fig. 6", "\"an area reduction of about 2%\"", circles, circles, "%",
       "two circles for an oval; formula, counted in hard case W4",
       "right, rounded: (4 pi / 3 + sqrt(3) / 2) to (pi + 2)"},
      {"property 5", "\"an area (pi + 2)L^2\"", oval, oval, "L^2", "formula; counted in hard case W5",
       "right"},
      {"property 5, Fig. 9", "\"a reduction in area by about 65%\"", halves, halves, "%",
       "a surface in two halves; formula, counted in hard case W5",
       "right, of what the two ovals cover together; the sum of their areas falls by 50 %"},
      {"property 6", "\"are within 90\"", Cell(), Real{180, 0}, "degrees",
       "normals of surfaces that can both be seen, one behind the other",
       "wrong: up to, not including, 180; see the table of the rule"},
  };
}

Table scenes_table(const std::list<Flown>& all) {
  Table table;
  table.id = "willis-scenes";
  table.title = "Willis: models and frames";
  table.columns = {{"scene", "Scene", "", false},
                   {"surfaces", "Surfaces", "", false},
                   {"tests", "Boundaries tested", "pairs", false},
                   {"clusters", "Clusters", "pairs", false},
                   {"pieces", "Pieces", "", false},
                   {"cells", "Order cells", "", false},
                   {"left_over", "Left over", "pairs", false},
                   {"distances", "Distances a frame", "", false},
                   {"spans", "Spans a frame", "", false},
                   {"covered", "Points covered", "", false},
                   {"scan_ms", "Scan by the display", "ms", false},
                   {"prepare_ms", "Model made", "ms", true},
                   {"order_us", "Distances and sort", "us", true},
                   {"order_us_per_1000", "per 1,000 pieces", "us", true},
                   {"frame_ms", "Frame, display emulated", "ms", true},
                   {"frames_a_second", "Frames a second", "", true}};
  const auto time = [](const std::optional<double>& ns, double unit, int places) {
    return ns ? Cell(Real{*ns / unit, places}) : Cell();
  };
  for (const Flown& flown : all) {
    const auto pieces = static_cast<double>(flown.model.pieces.size());
    std::vector<Cell> row{flown.scene.title()};
    for (const std::size_t value :
         {flown.model.surfaces, flown.model.tests, flown.model.clusters, flown.model.pieces.size(),
          static_cast<std::size_t>(flown.model.cells.cells), flown.model.residual.size(), flown.distances,
          flown.spans, static_cast<std::size_t>(flown.covered)})
      row.emplace_back(count_of(value));
    row.emplace_back(Real{static_cast<double>(flown.scan.count()) / 1e6, 3});
    row.push_back(time(flown.prepare_ns, 1e6, 2));
    row.push_back(time(flown.order_ns, 1e3, 1));
    row.push_back(time(flown.order_ns, pieces, 1));  // ns a piece are us for 1,000
    row.push_back(time(flown.frame_ns, 1e6, 2));
    row.push_back(flown.frame_ns ? Cell(Real{1e9 / *flown.frame_ns, 0}) : Cell());
    table.rows.push_back(std::move(row));
  }
  table.notes = {
      "A frame of 512 by 512 points from the scene's own camera. The scan is by the display's clock: 512 of "
      "the 625 lines of a frame of 40 ms. A frame by this computer is everything: distances and sort, spans, "
      "and the display emulated point by point. Sheets (rooms) have two sides, and so two surfaces."};
  return table;
}

// What the rule that normals be within 90 degrees saves, and what it costs.
Table rule_table(const Context& context) {
  Table table;
  table.id = "willis-rule90";
  table.title = "Willis: the rule that normals be within 90 degrees";
  table.columns = {{"scene", "Scene", "", false},
                   {"rule", "Rule", "", false},
                   {"tests", "Boundaries tested", "pairs", false},
                   {"clusters", "Clusters", "pairs", false},
                   {"pieces", "Pieces", "", false},
                   {"left_over", "Left over", "pairs", false},
                   {"lines", "Sight lines with two surfaces", "", false},
                   {"lines_wrong", "Wrong", "", false},
                   {"points", "Points of pictures", "", false},
                   {"points_wrong", "Wrong", "", false},
                   {"prepare_ms", "Model made", "ms", true}};
  const std::uint64_t lines_wanted = context.full ? 200'000 : 20'000;
  for (const WillisScene& scene : willis_order_scenes()) {
    context.progress(fmt::format("Willis: the 90-degree rule, {}", scene.title()));
    const TrueFaces truth = true_faces(scene.scene);
    std::vector<std::function<void()>> jobs;
    for (const bool rule : {false, true}) {
      const willis::ModelOptions options{.rules = {BoundaryShape::ball, rule}};
      const willis::Model model = scene.model(options);
      const willis::SightLines lines =
          willis::count_lines(model, scene.scene, sight_lines(scene, lines_wanted), 1);
      const FaceErrors errors = truth.errors_of(model);
      table.rows.push_back({scene.title(), std::string(rule ? "on" : "off"), count_of(model.tests),
                            count_of(model.clusters), count_of(model.pieces.size()),
                            count_of(model.residual.size()), count_of(lines.with_two), count_of(lines.wrong),
                            count_of(errors.points), count_of(errors.wrong_inside), Cell()});
      jobs.push_back([&scene, options] { (void)scene.model(options); });
    }
    if (!context.host_times) continue;
    const auto times = median_nanoseconds(jobs, 5);
    for (std::size_t i = 0; i < 2; ++i)
      table.rows[table.rows.size() - 2 + i].back() = Real{times[i] / 1e6, 2};
  }
  table.notes = {
      "With the rule fewer pairs count as clusters, so that less is tested and cut, and some surfaces that "
      "should have been are not: wrong where it can be seen, though no pair is left over. Sight lines start "
      "at random places in and around the scene, a random corner stands for each piece; 160 pictures are of "
      "24 by 24 points from places within it, points within 0.75 of an edge left out."};
  return table;
}

}  // namespace

Outcome<std::vector<Block>> timing_of_willis(const Context& context) {
  const std::list<Flown> all = fly_all(context);
  context.progress("Willis: pictures of what is wrong");
  auto gallery = willis_pictures();
  if (!gallery) return std::move(gallery.error());
  std::vector<Block> blocks;
  blocks.emplace_back(
      paper_table("willis-paper", "Willis 1977: every number for time and size", numbers(all)));
  blocks.emplace_back(scenes_table(all));
  blocks.emplace_back(std::move(*gallery));
  blocks.emplace_back(rule_table(context));
  return blocks;
}

}  // namespace sightline::harness::report
