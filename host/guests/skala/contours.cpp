#include "host/guests/skala/contours.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "host/guests/skala/stream_writer.hpp"

namespace sightline::harness {
namespace {

// Heights whose differences might overflow are scaled down, which changes no ratio, being by a power of two.
// Others are not: it would change small ones, down to nothing.
double scale_for(double a, double b) {
  constexpr double large = 1e300;
  return std::abs(a) > large || std::abs(b) > large ? 1.0 / 1024 : 1.0;
}

// The crossing of an edge is computed from its lower grid index, so that neighbours meet in the same dot.
SkalaVertex crossing_of_edge(const scene::HeightGrid& grid, const SkalaProjection& projection, GridIndex a,
                             GridIndex b, double level) {
  if (b.slice < a.slice || (b.slice == a.slice && b.point < a.point)) std::swap(a, b);
  const SkalaVertex& from = projection.at(a.point, a.slice);
  const SkalaVertex& to = projection.at(b.point, b.slice);
  const double first = grid.height(a.point, a.slice);
  const double second = grid.height(b.point, b.slice);
  const double scale = scale_for(first, second);  // and for the level, which is between them
  const double low = scale * first;
  const double high = scale * second;
  const double t = (scale * level - low) / (high - low);
  SkalaVertex result;
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
  Contours(const scene::HeightGrid& grid, const SkalaView& view)
      : grid_(grid),
        projection_(grid, view),
        cells_(projection_),
        writer_(view, skala_margin_colour, skala_margin_colour),
        levels_(contour_levels(grid.range, view.levels)),
        inner_margin_(view.net ? SkalaStep::draw : SkalaStep::mask) {}

  std::vector<std::uint8_t> stream() {
    writer_.chain_and_commit(cells_.near_margins(SkalaStep::draw));
    for (std::size_t row = 0; row + 1 < cells_.rows(); ++row) {
      for (std::size_t column = 0; column + 1 < cells_.columns(); ++column) cell(row, column);
    }
    writer_.colour(skala_margin_colour);
    writer_.outline();
    return writer_.finish();
  }

 private:
  void cell(std::size_t row, std::size_t column) {
    const SkalaCell cell = cells_.cell(row, column);
    if (defined(cell.nearest) && defined(cell.left) && defined(cell.right) && defined(cell.farthest)) {
      pieces({cell.nearest, cell.left, cell.right});
      SkalaChain diagonal;
      diagonal.segment(cells_.at(cell.left), cells_.at(cell.right), SkalaStep::mask);
      writer_.chain_and_commit(diagonal);
      pieces({cell.left, cell.farthest, cell.right});
    }
    if (inner_margin_ == SkalaStep::draw || cell.left_margin_is_border || cell.right_margin_is_border)
      writer_.colour(skala_margin_colour);
    writer_.chain_and_commit(cells_.far_margins(row, column, inner_margin_, SkalaStep::draw));
  }

  [[nodiscard]] bool defined(GridIndex index) const { return cells_.at(index).defined; }

  void pieces(const std::array<GridIndex, 3>& triangle) {
    std::vector<SkalaColouredChain> chains;
    for (std::size_t k = 0; k < levels_.size(); ++k) {
      const ContourCrossing crossing = contour_crossing(grid_, projection_, triangle, levels_[k]);
      const auto& [from, to] = crossing.piece;
      if (!crossing.crossed || (from.column == to.column && from.row == to.row)) continue;
      chains.push_back({skala_contour_colours[k % skala_contour_colours.size()], {}});
      chains.back().chain.segment(from, to, SkalaStep::test);
    }
    writer_.test_chains(std::move(chains));
  }

  const scene::HeightGrid& grid_;
  SkalaProjection projection_;
  SkalaCells cells_;
  SkalaStreamWriter writer_;
  std::vector<double> levels_;
  SkalaStep inner_margin_;
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

ContourCrossing contour_crossing(const scene::HeightGrid& grid, const SkalaProjection& projection,
                                 const std::array<GridIndex, 3>& triangle, double level) {
  std::array<bool, 3> above{};
  for (std::size_t i = 0; i < 3; ++i) above[i] = grid.height(triangle[i].point, triangle[i].slice) >= level;
  if (above[0] == above[1] && above[1] == above[2]) return {};
  // The corner that is alone on its side: both its edges are crossed.
  const std::size_t alone = above[1] == above[2] ? 0 : above[0] == above[2] ? 1 : 2;
  const auto edge = [&](std::size_t other) {
    return crossing_of_edge(grid, projection, triangle[alone], triangle[other], level);
  };
  return {true, {edge((alone + 2) % 3), edge((alone + 1) % 3)}};
}

std::vector<std::uint8_t> skala_contours(const scene::HeightGrid& grid, const SkalaView& view) {
  return Contours(grid, view).stream();
}

}  // namespace sightline::harness
