// A drawing as the commands of the CalComp 565, a drum plotter of 1961: a byte for each step of the pen.
//
// The codes are the emulated plotter's (emulators/devices/calcomp565.hpp). A byte FF ends the file; it is for the program
// that sends the others to the plotter. The pen starts up, at the left edge of the paper and at the lower end of the
// carriage; a straight line becomes the steps nearest to it in eight directions. There is one pen: layers follow each
// other without a change of it. The drum has no end, the carriage 1100 steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

inline constexpr double calcomp_step = 0.254;  // mm
inline constexpr char step_file_end = '\xff';

// The middle of the paper's height is that of the carriage. Facets are left out. Of a drawing within the plotter's
// plotting_area (plotter.hpp; precondition).
[[nodiscard]] std::string step_file_of(const VectorDrawing& drawing, const Paper& paper);

// What the commands of such a file cost.
struct StepFileTime {
  std::size_t steps = 0;
  std::size_t pen_commands = 0;
  double seconds = 0;
};
[[nodiscard]] StepFileTime step_file_time(std::string_view file);

}  // namespace sightline::picture
