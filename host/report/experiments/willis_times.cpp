#include "host/report/experiments/willis_times.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <list>
#include <utility>

#include "host/algorithms/registry/willis_display.hpp"
#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/geometry/vector.hpp"
#include "host/picture/camera_view.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/experiments/face_tree.hpp"
#include "host/report/experiments/willis_order.hpp"
#include "host/report/experiments/willis_scenes.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

namespace {

namespace willis = algorithms::willis;
namespace display = devices::priority_display;

// The face whose plane is nearest on the line of sight of each point, of those that cover it: the "correct points" of the paper,
// "the intersection of a line from the eye ... with the surfaces in question". Each takes a division.
class SightLinePicture {
 public:
  SightLinePicture(const willis::Model& model, const scene::PolyCamera& camera, const willis::ImageWindow& window)
      : model_(model),
        window_(window),
        perspective_(camera.perspective),
        eye_(geometry::real_vector(camera.eye)),
        view_(camera),
        grid_(window.width, window.height),
        nearest_(static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height)) {}

  const picture::PixelGrid& draw(const willis::FrameSpans& frame) {
    std::fill(nearest_.begin(), nearest_.end(), 0.0);
    std::fill(grid_.values.begin(), grid_.values.end(), 0U);
    for (const willis::SurfaceSpans& surface : frame.surfaces) add(frame, surface);
    return grid_;
  }

 private:
  void add(const willis::FrameSpans& frame, const willis::SurfaceSpans& surface) {
    const willis::SurfacePlane& plane = model_.pieces[surface.piece].plane;
    const geometry::RealVector normal{static_cast<double>(plane.normal[0]), static_cast<double>(plane.normal[1]),
                                      static_cast<double>(plane.normal[2])};
    const double across = geometry::dot(normal, view_.axis(0)) / window_.scale;
    const double upwards = geometry::dot(normal, view_.axis(1)) / window_.scale;
    const double ahead = geometry::dot(normal, view_.axis(2));
    const double from_eye = static_cast<double>(plane.offset) - geometry::dot(normal, eye_);
    for (std::uint32_t i = 0; i < surface.line_count; ++i) {
      const willis::Span span = frame.spans[surface.first_span + i];
      const auto line = static_cast<int>(surface.first_line + i);
      const double y = window_.top - (line + 0.5);
      for (int column = span.from; column < span.to; ++column) {
        const double of_point = across * (column + 0.5 - window_.left) + upwards * y;
        // The distance along the line of sight, in units of the distance of the image plane.
        const double distance = perspective_ ? from_eye / (of_point + ahead) : (from_eye - of_point) / ahead;
        const std::size_t at = grid_.index(column, window_.height - 1 - line);
        if (grid_.values[at] != 0 && nearest_[at] <= distance) continue;
        nearest_[at] = distance;
        grid_.values[at] = surface.face + 1;
      }
    }
  }

  const willis::Model& model_;
  willis::ImageWindow window_;
  bool perspective_;
  geometry::RealVector eye_;
  picture::CameraView view_;
  picture::PixelGrid grid_;
  std::vector<double> nearest_;
};

FaceTree::Eye eye_of(const scene::PolyCamera& camera) {
  const auto at = [](const scene::PolyPoint& p, double sign, double weight) {
    return FaceTree::Eye{sign * p[0], sign * p[1], sign * p[2], weight};
  };
  return camera.perspective ? at(camera.eye, 1, 1) : at(camera.forward, -1, 0);
}

// Must not be moved: frames point into the model.
struct Flight {
  explicit Flight(WillisScene of)
      : scene(std::move(of)),
        model(scene.model()),
        window(willis::window_around(scene.scene, scene.scene.camera, display::columns, display::lines)),
        frames(model),
        sight_lines(model, scene.scene.camera, window),
        tree(scene.scene) {}
  Flight(const Flight&) = delete;
  Flight& operator=(const Flight&) = delete;

