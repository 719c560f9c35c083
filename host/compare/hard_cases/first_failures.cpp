#include "host/compare/hard_cases/first_failures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "host/algorithms/montani_re/faces.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/compare/hard_cases/montani_re_pixels.hpp"
#include "host/compare/hard_cases/runner.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::compare {

namespace {

using geometry::Span;
using scene::CellScene;
using scene::PolyPoint;
using scene::PolyScene;

// --- corridors: rooms in a row along z, with a wall without thickness and a portal in it between any two; from z =
// -100 on, the eye at the origin

struct Portal {  // strictly inside its wall
  std::int32_t z = 0;
  Span x;
  Span y;
};

// The wall around a portal: above and below it over the whole width, and beside it.
void add_wall(CellScene& scene, const Portal& portal) {
  const Span width = scene.outer.span(0);
  const Span height = scene.outer.span(1);
  scene.walls.push_back({2, portal.z, {width, Span{height.low, portal.y.low}}});
  scene.walls.push_back({2, portal.z, {width, Span{portal.y.high, height.high}}});
  scene.walls.push_back({2, portal.z, {Span{width.low, portal.x.low}, portal.y}});
  scene.walls.push_back({2, portal.z, {Span{portal.x.high, width.high}, portal.y}});
}

scene::Opening opening_of(const Portal& portal, std::size_t below) {
  const auto& [z, x, y] = portal;
  const auto across = static_cast<std::int32_t>(x.length());
  const auto up = static_cast<std::int32_t>(y.length());
  return {{below, below + 1},
          {2, z, {x, y}},
          {{x.low, y.low, z}, {x.high, y.low, z}, {x.high, y.high, z}, {x.low, y.high, z}},
          {{true, 0, across}, {true, 1, up}, {true, 0, -across}, {true, 1, -up}}};
}

std::vector<scene::Line> edges_of(const geometry::Box& room) {
  std::vector<scene::Line> lines;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [u, v] = geometry::other_axes(axis);
    for (const bool high_u : {false, true}) {
      for (const bool high_v : {false, true}) {
        scene::Line line{room.low, room.low};
        line.from[u] = line.to[u] = high_u ? room.high[u] : room.low[u];
        line.from[v] = line.to[v] = high_v ? room.high[v] : room.low[v];
        line.to[axis] = room.high[axis];
        lines.push_back(line);
      }
    }
  }
  return lines;
}

// Exactly its cells must be visited; masks keep four sides.
CaseRun corridor(const std::vector<Portal>& portals, std::int32_t end, std::int32_t half = 50) {
  CellScene scene;
  scene.name = "corridor";
  scene.outer = {{-half, -half, -100}, {half, half, end}};
  geometry::Box room = scene.outer;
  for (const Portal& portal : portals) {
    room.high[2] = portal.z;
    add_wall(scene, portal);
    scene.openings.push_back(opening_of(portal, scene.cells.size()));
    scene.cells.push_back({room, edges_of(room)});
    room.low[2] = portal.z;
  }
  room.high[2] = end;
  scene.cells.push_back({room, edges_of(room)});
  HardCase hard;
  hard.baseline = "exact";
  hard.expect.counts = {{"cells", scene.cells.size()}, {"mask_sides", 4}};
  CaseInput input;
  input.scene = scene::poly_scene_of(scene);
  input.cells = std::move(scene);
  CaseRun run(std::move(hard), std::move(input));
  run.disable_pictures();
  return run;
}

std::vector<Portal> portals_every_100(int count, const std::function<Span(int)>& x) {
  std::vector<Portal> portals;
  for (int i = 1; i <= count; ++i) portals.push_back({100 * i, x(i), {-20, 20}});
  return portals;
}

CaseRun nested(double count) {
  const int n = static_cast<int>(count);
  return corridor(portals_every_100(n, [](int) { return Span{-20, 20}; }), 100 * (n + 1));
}
CaseRun grazing(double count) {
  const int n = static_cast<int>(count);
  return corridor(portals_every_100(n, [](int i) { return Span{i, 40}; }), 100 * (n + 1));
}
CaseRun tiny_window(double z) {
  const auto at = static_cast<std::int32_t>(z);
  return corridor({{at, {0, 1}, {0, 1}}}, at + 100);
}
CaseRun near_portal(double z) {
  return corridor({{static_cast<std::int32_t>(z), {-8190, 8190}, {-4000, 4000}}}, 100, 16000);
}

