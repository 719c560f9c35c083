// Limits of the counted work of a method for one view in a comparison. A method that needs more is left out, with the
// count and the limit. No clock is used, so the same scene gives the same table on every computer.
#pragma once

#include <cstddef>

namespace sightline::compare {

// Willis: pairs of pieces whose boundaries are compared while surfaces are cut. Twenty boxes need 1,000 and a hundred
// 4,000. Half a million come from long adjacent surfaces, where every cut makes more pairs (about 0.3 s until then).
inline constexpr std::size_t most_willis_pairs = 500'000;

// Functions: points of the grid. The reference of its lines is found pair by pair in every column of the screen; this
// many points take about 3 s.
inline constexpr std::size_t most_grid_points = 32'768;

}  // namespace sightline::compare
