#include "host/programs/skala/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sightline::programs::skala {

namespace {

constexpr double height_of_unit = 0.6;
constexpr double last_dot = 255.0;
constexpr double tie = 1.0 / (1 << 20);
// Smaller extents are rounding errors of a picture without extent.
constexpr double smallest_extent = 1e-12;

// Sine and cosine of 0 .. 45 degrees.
SineCosine sine_cosine_in_half_quadrant(double degrees) {
  const double radians = degrees / 180.0 * std::numbers::pi;
  return {std::sin(radians), std::cos(radians)};
}

SineCosine sine_cosine_in_quadrant(double degrees) {
  if (degrees == 45.0) return {std::sqrt(0.5), std::sqrt(0.5)};  // for which sin and cos are not exact
  if (degrees <= 45.0) return sine_cosine_in_half_quadrant(degrees);
  const auto [sine, cosine] = sine_cosine_in_half_quadrant(90.0 - degrees);
  return {cosine, sine};
}

// The extremes of one screen coordinate, and its mapping to the raster.
class Fit {
 public:
  void take(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  [[nodiscard]] double place(double value, double zoom) const {
    // Halved, like the heights below.
    const double half = 0.5 * high_ - 0.5 * low_;
    if (!(half > 0.5 * smallest_extent)) return 128.0;
    const double fitted = last_dot * ((0.5 * value - 0.5 * low_) / half);
    return zoom == 1.0 ? fitted : last_dot / 2 + zoom * (fitted - last_dot / 2);
  }

 private:
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

SineCosine sine_and_cosine(double degrees) {
  double turn = std::fmod(degrees, 360.0);
  if (turn < 0) turn += 360.0;
  const int quadrant = static_cast<int>(turn / 90.0) % 4;
  const double rest = std::fmod(turn, 90.0);
  const auto [sine, cosine] = sine_cosine_in_quadrant(rest);
  switch (quadrant) {
    case 0: return {sine, cosine};
    case 1: return {cosine, 0.0 - sine};
    case 2: return {0.0 - sine, 0.0 - cosine};
    default: return {0.0 - cosine, sine};
  }
}

int raster_coordinate(double value) {
  constexpr double most = 1 << 20;
  if (std::isnan(value)) return 0;
  return static_cast<int>(std::floor(std::clamp(value, -most, most) + 0.5 + tie));
}

double normalised_height(const scene::HeightGrid& grid, double height) {
  if (!std::isfinite(height)) return std::numeric_limits<double>::quiet_NaN();
  // Halved, because the difference of two heights may exceed the greatest double.
  const double extent = 0.5 * grid.range.high - 0.5 * grid.range.low;
  if (!(extent > 0)) return 0;
  return 2.0 * ((0.5 * height - 0.5 * grid.range.low) / extent) - 1.0;
}

Projection::Projection(const scene::HeightGrid& grid, const View& view)
    : points_(grid.points()),
      slices_(grid.slices()),
      rotation_(sine_and_cosine(view.rotation)),
      vertices_(grid.points() * grid.slices()) {
  const SineCosine elevation = sine_and_cosine(view.elevation);
  Fit across;
  Fit up;
  for (std::size_t slice = 0; slice < slices_; ++slice) {
    for (std::size_t point = 0; point < points_; ++point) {
      Vertex& vertex = vertices_[slice * points_ + point];
      const double x = grid.x[point];
      const double z = grid.z[slice];
      const double h = normalised_height(grid, grid.height(point, slice));
      vertex.x = x * rotation_.cosine + z * rotation_.sine;
      vertex.depth = z * rotation_.cosine - x * rotation_.sine;
      vertex.y = height_of_unit * h * elevation.cosine + vertex.depth * elevation.sine;
      vertex.defined = std::isfinite(vertex.y);
      if (!vertex.defined) continue;
      across.take(vertex.x);
      up.take(vertex.y);
    }
  }
  for (Vertex& vertex : vertices_) {
    vertex.x = across.place(vertex.x, view.zoom);
    vertex.column = raster_coordinate(vertex.x);
    if (!vertex.defined) continue;
    vertex.y = up.place(vertex.y, view.zoom);
    vertex.row = raster_coordinate(vertex.y);
  }
}

Family less_end_on(SineCosine rotation) {
  return std::abs(rotation.cosine) >= std::abs(rotation.sine) ? Family::along_x : Family::along_z;
}

DrawingOrder slice_order(const Projection& projection, Family family) {
  const auto [sine, cosine] = projection.rotation();
  DrawingOrder order;
  if (family == Family::along_x) {
    order.rows = projection.slices();
    order.columns = projection.points();
    order.rows_reversed = cosine < 0;
    order.columns_reversed = cosine < 0;
    order.row_shift = cosine < 0 ? -sine : sine;
    order.column_shift = std::abs(cosine);
    return order;
  }
  order.row_is_slice = false;
  order.rows = projection.points();
  order.columns = projection.slices();
  order.rows_reversed = sine > 0;
  order.columns_reversed = sine < 0;
  order.row_shift = sine > 0 ? -cosine : cosine;
  order.column_shift = std::abs(sine);
  return order;
}

DrawingOrder cell_order(const Projection& projection) {
  const auto [sine, cosine] = projection.rotation();
  DrawingOrder order = slice_order(projection, Family::along_x);
  order.columns_reversed = sine > 0;
  order.column_shift = sine > 0 ? -cosine : cosine;
  return order;
}

}  // namespace sightline::programs::skala
