#include "host/programs/skala/contours.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "host/programs/skala/stream_writer.hpp"

namespace sightline::programs::skala {
namespace {

// Scales heights down if differences of them might overflow; a power of two changes no ratio. Other heights keep their
// scale, because small ones could become zero.
double scale_for(double a, double b) {
  constexpr double large = 1e300;
  return std::abs(a) > large || std::abs(b) > large ? 1.0 / 1024 : 1.0;
}

// The crossing of an edge is computed from its lower grid index, so that neighbours meet in the same dot.
Vertex crossing_of_edge(const scene::HeightGrid& grid, const Projection& projection, GridIndex a, GridIndex b,
                        double level) {
  if (b.slice < a.slice || (b.slice == a.slice && b.point < a.point)) std::swap(a, b);
  const Vertex& from = projection.at(a.point, a.slice);
  const Vertex& to = projection.at(b.point, b.slice);
  const double first = grid.height(a.point, a.slice);
  const double second = grid.height(b.point, b.slice);
  const double scale = scale_for(first, second);  // valid for the level too, which lies between them
  const double low = scale * first;
  const double high = scale * second;
  const double t = (scale * level - low) / (high - low);
  Vertex result;
  result.x = from.x + t * (to.x - from.x);
  result.y = from.y + t * (to.y - from.y);
  result.depth = from.depth + t * (to.depth - from.depth);
  result.column = raster_coordinate(result.x);
  result.row = raster_coordinate(result.y);
  result.defined = true;
  return result;
}

class Contours {
 public:
  Contours(const scene::HeightGrid& grid, const View& view, const Output& output)
      : grid_(grid),
        projection_(grid, view),
        cells_(projection_),
        writer_(view, output, margin_colour, view.silhouette ? margin_colour : 0),
        levels_(contour_levels(grid.range, view.levels)),
        inner_margin_(view.net ? ChainStep::draw : ChainStep::mask) {}

  std::vector<std::uint8_t> stream() {
    writer_.chain_and_commit(cells_.near_margins(ChainStep::draw));
    for (std::size_t row = 0; row + 1 < cells_.rows(); ++row) {
      for (std::size_t column = 0; column + 1 < cells_.columns(); ++column) cell(row, column);
    }
    writer_.colour(margin_colour);
    writer_.outline();
    return writer_.finish();
  }

 private:
  void cell(std::size_t row, std::size_t column) {
    const Cell cell = cells_.cell(row, column);
    if (defined(cell.nearest) && defined(cell.left) && defined(cell.right) && defined(cell.farthest)) {
      pieces({cell.nearest, cell.left, cell.right});
      RasterChain diagonal;
      diagonal.segment(cells_.at(cell.left), cells_.at(cell.right), ChainStep::mask);
      writer_.chain_and_commit(diagonal);
      pieces({cell.left, cell.farthest, cell.right});
    }
    if (inner_margin_ == ChainStep::draw || cell.left_margin_is_border || cell.right_margin_is_border)
      writer_.colour(margin_colour);
    writer_.chain_and_commit(cells_.far_margins(row, column, inner_margin_, ChainStep::draw));
  }

  [[nodiscard]] bool defined(GridIndex index) const { return cells_.at(index).defined; }

  void pieces(const std::array<GridIndex, 3>& triangle) {
    std::vector<ColouredChain> chains;
    for (std::size_t k = 0; k < levels_.size(); ++k) {
      const ContourCrossing crossing = contour_crossing(grid_, projection_, triangle, levels_[k]);
      const auto& [from, to] = crossing.piece;
      if (!crossing.crossed || (from.column == to.column && from.row == to.row)) continue;
      chains.push_back({contour_colours[k % contour_colours.size()], {}});
      chains.back().chain.segment(from, to, ChainStep::test);
    }
    writer_.test_chains(std::move(chains));
  }

  const scene::HeightGrid& grid_;
  Projection projection_;
  Cells cells_;
  StreamWriter writer_;
  std::vector<double> levels_;
  ChainStep inner_margin_;
};

}  // namespace

std::vector<double> contour_levels(scene::Interval range, int count) {
  std::vector<double> levels;
  if (!(range.high > range.low)) return levels;
  const double scale = scale_for(range.low, range.high);
  const double low = scale * range.low;
  const double extent = scale * range.high - low;
  for (int k = 1; k <= count; ++k) levels.push_back((low + k * extent / (count + 1)) / scale);
  return levels;
}

ContourCrossing contour_crossing(const scene::HeightGrid& grid, const Projection& projection,
                                 const std::array<GridIndex, 3>& triangle, double level) {
  std::array<bool, 3> above{};
  for (std::size_t i = 0; i < 3; ++i) above[i] = grid.height(triangle[i].point, triangle[i].slice) >= level;
  if (above[0] == above[1] && above[1] == above[2]) return {};
  // The corner that is alone on its side: the contour crosses both its edges.
  const std::size_t alone = above[1] == above[2] ? 0 : above[0] == above[2] ? 1 : 2;
  const auto edge = [&](std::size_t other) {
    return crossing_of_edge(grid, projection, triangle[alone], triangle[other], level);
  };
  return {true, {edge((alone + 2) % 3), edge((alone + 1) % 3)}};
}

std::vector<std::uint8_t> contour_stream(const scene::HeightGrid& grid, const View& view, const Output& output) {
  return Contours(grid, view, output).stream();
}

}  // namespace sightline::programs::skala
