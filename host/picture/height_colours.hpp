// Colours for heights, from dark blue to yellow. Each is lighter than those below it, so they are also distinguished in
// grey prints and by colour-blind readers.
#pragma once

#include "host/picture/image.hpp"

namespace sightline::picture {

// `part` is the position in the range, 0 the lowest to 1 the highest; values beyond have the colour of that end.
[[nodiscard]] Colour height_colour(double part);

// The same for a line on white paper: darker.
[[nodiscard]] Colour height_line_colour(double part);

}  // namespace sightline::picture
