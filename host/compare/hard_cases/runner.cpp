#include "host/compare/hard_cases/runner.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <utility>

#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/base/text.hpp"
#include "host/compare/device_raster.hpp"
#include "host/compare/lines.hpp"
#include "host/geometry/box.hpp"
#include "host/geometry/interval_set.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/programs/skala/projection.hpp"
#include "host/programs/skala/skala.hpp"
#include "host/programs/skala/twin/twin.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/line_metrics_parts.hpp"
#include "host/compare/hard_cases/case_images.hpp"
#include "host/compare/hard_cases/montani_re_pixels.hpp"
#include "host/compare/hard_cases/willis_views.hpp"
#include "host/scene/cells/from_cell_scene.hpp"
#include "host/scene/cells/grid/decompose.hpp"
#include "host/scene/model/eye_place.hpp"

namespace sightline::compare {

namespace {

namespace oracle = algorithms::oracle;
namespace jones = programs::jones;
namespace skala = programs::skala;
using picture::LinePicture;
using picture::PixelGrid;
using scene::PolyCamera;
using scene::PolyScene;

Finding not_applicable(const std::string& why) {
  return {std::nullopt, "not applicable: " + why};
}

// A list of errors; empty if there are none.
class Complaints {
 public:
  void add(const std::string& text) { text_ += (text_.empty() ? "" : "; ") + text; }
  template <class Count>
  void compare(const Expectation& expect, const std::vector<Count>& counts) {
    for (const Count& count : counts) {
      const auto wanted = expect.counts.find(std::string(count.name));
      if (wanted == expect.counts.end() || wanted->second == count.value) continue;
      std::string name(count.name);
      std::replace(name.begin(), name.end(), '_', ' ');
      add(fmt::format("{} {}, not {}", name, count.value, wanted->second));
    }
  }
  [[nodiscard]] Finding finding(const std::string& when_right = "right") const {
    if (text_.empty()) return {true, when_right};
    return {false, "differs: " + text_};
  }

 private:
  std::string text_;
};

// --- lines

void check_segments(const Expectation& expect, const LinePicture& picture, const PolyScene& scene,
                    Complaints& complaints) {
  const auto wrong = [&](const std::vector<SceneSegment>& segments, SegmentSeen expected) {
    return std::count_if(segments.begin(), segments.end(), [&](const SceneSegment& segment) {
      return seen_of(segment, picture, scene) != expected;
    });
  };
  if (const auto count = wrong(expect.seen, SegmentSeen::whole); count != 0)
    complaints.add(fmt::format("{} lines not seen whole", count));
  if (const auto count = wrong(expect.hidden, SegmentSeen::nothing); count != 0)
    complaints.add(fmt::format("{} lines not hidden", count));
}

// Checks that bodies that intersect, and only these, are rejected with their names.
Finding refused_by_name(const Expectation& expect, const std::string& error) {
  const bool named =
      expect.through && std::all_of(expect.through->begin(), expect.through->end(), [&](auto body) {
        return error.find(fmt::format("body {}", body)) != std::string::npos;
      });
  return {named, (named ? "right: refused: " : "refused: ") + error};
}

// --- faces

double area_of(const registry::FaceRegion& region) {
  double twice = 0;
  for (const auto& loop : region.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& p = loop[i];
      const auto& q = loop[(i + 1) % loop.size()];
      twice += p.x * q.y - q.x * p.y;
    }
  }
  return twice / 2;
}

// By body; faces are numbered over all bodies from 1.
class AreasByBody {
 public:
  explicit AreasByBody(const PolyScene& scene) : areas_(scene.bodies.size()) {
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
      bodies_.insert(bodies_.end(), scene.bodies[body].faces.size(), body);
  }
  void add(std::uint32_t face, double area) { areas_[bodies_[face - 1]] += area; }
  void compare(const Expectation& expect, Complaints& complaints) {
    if (expect.areas.empty()) return;
    for (double& area : areas_) area = std::round(area * 1e6) / 1e6;
    if (areas_ != expect.areas) complaints.add(fmt::format("seen areas {}", base::joined(areas_, ", ")));
  }

