// A surface as a net of curves, which need not lie over a grid: gnuplot's parametric surfaces, of which each block of points between
// blank lines is a curve, and neighbouring curves have their points side by side.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/scene/heights/grid.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

struct SurfaceNet {
  std::size_t points = 0;  // of each curve
  std::size_t curves = 0;
  std::vector<std::array<double, 3>> vertices;  // x, y and height, curve by curve; not finite: a hole
  std::array<std::string, 3> names = {};        // of x, y and height, as a file's heading has them
  std::string note = {};                        // as that of a HeightGrid

  // Of x, y and height. {0, 0} if all are holes.
  [[nodiscard]] std::array<Interval, 3> ranges() const;
};

using HeightSurface = std::variant<HeightGrid, SurfaceNet>;

// Every `step`-th point of every `step`-th curve, at least two of each.
[[nodiscard]] SurfaceNet thinned(const SurfaceNet& net, std::size_t step);

// Triangles of the net's cells and its curves in both directions as wires. x stays; the height becomes y, upwards; y becomes z,
// away from a viewer in front. The ranges of the net become `halves` to either side of 0; a range of nothing is 0.
[[nodiscard]] PolyMesh mesh_of(const SurfaceNet& net, const std::array<double, 3>& halves, std::string_view source);

}  // namespace sightline::scene
