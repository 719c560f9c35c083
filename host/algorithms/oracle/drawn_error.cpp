#include "host/algorithms/oracle/drawn_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sightline::algorithms::oracle {
namespace {

constexpr double longest_step = 0.25;

double length_of(const ScreenSegment& s) {
  return std::hypot(s.x1 - s.x0, s.y1 - s.y0);
}

bool within(double x, double y, const ScreenSegment& s, double distance) {
  const double dx = s.x1 - s.x0;
  const double dy = s.y1 - s.y0;
  const double squared_length = dx * dx + dy * dy;
  const double t =
      squared_length > 0 ? std::clamp(((x - s.x0) * dx + (y - s.y0) * dy) / squared_length, 0.0, 1.0) : 0.0;
  const double off_x = x - (s.x0 + t * dx);
  const double off_y = y - (s.y0 + t * dy);
  return off_x * off_x + off_y * off_y <= distance * distance;
}

// Length of `lines` farther than `distance` from all of `others`.
double unmatched(const std::vector<ScreenSegment>& lines, const std::vector<ScreenSegment>& others,
                 double distance) {
  double total = 0;
  std::size_t last = 0;  // the one that was near the step before is likely near again
  for (const ScreenSegment& line : lines) {
    const double length = length_of(line);
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(length / longest_step)));
    std::size_t alone = 0;
    for (std::size_t n = 0; n < steps; ++n) {
      const double t = (static_cast<double>(n) + 0.5) / static_cast<double>(steps);
      const double x = line.x0 + t * (line.x1 - line.x0);
      const double y = line.y0 + t * (line.y1 - line.y0);
      if (last < others.size() && within(x, y, others[last], distance)) continue;
      const auto near = std::find_if(others.begin(), others.end(), [&](const ScreenSegment& other) {
        return within(x, y, other, distance);
      });
      if (near == others.end())
        ++alone;
      else
        last = static_cast<std::size_t>(near - others.begin());
    }
    total += length * static_cast<double>(alone) / static_cast<double>(steps);
  }
  return total;
}

double total_length(const std::vector<ScreenSegment>& lines) {
  double total = 0;
  for (const ScreenSegment& line : lines) total += length_of(line);
  return total;
}

}  // namespace

DrawnError drawn_error(const std::vector<ScreenSegment>& truth, const std::vector<ScreenSegment>& drawn,
                       double distance) {
  return {total_length(truth), total_length(drawn), unmatched(truth, drawn, distance),
          unmatched(drawn, truth, distance)};
}

}  // namespace sightline::algorithms::oracle
