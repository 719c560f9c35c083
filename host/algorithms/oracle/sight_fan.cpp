#include "host/algorithms/oracle/sight_fan.hpp"

#include <algorithm>

namespace sightline::algorithms::oracle {

using geometry::IntervalSet;
using geometry::Rational;

SightFan::SightFan(const Matter& matter, const RealLine& line, const geometry::Point& eye)
    : matter_(matter),
      axis_(line.axis),
      cross_(geometry::other_axes(line.axis)),
      eye_(eye),
      milestones_{0, 1} {
  for (std::size_t c = 0; c < 2; ++c) {
    const std::size_t a = cross_[c];
    direction_[c] = std::int64_t{line.from[a]} - eye[a];
    if (direction_[c] == 0) continue;
    for (const std::int32_t coordinate : matter.grid(a)) {
      const Rational s(std::int64_t{coordinate} - eye[a], direction_[c]);
      if (Rational(0) < s && s < Rational(1)) milestones_.push_back(s);
    }
  }
  std::sort(milestones_.begin(), milestones_.end());
  milestones_.erase(std::unique(milestones_.begin(), milestones_.end()), milestones_.end());
}

void SightFan::subtract_shadows(IntervalSet& seen) const {
  for (std::size_t m = 0; m + 1 < milestones_.size() && !seen.empty(); ++m) {
    take_stretch(seen, milestones_[m], milestones_[m + 1]);
    if (m > 0) take_crossing(seen, milestones_[m]);
  }
}

SightFan::Slot SightFan::slot(std::size_t cross, const Rational& s) const {
  const auto& grid = matter_.grid(cross_[cross]);
  const Rational moved(direction_[cross] * s.numerator(), s.denominator());
  const auto at =
      std::lower_bound(grid.begin(), grid.end(), moved, [&](std::int32_t g, const Rational& position) {
        return Rational(std::int64_t{g} - eye_[cross_[cross]]) < position;
      });
  const int line = static_cast<int>(at - grid.begin());
  const bool on_line = at != grid.end() && Rational(std::int64_t{*at} - eye_[cross_[cross]]) == moved;
  if (!on_line) return {false, false, 0, line - 1, line - 1};
  const bool backward = direction_[cross] < 0;
  return {true, direction_[cross] != 0, line, backward ? line : line - 1, backward ? line - 1 : line};
}

std::array<int, 3> SightFan::unit(int along, int first, int second) const {
  std::array<int, 3> result{};
  result[axis_] = along;
  result[cross_[0]] = first;
  result[cross_[1]] = second;
  return result;
}

std::int64_t SightFan::along(int grid_line) const {
  return std::int64_t{matter_.grid(axis_)[static_cast<std::size_t>(grid_line)]} - eye_[axis_];
}

// Removes what is hidden by matter from g0 to g1 (g0 <= g1) that the ray meets between s0 and s1 (s0 <= s1).
void SightFan::take(IntervalSet& seen, std::int64_t g0, std::int64_t g1, const Rational& s0,
                    const Rational& s1) const {
  if (seen.empty()) return;
  // g / s; at the eye (s = 0) a value beyond the ends of the line in the direction of g.
  const auto reach = [&](std::int64_t g, const Rational& s) {
    if (s.numerator() != 0) return Rational(g * s.denominator(), s.numerator());
    const Rational end = g < 0 ? seen.intervals().front().low : seen.intervals().back().high;
    return Rational(end.numerator() + (g < 0 ? -1 : 1) * end.denominator(), end.denominator());
  };
  const Rational low = g0 < 0 ? reach(g0, s0) : reach(g0, s1);
  const Rational high = g1 > 0 ? reach(g1, s0) : reach(g1, s1);
  seen.subtract(low, high);
}

// Between two milestones the ray stays in one unit of each cross axis, or on the grid line between two units.
void SightFan::take_stretch(IntervalSet& seen, const Rational& s0, const Rational& s1) const {
  const Rational middle = geometry::mediant(s0, s1);
  const Slot first = slot(0, middle);
  const Slot second = slot(1, middle);
  const auto everywhere = [&](const auto& holds) {
    return holds(first.before, second.before) && holds(first.after, second.after);
  };
  int run = -1;  // first unit of the current solid run
  for (int k = 0; k <= matter_.units(axis_); ++k) {
    const bool solid =
        k < matter_.units(axis_) && everywhere([&](int i, int j) { return matter_.solid(unit(k, i, j)); });
    if (solid && run < 0) run = k;
    if (!solid && run >= 0) {
      take(seen, along(run), along(k), s0, s1);
      run = -1;
    }
    const bool wall = everywhere([&](int i, int j) { return matter_.opaque_face(axis_, unit(k, i, j)); });
    if (wall) take(seen, along(k), along(k), s0, s1);
  }
}

// The ray meets a grid line of one cross axis, or of both at once. It passes if it can pass on one side.
bool SightFan::stopped_at(const std::array<Slot, 2>& slots, int along) const {
  const auto face = [&](std::size_t across, int beside) {
    const int line = slots[across].line;
    const auto place = across == 0 ? unit(along, line, beside) : unit(along, beside, line);
    return matter_.opaque_face(cross_[across], place);
  };
  const auto crossed = [](const Slot& s) { return s.on_line && s.moving; };
  if (crossed(slots[0]) && crossed(slots[1])) {
    return (face(0, slots[1].before) || face(1, slots[0].after)) &&
           (face(1, slots[0].before) || face(0, slots[1].after));
  }
  const std::size_t across = crossed(slots[0]) ? 0 : 1;
  const Slot& other = slots[1 - across];
  return face(across, other.before) && face(across, other.after);
}

void SightFan::take_crossing(IntervalSet& seen, const Rational& s) const {
  const std::array<Slot, 2> slots{slot(0, s), slot(1, s)};
  int run = -1;
  for (int k = 0; k <= matter_.units(axis_); ++k) {
    const bool stopped = k < matter_.units(axis_) && stopped_at(slots, k);
    if (stopped && run < 0) run = k;
    if (!stopped && run >= 0) {
      take(seen, along(run), along(k), s, s);
      run = -1;
    }
  }
}

}  // namespace sightline::algorithms::oracle