// --- sheets

CaseRun run_of(PolyScene scene, Expectation expect = {}) {
  HardCase hard;
  hard.expect = std::move(expect);
  CaseInput input;
  input.scene = std::move(scene);
  return {std::move(hard), std::move(input)};
}

void add_sheet(PolyScene& scene, const std::vector<PolyPoint>& corners) {
  scene::PolyFace face;
  for (const PolyPoint& corner : corners) {
    face.outline.push_back(static_cast<scene::VertexIndex>(scene.vertices.size()));
    scene.vertices.push_back(corner);
  }
  scene.bodies.push_back({"", true, {std::move(face)}});
}

PolyScene empty_scene() {
  PolyScene scene;
  scene.camera = {false, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  return scene;
}

// (0, 0)-(length, 0) and a wall of length 1 at distance 1 from its middle.
CaseRun long_beside_small(double value) {
  const auto length = static_cast<std::int32_t>(value);
  PolyScene scene = empty_scene();
  const auto add_upright = [&scene](std::int32_t from, std::int32_t to, std::int32_t z) {
    add_sheet(scene, {{from, -1, z}, {to, -1, z}, {to, 1, z}, {from, 1, z}});
  };
  add_upright(0, length, 0);
  add_upright(length / 2, length / 2 + 1, 1);
  CaseRun run = run_of(std::move(scene));
  run.disable_pictures();
  return run;
}

// Bars along the sides of a regular polygon of n corners p, rounded to integers, four times as large: bar k begins
// far, a quarter of a side before p(k), and ends near, a quarter beyond p(k + 1).
CaseRun pinwheel(double bars) {
  const int n = static_cast<int>(bars);
  PolyScene scene = empty_scene();
  const auto corner = [n](int k) {
    const double angle = 2 * std::numbers::pi * k / n;
    return std::array{static_cast<std::int32_t>(std::lround(100 * std::cos(angle))),
                      static_cast<std::int32_t>(std::lround(100 * std::sin(angle)))};
  };
  for (int k = 0; k < n; ++k) {
    const auto p = corner(k);
    const auto q = corner((k + 1) % n);
    const auto at = [&](std::int32_t along, std::int32_t out) {
      return PolyPoint{4 * p[0] + along * (q[0] - p[0]) + out * (p[0] + q[0]),
                       4 * p[1] + along * (q[1] - p[1]) + out * (p[1] + q[1]), -200 * along};
    };
    add_sheet(scene, {at(-1, 0), at(5, 0), at(5, 1), at(-1, 1)});
  }
  Expectation expect;
  expect.counts = {{"cycles_cut", 1}};
  return run_of(std::move(scene), std::move(expect));
}

// A pixel has 4096 units. The triangle is 40 pixels long, its base on a line between stripes of 8.
constexpr std::int32_t sliver_pixel = 4096;

CaseRun sliver(double height) {
  const auto high = static_cast<std::int32_t>(sliver_pixel * height);
  constexpr std::int32_t length = 40 * sliver_pixel;
  PolyScene scene = empty_scene();
  add_sheet(scene, {{0, 0, 0}, {length, 0, 0}, {length, high, 0}});
  add_sheet(
      scene,
      {{-8, -8, 9}, {length + 8, -8, 9}, {length + 8, 20 * sliver_pixel, 9}, {-8, 20 * sliver_pixel, 9}});
  return run_of(std::move(scene));
}

// --- trials

Trial trial_of(const Finding& finding) {
  Trial trial;
  if (finding.good != true)
    trial.fault = finding.text.starts_with("differs: ") ? finding.text.substr(9) : finding.text;
  return trial;
}

using Generate = CaseRun (*)(double value);
// Tries a build on a case that is made once for all builds.
using Attempt = Trial (*)(CaseRun& run, const FamilyBuild& build, double value);

Trial run_method(CaseRun& run, const FamilyBuild& build, double) {
  return trial_of(run.run(build.method, build.options));
}

// Counts the pieces of both walls. It is a failure if some are left over.
Trial count_pieces(CaseRun& run, const FamilyBuild& build, double) {
  Trial trial = trial_of(run.run(build.method, build.options));
  const auto prepared =
      registry::find_face_algorithm(build.method)->prepare(*run.input().scene, build.options.faces);
  for (const registry::FaceCount& count : prepared->counts)
    if (count.name == "pieces") trial.measure = static_cast<double>(count.value);
  return trial;
}

// About 0.4 pixels per unit: compares pixels farther than 0.75 pixels from all edges.
Trial compare_pinwheel(CaseRun& run, const FamilyBuild& build, double value) {
  if (build.method != "stripes") return run_method(run, build, value);
  constexpr compare::PixelParts parts{4, 10, {0, 0}};
  const PolyScene& scene = *run.input().scene;
  const auto view = compare::pixels_along_z(scene, parts);
  registry::FaceOptions options;
  options.stripe = build.options.stripes.front();
  const auto prepared = registry::find_face_algorithm("montani-re")->prepare(scene, options);
  const auto drawn =
      prepared->view(scene.camera, {view.frame.width, view.frame.height, view.frame.scale[0],
                                    view.frame.centre[0], view.frame.height - view.frame.centre[1]});
  const auto metrics = picture::pixel_metrics(view.truth, drawn->faces, view.edges);
  Trial trial;
  trial.measure = static_cast<double>(metrics.different_inside);
  if (metrics.different_inside != 0)
    trial.fault = fmt::format("{} of {} pixels away from edges show another face", metrics.different_inside,
                              metrics.pixels - metrics.boundary_pixels);
  return trial;
}

// The share of the triangle's area that its stripes cover, in per cent.
double covered_percent(const PolyScene& scene, double thickness, double height) {
  namespace native = algorithms::montani_re;
  const auto made = native::faces_of(scene, scene.camera);
  const auto& set = *made;
  constexpr double scale = 1.0 / sliver_pixel;
  const auto units = static_cast<std::int32_t>(16 / thickness);
  const auto pcs = native::stripe_pcs(set.image, set.faces[0].pcs, {{scale, scale}, {8, 8}, 64, 64}, units);
  return 100 * compare::square_pixels(pcs, units) / (20 * height);
}

Trial compare_sliver(CaseRun& run, const FamilyBuild& build, double height) {
  if (build.method != "stripes") return run_method(run, build, height);
  Trial trial;
  trial.measure = covered_percent(*run.input().scene, build.options.stripes.front(), height);
  if (std::abs(*trial.measure - 100) >= 1) trial.fault = fmt::format("{:.0f} % of its area", *trial.measure);
  return trial;
}

Trial find_sliver(CaseRun& run, const FamilyBuild& build, double height) {
  Trial trial;
  trial.measure = covered_percent(*run.input().scene, build.options.stripes.front(), height);
  if (*trial.measure == 0) trial.fault = "nothing is drawn";
  return trial;
}

// --- a nearer and a farther line that cross on Skala's screen

constexpr double last_column = 255;

// A floor, the nearer line, the farther line, and a ceiling, seen level, so that a height is a row. The lines cross
// in column d, at slopes that differ by 1 / d.
CaseRun crossing(double d) {
  HardCase hard;
  hard.options.view.family = algorithms::skala::Family::along_x;
  hard.options.view.elevation = 0;
  hard.options.view.rims = false;
  scene::HeightGrid grid{scene::even_positions(2),
                         scene::even_positions(4),
                         {0, 0, 100, 101, 99, 100 + last_column / d, last_column, last_column},
                         {},
                         {},
                         {}};
  grid.range = scene::finite_range(grid.heights);
  CaseInput input;
  input.heights = std::move(grid);
  return {std::move(hard), std::move(input)};
}

double near_height(double x) {
  return 100 + x / last_column;
}

// The first column where something is visible above the nearer line and below the ceiling.
double first_above(const HeightPicture& picture) {
  if (!picture.drawing) {
    for (int x = 0; x <= static_cast<int>(last_column); ++x) {
      const int row = static_cast<int>(std::floor(near_height(x) + 0.5));
      for (int y = row + 1; y < static_cast<int>(last_column); ++y)
        if (picture.dots.at(x, y) != 0) return x;
    }
    return last_column;
  }
  for (const picture::DrawingLine& line : picture.drawing->lines) {
    const picture::DrawingPoint from = picture.drawing->points[line.first];
    const picture::DrawingPoint to = picture.drawing->points[line.first + line.count - 1];
    if (double{to.x} > last_column - 1 && to.y > near_height(last_column) &&
        double{to.y} < last_column - 1e-3)
      return from.x;
  }
  return last_column;
}

Trial place_crossing(CaseRun& run, const FamilyBuild& build, double d, double limit) {
  algorithms::skala::View view = run.hard().options.view;
  view.columns = build.options.view.columns;
  const auto picture = find_height_method(build.method)->draw(*run.input().heights, view);
  Trial trial;
  trial.measure = std::abs(first_above(picture) - d);
  if (*trial.measure > limit) trial.fault = fmt::format("off by {:.2f} columns", *trial.measure);
  return trial;
}
Trial within_a_column(CaseRun& run, const FamilyBuild& build, double d) {
  return place_crossing(run, build, d, 1);
}
Trial within_d_columns(CaseRun& run, const FamilyBuild& build, double d) {
  return place_crossing(run, build, d, d);
}

// --- nearly equal angles and crossings of Plantinga, Seales and Dyer

namespace native = algorithms::plantinga;
using native::Segment;

// Two directions X : Z, the second after the first: consecutive quotients of Fibonacci numbers, which have the least
// angles between fractions of their size.
struct TwoDirections {
  explicit TwoDirections(int n) {
    std::array<std::int64_t, 3> f{1, 1, 2};
    for (int i = 0; i < n; ++i) f = {f[1], f[2], f[1] + f[2]};
    first = {f[0], f[1]};
    second = {f[1], f[2]};
    if (n % 2 == 0) std::swap(first, second);
  }
  // -log2 of the angle between the directions.
  [[nodiscard]] double separation() const {
    const auto length = [](const std::array<std::int64_t, 2>& d) {
      return std::hypot(static_cast<double>(d[0]), static_cast<double>(d[1]));
    };
    return std::log2(length(first)) + std::log2(length(second));
  }

  std::array<std::int64_t, 2> first;
  std::array<std::int64_t, 2> second;
};

// The sine of the second minus the sine of the first, up to a positive factor.
template <class Real>
bool by_products(const TwoDirections& two) {
  const Real left = static_cast<Real>(two.second[0]) * static_cast<Real>(two.first[1]);
  const Real right = static_cast<Real>(two.second[1]) * static_cast<Real>(two.first[0]);
  return left - right > 0;
}
template <class Real>
bool by_angles(const TwoDirections& two) {
  const auto angle = [](const std::array<std::int64_t, 2>& d) {
    return std::atan2(static_cast<Real>(d[0]), static_cast<Real>(d[1]));
  };
  return angle(two.first) < angle(two.second);
}
bool exactly(const TwoDirections& two) {
  return native::compare(native::rational_direction(two.first[0], two.first[1]),
                         native::rational_direction(two.second[0], two.second[1])) < 0;
}

// Seen along Z, two edges cross an upright edge, at parameters that differ by 2^-3j: the lower has the denominator
// (2^j + 1) 2^j, the upper (2^j - 1) 2^j, with numerators of the least possible difference.
using ThreeEdges = std::array<Segment, 3>;
ThreeEdges triple_point(int j) {
  const std::int64_t two = std::int64_t{1} << j;
  const auto across = [](std::int64_t numerator, std::int64_t width, std::int64_t z) {
    const std::int64_t low = numerator / width;
    const std::int64_t left = numerator % width;
    return Segment{{-left, low, z}, {width - left, low + 1, z}};
  };
  return {Segment{{0, 0, 0}, {0, two, 0}}, across(two * two / 2 + two + 1, two + 1, 3),
          across(two * two / 2, two - 1, 5)};
}

// Whether N / D of equation 5a along Z is less for the second edge than for the third.
template <class Real>
bool crossings_in_order(const ThreeEdges& edges) {
  const auto crossing_with = [&](const Segment& g) {
    const auto along = [](std::int64_t from, std::int64_t to) { return static_cast<Real>(to - from); };
    const Segment& e = edges[0];
    const Real gx = along(g.from[0], g.to[0]);
    const Real gy = along(g.from[1], g.to[1]);
    const Real ex = along(e.from[0], e.to[0]);
    const Real ey = along(e.from[1], e.to[1]);
    const Real n = along(e.from[0], g.from[0]) * gy - along(e.from[1], g.from[1]) * gx;
    return std::pair<Real, Real>{n, ex * gy - ey * gx};
  };
  const auto [n2, d2] = crossing_with(edges[1]);
  const auto [n3, d3] = crossing_with(edges[2]);
  return n2 * d3 < n3 * d2;
}
bool crossings_exactly(const ThreeEdges& edges) {
  return native::meeting_form(native::crossing_of(edges[0], edges[1]),
                              native::crossing_of(edges[0], edges[2]))
             .zz < 0;
}

// Whether the first edge ends at the second, when the second and third edges are the lower sides of sheets before the
// first. It must.
bool ends_at_the_lower(const ThreeEdges& edges) {
  PolyScene scene = empty_scene();
  for (const Segment& edge : edges) {
    const auto point = [](const native::Vector3& p) {
      return PolyPoint{static_cast<std::int32_t>(p[0]), static_cast<std::int32_t>(p[1]),
                       static_cast<std::int32_t>(p[2])};
    };
    const std::int64_t x = edge.from[0] == edge.to[0] ? edge.from[0] + 1 : 0;
    const std::int64_t y = &edge == &edges[0] ? 0 : 2 * edges[0].to[1];
    add_sheet(scene, {point(edge.from), point(edge.to), point({x, y, edge.from[2]})});
  }
  const native::RotationModel model(scene);
  const auto edge_of = [&](scene::VertexIndex from, scene::VertexIndex to) {
    const auto found = std::find_if(model.edges().begin(), model.edges().end(), [&](const auto& edge) {
      return std::minmax(edge.from, edge.to) == std::minmax(from, to);
    });
    return static_cast<native::EdgeIndex>(found - model.edges().begin());
  };
  const native::EdgeIndex upright = edge_of(0, 1);
  const auto pieces = native::structure_at(model, upright, model.occluders_of(upright), {0, 1});
  return pieces.size() == 1 && pieces[0].high == native::End::of(native::EndKind::junction, edge_of(3, 4));
}

Trial in_order(bool right, double bits) {
  Trial trial;
  trial.shown = bits;
  if (!right) trial.fault = "the wrong order";
  return trial;
}

struct AngleBuild {
  std::string_view name;
  bool (*right)(const TwoDirections&);
};
constexpr std::array angle_builds{AngleBuild{"angles in single precision", by_angles<float>},
                                  AngleBuild{"products in single precision", by_products<float>},
                                  AngleBuild{"angles in doubles", by_angles<double>},
                                  AngleBuild{"products in doubles", by_products<double>},
                                  AngleBuild{"exact", exactly}};
struct CrossingBuild {
  std::string_view name;
  bool (*right)(const ThreeEdges&);
};
constexpr std::array crossing_builds{CrossingBuild{"single precision", crossings_in_order<float>},
                                     CrossingBuild{"doubles", crossings_in_order<double>},
                                     CrossingBuild{"exact", crossings_exactly},
                                     CrossingBuild{"plantinga", ends_at_the_lower}};

// Null if there is no row of that name.
template <class Rows>
auto find_row(const Rows& rows, std::string_view name) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [name](const auto& row) { return row.name == name; });
  return found != rows.end() ? &*found : nullptr;
}

