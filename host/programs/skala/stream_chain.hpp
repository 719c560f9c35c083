// A chain: connected lines on the raster between two COMMITs, clipped at its border.
//
// Lines are clipped exactly, in real coordinates, and the clipped ends rounded once. Parts left or right of the raster are
// dropped. Parts above or below still hide what is behind them: they run along the border without ink (test-only lines have
// no effect there and are dropped; shading has no inkless mode and is clamped).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "host/programs/skala/projection.hpp"

namespace sightline::programs::skala {

enum class ChainStep { draw, test, mask, shade, rim };

struct ChainNode {
  int column = 0;  // 0..255
  int row = 0;
  int level = 0;
  ChainStep step = ChainStep::draw;  // of the line that ends here; of the dot, if it is the whole piece
  bool fresh = true;                 // a piece begins here: no line ends here

  friend bool operator==(const ChainNode&, const ChainNode&) = default;
};

class RasterChain {
 public:
  struct Levels {
    int from = 0;
    int to = 0;
  };

  // Both ends must be defined. Continues the piece if `from` is the same object as the end of the last segment.
  void segment(const Vertex& from, const Vertex& to, ChainStep step, Levels levels);
  void segment(const Vertex& from, const Vertex& to, ChainStep step) { segment(from, to, step, Levels{}); }
  // A defined vertex without neighbours.
  void point(const Vertex& vertex, ChainStep step, int level = 0);

  [[nodiscard]] const std::vector<ChainNode>& nodes() const { return nodes_; }
  // The same lines in the opposite direction.
  [[nodiscard]] RasterChain reversed() const;

 private:
  void part(const ChainNode& from, const ChainNode& to);

  std::vector<ChainNode> nodes_;
  const Vertex* end_ = nullptr;  // of the last segment; null if it was clipped away
};

// The cells of a grid from near to far, as polylines, used for contours and for both families of lines (Skala 1985, section
// 5: "firstly two margins must be drawn ... then draw back margins of the given grid").
//
// A cell has its nearest corner N, side corners L and R and its farthest corner F; N and F lie between L and
// R on the screen, so N's two edges, F's two edges and the diagonal L-R are all monotone in x.

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
  // The projection must outlive the cells.
  explicit Cells(const Projection& projection) : projection_(projection), order_(cell_order(projection)) {}

  // Numbers of grid points; there is one cell fewer.
  [[nodiscard]] std::size_t rows() const { return order_.rows; }
  [[nodiscard]] std::size_t columns() const { return order_.columns; }

  [[nodiscard]] const Vertex& at(GridIndex index) const { return projection_.at(index.point, index.slice); }
  [[nodiscard]] Cell cell(std::size_t row, std::size_t column) const;

  // The two edges of the domain that meet in its nearest corner, where defined, from left to right.
  [[nodiscard]] RasterChain near_margins(ChainStep step) const;
  // L - F - R where defined; `border` is the step on the domain's edge.
  [[nodiscard]] RasterChain far_margins(std::size_t row, std::size_t column, ChainStep step,
                                        ChainStep border) const;

 private:
  // Whether, of the two directions away from the eye, that of the columns goes left or less to the right.
  [[nodiscard]] bool columns_go_left() const { return order_.column_shift < order_.row_shift; }
  void join(RasterChain& chain, GridIndex from, GridIndex to, ChainStep step) const;

  const Projection& projection_;
  DrawingOrder order_;
};

}  // namespace sightline::programs::skala
