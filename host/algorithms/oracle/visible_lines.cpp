#include "host/algorithms/oracle/visible_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/algorithms/oracle/sight_fan.hpp"

namespace sightline::algorithms::oracle {
namespace {

using geometry::IntervalSet;
using geometry::Point;
using geometry::Rational;

Point relative(const Point& p, const Point& eye) {
  return {p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]};
}

// Whether the line is a feature of a quadrant that contains the eye or has it on its border. `r` is the line relative to
// the eye.
bool feature_for(const RealLine& line, const Point& r) {
  const auto [u, v] = geometry::other_axes(line.axis);
  for (const int high_u : {0, 1}) {
    for (const int high_v : {0, 1}) {
      const bool there = (high_u ? r[u] <= 0 : r[u] >= 0) && (high_v ? r[v] <= 0 : r[v] >= 0);
      if (there && line.feature[static_cast<std::size_t>(high_u + 2 * high_v)]) return true;
    }
  }
  return false;
}

// Keeps the coordinates x with k x + m >= 0.
void keep_half(IntervalSet& seen, std::int64_t k, std::int64_t m) {
  if (k == 0) {
    if (m < 0) seen = {};
  } else if (!seen.empty()) {
    const Rational limit(-m, k);
    const Rational low = seen.intervals().front().low;
    const Rational high = seen.intervals().back().high;
    if (k > 0)
      seen.intersect(std::max(low, limit), high);
    else
      seen.intersect(low, std::min(high, limit));
  }
}

// `seen` contains coordinates along the line, relative to the eye; `r` is any point of the line.
void keep_window(IntervalSet& seen, std::size_t axis, const Point& r, const Window& window) {
  if (axis == 2)
    keep_half(seen, 1, -std::int64_t{window.near});
  else
    keep_half(seen, 0, std::int64_t{r[2]} - window.near);
  for (std::size_t b = 0; b < 2; ++b) {
    for (const bool high : {false, true}) {
      // scale * r_b - bound * r_z >= 0, or <= 0 for the high bound
      const std::int64_t sign = high ? -1 : 1;
      const std::int64_t bound = (high ? window.points[b].high : window.points[b].low) - window.centre[b];
      const std::int64_t of_b = sign * window.scale;
      const std::int64_t of_z = -sign * bound;
      const std::int64_t k = axis == b ? of_b : axis == 2 ? of_z : 0;
      const std::int64_t m = (axis == b ? 0 : of_b * r[b]) + (axis == 2 ? 0 : of_z * r[2]);
      keep_half(seen, k, m);
    }
  }
}

// window: null for all around the eye.
VisibleLine seen_of(const Matter& matter, const RealLine& line, const Point& eye, const Window* window) {
  VisibleLine result{line.from, line.to, {}};
  const Point r = relative(line.from, eye);
  const auto [u, v] = geometry::other_axes(line.axis);
  if ((r[u] == 0 && r[v] == 0) || !feature_for(line, r)) return result;
  const std::int64_t start = r[line.axis];
  const std::int64_t length = std::int64_t{line.to[line.axis]} - line.from[line.axis];
  IntervalSet seen(start, start + length);
  if (window) keep_window(seen, line.axis, r, *window);
  if (!seen.empty()) SightFan(matter, line, eye).subtract_shadows(seen);
  const auto parameter = [&](const Rational& x) {
    return Rational(x.numerator() - start * x.denominator(), x.denominator() * length);
  };
  for (const auto& piece : seen.intervals())
    result.intervals.unite(parameter(piece.low), parameter(piece.high));
  return result;
}

std::vector<VisibleLine> seen_of_all(const Matter& matter, const std::vector<RealLine>& lines, const Point& eye, const Window* window) {
  std::vector<VisibleLine> visible;
  for (const RealLine& line : lines) {
    VisibleLine seen = seen_of(matter, line, eye, window);
    if (!seen.intervals.empty()) visible.push_back(std::move(seen));
  }
  return visible;
}

}  // namespace

