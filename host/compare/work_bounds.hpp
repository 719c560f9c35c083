// How much counted work a method may make of one view in a comparison. One that needs more is left out, with the count and the bound;
// nothing is stopped by a clock, so that the same scene gives the same table on every computer.
#pragma once

#include <cstddef>

namespace sightline::compare {

// Willis: pairs of pieces whose boundaries are compared while surfaces are cut. Twenty boxes need 1,000 and a hundred 4,000; what needs
// half a million is long surfaces beside each other, of which every cut makes more pairs (about 0.3 s until then).
inline constexpr std::size_t most_willis_pairs = 500'000;

// Functions: points of the grid. The truth of its lines is found pair by pair in every column of the screen; these take about 3 s.
inline constexpr std::size_t most_grid_points = 32'768;

}  // namespace sightline::compare
