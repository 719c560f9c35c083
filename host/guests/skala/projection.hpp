// Where the points of a grid lie on the screen: rotation about the vertical, parallel projection from an
// elevation, fit to the 256 x 256 raster. Verticals stay vertical, which Skala's masks rely on (Skala 1985,
// section 3).
//
// With x, z, h in [-1, 1], rotation A and elevation E:
//   screen x = x cos A + z sin A     depth = -x sin A + z cos A     screen y = 0.6 h cos E + depth sin E
// Screen x and y are each fitted to 0..255 by their extremes over the defined points; an extent of nothing
// lies at 128. A zoom enlarges about the middle, 127.5.
#pragma once

#include <cstddef>
#include <vector>

#include "host/guests/skala/view.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::guests::skala {

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

// Exact at multiples of 90 degrees and with exact symmetries: the sine of A is the cosine of 90 - A, bit for
// bit. Any finite angle.
[[nodiscard]] SineCosine sine_and_cosine(double degrees);

inline constexpr int raster_side = 256;  // dots

// A real screen coordinate as a raster coordinate: rounded once, halves upwards. A millionth of a dot below
// a half counts as the half, so that points of a symmetric surface do not depend on the last bit of a sine.
// Beyond +-2^20 the result is +-2^20.
[[nodiscard]] int raster_coordinate(double value);

struct Vertex {
  double x = 0;  // real screen coordinates: 0..255 but for a zoom
  double y = 0;  // (only if defined)
  int column = 0;
  int row = 0;
  double depth = 0;      // greater is farther
  bool defined = false;  // x, column and depth are right even if not
};

class Projection {
 public:
  // Heights are scaled by the grid's range. View: rotation, elevation and zoom are used.
  Projection(const scene::HeightGrid& grid, const View& view);

  [[nodiscard]] const Vertex& at(std::size_t point, std::size_t slice) const {
    return vertices_[slice * points_ + point];
  }
  [[nodiscard]] std::size_t points() const { return points_; }
  [[nodiscard]] std::size_t slices() const { return slices_; }
  [[nodiscard]] SineCosine rotation() const { return rotation_; }

 private:
  std::size_t points_;
  std::size_t slices_;
  SineCosine rotation_;
  std::vector<Vertex> vertices_;
};

// A height as h in [-1, 1] by the grid's range; 0 if that is empty; NaN for an undefined height.
[[nodiscard]] double normalised_height(const scene::HeightGrid& grid, double height);

}  // namespace sightline::guests::skala
