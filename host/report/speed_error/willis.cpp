// See willis.hpp.
#include "host/report/speed_error/willis.hpp"

#include <fmt/core.h>

#include <functional>
#include <list>
#include <memory>
#include <utility>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/speed_error/plot.hpp"
#include "host/report/willis_scenes.hpp"

namespace sightline::harness::report {

namespace {

namespace willis = algorithms::willis;
using willis::BoundaryShape;

constexpr int deepest = 8;

std::string_view boundary_name(BoundaryShape shape) {
  return shape == BoundaryShape::oval ? "oval" : "ball";
}

willis::ModelOptions options_of(const willis::PairRules& rules, int depth) {
  willis::ModelOptions options;
  options.rules = rules;
  options.order_cells = false;
  options.limits.depth = depth;
  return options;
}

WillisPoint measure(const WillisScene& scene, const TrueFaces& truth, const willis::Model& model,
                    std::uint64_t lines) {
  WillisPoint point;
  point.pieces = model.pieces.size();
  point.left_over = model.residual.size();
  point.faces = truth.errors_of(model);
  point.lines = willis::count_lines(model, scene.scene, lines, 1);
  return point;
}

// What is to be timed when all is measured; models stay where they are.
class Timed {
 public:
  void add(const WillisScene& scene, const willis::ModelOptions& options, willis::Model model,
           std::size_t curve, std::size_t point) {
    models_.push_back(std::move(model));
    const auto frames = std::make_shared<willis::Frames>(models_.back());
    jobs_.push_back([&scene, options] { (void)scene.model(options); });
    jobs_.push_back([frames, &scene] { (void)frames->order(scene.scene.camera); });
    places_.emplace_back(curve, point);
  }
  void take(std::vector<WillisCurve>& curves, int rounds) const {
    const auto times = median_nanoseconds(jobs_, rounds);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      WillisPoint& point = curves[places_[i].first].points[places_[i].second];
      point.prepare_ns = times[2 * i];
      point.frame_ns = times[2 * i + 1];
    }
  }