  std::size_t order() { return frames.order(scene.scene.camera).size(); }
  void fly() {
    willis::make_spans(model, frames.order(scene.scene.camera), scene.scene.camera, window, spans);
    (void)registry::show_on_display(spans, shown);
  }
  void make_spans() { willis::make_spans(model, frames.order(scene.scene.camera), scene.scene.camera, window, spans); }
  void draw_by_sight_lines() {
    make_spans();
    (void)sight_lines.draw(spans);
  }
  void scan_tree() { tree.paint(eye_of(scene.scene.camera), painted); }

  WillisScene scene;
  willis::Model model;
  willis::ImageWindow window;
  willis::Frames frames;
  willis::FrameSpans spans;
  registry::WillisDisplay shown;
  SightLinePicture sight_lines;
  FaceTree tree;
  std::vector<std::uint32_t> painted;
};

std::uint64_t different_points(const picture::PixelGrid& one, const picture::PixelGrid& other) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < one.values.size(); ++i) count += one.values[i] != other.values[i] ? 1U : 0U;
  return count;
}

WillisFrame frame_of(Flight& flight) {
  flight.fly();
  const willis::Model& model = flight.model;
  const std::uint64_t different = different_points(flight.sight_lines.draw(flight.spans), willis::resolve_priorities(flight.spans, flight.window));
  return {.scene = flight.scene.title(),
          .surfaces = model.surfaces,
          .tests = model.tests,
          .clusters = model.clusters,
          .pieces = model.pieces.size(),
          .order_cells = model.cells.cells,
          .left_over = model.residual.size(),
          .distances = flight.order(),
          .spans = flight.spans.spans.size(),
          .points_covered = flight.shown.device.counts().points,
          .points_different = different,
          .tree_nodes = flight.tree.nodes(),
          .tree_polygons = flight.tree.polygons().size()};
}

void time_frames(std::vector<WillisFrame>& frames, std::list<Flight>& flights, int rounds) {
  std::vector<std::function<void()>> jobs;
  for (Flight& flight : flights) {
    jobs.emplace_back([&flight] { (void)flight.scene.model(); });
    jobs.emplace_back([&flight] { (void)flight.order(); });
    jobs.emplace_back([&flight] { flight.fly(); });
    jobs.emplace_back([&flight] { flight.make_spans(); });
    jobs.emplace_back([&flight] { flight.draw_by_sight_lines(); });
    jobs.emplace_back([&flight] { flight.scan_tree(); });
  }
  const auto times = median_nanoseconds(jobs, rounds);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double* const of = &times[6 * i];
    frames[i].times = WillisFrame::Times{of[0] / 1e6, of[1] / 1e3, of[2] / 1e6, of[3] / 1e3, of[4] / 1e3, of[5] / 1e3};
  }
}

std::vector<WillisModelTime> model_times(int rounds) {
  const std::vector<WillisScene> scenes = willis_order_scenes();
  std::list<willis::Model> models;
  std::list<willis::Frames> frames;
  std::vector<std::function<void()>> jobs;
  for (const WillisScene& scene : scenes) {
    for (const WillisModelKind& kind : willis_model_kinds()) {
      willis::Frames& of_model = frames.emplace_back(models.emplace_back(scene.model(kind.options())));
      jobs.emplace_back([&scene, kind] { (void)scene.model(kind.options()); });
      jobs.emplace_back([&scene, &of_model] { (void)of_model.order(scene.scene.camera); });
    }
  }
  const auto times = median_nanoseconds(jobs, rounds);
  std::vector<WillisModelTime> of_models;
  for (std::size_t i = 0; i < times.size(); i += 2) of_models.push_back({times[i] / 1e3, times[i + 1] / 1e3});
  return of_models;
}

// The time of a frame; empty without host times.
std::optional<double> frame_ms(const WillisFrame& frame) {
  return frame.times ? std::optional(frame.times->frame_ms) : std::nullopt;
}
std::optional<double> order_us(const WillisFrame& frame) {
  return frame.times ? std::optional(frame.times->order_us) : std::nullopt;
}
std::optional<double> prepare_ms(const WillisFrame& frame) {
  return frame.times ? std::optional(frame.times->prepare_ms) : std::nullopt;
}
std::optional<double> rate(const WillisFrame& frame) {
  return frame.times ? std::optional(1000 / frame.times->frame_ms) : std::nullopt;
}

