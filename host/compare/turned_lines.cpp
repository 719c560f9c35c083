// See turned_lines.hpp.
#include "host/compare/turned_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sightline::compare {

namespace {

using algorithms::oracle::Window;
using Place = std::array<double, 3>;

// The part of a line from p to q before the sides of the window, from `low` to `high`.
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

std::vector<picture::PixelSegment> turned_lines(const std::vector<algorithms::oracle::VisibleLine>& lines, const geometry::Point& eye,
                                                const programs::jones::Direction& direction, const Window& window) {
  const double length = std::hypot(direction.cosine, direction.sine);
  const double cosine = direction.cosine / length, sine = direction.sine / length;
  const auto turned = [&](const geometry::Point& p, const geometry::Point& q, double t) {
    Place at{};
    for (std::size_t a = 0; a < 3; ++a) at[a] = p[a] + t * (q[a] - p[a]) - eye[a];
    return Place{at[0] * cosine - at[2] * sine, at[1], at[0] * sine + at[2] * cosine};
  };
  std::vector<picture::PixelSegment> segments;
  for (const auto& line : lines) {
    for (const auto& [from, to] : line.intervals.intervals()) {
      const Place p = turned(line.p, line.q, from.to_double());
      const Place q = turned(line.p, line.q, to.to_double());
      Part part;
      part.keep(p[2] - window.near, q[2] - window.near);
      for (std::size_t b = 0; b < 2; ++b) {
        const auto beyond = [&](const Place& at, std::int32_t bound) { return at[b] * window.scale - (bound - window.centre[b]) * at[2]; };
        part.keep(beyond(p, window.points[b].low), beyond(q, window.points[b].low));
        part.keep(-beyond(p, window.points[b].high), -beyond(q, window.points[b].high));
      }
      if (part.low >= part.high) continue;
      const auto point = [&](double t) {
        Place at{};
        for (std::size_t a = 0; a < 3; ++a) at[a] = p[a] + t * (q[a] - p[a]);
        return picture::PixelPoint{at[0] * window.scale / at[2] + window.centre[0], at[1] * window.scale / at[2] + window.centre[1]};
      };
      segments.push_back({point(part.low), point(part.high)});
    }
  }
  return segments;
}

}  // namespace sightline::compare
