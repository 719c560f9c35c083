// Pen paths as HP-GL, the language of Hewlett-Packard's plotters.
//
// IN; SP1; then for every path PU to its first corner and PD through the others, at last PU and SP0 (the pen
// goes back to its stall). Coordinates are absolute plotter units of 0.025 mm from step (0, 0); a step that
// is no whole number of units (0.01 inch is 10.16) is rounded once, so that errors do not add up. One
// instruction a line, and at most 64 corners in one PD: plotters of the time hold one instruction in a small
// buffer. Left out: speed, line types, paper. Source: HP 7475A Interfacing and Programming Manual.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "host/picture/pen_path.hpp"

namespace sightline::picture {

inline constexpr std::int64_t hpgl_unit_micrometres = 25;
inline constexpr std::size_t hpgl_most_corners = 64;

[[nodiscard]] std::string hpgl(std::span<const PenPath> paths, const PlotterPaper& paper);

}  // namespace sightline::picture