 private:
  std::vector<std::size_t> bodies_;
  std::vector<double> areas_;
};

registry::FaceWindow window_of(const algorithms::montani_re::StripeFrame& frame) {
  return {frame.width, frame.height, frame.scale[0], frame.centre[0], frame.height - frame.centre[1]};
}

// --- dots

bool lit_near(const PixelGrid& dots, const oracle::RasterDot& dot, int reach) {
  for (int y = dot.y - reach; y <= dot.y + reach; ++y)
    for (int x = dot.x - reach; x <= dot.x + reach; ++x)
      if (x >= 0 && x < dots.width && y >= 0 && y < dots.height && dots.at(x, y) != 0) return true;
  return false;
}

std::vector<oracle::RasterDot> dots_between(const std::vector<skala::Vertex>& vertices) {
  std::vector<oracle::RasterDot> dots;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    const auto some = oracle::segment_dots(vertices[i].column, vertices[i].row, vertices[i + 1].column,
                                           vertices[i + 1].row);
    dots.insert(dots.end(), some.begin(), some.end());
  }
  return dots;
}

std::vector<oracle::RasterDot> dots_that_must_be_lit(const LitDots& lit, const scene::HeightGrid& grid,
                                                     const algorithms::skala::View& view) {
  const skala::Projection projection(grid, view);
  std::vector<oracle::RasterDot> dots;
  const auto add = [&](const std::optional<std::array<std::size_t, 2>>& range, std::size_t across, auto at) {
    for (std::size_t line = range ? (*range)[0] : 1; line <= (range ? (*range)[1] : 0); ++line) {
      std::vector<skala::Vertex> vertices;
      for (std::size_t i = 0; i < across; ++i) vertices.push_back(at(line, i));
      const auto some = dots_between(vertices);
      dots.insert(dots.end(), some.begin(), some.end());
    }
  };
  add(lit.slices, grid.points(),
      [&](std::size_t slice, std::size_t point) { return projection.at(point, slice); });
  add(lit.points, grid.slices(),
      [&](std::size_t point, std::size_t slice) { return projection.at(point, slice); });
  std::erase_if(dots, [&](const oracle::RasterDot& dot) {
    const bool on_screen =
        dot.x >= 0 && dot.x < skala::raster_side && dot.y >= 0 && dot.y < skala::raster_side;
    return !on_screen || (lit.columns && (dot.x < (*lit.columns)[0] || dot.x > (*lit.columns)[1]));
  });
  return dots;
}

// reach: tolerance of vectors, which may be a dot away from a raster's rounded dots.
void check_dots(const Expectation& expect, const scene::HeightGrid& grid, const algorithms::skala::View& view,
                const PixelGrid& dots, int reach, Complaints& complaints) {
  const auto lit_dots = std::count(dots.values.begin(), dots.values.end(), 1U);
  if (expect.dots && reach == 0 && static_cast<std::size_t>(lit_dots) != *expect.dots)
    complaints.add(fmt::format("{} dots, not {}", lit_dots, *expect.dots));
  if (!expect.lit) return;
  const auto wanted = dots_that_must_be_lit(*expect.lit, grid, view);
  const auto dark = std::count_if(wanted.begin(), wanted.end(),
                                  [&](const oracle::RasterDot& dot) { return !lit_near(dots, dot, reach); });
  if (dark != 0) complaints.add(fmt::format("{} dots dark that must be lit", dark));
  if (expect.lit->alone && reach == 0) {
    PixelGrid alone(dots.width, dots.height);
    for (const oracle::RasterDot& dot : wanted) alone.set(dot.x, dot.y, 1);
    const auto others = lit_dots - std::count(alone.values.begin(), alone.values.end(), 1U);
    if (others != 0) complaints.add(fmt::format("{} other dots", others));
  }
  if (expect.lit->row) {
    bool any = false;
    for (int x = 0; x < dots.width; ++x) any = any || dots.at(x, *expect.lit->row) != 0;
    if (!any) complaints.add(fmt::format("nothing in row {}", *expect.lit->row));
  }
}

