#include "host/compare/jones_precision/study.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "host/algorithms/oracle/matter.hpp"
#include "host/base/result.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::compare::jones_precision {

using namespace programs::jones;

namespace {

namespace oracle = algorithms::oracle;

// The program shows everything from the plane z = 1 on.
oracle::Window exact_window() {
  oracle::Window window;
  window.near = near_z;
  return window;
}

std::vector<DrawnLine> drawn_lines(const std::vector<std::optional<SceneLine>>& lines,
                                   const std::vector<PrecisePiece>& pieces) {
  std::vector<DrawnLine> drawn;
  for (const PrecisePiece& piece : pieces) {
    if (const auto& line = lines.at(piece.vector_address)) drawn.push_back({*line, piece.line});
  }
  return drawn;
}

std::uint64_t sum_of(const Operations& operations, std::uint64_t Work::*count) {
  std::uint64_t sum = 0;
  for (const Work* work : {&operations.projection, &operations.line_box, &operations.line_sloped,
                           &operations.mask_box, &operations.mask_sloped, &operations.mask_area})
    sum += work->*count;
  return sum;
}

namespace oracle = algorithms::oracle;

// A straight line of space: its axis, and its position on the two others.
using Carrier = std::tuple<std::size_t, std::int32_t, std::int32_t>;

Carrier carrier_of(const SceneLine& line) {
  const std::size_t one = line.axis == 0 ? 1 : 0;
  const std::size_t other = line.axis == 2 ? 1 : 2;
  return {line.axis, line.from[one], line.from[other]};
}

// The image of a straight line on the screen: a point of it and its direction.
struct Image {
  double x, y, dx, dy;
  [[nodiscard]] double along(double px, double py) const { return (px - x) * dx + (py - y) * dy; }
  [[nodiscard]] std::array<double, 2> at(double t) const { return {x + t * dx, y + t * dy}; }
};

// Parallels of x and y keep their direction; those of z start at the centre.
std::optional<Image> image_of(const SceneLine& line, const geometry::Point& eye,
                              const oracle::Window& window) {
  const double cx = window.centre[0], cy = window.centre[1];
  const double x = line.from[0] - eye[0], y = line.from[1] - eye[1], z = line.from[2] - eye[2];
  if (line.axis == 2) {
    const double far = std::hypot(x, y);
    if (far == 0) return std::nullopt;
    return Image{cx, cy, x / far, y / far};
  }
  if (z <= 0) return std::nullopt;
  if (line.axis == 0) return Image{cx, cy + y * window.scale / z, 1, 0};
  return Image{cx + x * window.scale / z, cy, 0, 1};
}

struct Intervals {
  std::optional<Image> image;
  std::optional<SceneLine> whole;
  std::vector<std::pair<double, double>> visible, drawn;

