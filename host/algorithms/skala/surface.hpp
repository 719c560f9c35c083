// A height grid on the screen, in the order in which it is drawn: row 0 in front, and in every row the
// column nearest to the eye first, whatever the rotation (Skala 1985, section 3).
//
// With x, z, h in [-1, 1], rotation A and elevation E:
//   screen x = x cos A + z sin A     depth = -x sin A + z cos A     screen y = 0.6 h cos E + depth sin E
// where 0.6 is View::sides' height, and x and z are stretched by the others.
// Both are fitted to 0..255 by their extremes over the defined points, and rounded to a lattice far finer
// than a mask column: points that coincide in exact arithmetic then coincide here, and the last bit of a sine
// does not decide what is visible. Along a vertical of the screen depth grows with z / cos A and with
// -x / sin A; so every row's and every column's order follows from two signs.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "host/algorithms/skala/view.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::algorithms::skala {

inline constexpr double picture_extent = 255;  // of the drawing, in both directions

struct Vertex {
  float x = 0;  // in mask columns; column c samples the screen at x = c, the picture is [-0.5, columns - 0.5]
  float y = 0;  // 0..255 upwards; NaN where the surface is undefined

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

class Surface {
 public:
  // `family` along_x and along_z: the slices are the rows; else the rows are those along x. The picture is fitted to all grids that share it,
  // which have the same places and range; none: to this grid.
  Surface(const scene::HeightGrid& grid, const View& view, Family family, std::span<const scene::HeightGrid> sharing = {});

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] const Vertex& at(std::size_t row, std::size_t column) const {
    return vertices_[row * columns_ + column];
  }
  [[nodiscard]] std::span<const Vertex> row(std::size_t row) const {
    return std::span(vertices_).subspan(row * columns_, columns_);
  }
  [[nodiscard]] bool defined(std::size_t row, std::size_t column) const {
    const Vertex& vertex = at(row, column);
    return vertex.y == vertex.y;
  }
  // Any place of the box in which x, z and height run from -1 to 1; and beyond it.
  [[nodiscard]] Vertex place(double x, double z, double height) const;
  // A height of the grid in these terms: its range is -1 to 1. 0 for all if the range is nothing.
  [[nodiscard]] double normalised_height(double height) const;
  // Towards the eye of x, z and height.
  [[nodiscard]] std::array<double, 3> to_eye() const;
  // The same in the units of View::sides, x and y, and what 0 and 255 of the picture are there.
  [[nodiscard]] std::array<double, 2> project(double x, double z, double height) const;
  [[nodiscard]] std::array<double, 2> origin() const { return origin_; }
  [[nodiscard]] std::array<double, 2> extents() const { return extents_; }
  // Is every vertex defined?
  [[nodiscard]] bool whole() const { return whole_; }
  // Index of the vertex's height in the grid.
  [[nodiscard]] std::size_t height_index(std::size_t row, std::size_t column) const {
    const std::size_t r = rows_reversed_ ? rows_ - 1 - row : row;
    const std::size_t c = columns_reversed_ ? columns_ - 1 - column : column;
    return row_is_slice_ ? r * columns_ + c : c * rows_ + r;
  }

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  bool row_is_slice_ = true;
  bool rows_reversed_ = false;
  bool columns_reversed_ = false;
  bool whole_ = true;
  std::vector<Vertex> vertices_;

  // To the screen: of x, z and height each, and where these are fitted to.
  std::array<double, 3> across_{};
  std::array<double, 3> up_{};
  std::array<double, 2> from_{};
  std::array<double, 2> scale_{};
  std::array<double, 2> shift_{};
  std::array<double, 2> origin_{};
  std::array<double, 2> extents_{};
  std::array<double, 3> to_eye_{};
  scene::Interval range_;
};

// along_x or along_z, as asked for or else the less end-on; both stays.
[[nodiscard]] Family resolved_family(const View& view);

}  // namespace sightline::algorithms::skala