Trial order_angles(CaseRun&, const FamilyBuild& build, double n) {
  const TwoDirections two(static_cast<int>(n));
  return in_order(find_row(angle_builds, build.method)->right(two), two.separation());
}
Trial order_crossings(CaseRun&, const FamilyBuild& build, double j) {
  return in_order(find_row(crossing_builds, build.method)->right(triple_point(static_cast<int>(j))), 3 * j);
}

CaseRun nothing(double) {
  return {HardCase{}, CaseInput{}};
}

// --- generators by their names in the manifest

struct Generator {
  std::string_view name;
  Generate generate;
  Attempt attempt;
};

constexpr std::array generators{
    Generator{"nested", nested, run_method},
    Generator{"grazing", grazing, run_method},
    Generator{"tiny-window", tiny_window, run_method},
    Generator{"near-portal", near_portal, run_method},
    Generator{"crossing-to-a-column", crossing, within_a_column},
    Generator{"crossing-to-d-columns", crossing, within_d_columns},
    Generator{"long-beside-small", long_beside_small, count_pieces},
    Generator{"pinwheel", pinwheel, compare_pinwheel},
    Generator{"sliver", sliver, compare_sliver},
    Generator{"sliver-drawn", sliver, find_sliver},
    Generator{"neighbouring-angles", nothing, order_angles},
    Generator{"triple-point", nothing, order_crossings},
    Generator{"triple-point-of-sheets", nothing, order_crossings},
};

