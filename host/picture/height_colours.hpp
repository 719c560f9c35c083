// Colours of heights, from dark blue to yellow: every one is lighter than those below it, so that a print in grey
// and an eye that does not tell red from green still read them.
#pragma once

#include "host/picture/image.hpp"

namespace sightline::picture {

// Of a part of the range, 0 the lowest to 1 the highest; what is beyond has the colour of that end.
[[nodiscard]] Colour height_colour(double part);

// The same as a line on white paper, darker.
[[nodiscard]] Colour height_line_colour(double part);

}  // namespace sightline::picture
