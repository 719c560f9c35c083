// Willis's models cut to every depth, by both boundaries, with the 90-degree rule and without: how wrong the
// order of their surfaces is.
//
//   models    a model each: pairs tested and left over; sight lines that meet two or more surfaces, and those
//             on which the nearest has not the highest priority; points of pictures that show another face
//             than the nearest. A random corner stands for each piece.
//   measures  what the counts are of
//   normals   a scene each: pairs of surfaces of which one can obscure the other, and the angles between
//             their normals
//   areas     of the boundaries of a wall of length 1 in plan, by formula and counted
//   pictures  a town in space, cut never, once, and as often as it takes
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "host/algorithms/willis/boundary.hpp"
#include "host/algorithms/willis/sight_lines.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/report/experiments/willis_scenes.hpp"
#include "host/compare/hard_cases/willis_views.hpp"

namespace sightline::report {

namespace {

namespace willis = algorithms::willis;
using compare::FaceErrors;
using compare::TrueFaces;

constexpr std::size_t eyes = 160;
constexpr int points_a_side = 24;

double per_cent(std::uint64_t part, std::uint64_t whole) {
  return whole > 0 ? 100 * static_cast<double>(part) / static_cast<double>(whole) : 0;
}

struct Measured {
  FaceErrors faces;
  willis::SightLines lines;
};

void add_models(RowSet& models, const WillisScene& scene, const TrueFaces& truth, bool full) {
  // In space there are few lines that meet two surfaces, and finding them takes longer.
  const std::uint64_t lines = (full ? 40'000 : 4'000) / (scene.plan ? 1 : 4);
  constexpr std::uint64_t more = 5;  // of balls of which nothing is left over: few are wrong, if any
  std::optional<Measured> whole;     // of a model of which nothing is left over: the next ones are the same
  for (const WillisModelKind& kind : willis_model_kinds()) {
    const willis::Model model = scene.model(kind.options());
    const bool left_over = !model.residual.empty();
    if (left_over || kind.depth == 0) whole.reset();
    const bool thorough = !left_over && kind.rules.shape == willis::BoundaryShape::ball;
    const Measured measured =
        whole ? *whole
              : Measured{truth.errors_of(model),
                         willis::count_lines(model, scene.scene, thorough ? more * lines : lines, 1)};
    if (!left_over) whole = measured;
    models.add({{"scene", scene.title()},
                {"boundary", kind.boundary()},
                {"rule90", kind.rule90()},
                {"depth", kind.depth},
                {"tests", model.tests},
                {"clusters", model.clusters},
                {"pieces", model.pieces.size()},
                {"left_over", model.residual.size()},
                {"points", measured.faces.points},
                {"points_wrong", measured.faces.wrong_inside},
                {"pmr_inside_percent", measured.faces.inside_per_cent()},
                {"lines", measured.lines.with_two},
                {"lines_wrong", measured.lines.wrong},
                {"lines_wrong_percent", per_cent(measured.lines.wrong, measured.lines.with_two)}});
  }
}

double degrees_between(const willis::SurfacePlane& a, const willis::SurfacePlane& b) {
  const auto dot = [](const geometry::Vector3& u, const geometry::Vector3& v) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += static_cast<double>(u[i]) * static_cast<double>(v[i]);
    return sum;
  };
  const double cosine =
      dot(a.normal, b.normal) / std::sqrt(dot(a.normal, a.normal) * dot(b.normal, b.normal));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

void add_normals(RowSet& normals, const WillisScene& scene) {
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
  normals.add({{"scene", scene.title()},
               {"pairs", pairs},
               {"pairs_over_90", over_90},
               {"greatest_degrees", greatest}});
}

// What the boundaries of walls along x cover, as a share of the square of `length`, by counting.
double counted_area(const std::vector<std::array<std::int32_t, 2>>& walls, std::int32_t length,
                    willis::BoundaryShape shape) {
  constexpr int steps = 600;  // of a square of three lengths around the first
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

void add_areas(RowSet& areas) {
  using willis::BoundaryShape;
  constexpr std::int32_t length = 1 << 20;
  const auto add = [&](const char* boundary, double formula, double counted) {
    areas.add({{"boundary", boundary},
               {"area", formula},
               {"counted", counted},
               {"smaller_percent", 100 * (1 - formula / willis::oval_area())}});
  };
  add("oval", willis::oval_area(), counted_area({{0, length}}, length, BoundaryShape::oval));
  add("two circles", willis::two_circles_area(), counted_area({{0, length}}, length, BoundaryShape::ball));
  add("ovals of both halves", willis::halves_ovals_area(),
      counted_area({{0, length / 2}, {length / 2, length}}, length, BoundaryShape::oval));
}

// Greys by face; points at which the order is wrong in red.
picture::Image marked(const picture::PixelGrid& drawn, const picture::PixelGrid& truth) {
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

// The view of the uncut model in which most is wrong; of several, the one in which most is seen.
std::size_t worst_view(const TrueFaces& views, const willis::Model& uncut) {
  std::size_t worst = 0;
  std::pair<std::uint64_t, std::ptrdiff_t> most;
  for (std::size_t view = 0; view < views.cameras().size(); ++view) {
    const auto& truth = views.truth(view).values;
    const std::pair here{views.errors_of(views.drawn(uncut, view), view).wrong_inside,
                         std::count_if(truth.begin(), truth.end(), [](auto face) { return face != 0; })};
    if (here <= most) continue;
    most = here;
    worst = view;
  }
  return worst;
}

void add_pictures(RowSet& pictures, const WillisScene& scene, const TrueFaces& views) {
  const std::size_t view = worst_view(views, scene.model({.limits = {.depth = 0}}));
  const TrueFaces truth(scene.scene, {views.cameras().at(view)}, 256);
  for (const int depth : {0, 1, 12}) {
    const willis::Model model = scene.model({.limits = {.depth = depth}});
    const auto corners = compare::random_corners(model, static_cast<std::uint32_t>(view) + 1);
    const auto drawn = compare::ordered_faces(model, truth.cameras().front(), truth.size(), corners);
    const FaceErrors errors = truth.errors_of(drawn, 0);
    pictures.add({{"scene", scene.title()},
                  {"depth", depth},
                  {"pieces", model.pieces.size()},
                  {"left_over", model.residual.size()},
                  {"wrong_inside", errors.wrong_inside},
                  {"wrong_at_edges", errors.wrong_on_edges},
                  {"picture", png_picture(marked(drawn, truth.truth(0)), true)}});
  }
}

}  // namespace

Records willis_order(const Context& context) {
  Records records;
  add_areas(records["areas"]);
  records["measures"].add({{"eyes", eyes}, {"points_a_side", points_a_side}, {"deepest_cuts", deepest_cuts}});
  for (const WillisScene& scene : willis_order_scenes()) {
    context.progress(fmt::format("{} by distance, cut to every depth", scene.title()));
    add_normals(records["normals"], scene);
    // From among the solids, where the order is hardest. In plan the eye is between feet and tops, as it is
    // here.
    const TrueFaces truth(scene.scene, compare::cameras_within(scene.scene, eyes), points_a_side);
    add_models(records["models"], scene, truth, context.full);
    if (scene.name == prisms_in_space().name) add_pictures(records["pictures"], scene, truth);
  }
  return records;
}

}  // namespace sightline::report
