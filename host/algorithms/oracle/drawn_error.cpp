#include "host/algorithms/oracle/drawn_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sightline::algorithms::oracle {
namespace {

constexpr double longest_step = 0.25;
// Far above the rounding error of a distance between points of a picture.
constexpr double rounding_allowed = 1e-6;

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

// The midpoints of equal steps along a line.
class Steps {
 public:
  explicit Steps(const ScreenSegment& line)
      : line_(line),
        count_(static_cast<std::size_t>(std::max(1.0, std::ceil(length_of(line) / longest_step)))) {}

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] bool within(std::size_t n, const ScreenSegment& other, double distance) const {
    const double t = (static_cast<double>(n) + 0.5) / static_cast<double>(count_);
    const double x = line_.x0 + t * (line_.x1 - line_.x0);
    const double y = line_.y0 + t * (line_.y1 - line_.y0);
    return oracle::within(x, y, other, distance);
  }
  // The points near a segment form a convex set. If step n is within `distance` of `other`, so are all steps up to the
  // returned one. Distances that rounding could change are not used.
  [[nodiscard]] std::size_t last_within(std::size_t n, const ScreenSegment& other, double distance) const {
    const double surely = distance - rounding_allowed;
    if (surely <= 0 || !within(n, other, surely)) return n;
    std::size_t low = n;
    std::size_t high = count_;
    for (std::size_t next = count_ - 1; high - low > 1; next = low + (high - low) / 2)
      (next > low && within(next, other, surely) ? low : high) = next;
    return low;
  }

 private:
  ScreenSegment line_;
  std::size_t count_;
};

// Length of `lines` farther than `distance` from all of `others`.
double unmatched(const std::vector<ScreenSegment>& lines, const std::vector<ScreenSegment>& others,
                 double distance) {
  double total = 0;
  std::size_t last = 0;  // the segment near the last step is likely near this one
  for (const ScreenSegment& line : lines) {
    const Steps steps(line);
    std::size_t alone = 0;
    for (std::size_t n = 0; n < steps.count(); ++n) {
      if (last >= others.size() || !steps.within(n, others[last], distance)) {
        const auto near = std::find_if(others.begin(), others.end(), [&](const ScreenSegment& other) {
          return steps.within(n, other, distance);
        });
        if (near == others.end()) {
          ++alone;
          continue;
        }
        last = static_cast<std::size_t>(near - others.begin());
      }
      n = steps.last_within(n, others[last], distance);
    }
    total += length_of(line) * static_cast<double>(alone) / static_cast<double>(steps.count());
  }
  return total;
}

double total_length(const std::vector<ScreenSegment>& lines) {
  double total = 0;
  for (const ScreenSegment& line : lines) total += length_of(line);
  return total;
}

}  // namespace

DrawnError drawn_error(const std::vector<ScreenSegment>& reference, const std::vector<ScreenSegment>& drawn,
                       double distance) {
  return {total_length(reference), total_length(drawn), unmatched(reference, drawn, distance),
          unmatched(drawn, reference, distance)};
}

}  // namespace sightline::algorithms::oracle