void compare_dots(const PixelGrid& truth, const PixelGrid& drawn, Complaints& complaints) {
  const auto metrics = picture::pixel_metrics(truth, drawn, {});
  if (metrics.missing + metrics.extra != 0)
    complaints.add(fmt::format("{} dots missing, {} too many", metrics.missing, metrics.extra));
}

// At a rotation of 0, the grid's side edges are in one column with the ends of all slices. The raster's order, slices
// first, hides one of the two there; vectors show both.
PixelGrid without_outer_columns(PixelGrid grid) {
  for (int y = 0; y < skala::raster_side; ++y)
    for (const int x : {0, skala::raster_side - 1}) grid.set(x, y, 0);
  return grid;
}

void compare_vectors(const PixelGrid& truth, const PixelGrid& drawn, bool straight_on,
                     Complaints& complaints) {
  const auto metrics =
      straight_on ? picture::pixel_metrics(without_outer_columns(truth), without_outer_columns(drawn), {})
                  : picture::pixel_metrics(truth, drawn, {});
  if (metrics.missing_far + metrics.extra_far != 0)
    complaints.add(fmt::format("{} dots missing, {} too many, by more than a dot", metrics.missing_far,
                               metrics.extra_far));
}

// --- programs with cells

// Why a scene of polyhedra cannot be a scene for Jones's program.
std::string why_no_cells(const PolyScene& scene) {
  if (const auto error = scene::why_no_grid(scene)) return error->message();
  for (const scene::PolyPoint& vertex : scene.vertices) {
    for (const std::int32_t coordinate : vertex) {
      if (std::abs(coordinate) >= geometry::coordinate_limit)
        return fmt::format("found the coordinate {}, the program's are below {}", coordinate,
                           geometry::coordinate_limit);
    }
  }
  return "the scene has no cells";
}

struct ProgramCount {
  std::string_view name;
  std::uint64_t value = 0;
};

Finding run_in_arithmetic(const Expectation& expect, const scene::CellScene& scene,
                          const jones_precision::Precision& precision) {
  const auto made = jones_precision::scene_in_core(scene, scene.default_view);
  if (!made) return {false, made.error().message()};
  const auto& core = made->core;
  const auto view = jones_precision::run_precisely(core, 0, jones::default_parameters(core, 0), precision);
  Complaints complaints;
  if (view.status != jones::Status::complete)
    complaints.add(std::string(jones::name(view.status)));
  else
    complaints.compare(expect, std::vector<ProgramCount>{{"cells", view.counts.distinct_cells}});
  return complaints.finding();
}

// --- segments

bool on_line(const SceneSegment& segment, const scene::PolyPoint& point) {
  const auto& [from, to] = segment;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    if (std::int64_t{to[a] - from[a]} * (point[b] - from[b]) !=
        std::int64_t{to[b] - from[b]} * (point[a] - from[a]))
      return false;
  }
  return true;
}

std::size_t longest_axis(const SceneSegment& segment) {
  const auto length = [&](std::size_t a) { return std::abs(segment[1][a] - segment[0][a]); };
  std::size_t longest = 0;
  for (const std::size_t a : {1U, 2U})
    if (length(a) > length(longest)) longest = a;
  return longest;
}

// The coordinate from + s (to - from); empty if the fraction is too long.
std::optional<geometry::Rational> coordinate(std::int64_t from, std::int64_t to,
                                             const geometry::Rational& s) {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  const geometry::Int128 numerator =
      geometry::Int128{from} * s.denominator() + geometry::Int128{to - from} * s.numerator();
  if (numerator > most || numerator < -most) return std::nullopt;
  return geometry::Rational(static_cast<std::int64_t>(numerator), s.denominator());
}

}  // namespace