double points_a_distance(const WillisFrame& frame) {
  return static_cast<double>(frame.points_covered) / static_cast<double>(frame.distances);
}
double nodes_a_distance(const WillisFrame& frame) {
  return static_cast<double>(frame.tree_nodes) / static_cast<double>(frame.distances);
}

std::string whole_per_cent(double here, double paper) {
  return std::abs(here - paper) < 0.5 ? "equal, rounded to whole per cent" : "not equal";
}

void add_claims(Page& page, const WillisTimes& times, const WillisOrder& order) {
  const WillisDisplay& shows = times.display;
  const std::vector<WillisFrame>& frames = times.frames;
  const WillisFrame& last = frames.back();
  const std::size_t hundreds = count(frames, [](const WillisFrame& f) { return f.distances >= 100; });
  const std::size_t all_pairs = last.surfaces * last.surfaces;
  const double two_circles = only(order.areas, equals(&WillisArea::boundary, "two circles")).smaller_percent;
  const double oval = only(order.areas, equals(&WillisArea::boundary, "oval")).counted;
  const double halves = only(order.areas, equals(&WillisArea::boundary, "ovals of both halves")).smaller_percent;
  const auto figure_of = [&page](std::string_view claim) { return page.paper_figure(claim).least; };
  const double greatest_angle = greatest(order.normals, &WillisNormals::greatest_degrees);
  std::vector<ClaimRow> rows{
      {.claim = "willis.rate",
       .here = one_figure(shows.frames_per_s),
       .places = 0,
       .condition = fmt::format("priority display, {} lines of {} us", shows.scan_lines, text_of(shows.line_us, 0)),
       .comparison = fmt::format("{}: the rate of the display, for any picture",
                                 shows.frames_per_s == figure_of("willis.rate") ? "equal" : "not equal")}};
  if (page.host_times()) {
    const bool all = least(frames, &rate) >= figure_of("willis.update");
    rows.push_back({.claim = "willis.update",
                    .here = least_and_greatest(frames, &rate),
                    .places = 0,
                    .condition = "this computer, scenes of the next table, the display emulated",
                    .comparison = fmt::format(
                        "{}; no time of a program is given: a comparison needs one, with its computer and scene",
                        all ? "all are fast enough"
                            : fmt::format("{} of {} are fast enough",
                                          count(frames, [](const WillisFrame& f) { return f.times && f.times->frame_ms <= 40; }),
                                          frames.size()))});
  }
  rows.insert(
      rows.end(),
      {{.claim = "willis.lines",
        .here = least_and_greatest(frames, &points_a_distance),
        .places = 0,
        .condition = "points on lines of sight for each distance, scenes of the next tables",
        .comparison = least(frames, &points_a_distance) > 1 ? "so it is: every point that a piece covers takes a division" : "not in every scene"},
       {.claim = "willis.trees",
        .here = least_and_greatest(frames, &nodes_a_distance),
        .places = 1,
        .condition = "nodes of a BSP tree of the faces for each distance, the same scenes",
        .comparison = least(frames, &nodes_a_distance) > 1 ? "a scan compares the eye with more planes than there are distances, but needs no sort"
                                                           : "fewer nodes than distances in some scenes"},
       {.claim = "willis.surfaces",
        .here = least_and_greatest(frames, &WillisFrame::distances),
        .condition = "pieces turned to the eye, scenes of the next table",
        .comparison = fmt::format("{} of {} scenes show hundreds", hundreds, frames.size())},
       {.claim = "willis.comparisons",
        .here = {as_cell(last.tests), as_cell(all_pairs)},
        .condition = last.scene + ": boundaries tested, and N^2",
        .comparison = fmt::format(
            "{} % of N^2, once, when the model is made; a frame has {} distances and, as the display is given an order, a sort",
            text_of(100 * static_cast<double>(last.tests) / static_cast<double>(all_pairs), 1), text_of(last.distances))},
       {.claim = "willis.circles",
        .here = one_figure(two_circles),
        .places = 2,
        .condition = "two circles for an oval: (4 pi / 3 + sqrt(3) / 2) to (pi + 2)",
        .comparison = whole_per_cent(two_circles, figure_of("willis.circles"))},
       {.claim = "willis.oval",
        .here = one_figure(oval),
        .places = 4,
        .condition = "points in the boundary, counted",
        .comparison = std::abs(oval / figure_of("willis.oval") - 1) <= 0.002 ? "equal within 0.2 %" : "not equal"},
       {.claim = "willis.halves",
        .here = one_figure(halves),
        .places = 2,
        .condition = "a surface in two halves: (1 + pi / 4) to (pi + 2)",
        .comparison = whole_per_cent(halves, figure_of("willis.halves")) + ", of what the two ovals cover together"},
       {.claim = "willis.normals",
        .here = {.greatest = as_cell(greatest_angle)},
        .places = 1,
        .condition = "pairs of surfaces of which one can obscure the other, four scenes",
        .comparison = greatest_angle > figure_of("willis.normals")
                          ? fmt::format("wrong: {} of {} pairs are farther apart; see the table of the rule",
                                        text_of(sum(order.normals, &WillisNormals::pairs_over_90)),
                                        text_of(sum(order.normals, &WillisNormals::pairs)))
                          : "no pair is farther apart"}});
  page.claims("willis-paper", "Willis 1977: every number for time and size", rows);
}

