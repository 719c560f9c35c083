// Lines a pen draws on paper, in whole steps of its plotter, and the paper they stand on.
#pragma once

#include <cstdint>
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
  std::int64_t micrometres_a_step = 254;  // 0.01 inch
};
inline constexpr PlotterPaper calcomp_paper{256, 254};
inline constexpr PlotterPaper minigraf_paper{256, 125};

}  // namespace sightline::picture
