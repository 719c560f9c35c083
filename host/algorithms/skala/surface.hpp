// A height grid on the screen, in drawing order: row 0 is in front, and in every row the column nearest to the eye is
// first, whatever the rotation (Skala 1985, section 3).
//
// With x, z, h in [-1, 1], rotation A and elevation E:
//   screen x = x cos A + z sin A     depth = -x sin A + z cos A     screen y = 0.6 h cos E + depth sin E
// where 0.6 is the height of View::sides; x and z are scaled by its other members.
// Both are fitted to 0..255 by their extremes over the defined points, and rounded to a lattice far finer than a mask
// column. Points that coincide in exact arithmetic then coincide here, and the last bit of a sine does not decide
// visibility. Along a vertical of the screen, depth grows with z / cos A and with -x / sin A, so the order of rows and
// columns follows from two signs.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "host/algorithms/skala/view.hpp"
#include "host/base/result.hpp"
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
  // For `family` along_x and along_z, the slices are the rows; otherwise the rows are the slices along x. The picture is
  // fitted to all grids in `sharing`, which have the same coordinates and range; if it is empty, to this grid.
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
  // The position of a point in coordinates of the box, where x, z and height are -1..1. The point may be outside the box.
  [[nodiscard]] Vertex place(double x, double z, double height) const;
  // A height of the grid mapped to -1..1 by the grid's range; 0 if the range is empty.
  [[nodiscard]] double normalised_height(double height) const;
  // The direction towards the eye in x, z and height.
  [[nodiscard]] std::array<double, 3> to_eye() const;
  // The position in the units of View::sides, and the position and extents in these units of the picture's 0..255.
  [[nodiscard]] std::array<double, 2> project(double x, double z, double height) const;
  [[nodiscard]] std::array<double, 2> origin() const { return origin_; }
  [[nodiscard]] std::array<double, 2> extents() const { return extents_; }
  // Whether every vertex is defined.
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

  // The map to the screen: factors of x, z and height, and the fit of the result.
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

// The given family if it is along_x, along_z or both; otherwise the family that is less end-on.
[[nodiscard]] Family resolved_family(const View& view);
// The slices along which a finer mesh is smooth without more of them: those of a picture of lines along one axis; otherwise both.
[[nodiscard]] Family smoothed_family(const View& view);
// Each cell in `parts` parts along the slices of one family, or in `parts` by `parts`. Errors as of scene::subdivided.
[[nodiscard]] base::Result<scene::HeightGrid> finer_mesh(const scene::HeightGrid& grid, std::size_t parts, Family along);

}  // namespace sightline::algorithms::skala
