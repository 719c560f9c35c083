#include "host/scene/heights/subdivide.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace sightline::scene {

namespace {

constexpr double hole = std::numeric_limits<double>::quiet_NaN();

// Heights along a line of the grid, at ascending places.
struct Profile {
  std::vector<double> places;
  std::vector<double> heights;
};

bool defined(const Profile& profile, std::size_t i) {
  return i < profile.heights.size() && std::isfinite(profile.heights[i]);
}

double secant(const Profile& profile, std::size_t i, std::size_t j) {
  return (profile.heights[j] - profile.heights[i]) / (profile.places[j] - profile.places[i]);
}

// The slope at place `at` of the parabola through three places.
double parabola_slope(const Profile& profile, std::size_t i, std::size_t j, std::size_t k, std::size_t at) {
  const double first = secant(profile, i, j);
  const double bend = (secant(profile, j, k) - first) / (profile.places[k] - profile.places[i]);
  return first + bend * (2 * profile.places[at] - profile.places[i] - profile.places[j]);
}

// The slope at `i`, of the curve to the neighbour `next` = i + 1 or i - 1, which is defined.
double slope_at(const Profile& profile, std::size_t i, std::size_t next) {
  const std::size_t before = next > i ? i - 1 : i + 1;  // wraps below the first place, where nothing is defined
  const std::size_t beyond = next > i ? next + 1 : next - 1;
  if (defined(profile, before))
    return parabola_slope(profile, std::min(before, next), i, std::max(before, next), i);
  if (defined(profile, beyond)) return parabola_slope(profile, std::min(i, beyond), next, std::max(i, beyond), i);
  return secant(profile, std::min(i, next), std::max(i, next));
}

std::vector<double> finer_places(const std::vector<double>& places, std::size_t parts) {
  std::vector<double> finer;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    for (std::size_t k = 0; k < parts; ++k)
      finer.push_back(places[i] + (places[i + 1] - places[i]) * static_cast<double>(k) / static_cast<double>(parts));
  }
  finer.push_back(places.back());
  return finer;
}

std::vector<double> finer_heights(const Profile& profile, std::size_t parts) {
  std::vector<double> finer;
  for (std::size_t i = 0; i + 1 < profile.heights.size(); ++i) {
    finer.push_back(profile.heights[i]);
    const bool known = defined(profile, i) && defined(profile, i + 1);
    const double from = known ? slope_at(profile, i, i + 1) : hole;
    const double to = known ? slope_at(profile, i + 1, i) : hole;
    const double width = profile.places[i + 1] - profile.places[i];
    const double rise = profile.heights[i + 1] - profile.heights[i];
    for (std::size_t k = 1; k < parts; ++k) {
      // Hermite's cubic.
      const double t = static_cast<double>(k) / static_cast<double>(parts);
      const double straight = profile.heights[i] + rise * t;
      finer.push_back(known ? straight + t * (1 - t) * ((1 - t) * (from * width - rise) - t * (to * width - rise)) : hole);
    }
  }
  finer.push_back(profile.heights.back());
  return finer;
}

}  // namespace

base::Result<HeightGrid> subdivided(const HeightGrid& grid, const CellParts& parts) {
  HeightGrid finer = grid;
  finer.x = finer_places(grid.x, parts.x);
  finer.z = finer_places(grid.z, parts.z);
  if (finer.points() > largest_grid.points || finer.slices() > largest_grid.slices) {
    return base::Error{"", "--subdivide", fmt::format("{} slices of {} points, each cell in {} by {}: {} by {}", grid.slices(), grid.points(), parts.x,
                                                      parts.z, finer.slices(), finer.points()),
                       fmt::format("at most {} by {}", largest_grid.slices, largest_grid.points)};
  }
  // Slice by slice along x, then column by column along z.
  std::vector<double> along_x;
  for (std::size_t slice = 0; slice < grid.slices(); ++slice) {
    const auto from = grid.heights.begin() + static_cast<std::ptrdiff_t>(slice * grid.points());
    const auto heights = finer_heights({grid.x, {from, from + static_cast<std::ptrdiff_t>(grid.points())}}, parts.x);
    along_x.insert(along_x.end(), heights.begin(), heights.end());
  }
  finer.heights.assign(finer.points() * finer.slices(), hole);
  for (std::size_t point = 0; point < finer.points(); ++point) {
    Profile column{grid.z, {}};
    for (std::size_t slice = 0; slice < grid.slices(); ++slice) column.heights.push_back(along_x[slice * finer.points() + point]);
    const auto heights = finer_heights(column, parts.z);
    for (std::size_t slice = 0; slice < heights.size(); ++slice) finer.heights[slice * finer.points() + point] = heights[slice];
  }
  const Interval range = finite_range(finer.heights);
  finer.range = {std::min(grid.range.low, range.low), std::max(grid.range.high, range.high)};
  return finer;
}

}  // namespace sightline::scene
