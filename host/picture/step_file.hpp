// A drawing as commands of the CalComp 565, a drum plotter of 1961: one byte for each step of the pen.
//
// The codes are those of the emulated plotter (emulators/devices/calcomp565.hpp). A byte FF ends the file for the program
// that sends the other bytes to the plotter. The pen starts raised, at the left edge of the paper and at the lower end of
// the carriage. A straight line becomes the steps nearest to it in eight directions. There is one pen, so layers follow
// each other without a pen change. The drum is endless, the carriage has 1100 steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

inline constexpr double calcomp_step = 0.254;  // mm
inline constexpr char step_file_end = '\xff';

// The middle of the paper's height is placed at the middle of the carriage. Facets are omitted. Precondition: the drawing
// is within the plotter's plotting_area (plotter.hpp).
[[nodiscard]] std::string step_file_of(const VectorDrawing& drawing, const Paper& paper);

// What executing such a file takes.
struct StepFileTime {
  std::size_t steps = 0;
  std::size_t pen_commands = 0;
  double seconds = 0;
};
[[nodiscard]] StepFileTime step_file_time(std::string_view file);

}  // namespace sightline::picture
