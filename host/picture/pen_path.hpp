// Lines that a pen draws on paper, in integer steps of its plotter, and the size of the paper.
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

// The pen is lowered at the first corner and raised at the last. Consecutive corners differ by k * (sx, sy) with sx and
// sy in -1..1, because a step goes in x, in y or in both. A path of one corner is a dot.
struct PenPath {
  std::vector<PenPoint> corners;

  friend bool operator==(const PenPath&, const PenPath&) = default;
};

// Appends one step. A corner inside a straight run is dropped. Precondition: the path is not empty.
void extend(PenPath& path, PenPoint next);

// A square area measured in steps, and the length of a step.
struct PlotterPaper {
  int steps = 256;                        // points per side
  std::int64_t micrometres_per_step = 254;  // 0.01 inch
};
inline constexpr PlotterPaper calcomp_paper{256, 254};
inline constexpr PlotterPaper minigraf_paper{256, 125};

// Pen paths as HP-GL, the language of Hewlett-Packard's plotters.
//
// IN; SP1; then for every path PU to its first corner and PD through the others, finally PU and SP0 (the pen returns to
// its stall). Coordinates are absolute plotter units of 0.025 mm from step (0, 0). If a step is not a whole number of
// units (0.01 inch is 10.16), each coordinate is rounded once, so errors do not accumulate. Each line has one
// instruction, and each PD at most 64 corners, because plotters of the time hold one instruction in a small buffer. Not
// written: speed, line types, paper. Source: HP 7475A Interfacing and Programming Manual.

inline constexpr std::int64_t hpgl_unit_micrometres = 25;
inline constexpr std::size_t hpgl_most_corners = 64;

[[nodiscard]] std::string hpgl(std::span<const PenPath> paths, const PlotterPaper& paper);

}  // namespace sightline::picture
