// Lines that a pen draws on paper, in whole steps of its plotter, and the size of the paper.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sightline::picture {

struct PenPoint {
  int x = 0;  // steps from the left
  int y = 0;  // steps from the bottom

  friend constexpr bool operator==(PenPoint, PenPoint) = default;
};

// The pen goes down at the first corner and up at the last. Consecutive corners differ by k * (sx, sy), sx
// and sy in -1..1, as a step in x, in y or in both makes them; a path of one corner is a dot.
struct PenPath {
  std::vector<PenPoint> corners;

  friend bool operator==(const PenPath&, const PenPath&) = default;
};

// One step further; a corner in the middle of a straight run is dropped. The path must not be empty.
void extend(PenPath& path, PenPoint next);

// A square field of whole steps, and how long a step is.
struct PlotterPaper {
  int steps = 256;                        // points a side
  std::int64_t micrometres_per_step = 254;  // 0.01 inch
};
inline constexpr PlotterPaper calcomp_paper{256, 254};
inline constexpr PlotterPaper minigraf_paper{256, 125};

// Pen paths as HP-GL, the language of Hewlett-Packard's plotters.
//
// IN; SP1; then for every path PU to its first corner and PD through the others, at last PU and SP0 (the pen
// goes back to its stall). Coordinates are absolute plotter units of 0.025 mm from step (0, 0); a step that
// is no whole number of units (0.01 inch is 10.16) is rounded once, so that errors do not add up. One
// instruction a line, and at most 64 corners in one PD: plotters of the time hold one instruction in a small
// buffer. Left out: speed, line types, paper. Source: HP 7475A Interfacing and Programming Manual.

inline constexpr std::int64_t hpgl_unit_micrometres = 25;
inline constexpr std::size_t hpgl_most_corners = 64;

[[nodiscard]] std::string hpgl(std::span<const PenPath> paths, const PlotterPaper& paper);

}  // namespace sightline::picture