SegmentSeen seen_of(const SceneSegment& segment, const LinePicture& picture, const PolyScene& scene) {
  const std::size_t axis = longest_axis(segment);
  const auto [low, high] = std::minmax(segment[0][axis], segment[1][axis]);
  geometry::IntervalSet seen;
  for (const picture::LinePiece& piece : picture.pieces) {
    const scene::PolyPoint& from = scene.vertices[piece.edge.from];
    const scene::PolyPoint& to = scene.vertices[piece.edge.to];
    if (!on_line(segment, from) || !on_line(segment, to)) continue;
    auto a = coordinate(from[axis], to[axis], piece.low);
    auto b = coordinate(from[axis], to[axis], piece.high);
    if (!a || !b) return SegmentSeen::in_part;
    if (*b < *a) std::swap(a, b);
    seen.unite(*a, *b);
  }
  seen.intersect(low, high);
  if (seen.empty()) return SegmentSeen::nothing;
  return seen == geometry::IntervalSet(low, high) ? SegmentSeen::whole : SegmentSeen::in_part;
}

bool is_method(std::string_view name) {
  return name == "willis" || name == "stripes" || registry::find_line_algorithm(name) != nullptr ||
         find_height_method(name) != nullptr;
}

std::vector<PolyCamera> CaseRun::cameras() const {
  if (!hard_.turn) return hard_.cameras.empty() ? std::vector{input_->scene->camera} : hard_.cameras;
  // Some fixed directions of small integers, and random ones.
  std::vector<std::array<std::int32_t, 2>> sights{{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {1, 1}, {4, -3}, {3, 4}};
  std::mt19937 random(1990);
  const auto part = [&random] { return static_cast<std::int32_t>(random() % 20001) - 10000; };
  while (sights.size() < 24) {
    const std::int32_t x = part();
    sights.push_back({x, part()});
  }
  std::vector<PolyCamera> cameras;
  for (const auto& [x, z] : sights) cameras.push_back({false, {0, 0, 0}, {-x, 0, -z}, {z, 0, -x}, {0, 1, 0}});
  return cameras;
}

const LinePicture& CaseRun::baseline(std::size_t camera) {
  if (baselines_.empty()) {
    const auto prepared = registry::find_line_algorithm(hard_.baseline)->prepare(*input_->scene);
    for (const PolyCamera& of : cameras()) {
      const auto view = prepared->view(of);
      baselines_.emplace_back(view->picture);
    }
  }
  return *baselines_[camera];
}

Finding CaseRun::run(std::string_view method, const MethodOptions& options) {
  Finding finding = judge(method, options);
  finding.image = std::exchange(image_, std::nullopt);
  finding.truth = std::exchange(truth_, std::nullopt);
  return finding;
}

Finding CaseRun::judge(std::string_view method, const MethodOptions& options) {
  if (!input_) return {hard_.expect.refused, "refused: " + input_.error()};
  if (hard_.expect.refused) return {false, "accepted"};
  if (!input_->screens.empty()) return run_commands(method);
  if (input_->heights) return run_heights(method, options);
  if (method == "guest" || method == "twin") return run_cell_program(method, options);
  if (method == "willis") return run_ordered_faces(options);
  if (method == "stripes") return run_stripes(options);
  return run_lines(method, options);
}

Finding CaseRun::run_lines(std::string_view method, const MethodOptions& options) {
  const registry::LineAlgorithm* const algorithm = registry::find_line_algorithm(method);
  if (algorithm == nullptr) return {false, fmt::format("there is no method {}", method)};
  const PolyScene& scene = *input_->scene;
  const Expectation& expect = hard_.expect;
  if (const auto reason = algorithm->why_not(scene)) return not_applicable(*reason);
  auto made = input_->cells && algorithm->prepare_cells != nullptr
                  ? algorithm->prepare_cells(scene::complex_of(*input_->cells, scene))
                  : algorithm->prepare(scene);
  if (!made) return {false, "refused: " + made.error().message()};
  Complaints complaints;
  const auto all = cameras();
  for (std::size_t i = 0; i < all.size(); ++i) {
    // If the eye is on a face, Jones's cells are tested on the side of the direction of view; other methods have no
    // answer there.
    const auto no_eye = scene::eye_error(scene, all[i]);
    if (no_eye && method != "jones") return not_applicable(no_eye->message());
    if (const auto reason = algorithm->why_not_seen(scene, all[i])) return not_applicable(*reason);
    const auto drawn = made->view(all[i]);
    if (!drawn) return refused_by_name(expect, drawn.error().message());
    const auto& view = *drawn;
    keep_image(image_, [&] { return lines_image(view.picture, scene, all[i], {}, image_side_); });
    if (!no_eye && method != hard_.baseline &&
        !registry::agrees(*algorithm, view.picture, baseline(i), scene, all[i]))
      complaints.add(fmt::format("not the picture of {}", hard_.baseline));
    complaints.compare(expect, view.counts);
    check_segments(expect, view.picture, scene, complaints);
  }
  if (expect.areas.empty()) return complaints.finding();
  AreasByBody areas(scene);
  const auto view = compare::pixels_along_z(scene, compare::on_lines);
  if (method == "oracle") {  // one sight line through every unit square
    for (const std::uint32_t face : view.truth.values)
      if (face != 0) areas.add(face, 1);
    areas.compare(expect, complaints);
  }
  if (const auto* const faces = registry::find_face_algorithm(method); faces != nullptr) {
    if (expect.through) return {false, "accepted"};
    const auto prepared = faces->prepare(scene, options.faces);
    const auto regions = prepared->regions(scene.camera, window_of(view.frame));
    for (const registry::FaceRegion& region : regions->regions) areas.add(region.face, area_of(region));
    areas.compare(expect, complaints);
  }
  return complaints.finding();
}

// From the scene's own camera and from four sides, 90 degrees wide. Within 0.75 points of an edge rounding may choose
// either face.
Finding CaseRun::run_ordered_faces(const MethodOptions& options) {
  constexpr int size = 128;
  const PolyScene& scene = *input_->scene;
  const Expectation& expect = hard_.expect;
  const auto made = registry::find_face_algorithm("willis")->prepare(scene, options.faces);
  if (!made) return {false, "refused: " + made.error().message()};
  const auto& prepared = *made;
  Complaints complaints;
  complaints.compare(expect, prepared.counts);
  if (prepared.not_solved.empty() == expect.left_over)
    complaints.add(expect.left_over ? "nothing is left over" : prepared.not_solved.front());
  std::vector<std::string> found;
  for (const registry::FaceCount& count : prepared.counts) {
    std::string name(count.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    found.push_back(fmt::format("{} {}", name, count.value));
  }
  if (!prepared.not_solved.empty()) found.push_back("left over, named: " + prepared.not_solved.front());
  if (!pictures_) return complaints.finding(base::joined(found, ", "));
  auto cameras = compare::cameras_around(scene, scene.camera.eye[1]);
  const auto no_eye = scene::eye_error(scene, scene.camera);
  if (no_eye.has_value() != expect.eye_refused)
    complaints.add(no_eye ? no_eye->message() : "the eye is accepted");
  if (no_eye) {
    found.push_back("the eye is refused");
  } else {
    cameras.insert(cameras.begin(), scene.camera);
  }
  const compare::TrueFaces truth(scene, std::move(cameras), size);
  const registry::FaceWindow window{size, size, size / 2.0, size / 2.0, size / 2.0};
  compare::FaceErrors errors;
  for (std::size_t i = 0; i < truth.cameras().size(); ++i) {
    const auto view = prepared.view(truth.cameras()[i], window);
    if (!view) return {false, "refused: " + view.error().message()};
    errors.add(truth.errors_of(view->faces, i));
    keep_image(image_, [&] { return faces_image(view->faces, image_side_); });
    keep_image(truth_, [&] { return faces_image(truth.truth(i), image_side_); });
  }
  found.push_back(fmt::format("{} of {} points wrong in {} views, {} more next to edges", errors.wrong_inside,
                              errors.points, truth.cameras().size(), errors.wrong_on_edges));
  if (errors.wrong_inside != 0 && !expect.left_over) complaints.add("points wrong");
  const Finding finding = complaints.finding();
  return {finding.good, fmt::format("{}: {}", finding.text, base::joined(found, ", "))};
}

// With corners on lines between stripes every pixel must be right; otherwise only those not on an edge.
Finding CaseRun::run_stripes(const MethodOptions& options) {
  namespace pixels = sightline::compare;
  const PolyScene& scene = *input_->scene;
  Complaints complaints;
  std::string on_edges;
  const auto check = [&](const pixels::PixelView& view, double thickness,
                         auto judge) -> std::optional<Finding> {
    registry::FaceOptions faces;
    faces.stripe = thickness;
    const auto prepared = registry::find_face_algorithm("montani-re")->prepare(scene, faces);
    const auto drawn = prepared->view(scene.camera, window_of(view.frame));
    if (!drawn) return refused_by_name(hard_.expect, drawn.error().message());
    judge(picture::pixel_metrics(view.truth, drawn->faces, view.edges));
    keep_image(image_, [&] { return faces_image(drawn->faces, image_side_); });
    keep_image(truth_, [&] { return faces_image(view.truth, image_side_); });
    return std::nullopt;
  };
  const auto on = pixels::pixels_along_z(scene, pixels::on_lines);
  for (const double thickness : options.stripes) {
    const auto refused = check(on, thickness, [&](const picture::PixelMetrics& metrics) {
      if (metrics.different() != 0)
        complaints.add(fmt::format("{} pixels wrong with corners on lines, stripes of {} pixels",
                                   metrics.different(), thickness));
    });
    if (refused) return *refused;
  }
  const auto refused = check(pixels::pixels_along_z(scene, pixels::off_lines), 1, [&](const auto& metrics) {
    if (metrics.different_inside != 0)
      complaints.add(fmt::format("{} pixels wrong away from edges", metrics.different_inside));
    on_edges = fmt::format("right; corners off the lines: {} of {} pixels differ, all on edges",
                           metrics.different(), metrics.pixels);
  });
  if (refused) return *refused;
  if (hard_.expect.through) return {false, "accepted"};
  return complaints.finding(on_edges);
}

// Points of the display farther than one point from the reference are wrong.
Finding CaseRun::run_cell_program(std::string_view method, const MethodOptions& options) {
  constexpr double wrong_from = 1;
  if (!input_->cells) return not_applicable(why_no_cells(*input_->scene));
  const scene::CellScene& scene = *input_->cells;
  const Expectation& expect = hard_.expect;
  if (options.precision) return run_in_arithmetic(expect, scene, *options.precision);
  jones::Order order;
  order.scale = options.scale;
  order.views = 1;
  order.display = false;
  const auto prepared = jones::Prepared::of(scene);
  const auto twin = prepared ? prepared->twin(order) : base::Result<jones::TwinView>(prepared.error());
  if (!twin) return {expect.program_refuses, (pictures_ ? "refuses: " : "") + twin.error().message()};
  if (expect.program_refuses) return {false, "accepted"};
  const jones::Program& program = prepared->program();

  std::vector<ProgramCount> counts{{"cells", twin->counts.distinct_cells}, {"visits", twin->counts.visits}};
  Complaints complaints;
  if (method == "guest") {
    const auto outcome = prepared->run(order);
    if (!outcome) return {false, outcome.error().message()};
    const jones::View& view = outcome->view();
    if (const std::string difference = jones::difference_of(view, *twin); !difference.empty())
      return {false, "differs: not its twin's view: " + difference};
    counts = {{"cells", view.distinct_cells}, {"visits", view.visits}};
  }
  const jones::Status status = twin->status;
  if (status != jones::Status::complete)
    complaints.add(fmt::format("stops with \"{}\"", jones::name(status)));
  if (pictures_) {
    const auto matter = compare::MatterScene::of(scene);
    if (!matter) return {false, "the scene is too large for the oracle"};
    scene::PolyCamera camera;
    camera.eye = scene.default_view;
    const auto chosen = matter->lines_at(camera.eye);
    const compare::ImageLines reference(matter->visible(camera.eye, type340_window(options.scale)), matter->scene(), camera,
                                        type340_frame(options.scale), &chosen);
    const auto vectors = compare::lines_of_vectors(program.scene, *matter, reference);
    const auto pieces = method == "guest" ? compare::display_pieces(*twin, vectors) : compare::twin_pieces(*twin, vectors);
        keep_image(image_, [&] { return screen_image(pieces, image_side_); });
    keep_image(truth_, [&] {
      std::vector<picture::DrawnPiece> seen;
      for (const picture::ReferenceLine& line : reference.lines())
        for (const picture::LinePart& part : line.visible)
          seen.push_back({line.id, {picture::point_at(line.image, part.low), picture::point_at(line.image, part.high)}});
      return screen_image(seen, image_side_);
    });
    const auto metrics = picture::line_metrics(reference.lines(), pieces);
    if (metrics.extra_far > wrong_from)
      complaints.add(fmt::format("{:.1f} points too much", metrics.extra_far));
    if (metrics.missing_far > wrong_from)
      complaints.add(fmt::format("{:.1f} points missing", metrics.missing_far));
  }
  complaints.compare(expect, counts);
  return complaints.finding();
}

Finding CaseRun::run_heights(std::string_view name, const MethodOptions& options) {
  const HeightMethod* const method = find_height_method(name);
  if (method == nullptr) return {false, fmt::format("there is no method {}", name)};
  const scene::HeightGrid& grid = *input_->heights;
  const algorithms::skala::View& view = options.view;
  if (const auto reason = method->why_not(grid, view)) return not_applicable(*reason);
  const HeightPicture picture = method->draw(grid, view);
  Complaints complaints;
  if (!picture.fault.empty()) complaints.add(picture.fault);
  keep_image(image_, [&] { return dots_image(picture.dots); });
  const bool vectors = picture.drawing.has_value();
  check_dots(hard_.expect, grid, view, picture.dots, vectors ? 1 : 0, complaints);
  const HeightMethod& truth = *find_height_method("oracle");
  if (method == &truth || truth.why_not(grid, view)) return complaints.finding();
  if (vectors) {
    compare_vectors(oracle_dots(grid, view, false), picture.dots, std::fmod(view.rotation, 90) == 0,
                    complaints);
  } else {
    compare_dots(truth.draw(grid, view).dots, picture.dots, complaints);
  }
  return complaints.finding();
}

Finding CaseRun::run_commands(std::string_view method) {
  if (method == "native") return not_applicable("draws grids, and lines instead of dots");
  Complaints complaints;
  for (const CommandScreen& screen : input_->screens) {
    if (method == "oracle") {
      keep_image(image_, [&] { return dots_image(screen.truth); });
      const auto lit = std::count(screen.truth.values.begin(), screen.truth.values.end(), 1U);
      if (hard_.expect.dots && static_cast<std::size_t>(lit) != *hard_.expect.dots)
        complaints.add(fmt::format("{} dots, not {}", lit, *hard_.expect.dots));
      continue;
    }
    PixelGrid dots;
    if (method == "guest") {
      const auto run = skala::run(screen.stream, skala::Device::ef9365, true);
      if (!run) {
        complaints.add(run.error().message());
        continue;
      }
      dots = points_of(run->picture.raster);
    } else {
      dots = points_of(skala::run_twin(screen.stream).raster(skala::Device::ef9365));
    }
    keep_image(image_, [&] { return dots_image(dots); });
    compare_dots(screen.truth, dots, complaints);
  }
  return complaints.finding();
}

}  // namespace sightline::compare