 private:
  std::list<willis::Model> models_;
  std::vector<std::function<void()>> jobs_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;
};

struct Measure {
  std::string_view key;
  std::string_view title;
  double (*value)(const WillisPoint&);
};

double lines_per_cent(const WillisPoint& point) {
  if (point.lines.with_two == 0) return 0;
  return 100 * static_cast<double>(point.lines.wrong) / static_cast<double>(point.lines.with_two);
}

constexpr Measure wrong_lines{"lines", "sight lines in the wrong order", lines_per_cent};

struct Cost {
  std::string_view key;
  std::string_view title;
  Axis axis;
  bool host_time;
  double (*value)(const WillisPoint&);
};

Plot plot_of(const std::vector<WillisCurve>& curves, const Measure& measure, const Cost& cost) {
  Plot plot;
  plot.id = fmt::format("willis-{}-{}", measure.key, cost.key);
  plot.title = fmt::format("Willis: surfaces cut up to 0 to {} times: {}", deepest, cost.title);
  plot.caption =
      "Boundaries are balls. Labels are the limit of cuts, of the first curve. A curve that reaches 0 has no "
      "error that was met; one that stops short of it has the rule's.";
  plot.alternative = fmt::format("Log-log plot of {} against {}, one curve a scene, boundary and rule.",
                                 cost.axis.title, measure.title);
  plot.host_time = cost.host_time;
  plot.x = {std::string(measure.title), "%", true, {}};
  plot.y = cost.axis;
  bool first = true;
  for (const WillisCurve& of : curves) {
    // The two boundaries differ by so little that both cannot be told apart here; the table has the oval,
    // too.
    if (of.rules.shape == BoundaryShape::oval) continue;
    Curve curve;
    curve.name = fmt::format("{}{}", of.scene, of.rules.rule90 ? ", 90-degree rule" : "");
    for (const WillisPoint& point : of.points)
      curve.points.push_back(
          {measure.value(point), cost.value(point), first ? fmt::format("{}", point.depth) : ""});
    first = false;
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Table table_of(const std::vector<WillisCurve>& curves) {
  Table table;
  table.id = "willis-speed-error";
  table.title = "Willis: depth, boundary and rule";
  table.columns = {{"scene", "Scene", "", false},
                   {"boundary", "Boundary", "", false},
                   {"rule90", "90-degree rule", "", false},
                   {"depth", "Cuts up to", "", false},
                   {"pieces", "Pieces", "", false},
                   {"left_over", "Left over", "pairs", false},
                   {"pmr_inside_per_cent", "PMR inside", "%", false},
                   {"lines", "Sight lines", "", false},
                   {"lines_wrong", "in the wrong order", "", false},
                   {"lines_wrong_per_cent", "wrong", "%", false},
                   {"prepare_us", "Model made", "us", true},
                   {"frame_us", "Distances and sort", "us", true}};
  for (const WillisCurve& curve : curves) {
    for (const WillisPoint& point : curve.points) {
      const auto time = [](const std::optional<double>& ns) {
        return ns ? Cell(Real{*ns / 1000, 1}) : Cell();
      };
      table.rows.push_back({curve.scene, std::string(boundary_name(curve.rules.shape)),
                            std::string(curve.rules.rule90 ? "on" : "off"), std::int64_t{point.depth},
                            static_cast<std::int64_t>(point.pieces),
                            static_cast<std::int64_t>(point.left_over), Real{point.faces.inside_per_cent()},
                            static_cast<std::int64_t>(point.lines.with_two),
                            static_cast<std::int64_t>(point.lines.wrong), Real{lines_per_cent(point)},
                            time(point.prepare_ns), time(point.frame_ns)});
    }
  }
  table.notes = {
      "Distance alone, without order cells. Sight lines are those that meet two or more surfaces, from "
      "random places in and around the scene, a random corner of each piece standing for it; points are of "
      "160 pictures of 24 by 24 from places within it. First measured on a prototype with other towns of the "
      "same kind, in plan: 0.06 and 0.49 % of the sight lines wrong with nothing cut, 0.03 % with one cut, "
      "none seen with two or more. Far fewer lines are wrong than pairs are left over: a pair is left over "
      "if some eye could see it wrongly."};
  return table;
}

}  // namespace

std::string WillisCurve::name() const {
  return fmt::format("{}: {}{}", scene, boundary_name(rules.shape), rules.rule90 ? ", 90-degree rule" : "");
}

std::vector<WillisCurve> measure_willis(const Context& context) {
  const std::vector<WillisScene> scenes = willis_order_scenes();
  const std::uint64_t lines = context.full ? 40'000 : 4'000;
  std::vector<WillisCurve> curves;
  Timed timed;
  for (const WillisScene& scene : scenes) {
    context.progress(fmt::format("{} by distance, cut to every depth", scene.title()));
    const TrueFaces truth = true_faces(scene.scene);
    for (const BoundaryShape shape : {BoundaryShape::ball, BoundaryShape::oval}) {
      for (const bool rule90 : {false, true}) {
        curves.push_back({scene.title(), {shape, rule90}, {}});
        for (int depth = 0; depth <= deepest; ++depth) {
          const willis::ModelOptions options = options_of(curves.back().rules, depth);
          willis::Model model = scene.model(options);
          auto& points = curves.back().points;
          // Once nothing is left over, nothing more is cut.
          WillisPoint point = !points.empty() && points.back().left_over == 0
                                  ? points.back()
                                  : measure(scene, truth, model, sight_lines(scene, lines));
          point.depth = depth;
          points.push_back(point);
          if (context.host_times)
            timed.add(scene, options, std::move(model), curves.size() - 1, curves.back().points.size() - 1);
        }
      }
    }
  }
  if (context.host_times) {
    context.progress("Willis at every depth, timed");
    timed.take(curves, context.full ? 9 : 3);
  }
  return curves;
}

Outcome<std::vector<Block>> willis_error_blocks(const std::vector<WillisCurve>& curves) {
  const Cost pieces{"pieces", "pieces", {"pieces", "", true, {}}, false, [](const WillisPoint& point) {
                      return static_cast<double>(point.pieces);
                    }};
  const Cost prepare{"prepare",
                     "time of a model",
                     {fmt::format("a model, {}", host_title), "ms", true, {}},
                     true,
                     [](const WillisPoint& point) { return point.prepare_ns.value_or(0) / 1e6; }};
  const Cost frame{"frame",
                   "time of a frame",
                   {fmt::format("distances and sort, {}", host_title), "us", true, {}},
                   true,
                   [](const WillisPoint& point) { return point.frame_ns.value_or(0) / 1e3; }};
  std::vector<Block> blocks;
  if (auto error = add_figure(blocks, plot_of(curves, wrong_lines, pieces))) return std::move(*error);
  if (auto error = add_figure(blocks, plot_of(curves, wrong_lines, prepare))) return std::move(*error);
  if (auto error = add_figure(blocks, plot_of(curves, wrong_lines, frame))) return std::move(*error);
  blocks.emplace_back(table_of(curves));
  return blocks;
}

}  // namespace sightline::harness::report
