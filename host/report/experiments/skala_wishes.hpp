// What Skala leaves to the reader: contours smoothed by subdividing the mesh, and what the temporary masks M1T and M1B are for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

// Contours of a function that is known at 17 by 17 points, each cell in `parts` by `parts`. The reference is the same
// function, sampled as finely as the finest mesh.
struct SmoothContours {
  std::string function;
  std::size_t parts = 1;
  std::size_t command_bytes = 0;
  double drawing_s = 0;        // on the 8080
  std::uint64_t wrong_dots = 0;  // that differ from the reference's picture on the 8080
  double mean_error_percent = 0;  // of the native mesh's heights, of the range of heights
  Picture raster;
};

// Lines and surfaces drawn without the temporary masks.
struct DirectMasks {
  std::string function;
  std::string picture;
  std::uint64_t dots = 0;  // of the right picture
  std::uint64_t missing = 0;
  std::uint64_t extra = 0;
  Picture raster;  // the right dots white, the missing ones red

  [[nodiscard]] double missing_percent() const { return 100.0 * static_cast<double>(missing) / static_cast<double>(dots); }
};

struct SkalaWishes {
  std::vector<SmoothContours> contours;
  std::vector<DirectMasks> masks;
  std::size_t reference_points = 0;
};

[[nodiscard]] SkalaWishes skala_wishes(const Context& context);

class Page;
void skala_smooth_chapter(Page& page, const SkalaWishes& measured);

}  // namespace sightline::report