void add_scenes_table(Page& page, const WillisTimes& times) {
  const WillisDisplay& shows = times.display;
  const std::size_t left_over = greatest(times.frames, &WillisFrame::left_over);
  std::vector<CheckedText> notes{
      fmt::format("A frame of 512 by 512 points from the scene's own camera. The display scans it in {} of the {} lines of a "
                  "frame, {} of {} ms. ",
                  shows.shown_lines, shows.scan_lines, text_of(static_cast<double>(shows.shown_lines) * shows.line_us / 1000, 3),
                  text_of(shows.frame_ms, 0)) +
      page.claim(left_over == 0, "No pair is left over in any scene.", fmt::format("{} are in one", left_over)) +
      " Sheets (rooms) have two sides, and so two surfaces."};
  if (page.host_times())
    notes.emplace_back(
        "A frame on this computer includes all steps: distances and sort, spans, and the display, emulated point by point.");
  page.table("willis-scenes", "Willis: models and frames", times.frames,
             {{"scene", "Scene", &WillisFrame::scene},
              {"surfaces", "Surfaces", &WillisFrame::surfaces},
              {"tests", "Boundaries tested", "pairs", &WillisFrame::tests},
              {"clusters", "Clusters", "pairs", &WillisFrame::clusters},
              {"pieces", "Pieces", &WillisFrame::pieces},
              {"order_cells", "Order cells", &WillisFrame::order_cells},
              {"left_over", "Left over", "pairs", &WillisFrame::left_over},
              {"distances", "Distances a frame", &WillisFrame::distances},
              {"spans", "Spans a frame", &WillisFrame::spans},
              {"points_covered", "Points covered", &WillisFrame::points_covered},
              {"prepare_ms", "Model made", "ms", &prepare_ms, 2, host_time},
              {"order_us", "Distances and sort", "us", &order_us, 1, host_time},
              {"order_us_per_1000", "per 1,000 pieces", "us",
               [](const WillisFrame& f) { return 1000 * order_us(f).value_or(0) / static_cast<double>(f.pieces); }, 1, host_time},
              {"frame_ms", "Frame, display emulated", "ms", &frame_ms, 2, host_time},
              {"frames_per_s", "Rate", "frames/s", &rate, 0, host_time}},
             {.notes = std::move(notes)});
}

