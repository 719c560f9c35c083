// Counts the pixels in which two rasters differ (PMR), separately near the images of edges and elsewhere.
//
// The value of a pixel is the number of the face seen there, a grey, or 1 for lit and 0 for dark. Column c, row r has its
// middle at (c, r), rows from the bottom, like the points of a screen. A pixel is a boundary pixel iff its middle is
// within 0.75 pixels of a projected edge, hidden or not; there, rounding may choose either side. Elsewhere, in the
// interior, exact algorithms must agree.
//
// Laws: equal rasters have no differences; exchanging the rasters only exchanges missing and extra; boundary and interior
// pixels add up to all pixels. Source: the suite's cross-check of algorithms, sections 3 and 4.
#pragma once

#include <cstdint>
#include <vector>

#include "host/picture/line_metrics.hpp"

namespace sightline::picture {

struct PixelGrid {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> values;  // width * height, bottom row first

  PixelGrid() = default;
  PixelGrid(int columns, int rows)
      : width(columns),
        height(rows),
        values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] std::uint32_t at(int column, int row) const { return values[index(column, row)]; }
  void set(int column, int row, std::uint32_t value) { values[index(column, row)] = value; }

  friend bool operator==(const PixelGrid&, const PixelGrid&) = default;
};

struct PixelMetrics {
  std::uint64_t pixels = 0;
  std::uint64_t boundary_pixels = 0;
  std::uint64_t different_on_boundary = 0;
  std::uint64_t different_inside = 0;
  std::uint64_t lit = 0;      // pixels of the reference that are not 0
  std::uint64_t missing = 0;  // 0 in the picture, not in the reference
  std::uint64_t extra = 0;    // 0 in the reference, not in the picture
  // Of missing and extra, those without a lit pixel of the other raster among their eight neighbours.
  std::uint64_t missing_far = 0;
  std::uint64_t extra_far = 0;

  [[nodiscard]] std::uint64_t different() const { return different_on_boundary + different_inside; }
  // PMR: as a share of all pixels.
  [[nodiscard]] double mismatch() const;
  [[nodiscard]] double boundary_mismatch() const;  // of the boundary pixels
  [[nodiscard]] double interior_mismatch() const;  // of the others
};

// Precondition: both have the same size.
[[nodiscard]] PixelMetrics pixel_metrics(const PixelGrid& reference, const PixelGrid& drawn,
                                         const std::vector<PixelSegment>& projected_edges);

}  // namespace sightline::picture
