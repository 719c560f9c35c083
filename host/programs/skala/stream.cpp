#include "host/programs/skala/stream.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include "host/programs/skala/contours.hpp"
#include "host/programs/skala/stream_chain.hpp"
#include "host/programs/skala/stream_writer.hpp"

namespace sightline::programs::skala {
namespace {

// One family of slices, as lines or as a shaded surface.
class Slices {
 public:
  Slices(const scene::HeightGrid& grid, const View& view, const Output& output)
      : shaded_(view.subject == Subject::surface),
        projection_(grid, view),
        order_(slice_order(projection_, family(view))),
        writer_(view, output, line_colour) {
    if (shaded_) shades_ = shades(grid);
  }

  std::vector<std::uint8_t> stream() {
    if (order_.rows != 0 && order_.columns != 0) {
      writer_.chain_and_commit(near_chain());
      for (std::size_t row = 1; row < order_.rows; ++row) {
        RasterChain chain;
        slice(chain, row);
        writer_.chain_and_commit(chain);
        if (shaded_) gaps(row);
      }
      RasterChain trailing;
      rim(trailing, leading_right() ? 0 : order_.columns - 1, leading_right(), drawn());
      writer_.chain_and_commit(trailing);
    }
    return writer_.finish();
  }

 private:
  [[nodiscard]] Family family(const View& view) const {
    const bool chosen = view.family == Family::along_x || view.family == Family::along_z;
    return chosen ? view.family : less_end_on(projection_.rotation());
  }

  [[nodiscard]] bool leading_right() const { return order_.row_shift >= 0; }
  [[nodiscard]] ChainStep drawn() const { return shaded_ ? ChainStep::shade : ChainStep::draw; }

  [[nodiscard]] const Vertex& at(std::size_t row, std::size_t column) const {
    const GridIndex index = order_.index(row, column);
    return projection_.at(index.point, index.slice);
  }
  [[nodiscard]] int shade(std::size_t row, std::size_t column) const {
    const GridIndex index = order_.index(row, column);
    return shaded_ ? shades_[index.slice * projection_.points() + index.point] : 0;
  }

  // The leading rim is nearest in the columns beyond slice 0, so the two form one chain. The trailing rim is farthest in
  // its columns, so it comes last.
  RasterChain near_chain() const {
    RasterChain chain;
    const ChainStep rim_step = shaded_ ? ChainStep::rim : ChainStep::draw;
    if (!leading_right()) rim(chain, 0, false, rim_step);
    slice(chain, 0);
    if (leading_right()) rim(chain, order_.columns - 1, true, rim_step);
    return chain;
  }

  // Adds a column's rim, from its near end or towards it.
  void rim(RasterChain& chain, std::size_t column, bool from_near, ChainStep step) const {
    for (std::size_t i = 0; i + 1 < order_.rows; ++i) {
      const std::size_t from = from_near ? i : order_.rows - 1 - i;
      join(chain, {from, column}, {from_near ? from + 1 : from - 1, column}, step);
    }
  }

  void slice(RasterChain& chain, std::size_t row) const {
    for (std::size_t column = 0; column < order_.columns; ++column) {
      const bool alone = !defined(row, column + 1) && (column == 0 || !defined(row, column - 1));
      if (alone && defined(row, column)) chain.point(at(row, column), drawn(), shade(row, column));
      if (column + 1 < order_.columns) join(chain, {row, column}, {row, column + 1}, drawn());
    }
  }

  struct Place {
    std::size_t row;
    std::size_t column;
  };
  void join(RasterChain& chain, Place from, Place to, ChainStep step) const {
    const Vertex& a = at(from.row, from.column);
    const Vertex& b = at(to.row, to.column);
    if (a.defined && b.defined)
      chain.segment(a, b, step, {shade(from.row, from.column), shade(to.row, to.column)});
  }

  [[nodiscard]] bool defined(std::size_t row, std::size_t column) const {
    return column < order_.columns && at(row, column).defined;
  }

  // Prevents filling from earlier slices across the holes of this one, including those at its ends.
  void gaps(std::size_t row) {
    for (std::size_t column = 0; column < order_.columns; ++column) {
      if (defined(row, column)) continue;
      const std::size_t hole = column;
      while (column + 1 < order_.columns && !defined(row, column + 1)) ++column;
      const int first = hole == 0 ? at(row, 0).column : at(row, hole - 1).column + 1;
      const int last = column + 1 == order_.columns ? at(row, column).column : at(row, column + 1).column - 1;
      writer_.gap(first, last);
    }
  }

  bool shaded_;
  Projection projection_;
  DrawingOrder order_;
  StreamWriter writer_;
  std::vector<int> shades_;
};

// Both families in one pass; the far margins of a cell are tested before they hide anything.
std::vector<std::uint8_t> cell_lines(const scene::HeightGrid& grid, const View& view, const Output& output) {
  const Projection projection(grid, view);
  const Cells cells(projection);
  StreamWriter writer(view, output, line_colour);
  writer.chain_and_commit(cells.near_margins(ChainStep::draw));
  for (std::size_t row = 0; row + 1 < cells.rows(); ++row) {
    for (std::size_t column = 0; column + 1 < cells.columns(); ++column) {
      writer.chain_and_commit(cells.far_margins(row, column, ChainStep::draw, ChainStep::draw));
    }
  }
  return writer.finish();
}

// Slope along x at a point in a row of normalised heights, from its defined neighbours.
double slope(double before, double here, double after, double to_before, double to_after) {
  const bool has_before = std::isfinite(before);
  const bool has_after = std::isfinite(after);
  if (has_before && has_after) return (after - before) / (to_before + to_after);
  if (has_after) return (after - here) / to_after;
  return has_before ? (here - before) / to_before : 0.0;
}

// 1 .. 7 by the normal's lean towards x; that of no lean if points coincide or are so close that the slope exceeds the
// greatest double.
int shade_of(double across, double along) {
  const double normal_x = -across / std::hypot(1.0, across, along);
  if (!std::isfinite(normal_x)) return 4;
  return 1 + static_cast<int>(std::floor((normal_x + 1) / 2 * 6 + 0.5));
}

}  // namespace

std::vector<int> shades(const scene::HeightGrid& grid) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  const auto h = [&](std::size_t point, std::size_t slice) {
    if (point >= grid.points() || slice >= grid.slices()) return undefined;  // includes indices before the first one
    return 0.6 * normalised_height(grid, grid.height(point, slice));
  };
  const auto distance = [](const std::vector<double>& places, std::size_t i) {
    return i > 0 && i < places.size() ? places[i] - places[i - 1] : 1.0;
  };
  std::vector<int> shades(grid.heights.size(), 0);
  for (std::size_t slice = 0; slice < grid.slices(); ++slice) {
    for (std::size_t point = 0; point < grid.points(); ++point) {
      const double here = h(point, slice);
      if (!std::isfinite(here)) continue;
      const double across = slope(h(point - 1, slice), here, h(point + 1, slice), distance(grid.x, point),
                                  distance(grid.x, point + 1));
      const double along = slope(h(point, slice - 1), here, h(point, slice + 1), distance(grid.z, slice),
                                 distance(grid.z, slice + 1));
      shades[slice * grid.points() + point] = shade_of(across, along);
    }
  }
  return shades;
}

std::vector<std::uint8_t> stream_of(const scene::HeightGrid& grid, const View& view, const Output& output) {
  if (view.subject == Subject::contours) return contour_stream(grid, view, output);
  if (view.subject == Subject::lines && view.family == Family::both) return cell_lines(grid, view, output);
  return Slices(grid, view, output).stream();
}

}  // namespace sightline::programs::skala