void add_baselines_table(Page& page, const WillisTimes& times) {
  const auto& frames = times.frames;
  const auto of_times = [](double WillisFrame::Times::*member) {
    return [member](const WillisFrame& f) { return f.times ? std::optional((*f.times).*member) : std::nullopt; };
  };
  std::vector<CheckedText> notes{
      fmt::format("A point on the line of sight is found for every piece at every point of the picture that it covers, a division each: "
                  "{} to {} times as many as there are distances. ",
                  text_of(least(frames, points_a_distance), 0), text_of(greatest(frames, points_a_distance), 0)) +
          page.claim(sum(frames, &WillisFrame::points_different) == 0, "Priorities give the same picture, point for point.",
                     text_of(sum(frames, &WillisFrame::points_different)) + " points differ"),
      fmt::format("The tree is a BSP tree of the faces (Fuchs, Kedem and Naylor, 1980). A view compares the eye with the plane of every node, "
                  "also of those that are turned away: {} to {} nodes for each distance. It sorts nothing, and needs no surfaces to be cut "
                  "apart, but the faces that planes of other faces cut.",
                  text_of(least(frames, nodes_a_distance), 1), text_of(greatest(frames, nodes_a_distance), 1))};
  if (page.host_times()) {
    const auto lines = range_of(frames, [](const WillisFrame& f) { return f.times->lines_us / f.times->spans_us; });
    const auto tree = range_of(frames, [](const WillisFrame& f) { return f.times->tree_us / f.times->order_us; });
    notes.emplace_back(fmt::format("On this computer a frame with lines of sight takes {} to {} times as long as one of spans with priorities, "
                                   "and a scan of the tree {} to {} times as long as distances and sort.",
                                   text_of(lines.least, 1), text_of(lines.greatest, 1), text_of(tree.least, 2), text_of(tree.greatest, 2)));
  }
  page.table("willis-baselines", "Willis: what distances replace", frames,
             {{"scene", "Scene", &WillisFrame::scene},
              {"surfaces", "Surfaces", &WillisFrame::surfaces},
              {"pieces", "Pieces", &WillisFrame::pieces},
              {"distances", "Distances a frame", &WillisFrame::distances},
              {"points_covered", "Points on lines of sight", &WillisFrame::points_covered},
              {"points_different", "Points that differ", &WillisFrame::points_different},
              {"tree_nodes", "Nodes of the tree", &WillisFrame::tree_nodes},
              {"tree_polygons", "Polygons of the tree", &WillisFrame::tree_polygons},
              {"order_us", "Distances and sort", "us", of_times(&WillisFrame::Times::order_us), 1, host_time},
              {"tree_us", "Scan of the tree", "us", of_times(&WillisFrame::Times::tree_us), 1, host_time},
              {"spans_us", "Distances, sort and spans", "us", of_times(&WillisFrame::Times::spans_us), 0, host_time},
              {"lines_us", "The same with lines of sight", "us", of_times(&WillisFrame::Times::lines_us), 0, host_time}},
             {.notes = std::move(notes)});
}

void add_rule90_table(Page& page, const WillisTimes& times, const WillisOrder& order) {
  const auto cut = where(order.models, [](const WillisModel& m) { return m.boundary == "ball" && m.depth == deepest_cuts; });
  const auto by_rule = where(cut, &WillisModel::rule90);
  const std::uint64_t wrong_by_rule = sum(by_rule, &WillisModel::lines_wrong);
  const std::size_t left_over = sum(by_rule, &WillisModel::left_over);
  const auto whole = where(order.models, [](const WillisModel& m) { return m.left_over == 0 && !m.rule90; });
  const std::uint64_t wrong_lines = sum(whole, &WillisModel::lines_wrong);
  const std::uint64_t wrong_points = sum(whole, &WillisModel::points_wrong);
  page.table(
      "willis-rule90", "Willis: the rule that normals be within 90 degrees", cut,
      {{"scene", "Scene", &WillisModel::scene},
       {"rule90", "Rule", &WillisModel::rule},
       {"tests", "Boundaries tested", "pairs", &WillisModel::tests},
       {"clusters", "Clusters", "pairs", &WillisModel::clusters},
       {"pieces", "Pieces", &WillisModel::pieces},
       {"left_over", "Left over", "pairs", &WillisModel::left_over},
       {"lines", "Sight lines with two surfaces", &WillisModel::lines},
       {"lines_wrong", "Wrong", &WillisModel::lines_wrong},
       {"points", "Points of pictures", &WillisModel::points},
       {"points_wrong", "Wrong", &WillisModel::points_wrong},
       {"prepare_ms", "Model made", "ms", [&](const WillisModel& m) { return times.of(m, order).prepare_us / 1000; }, 2,
        host_time}},
      {.notes = {
           "With the rule fewer pairs count as clusters, so fewer surfaces are tested and cut, including some that should be. " +
               page.claim(wrong_by_rule > 0 && left_over == 0,
                          fmt::format("{} sight lines are wrong with it though no pair is left over.", text_of(wrong_by_rule)),
                          fmt::format("{} pairs are left over", left_over)) +
               " " +
               page.claim(wrong_lines == 0 && wrong_points == 0, "Without it no line or point is wrong if no pair is left over.",
                          fmt::format("{} lines and {} points are", wrong_lines, wrong_points)),
           fmt::format("Sight lines start at random positions in and around the scene; each piece is represented by a random "
                       "corner. {0} pictures have {1} by {1} points, from positions inside the scene, without points within "
                       "0.75 of an edge.",
                       WillisOrder::eyes, WillisOrder::points_a_side)}});
}

}  // namespace

