// All sight lines from an eye to the points of one line, seen along that line: a ray in the plane of the two other axes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/algorithms/oracle/matter.hpp"
#include "host/geometry/interval_set.hpp"
#include "host/geometry/rational.hpp"

namespace sightline::algorithms::oracle {

// Let s be the position on the ray, 0 at the eye and 1 at the line, and u = 1/s. A sight line that meets matter at (s,
// g), where g is the coordinate along the line relative to the eye, ends at x = g u on the line. So matter from g0 to g1
// along the line, met on the part u0..u1 of the ray, hides all x between the least and the greatest g u.
class SightFan {
 public:
  // Precondition: the line does not pass through the eye.
  SightFan(const Matter& matter, const RealLine& line, const geometry::Point& eye);

  // Removes from `seen` the coordinates, along the line relative to the eye, that matter hides.
  void subtract_shadows(geometry::IntervalSet& seen) const;

 private:
  // The ray's position on one of the two cross axes: inside unit `before` (== `after`); on grid line `line`, passing from
  // unit `before` to unit `after`; or on a grid line and staying between the two units.
  struct Slot {
    bool on_line = false;
    bool moving = false;
    int line = 0;
    int before = 0;
    int after = 0;
  };

  [[nodiscard]] Slot slot(std::size_t cross, const geometry::Rational& s) const;
  [[nodiscard]] std::array<int, 3> unit(int along, int first, int second) const;
  [[nodiscard]] bool stopped_at(const std::array<Slot, 2>& slots, int along) const;
  void take_stretch(geometry::IntervalSet& seen, const geometry::Rational& s0,
                    const geometry::Rational& s1) const;
  void take_crossing(geometry::IntervalSet& seen, const geometry::Rational& s) const;
  void take(geometry::IntervalSet& seen, std::int64_t g0, std::int64_t g1, const geometry::Rational& s0,
            const geometry::Rational& s1) const;
  [[nodiscard]] std::int64_t along(int grid_line) const;

  const Matter& matter_;
  std::size_t axis_;
  std::array<std::size_t, 2> cross_;
  geometry::Point eye_;
  std::array<std::int64_t, 2> direction_{};     // from the eye to the line, on the cross axes
  std::vector<geometry::Rational> milestones_;  // 0, each s at which the ray meets a grid line, 1; ascending
};

}  // namespace sightline::algorithms::oracle
