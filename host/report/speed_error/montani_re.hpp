// Montani and Re's algorithm in stripes of every thickness, and exact: how wrong its pictures are, how long a
// view takes, how many sides there are.
//
// Rasters are held against the faces met by exact sight lines, lines against those of `exact`. Stripes are
// drawn as the boundaries of what is seen of every face: their sides do not say whose edge they are, so that
// lines are compared as sets of points, and what is within a pixel of the other set counts as found.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/algorithms/montani_re/stripes.hpp"
#include "host/report/report.hpp"
#include "host/picture/line_metrics.hpp"

namespace sightline::harness::report {

struct MontaniRePoint {
  double thickness = 0;  // pixels of a stripe; 0: the exact build
  double missing = 0;    // per cent of the true length, farther than a pixel from everything drawn
  double extra = 0;      // the same of what is drawn, farther than a pixel from everything true
  double hausdorff = 0;  // pixels
  double usual = 0;      // exceeded by one sample in a thousand
  double on_edges = 0;   // PMR, per cent of all pixels: pixels within 0.75 pixels of an edge
  double inside = 0;     // the others
  std::uint64_t sides = 0;
  double host_ns = 0;  // of a view; 0: not timed

  [[nodiscard]] double symmetric() const { return missing + extra; }
  [[nodiscard]] double mismatch() const { return on_edges + inside; }
};

struct MontaniReCurve {
  std::string scene;
  std::size_t faces = 0;
  double true_length = 0;              // pixels
  std::vector<MontaniRePoint> points;  // thick to thin, the exact build last
};

struct MontaniReMeasure {
  std::vector<std::string> scenes{"boxes", "town", "triangles"};  // generated
  std::size_t scene_size = 30;
  std::int32_t raster = 384;
  int rounds = 3;  // of times; 0: none
};
[[nodiscard]] std::vector<MontaniReCurve> measure_montani_re(const MontaniReMeasure& order,
                                                             const Context& context);

// The boundary of stripes of so many sixteenths of a pixel, middles of pixels at whole numbers: sides, and
// horizontal pieces where what is above is covered and what is below not, or the other way round.
[[nodiscard]] std::vector<picture::PixelSegment> boundary_of(const algorithms::montani_re::StripePcs& pcs,
                                                             std::int32_t units);

// What they are, then figures and tables. Error: gnuplot.
[[nodiscard]] Outcome<std::vector<Block>> montani_re_error_blocks(const std::vector<MontaniReCurve>& curves,
                                                                  const MontaniReMeasure& order);
// All of it, larger where the report is to be full.
[[nodiscard]] Outcome<std::vector<Block>> montani_re_error_part(const Context& context);

}  // namespace sightline::harness::report