bool is_line_for(const RealLine& line, const Point& eye) {
  return feature_for(line, relative(line.from, eye));
}

std::vector<VisibleLine> visible_lines(const Matter& matter, const std::vector<RealLine>& lines,
                                       const Point& eye, const Window& window) {
  return seen_of_all(matter, lines, eye, &window);
}

std::optional<std::vector<VisibleLine>> visible_lines(const scene::CellScene& scene, const Point& eye,
                                                      const Window& window) {
  const auto matter = Matter::of(scene);
  if (!matter) return std::nullopt;
  return visible_lines(*matter, matter->real_lines(), eye, window);
}

std::vector<ScreenSegment> on_screen(const std::vector<VisibleLine>& lines, const Point& eye,
                                     const Window& window) {
  std::vector<ScreenSegment> segments;
  for (const VisibleLine& line : lines) {
    const Point p = relative(line.p, eye);
    const Point q = relative(line.q, eye);
    const auto project = [&](const Rational& parameter, std::size_t b) {
      const double t = parameter.to_double();
      const auto along = [&](std::size_t a) { return p[a] + t * (q[a] - p[a]); };
      return along(b) * window.scale / along(2) + window.centre[b];
    };
    for (const auto& [low, high] : line.intervals.intervals()) {
      segments.push_back({project(low, 0), project(low, 1), project(high, 0), project(high, 1)});
    }
  }
  return segments;
}

namespace {

// The part of a line that is before the sides of a window, from `low` to `high` of its length.
struct Part {
  double low = 0, high = 1;

  // dp, dq: distances of the ends from a side, negative beyond it.
  void keep(double dp, double dq) {
    if (dp < 0 && dq < 0) high = -1;
    if (dp < 0 && dq >= 0) low = std::max(low, dp / (dp - dq));
    if (dp >= 0 && dq < 0) high = std::min(high, dp / (dp - dq));
  }
};

}  // namespace

std::vector<ScreenSegment> turned_view(const Matter& matter, const std::vector<RealLine>& lines, const Point& eye, const Window& window, double cosine,
                                       double sine) {
  using Place = std::array<double, 3>;
  const double length = std::hypot(cosine, sine);
  const auto between = [](const Place& p, const Place& q, double t) { return Place{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])}; };
  const auto turned = [&](const Point& p) {
    const Point r = relative(p, eye);
    return Place{(r[0] * cosine - r[2] * sine) / length, static_cast<double>(r[1]), (r[0] * sine + r[2] * cosine) / length};
  };
  std::vector<ScreenSegment> segments;
  for (const VisibleLine& line : seen_of_all(matter, lines, eye, nullptr)) {
    for (const auto& [from, to] : line.intervals.intervals()) {
      const Place p = between(turned(line.p), turned(line.q), from.to_double());
      const Place q = between(turned(line.p), turned(line.q), to.to_double());
      Part part;
      part.keep(p[2], q[2]);
      for (std::size_t b = 0; b < 2; ++b) {
        const auto inside = [&](const Place& at, std::int32_t bound) { return at[b] * window.scale - (bound - window.centre[b]) * at[2]; };
        part.keep(inside(p, window.points[b].low), inside(q, window.points[b].low));
        part.keep(-inside(p, window.points[b].high), -inside(q, window.points[b].high));
      }
      if (part.low >= part.high) continue;
      const Place a = between(p, q, part.low), z = between(p, q, part.high);
      if (a[2] <= 0 || z[2] <= 0) continue;  // a line through the eye is a point
      const auto screen = [&](const Place& at, std::size_t b) { return at[b] * window.scale / at[2] + window.centre[b]; };
      segments.push_back({screen(a, 0), screen(a, 1), screen(z, 0), screen(z, 1)});
    }
  }
  return segments;
}

}  // namespace sightline::algorithms::oracle
