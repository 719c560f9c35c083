// Round values of a scale: multiples of 1, 2 or 5 times a power of ten, and how they are written.
#pragma once

#include <string>
#include <vector>

#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

struct RoundValue {
  double value = 0;
  std::string text;  // the shortest text of the value
};

// The multiples within the interval, ends included, ascending, with the smallest round step that gives at most `most` of them. A
// multiple that exceeds an end by rounding alone is within. Empty for an interval without extent or one that is not finite.
[[nodiscard]] std::vector<RoundValue> round_values(Interval interval, int most);

// The multiples of this step within the interval, ends excluded; none if there are more than `most`.
[[nodiscard]] std::vector<double> multiples_within(Interval interval, double step, int most);

}  // namespace sightline::scene