  void add(std::vector<std::pair<double, double>>& to, const SceneLine& line, const oracle::ScreenSegment& s,
           const geometry::Point& eye, const oracle::Window& window) {
    if (!image) image = image_of(line, eye, window);
    if (!image) return;
    const double a = image->along(s.x0, s.y0), b = image->along(s.x1, s.y1);
    to.push_back(std::minmax(a, b));
    if (!whole) whole = line;
    whole->from[line.axis] = std::min(whole->from[line.axis], line.from[line.axis]);
    whole->to[line.axis] = std::max(whole->to[line.axis], line.to[line.axis]);
  }
};

void add_wrong(const Intervals& line, bool extra, double from, double to, double named_from,
               LineError& error) {
  const double length = to - from;
  (extra ? error.extra : error.missing) += length;
  error.longest = std::max(error.longest, length);
  if (length <= named_from) return;
  const auto a = line.image->at(from), b = line.image->at(to);
  error.wrong.push_back({*line.whole, extra, length, {a[0], a[1], b[0], b[1]}});
}

// Sweeps along the line and finds where only one of both covers it.
void compare(const Intervals& line, double named_from, LineError& error) {
  struct End {
    double at;
    bool drawn;
    int step;
  };
  std::vector<End> ends;
  for (const auto& [from, to] : line.visible) ends.insert(ends.end(), {{from, false, 1}, {to, false, -1}});
  for (const auto& [from, to] : line.drawn) ends.insert(ends.end(), {{from, true, 1}, {to, true, -1}});
  // Of equal ends, beginnings come first, so that touching stretches are joined.
  std::sort(ends.begin(), ends.end(),
            [](const End& a, const End& b) { return std::tuple(a.at, -a.step) < std::tuple(b.at, -b.step); });
  int visible = 0, drawn = 0;
  double seen_from = 0, wrong_from = 0;
  for (const End& end : ends) {
    const bool was_wrong = (visible > 0) != (drawn > 0), was_extra = drawn > 0, was_visible = visible > 0;
    (end.drawn ? drawn : visible) += end.step;
    const bool is_wrong = (visible > 0) != (drawn > 0), is_extra = drawn > 0;
    if (!was_visible && visible > 0) seen_from = end.at;
    if (was_visible && visible == 0) error.visible += end.at - seen_from;
    const bool ends_here = was_wrong && (!is_wrong || is_extra != was_extra);
    if (ends_here && end.at > wrong_from) add_wrong(line, was_extra, wrong_from, end.at, named_from, error);
    if (is_wrong && (!was_wrong || ends_here)) wrong_from = end.at;
  }
}

}  // namespace

bool ArithmeticError::complete() const {
  return std::all_of(statuses.begin(), statuses.end(), [](Status s) { return s == Status::complete; });
}

base::Result<PrecisionStudy> PrecisionStudy::of(const scene::CellScene& scene,
                                                std::span<const geometry::Point> eyes) {
  const auto matter = oracle::Matter::of(scene);
  if (!matter) return base::Error{"", "", "found a scene with too many grid units for the exact reference"};
  const auto lines = matter->real_lines();
  PrecisionStudy study;
  study.scene_ = scene;
  for (const geometry::Point& eye : eyes) {
    auto in_core = scene_in_core(scene, eye);
    if (!in_core) return std::move(in_core.error());
    study.views_.push_back(
        {eye, std::move(*in_core), oracle::visible_lines(*matter, lines, eye, exact_window())});
  }
  return study;
}

PreciseView PrecisionStudy::run(const View& view, const Precision& precision) const {
  return run_precisely(view.in_core.core, 0, default_parameters(view.in_core.core, 0), precision);
}

void PrecisionStudy::add(ArithmeticError& sum, std::size_t view, Status status,
                         const std::vector<DrawnLine>& drawn) const {
  const LineError error =
      line_error(views_[view].truth, drawn, views_[view].eye, exact_window(), named_from_points);
  sum.visible += error.visible;
  sum.missing += error.missing;
  sum.extra += error.extra;
  sum.longest = std::max(sum.longest, error.longest);
  for (const WrongStretch& stretch : error.wrong) sum.named.push_back({view, stretch});
  sum.statuses.push_back(status);
}

Measured PrecisionStudy::measure(const Precision& precision) const {
  Measured measured;
  measured.precision = precision;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const PreciseView view = run(views_[i], precision);
    add(measured.clipped, i, view.status, drawn_lines(views_[i].in_core.lines, view.pieces));
    measured.muldivs += sum_of(view.counts.operations, &Work::muldivs);
    measured.products += sum_of(view.counts.operations, &Work::products);
    measured.largest_coordinate = std::max(measured.largest_coordinate, view.counts.largest_coordinate);
  }
  return measured;
}