bool knows(Attempt attempt, std::string_view method) {
  if (attempt == order_angles) return find_row(angle_builds, method) != nullptr;
  if (attempt == order_crossings) return find_row(crossing_builds, method) != nullptr;
  return is_method(method);
}

std::string name_of(const FamilyBuild& build) {
  const MethodOptions& options = build.options;
  if (options.precision) return fmt::format("{}, {}", build.method, jones_precision::name(*options.precision));
  if (build.method == "stripes")
    return fmt::format("stripes of {} pixel{}", options.stripes.front(),
                       options.stripes.front() > 1 ? "s" : "");
  if (build.method == "willis") return options.faces.oval ? "willis, ovals" : "willis, two circles";
  if (build.method == "native") return fmt::format("native, masks of {} columns", options.view.columns);
  return build.method;
}

}  // namespace

SearchResult find_first_failure(const std::vector<double>& values, bool bisect,
                                const std::function<Trial(double value)>& attempt) {
  std::map<std::size_t, Trial> tried;
  const auto fails = [&](std::size_t i) {
    return tried.emplace(i, attempt(values[i])).first->second.fault.has_value();
  };
  std::optional<std::size_t> first;
  std::size_t right = 0;  // the values before this one are right
  for (std::size_t step = 1; right < values.size() && !first; step = bisect ? 2 * step : 1) {
    const std::size_t i = std::min(right + step, values.size()) - 1;
    if (fails(i)) {
      first = i;
    } else {
      right = i + 1;
    }
  }
  while (first && right < *first) {
    const std::size_t middle = right + (*first - right) / 2;
    if (fails(middle)) {
      first = middle;
    } else {
      right = middle + 1;
    }
  }
  SearchResult result;
  for (auto& [i, trial] : tried) {
    if (i == first) result.first = result.tried.size();
    result.tried.emplace_back(values[i], std::move(trial));
  }
  return result;
}

