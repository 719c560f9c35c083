#include "host/algorithms/exact/image_grid.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::algorithms::exact {
namespace {

constexpr double cells_an_occluder = 1.0;
constexpr double widest_cells = 1024;
constexpr std::uint32_t most_entries_an_occluder = 32;  // on average

// Every so many-th edge is looked at to place the grid: a few at the rim are seen as well without.
double percentile(std::vector<double>& values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

ImageGrid::ImageGrid(const View& view) {
  side_ = static_cast<std::uint32_t>(std::clamp(
      std::sqrt(static_cast<double>(view.occluders.size()) * cells_an_occluder), 1.0, widest_cells));
  fit(view);
  // Occluders that cover much of the image are in many cells each: then there are fewer cells.
  const std::uint64_t most = std::uint64_t{most_entries_an_occluder} * view.occluders.size() + 4096;
  while (side_ > 1 && entries_needed(view) > most) {
    side_ /= 2;
    fit(view);
  }
  starts_.assign(std::size_t{side_} * side_ + 1, 0);
  std::vector<Cells> covered;
  covered.reserve(view.occluders.size());
  for (const Occluder& occluder : view.occluders) {
    const Cells cells = cells_of(occluder.bounds);
    covered.push_back(cells);
    for (std::uint32_t row = cells.low[1]; row <= cells.high[1]; ++row) {
      for (std::uint32_t column = cells.low[0]; column <= cells.high[0]; ++column) {
        ++starts_[std::size_t{row} * side_ + column + 1];
      }
    }
  }
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  entries_.resize(starts_.back());
  std::vector<std::uint32_t> fill(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < covered.size(); ++i) {
    for (std::uint32_t row = covered[i].low[1]; row <= covered[i].high[1]; ++row) {
      for (std::uint32_t column = covered[i].low[0]; column <= covered[i].high[0]; ++column) {
        entries_[fill[std::size_t{row} * side_ + column]++] = i;
      }
    }
  }
}

std::uint64_t ImageGrid::entries_needed(const View& view) const {
  std::uint64_t entries = 0;
  for (const Occluder& occluder : view.occluders) {
    const Cells cells = cells_of(occluder.bounds);
    entries += std::uint64_t{cells.high[0] - cells.low[0] + 1} * (cells.high[1] - cells.low[1] + 1);
  }
  return entries;
}

// Over the edges drawn, but for the outermost hundredth on each side: one edge beside the eye may be seen a
// thousand widths away.
void ImageGrid::fit(const View& view) {
  const std::size_t step = view.drawn.size() / 4096 + 1;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::vector<double> lows;
    std::vector<double> highs;
    for (std::size_t e = 0; e < view.drawn.size(); e += step) {
      if (view.drawn[e] == 0) continue;
      if (std::isfinite(view.bounds[e].low[axis])) lows.push_back(view.bounds[e].low[axis]);
      if (std::isfinite(view.bounds[e].high[axis])) highs.push_back(view.bounds[e].high[axis]);
    }
    if (lows.empty() || highs.empty()) continue;
    origin_[axis] = percentile(lows, 0.01);
    const double width = percentile(highs, 0.99) - origin_[axis];
    if (width > 0) cells_a_unit_[axis] = side_ / width;
  }
}

ImageGrid::Cells ImageGrid::cells_of(const ImageBounds& bounds) const {
  const auto cell = [&](double coordinate, std::size_t axis) {
    return static_cast<std::uint32_t>(
        std::clamp((coordinate - origin_[axis]) * cells_a_unit_[axis], 0.0, static_cast<double>(side_ - 1)));
  };
  return {{cell(bounds.low[0], 0), cell(bounds.low[1], 1)},
          {cell(bounds.high[0], 0), cell(bounds.high[1], 1)}};
}

}  // namespace sightline::algorithms::exact
