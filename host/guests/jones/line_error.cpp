#include "host/guests/jones/line_error.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace sightline::guests::jones {
namespace {

namespace oracle = algorithms::oracle;

// The straight line of space: axis, and the place on the two others.
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

// Parallels of x and y keep their direction; those of z run from the centre.
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

// Sweeps along the line: where the one covers and the other does not.
void compare(const Intervals& line, double named_from, LineError& error) {
  struct End {
    double at;
    bool drawn;
    int step;
  };
  std::vector<End> ends;
  for (const auto& [from, to] : line.visible) ends.insert(ends.end(), {{from, false, 1}, {to, false, -1}});
  for (const auto& [from, to] : line.drawn) ends.insert(ends.end(), {{from, true, 1}, {to, true, -1}});
  // Of ends at one place those that begin come first, so that what touches is one stretch.
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

}  // namespace sightline::guests::jones
