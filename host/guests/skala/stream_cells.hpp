// The cells of a grid from near to far, as polylines: what contours and both families of lines are made of
// (Skala 1985, section 5: "firstly two margins must be drawn ... then draw back margins of the given grid").
//
// A cell has its nearest corner N, side corners L and R and its farthest corner F; N and F lie between L and
// R on the screen, so N's two edges, F's two edges and the diagonal L-R are all monotone in x.
#pragma once

#include <array>
#include <cstddef>

#include "host/guests/skala/order.hpp"
#include "host/guests/skala/stream_chain.hpp"

namespace sightline::guests::skala {

struct Cell {
  GridIndex nearest;
  GridIndex left;
  GridIndex right;
  GridIndex farthest;
  bool left_margin_is_border = false;  // L-F is the domain's edge
  bool right_margin_is_border = false;
};

class Cells {
 public:
  // The projection must outlive it.
  explicit Cells(const Projection& projection) : projection_(projection), order_(cell_order(projection)) {}

  // Of grid points; one more than of cells.
  [[nodiscard]] std::size_t rows() const { return order_.rows; }
  [[nodiscard]] std::size_t columns() const { return order_.columns; }

  [[nodiscard]] const Vertex& at(GridIndex index) const { return projection_.at(index.point, index.slice); }
  [[nodiscard]] Cell cell(std::size_t row, std::size_t column) const;

  // The two edges of the domain that meet in its nearest corner, as far as defined, from left to right.
  [[nodiscard]] RasterChain near_margins(ChainStep step) const;
  // L - F - R as far as defined; `border` is the step on the domain's edge.
  [[nodiscard]] RasterChain far_margins(std::size_t row, std::size_t column, ChainStep step,
                                        ChainStep border) const;

 private:
  // Of the two directions away from the eye the one that goes left, or goes less to the right.
  [[nodiscard]] bool columns_go_left() const { return order_.column_shift < order_.row_shift; }
  void join(RasterChain& chain, GridIndex from, GridIndex to, ChainStep step) const;

  const Projection& projection_;
  DrawingOrder order_;
};

}  // namespace sightline::guests::skala
