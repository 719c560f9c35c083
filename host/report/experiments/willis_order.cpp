#include "host/report/experiments/willis_order.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "host/algorithms/willis/boundary.hpp"
#include "host/algorithms/willis/sight_lines.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/report/experiments/willis_scenes.hpp"
#include "host/report/experiments/willis_times.hpp"
#include "host/compare/hard_cases/willis_views.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

namespace {

namespace willis = algorithms::willis;
using compare::FaceErrors;
using compare::TrueFaces;

double per_cent(std::uint64_t part, std::uint64_t whole) {
  return whole > 0 ? 100 * static_cast<double>(part) / static_cast<double>(whole) : 0;
}

struct Measured {
  FaceErrors faces;
  willis::SightLines lines;
};

void add_models(std::vector<WillisModel>& models, const WillisScene& scene, const TrueFaces& truth, bool full) {
  // In space few lines meet two surfaces, and finding them takes longer.
  const std::uint64_t lines = (full ? 40'000 : 4'000) / (scene.plan ? 1 : 4);
  constexpr std::uint64_t more = 5;  // for balls without pairs left over, where few lines are wrong, if any
  std::optional<Measured> whole;     // of a model without pairs left over: further cuts do not change it
  for (const WillisModelKind& kind : willis_model_kinds()) {
    const willis::Model model = scene.model(kind.options());
    const bool left_over = !model.residual.empty();
    if (left_over || kind.depth == 0) whole.reset();
    const bool thorough = !left_over && kind.rules.shape == willis::BoundaryShape::ball;
    const Measured measured =
        whole ? *whole
              : Measured{truth.errors_of(model), willis::count_lines(model, scene.scene, thorough ? more * lines : lines, 1)};
    if (!left_over) whole = measured;
    models.push_back({.scene = scene.title(),
                      .boundary = kind.boundary(),
                      .rule90 = kind.rules.rule90,
                      .depth = kind.depth,
                      .tests = model.tests,
                      .clusters = model.clusters,
                      .pieces = model.pieces.size(),
                      .left_over = model.residual.size(),
                      .points = measured.faces.points,
                      .points_wrong = measured.faces.wrong_inside,
                      .pmr_inside_percent = measured.faces.inside_per_cent(),
                      .lines = measured.lines.with_two,
                      .lines_wrong = measured.lines.wrong,
                      .lines_wrong_percent = per_cent(measured.lines.wrong, measured.lines.with_two)});
  }
}

double degrees_between(const willis::SurfacePlane& a, const willis::SurfacePlane& b) {
  const auto dot = [](const geometry::Vector3& u, const geometry::Vector3& v) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += static_cast<double>(u[i]) * static_cast<double>(v[i]);
    return sum;
  };
  const double cosine = dot(a.normal, b.normal) / std::sqrt(dot(a.normal, a.normal) * dot(b.normal, b.normal));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

WillisNormals normals_of(const WillisScene& scene) {
  const willis::Model uncut = scene.model({.order_cells = false, .limits = {.depth = 0}});
  std::uint64_t pairs = 0;
  std::uint64_t over_90 = 0;
  double greatest = 0;
  for (const willis::Surface& s : uncut.pieces) {
    for (const willis::Surface& t : uncut.pieces) {
      if (s.body == t.body || !willis::can_obscure(s, t)) continue;
      ++pairs;
      over_90 += willis::can_obscure(s, t, true) ? 0 : 1;
      greatest = std::max(greatest, degrees_between(s.plane, t.plane));
    }
  }
  return {scene.title(), pairs, over_90, greatest};
}

// The area inside the boundaries of walls along x, divided by the square of `length`, by counting.
double counted_area(const std::vector<std::array<std::int32_t, 2>>& walls, std::int32_t length, willis::BoundaryShape shape) {
  constexpr int steps = 600;  // across a square of three lengths around the first wall
  std::vector<willis::Surface> surfaces;
  for (const auto& [from, to] : walls) {
    willis::Surface wall;
    wall.points = {{from, 0, 0}, {to, 0, 0}};
    wall.plane.normal = {0, 0, 1};
    surfaces.push_back(std::move(wall));
  }
  const auto at = [length](int step) {
    return static_cast<std::int32_t>(std::int64_t{3} * length * (2 * step + 1) / (2 * steps) - length);
  };
  int inside = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      inside += std::any_of(surfaces.begin(), surfaces.end(), [&](const willis::Surface& wall) {
        return willis::in_boundary(wall, {at(i), 0, at(j) - length / 2}, shape);
      });
  return 9.0 * inside / (steps * steps);
}

std::vector<WillisArea> boundary_areas() {
  using willis::BoundaryShape;
  constexpr std::int32_t length = 1 << 20;
  const auto area = [](const char* boundary, double formula, double counted) {
    return WillisArea{boundary, formula, counted, 100 * (1 - formula / willis::oval_area())};
  };
  return {area("oval", willis::oval_area(), counted_area({{0, length}}, length, BoundaryShape::oval)),
          area("two circles", willis::two_circles_area(), counted_area({{0, length}}, length, BoundaryShape::ball)),
          area("ovals of both halves", willis::halves_ovals_area(),
               counted_area({{0, length / 2}, {length / 2, length}}, length, BoundaryShape::oval))};
}

// Greys by face; points with wrong order in red.
picture::Image mark_errors(const picture::PixelGrid& drawn, const picture::PixelGrid& truth) {
  picture::Image image(drawn.width, drawn.height, 3);
  for (int row = 0; row < drawn.height; ++row) {
    for (int column = 0; column < drawn.width; ++column) {
      const std::uint32_t face = drawn.at(column, row);
      const auto grey = static_cast<std::uint8_t>(face == 0 ? 255 : 90 + face * 53 % 120);
      std::uint8_t* const point = &image.pixels[image.index(column, drawn.height - 1 - row)];
      const bool wrong = face != truth.at(column, row);
      point[0] = wrong ? 230 : grey;
      point[1] = point[2] = wrong ? 0 : grey;
    }
  }
  return image;
}

// The view with most errors in the uncut model; of several, the one in which most is visible.
std::size_t worst_view(const TrueFaces& views, const willis::Model& uncut) {
  std::size_t worst = 0;
  std::pair<std::uint64_t, std::ptrdiff_t> most;
  for (std::size_t view = 0; view < views.cameras().size(); ++view) {
    const auto& truth = views.truth(view).values;
    const std::pair here{views.errors_of(views.draw(uncut, view), view).wrong_inside,
                         std::count_if(truth.begin(), truth.end(), [](auto face) { return face != 0; })};
    if (here <= most) continue;
    most = here;
    worst = view;
  }
  return worst;
}

void add_pictures(std::vector<WillisPicture>& pictures, const WillisScene& scene, const TrueFaces& views) {
  const std::size_t view = worst_view(views, scene.model({.limits = {.depth = 0}}));
  const TrueFaces truth(scene.scene, {views.cameras().at(view)}, 256);
  for (const int depth : {0, 1, 12}) {
    const willis::Model model = scene.model({.limits = {.depth = depth}});
    const auto corners = compare::random_corners(model, static_cast<std::uint32_t>(view) + 1);
    const auto drawn = compare::ordered_faces(model, truth.cameras().front(), truth.size(), corners);
    const FaceErrors errors = truth.errors_of(drawn, 0);
    pictures.push_back({scene.title(), depth, model.pieces.size(), model.residual.size(), errors.wrong_inside,
                        errors.wrong_on_edges, png_picture(mark_errors(drawn, truth.truth(0)), true)});
  }
}

CheckedText without_rule(const Page& page, const std::vector<WillisModel>& models) {
  const std::uint64_t wrong =
      sum(where(models, [](const WillisModel& m) { return m.left_over == 0 && !m.rule90; }), &WillisModel::lines_wrong);
  return page.claim(wrong == 0,
                    "Without the rule no line is wrong in a model of which no pair is left over: its point is at the mark 0.",
                    fmt::format("{} lines are wrong", wrong));
}

CheckedText with_rule(const Page& page, const std::vector<WillisModel>& models) {
  const auto whole = where(models, [](const WillisModel& m) { return m.left_over == 0 && m.rule90; });
  const std::size_t wrong = count(whole, [](const WillisModel& m) { return m.lines_wrong > 0; });
  return page.claim(wrong > 0,
                    fmt::format("With the 90-degree rule, lines are wrong in {} of {} such models.", wrong, whole.size()));
}

// A curve for each scene and rule; boundaries are balls.
template <class Y>
void add_lines_plot(Page& page, const std::vector<WillisModel>& models, std::string_view id, std::string_view what, CheckedText caption,
                    Axis y, Y value) {
  Plot plot{.id = fmt::format("willis-lines-{}", id),
            .title = fmt::format("Willis: surfaces cut up to 0 to {} times: {}", deepest_cuts, what),
            .caption = std::move(caption),
            .alternative =
                fmt::format("Log-log plot of {}{} against sight lines in the wrong order, one curve for each scene and rule.",
                            what == "pieces" ? "" : "the ", what),
            .x = {"sight lines in the wrong order", "%"},
            .y = std::move(y)};
  const std::string first = models.front().scene;
  add_curves(plot, where(models, equals(&WillisModel::boundary, "ball")),
             [](const WillisModel& m) { return m.scene + (m.rule90 ? ", 90-degree rule" : ""); },
             &WillisModel::lines_wrong_percent, value, {.label = [first](const WillisModel& m) {
               return m.scene == first && !m.rule90 && m.left_over > 0 ? text_of(m.depth) : std::string();
             }});
  page.plot(std::move(plot));
}

}  // namespace

