#include "host/guests/skala/stream_cells.hpp"

namespace sightline::guests::skala {

Cell Cells::cell(std::size_t row, std::size_t column) const {
  const GridIndex along_row = order_.index(row, column + 1);
  const GridIndex across_rows = order_.index(row + 1, column);
  const bool last_row = row + 2 == order_.rows;
  const bool last_column = column + 2 == order_.columns;
  const bool swap = !columns_go_left();
  return {order_.index(row, column),         swap ? across_rows : along_row, swap ? along_row : across_rows,
          order_.index(row + 1, column + 1), swap ? last_row : last_column,  swap ? last_column : last_row};
}

void Cells::join(RasterChain& chain, GridIndex from, GridIndex to, ChainStep step) const {
  if (at(from).defined && at(to).defined) chain.segment(at(from), at(to), step);
}

RasterChain Cells::near_margins(ChainStep step) const {
  RasterChain chain;
  if (rows() == 0 || columns() == 0) return chain;
  if (rows() == 1 && columns() == 1) {
    if (at(order_.index(0, 0)).defined) chain.point(at(order_.index(0, 0)), step);
    return chain;
  }
  const bool swap = !columns_go_left();
  const auto margin = [&](bool left, std::size_t i) {
    return left == swap ? order_.index(i, 0) : order_.index(0, i);
  };
  for (std::size_t i = (swap ? rows() : columns()) - 1; i > 0; --i)
    join(chain, margin(true, i), margin(true, i - 1), step);
  for (std::size_t i = 1; i < (swap ? columns() : rows()); ++i)
    join(chain, margin(false, i - 1), margin(false, i), step);
  return chain;
}

RasterChain Cells::far_margins(std::size_t row, std::size_t column, ChainStep step, ChainStep border) const {
  const Cell here = cell(row, column);
  RasterChain chain;
  join(chain, here.left, here.farthest, here.left_margin_is_border ? border : step);
  join(chain, here.farthest, here.right, here.right_margin_is_border ? border : step);
  return chain;
}

}  // namespace sightline::guests::skala