base::Result<std::vector<FamilyResult>> run_family(const Family& family) {
  const Generator* const generator = find_row(generators, family.generator);
  if (generator == nullptr)
    return base::Error{.place = family.id,
                       .found = fmt::format("there is no generator \"{}\"", family.generator)};
  std::map<double, std::unique_ptr<CaseRun>> made;
  std::vector<FamilyResult> results;
  for (const FamilyBuild& build : family.builds) {
    if (!knows(generator->attempt, build.method))
      return base::Error{.place = family.id, .found = fmt::format("there is no build \"{}\"", build.method)};
    std::vector<double> values = family.values;
    if (build.to) values.erase(std::next(std::find(values.begin(), values.end(), *build.to)), values.end());
    FamilyResult result{name_of(build), {}};
    result.search = find_first_failure(values, family.bisect, [&](double value) {
      std::unique_ptr<CaseRun>& run = made[value];
      if (!run) run = std::make_unique<CaseRun>(generator->generate(value));
      return generator->attempt(*run, build, value);
    });
    result.as_recorded = result.search.first.has_value() == build.first.has_value();
    if (result.as_recorded && build.first) {
      // The manifest gives tenths.
      const auto& [value, trial] = result.search.tried[*result.search.first];
      result.as_recorded = std::abs(trial.shown.value_or(value) - *build.first) <= 0.05 + 1e-9;
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace sightline::compare