WillisOrder willis_order(const Context& context) {
  WillisOrder measured;
  measured.areas = boundary_areas();
  for (const WillisScene& scene : willis_order_scenes()) {
    context.progress(fmt::format("{} by distance, cut to every depth", scene.title()));
    measured.normals.push_back(normals_of(scene));
    // The eye is among the solids, where ordering is hardest. In plan it must be between feet and tops, as it is
    // here.
    const TrueFaces truth(scene.scene, compare::cameras_within(scene.scene, WillisOrder::eyes), WillisOrder::points_a_side);
    add_models(measured.models, scene, truth, context.full);
    if (scene.name == prisms_in_space().name) add_pictures(measured.pictures, scene, truth);
  }
  return measured;
}

void willis_accuracy(Page& page, const WillisOrder& order, const WillisTimes& times) {
  const std::vector<WillisModel>& models = order.models;
  const double uncut = greatest(where(models, equals(&WillisModel::depth, 0)), &WillisModel::lines_wrong_percent);
  const std::uint64_t cut =
      sum(where(models, [](const WillisModel& m) { return m.depth == deepest_cuts && !m.rule90; }), &WillisModel::lines_wrong);
  page.paragraph(
      "Surfaces in the order of their distances, each cut as often as the limit allows until no two are in each other's "
      "boundary, compared with the nearest face on every sight line. " +
      page.claim(uncut > 0 && cut == 0,
                 fmt::format("Without cuts at most {} % of the sight lines are in the wrong order; with up to {} cuts, and "
                             "without the 90-degree rule, none.",
                             text_of(uncut, 2), deepest_cuts),
                 fmt::format("{} lines are wrong", cut)));

  add_lines_plot(page, models, "pieces", "pieces",
                 "Boundaries are balls. Labels are the limit of cuts, of the first curve. " + without_rule(page, models) + " " +
                     with_rule(page, models),
                 {"pieces"}, [](const WillisModel& m) { return static_cast<double>(m.pieces); });
  if (page.host_times()) {
    const CheckedText caption("As above. Times are medians of interleaved repetitions, of this computer.");
    add_lines_plot(page, models, "prepare", "time of a model", caption, {"a model, time on this computer", "ms"},
                   [&](const WillisModel& m) { return times.of(m, order).prepare_us / 1000; });
    add_lines_plot(page, models, "frame", "time of a frame", caption, {"distances and sort, time on this computer", "us"},
                   [&](const WillisModel& m) { return times.of(m, order).order_us; });
  }

  const auto left_over = where(models, [](const WillisModel& m) { return m.left_over > 0; });
  const double most_wrong = greatest(left_over, &WillisModel::lines_wrong_percent);
  const auto pairs = range_of(left_over, &WillisModel::left_over);
  page.table(
      "willis-speed-error", "Willis: limit of cuts, boundary and rule", models,
      {{"scene", "Scene", &WillisModel::scene},
       {"boundary", "Boundary", &WillisModel::boundary},
       {"rule90", "90-degree rule", &WillisModel::rule},
       {"depth", "Cuts up to", &WillisModel::depth},
       {"pieces", "Pieces", &WillisModel::pieces},
       {"left_over", "Left over", "pairs", &WillisModel::left_over},
       {"pmr_inside_percent", "Differing pixels inside faces", "%", &WillisModel::pmr_inside_percent},
       {"lines", "Sight lines", &WillisModel::lines},
       {"lines_wrong", "in the wrong order", &WillisModel::lines_wrong},
       {"lines_wrong_percent", "wrong", "%", &WillisModel::lines_wrong_percent},
       {"prepare_us", "Model made", "us", [&](const WillisModel& m) { return times.of(m, order).prepare_us; }, 1, host_time},
       {"order_us", "Distances and sort", "us", [&](const WillisModel& m) { return times.of(m, order).order_us; }, 1, host_time}},
      {.notes =
           {fmt::format(
                "Distance alone, without order cells. Sight lines are those that meet two or more surfaces, from random "
                "positions in and around the scene; each piece is represented by a random corner. There are five times as many "
                "where boundaries are balls and no pair is left over. Points are those of {0} pictures of {1} by {1} from "
                "positions inside the scene. ",
                WillisOrder::eyes, WillisOrder::points_a_side) +
            page.claim(most_wrong < 2,
                       fmt::format("Few lines are wrong, at most {} %, where {} to {} pairs are left over: a pair is left over "
                                   "if some eye could see it wrongly.",
                                   text_of(most_wrong, 2), text_of(pairs.least), text_of(pairs.greatest)),
                       text_of(most_wrong) + " % of the lines are wrong")},
       .folded = true});
}

}  // namespace sightline::report