base::Result<Measured> PrecisionStudy::measure_on_machine(int fraction_bits, bool truncate, bool eae) const {
  Measured measured;
  measured.precision.fraction_bits = fraction_bits;
  measured.precision.truncate = truncate;
  measured.displayed.emplace();
  const Build build{eae, static_cast<std::uint32_t>(fraction_bits), truncate};
  const auto prepared = Prepared::of(scene_, build);
  if (!prepared) return prepared.error();
  const Program& program = prepared->program();
  const auto lines = lines_by_address(program.scene, program.core);
  const ShortWords number(machine_word_bits, fraction_bits, truncate);
  const Window window;
  Order order;
  order.clock = false;
  order.views = 1;
  order.display = false;
  order.pieces = true;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    order.eye = views_[i].eye;
    const auto outcome = prepared->run(order);
    if (!outcome) return outcome.error();
    const programs::jones::View& view = outcome->view();
    std::vector<DrawnLine> clipped, displayed;
    for (std::size_t n = 0; n < view.clipped.size(); ++n) {
      const auto& line = lines.at(view.clipped[n].vector_address);
      if (!line) continue;
      const ScreenSegment& at = view.clipped[n].line;
      clipped.push_back({*line,
                         {number.points(at.a.x) + window.centre_x, number.points(at.a.y) + window.centre_y,
                          number.points(at.b.x) + window.centre_x, number.points(at.b.y) + window.centre_y}});
      if (!view.clipped[n].drawn) continue;
      const auto point = [](std::int32_t place) { return static_cast<double>(place); };
      const ScreenSegment& shown = view.on_display[n];
      displayed.push_back({*line, {point(shown.a.x), point(shown.a.y), point(shown.b.x), point(shown.b.y)}});
    }
    add(measured.clipped, i, view.status, clipped);
    add(*measured.displayed, i, view.status, displayed);
  }
  return measured;
}

std::optional<int> PrecisionStudy::shortest_complete_word(int fraction_bits, bool truncate) const {
  for (int bits = shortest_word; bits <= longest_word; ++bits) {
    const Precision precision{NumberKind::fixed_point, bits, fraction_bits, truncate};
    const auto complete = [&](const View& view) { return run(view, precision).status == Status::complete; };
    if (std::all_of(views_.begin(), views_.end(), complete)) return bits;
  }
  return std::nullopt;
}

ErrorTable measure_error_table(bool eae) {
  ErrorTable table;
  for (int f = 0; f <= 3; ++f)
    table.columns.push_back({NumberKind::fixed_point, machine_word_bits, f, false});
  for (const int f : {0, 2}) table.columns.push_back({NumberKind::fixed_point, machine_word_bits, f, true});
  for (const SixViews& views : six_views) {
    const auto scene = scene::load_cell_scene(std::string(views.scene));
    ErrorTableRow row{std::string(views.scene), {views.eyes.begin(), views.eyes.end()}, {}};
    const auto study = PrecisionStudy::of(*scene, views.eyes);
    for (const Precision& column : table.columns) {
      auto cell = study->measure_on_machine(column.fraction_bits, column.truncate, eae);
      row.cells.push_back(std::move(*cell));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

LineError line_error(const std::vector<oracle::VisibleLine>& truth, const std::vector<DrawnLine>& drawn,
                     const geometry::Point& eye, const oracle::Window& window, double named_from) {
  std::map<Carrier, Intervals> lines;
  for (const oracle::VisibleLine& seen : truth) {
    const std::size_t axis = seen.p[0] != seen.q[0] ? 0 : seen.p[1] != seen.q[1] ? 1 : 2;
    SceneLine line{axis, seen.p, seen.q};
    if (line.to[axis] < line.from[axis]) std::swap(line.from, line.to);
    Intervals& intervals = lines[carrier_of(line)];
    for (const auto& segment : oracle::on_screen({seen}, eye, window))
      intervals.add(intervals.visible, line, segment, eye, window);
  }
  for (const DrawnLine& piece : drawn) {
    Intervals& intervals = lines[carrier_of(piece.line)];
    intervals.add(intervals.drawn, piece.line, piece.piece, eye, window);
  }
  LineError error;
  for (const auto& [carrier, intervals] : lines) {
    if (intervals.image) compare(intervals, named_from, error);
  }
  return error;
}

}  // namespace sightline::compare::jones_precision
