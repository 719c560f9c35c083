#include "host/report/experiments/surface_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sightline::report {

namespace {

using picture::PixelGrid;
using picture::PixelPoint;
using picture::PixelSegment;

constexpr int board = 256;
constexpr double middle = 127.5;  // of the picture's units
constexpr double units = 256;     // the width of the raster
constexpr double pixels = 1024;   // the unit of distances

PixelPoint on_raster(const picture::DrawingPoint& point, double n) {
  const auto place = [n](double c) { return (n - 1) / 2 + (c - middle) * n / units; };
  return {place(static_cast<double>(point.x)), place(static_cast<double>(point.y))};
}

std::vector<PixelSegment> segments_of(const picture::VectorDrawing& drawing, double n) {
  std::vector<PixelSegment> segments;
  for (const picture::DrawingLine& line : drawing.lines) {
    const auto at = [&](std::uint32_t i) {
      return on_raster(drawing.points[line.first + std::min(i, line.count - 1)], n);
    };
    for (std::uint32_t i = 0; i == 0 || i + 1 < line.count; ++i) segments.push_back({at(i), at(i + 1)});
  }
  return segments;
}

void light(PixelGrid& grid, PixelSegment line) {
  const bool steep = std::abs(line.b.y - line.a.y) > std::abs(line.b.x - line.a.x);
  if (steep) {
    std::swap(line.a.x, line.a.y);
    std::swap(line.b.x, line.b.y);
  }
  if (line.a.x > line.b.x) std::swap(line.a, line.b);
  const double slope = line.b.x > line.a.x ? (line.b.y - line.a.y) / (line.b.x - line.a.x) : 0;
  const auto nearest = [&grid](double place) {
    return std::clamp(static_cast<int>(std::floor(place + 0.5)), 0, grid.width - 1);
  };
  for (int along = nearest(line.a.x); along <= nearest(line.b.x); ++along) {
    const double place = std::clamp(static_cast<double>(along), line.a.x, line.b.x);
    const int across = nearest(line.a.y + (place - line.a.x) * slope);
    grid.set(steep ? across : along, steep ? along : across, 1);
  }
}

std::vector<PixelSegment> dots_as_segments(const PixelGrid& dots) {
  const auto place = [&dots](int i) {
    return (pixels - 1) / 2 + (i - (dots.width - 1) / 2.0) * pixels / dots.width;
  };
  std::vector<PixelSegment> points;
  for (int y = 0; y < dots.height; ++y) {
    for (int x = 0; x < dots.width; ++x) {
      if (dots.at(x, y) == 0) continue;
      const PixelPoint point{place(x), place(y)};
      points.push_back({point, point});
    }
  }
  return points;
}

void add_mismatch(SurfaceError& error, const PixelGrid& truth, const PixelGrid& dots) {
  const auto metrics = picture::pixel_metrics(truth, dots, {});
  error.mismatch = 100 * metrics.mismatch();
  error.far = 100 * static_cast<double>(metrics.missing_far + metrics.extra_far) /
              static_cast<double>(metrics.pixels);
}

void add_distance(SurfaceError& error, const picture::HausdorffDistance& distance) {
  error.hausdorff = distance.greatest;
  error.usual = distance.usual;
}

}  // namespace

PixelGrid dots_of(const core::Raster& raster, int n) {
  PixelGrid grid(n, n);
  const int margin = (board - n) / 2;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const auto place = static_cast<std::size_t>((y + margin) * board + x + margin);
      grid.set(x, y, raster.points()[place] != 0 ? 1 : 0);
    }
  }
  return grid;
}

PixelGrid dots_of(const picture::VectorDrawing& drawing, int n) {
  PixelGrid grid(n, n);
  for (const PixelSegment& segment : segments_of(drawing, n)) light(grid, segment);
  return grid;
}

FinePicture::FinePicture(picture::VectorDrawing drawing)
    : drawing_(std::move(drawing)), segments_(segments_of(drawing_, pixels)) {}

SurfaceError FinePicture::error_of(const PixelGrid& dots) const {
  SurfaceError error;
  add_mismatch(error, dots_of(drawing_, dots.width), dots);
  add_distance(error, picture::hausdorff_distance(segments_, dots_as_segments(dots)));
  return error;
}

SurfaceError FinePicture::error_of(const picture::VectorDrawing& vectors, int n) const {
  SurfaceError error;
  add_mismatch(error, dots_of(drawing_, n), dots_of(vectors, n));
  add_distance(error, picture::hausdorff_distance(segments_, segments_of(vectors, pixels)));
  return error;
}

}  // namespace sightline::report
