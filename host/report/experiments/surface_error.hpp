// Compares pictures of surfaces, as dots on a square raster or as vectors, with a finer picture of the same surface.
//
// The picture's coordinates c run from 0 to 255, as Skala's do. On a raster of n by n dots, the centre of the dots is
// the centre of the picture, and n dots are 256 units: c = 127.5 + (i - (n - 1) / 2) * 256 / n. There the program
// puts them when its picture is zoomed to n / 256. Distances are pixels of a raster of 1024, whatever raster the dots
// are on.
#pragma once

#include "emulators/core/raster.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::report {

// The dots, lit or not, of a picture on a board of 256 by 256 of which the central n by n are used, n even.
[[nodiscard]] picture::PixelGrid dots_of(const core::Raster& raster, int n);
// The lines of a drawing of 255 by 255 units on n by n dots: one dot per column, or per row for a steep line, the
// nearest to the line.
[[nodiscard]] picture::PixelGrid dots_of(const picture::VectorDrawing& drawing, int n);

struct SurfaceError {
  double mismatch = 0;   // PMR, per cent of the dots of the raster
  double far = 0;        // the same, for dots without an adjacent lit dot in the other picture
  double hausdorff = 0;  // pixels of 1024
  double usual = 0;      // exceeded by one sample in a thousand
};

// The picture with which others of the same view are compared.
class FinePicture {
 public:
  explicit FinePicture(picture::VectorDrawing drawing);

  // Rasters are compared with this picture on a raster of the same size, distances with its lines.
  [[nodiscard]] SurfaceError error_of(const picture::PixelGrid& dots) const;
  // For vectors: their distance from this picture's, and both on n by n dots.
  [[nodiscard]] SurfaceError error_of(const picture::VectorDrawing& vectors, int n) const;

 private:
  picture::VectorDrawing drawing_;
  std::vector<picture::PixelSegment> segments_;
};

}  // namespace sightline::report