const WillisModelTime& WillisTimes::of(const WillisModel& model, const WillisOrder& order) const {
  return models.at(static_cast<std::size_t>(&model - order.models.data()));
}

WillisTimes willis_times(const Context& context) {
  WillisTimes measured;
  measured.display = {1e9 / static_cast<double>(display::frame.count()), display::frame / display::line,
                      static_cast<double>(display::line.count()) / 1e3, display::lines,
                      static_cast<double>(display::frame.count()) / 1e6};
  std::vector<WillisScene> scenes{
      {"prisms-35", scene::generate_prisms(35), true}, prisms_in_space(),
      {"boxes-30", scene::generate_boxes(30), false},  {"touch-3", scene::generate_touch(3), false},
      {"rooms-3", scene::generate_rooms(3), false},    {"town-35", scene::generate_town(35), false},
      {"town-167", scene::generate_town(167), true},   {"town-167", scene::generate_town(167), false}};
  if (context.full) scenes.push_back({"town-1667", scene::generate_town(1667), false});
  std::list<Flight> flights;
  for (WillisScene& scene : scenes) {
    context.progress(fmt::format("Willis: {}", scene.title()));
    measured.frames.push_back(frame_of(flights.emplace_back(std::move(scene))));
  }
  if (!context.host_times) return measured;
  context.progress("Willis, timed");
  time_frames(measured.frames, flights, context.full ? 31 : 5);
  measured.models = model_times(context.full ? 9 : 3);
  return measured;
}

void willis_timing(Page& page, const WillisTimes& times, const WillisOrder& order) {
  add_claims(page, times, order);
  page.table(
      "willis-areas", "Willis: areas of the boundaries of a wall of length L", order.areas,
      {{"boundary", "Boundary", &WillisArea::boundary},
       {"area", "Formula", "L^2", &WillisArea::area, 4},
       {"counted", "Counted", "L^2", &WillisArea::counted, 4},
       {"smaller_percent", "Less than the oval", "%", &WillisArea::smaller_percent, 2},
       {"agree", "Comparison",
        [](const WillisArea& a) {
          return std::abs(a.counted / a.area - 1) <= 0.002 ? Verdict{true, "equal within 0.2 %"} : Verdict{false, "differs"};
        }}},
      {.folded = true});
  add_scenes_table(page, times);
  add_baselines_table(page, times);
  page.gallery("willis-pictures", fmt::format("Willis: {}, wrong points in red", order.pictures.front().scene), order.pictures,
               [](const WillisPicture& p) {
                 return figure(p.picture, fmt::format("willis-depth-{}", p.depth),
                               p.depth == 0   ? "nothing cut"
                               : p.depth == 1 ? "cut once"
                                              : fmt::format("cut up to {} times", p.depth),
                               fmt::format("{} pieces, {} pairs left over; points wrong: {} inside faces, {} at edges",
                                           text_of(p.pieces), text_of(p.left_over), text_of(p.wrong_inside), text_of(p.wrong_at_edges)),
                               fmt::format("A town of turned houses from within; {} points in red",
                                           text_of(p.wrong_inside + p.wrong_at_edges)));
               });
  add_rule90_table(page, times, order);
}

}  // namespace sightline::report
