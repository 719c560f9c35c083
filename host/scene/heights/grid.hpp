// A function of two variables as a rectangle of heights: what Skala's programs draw (Skala 1985, section 2).
//
// x runs along a slice, z from slice to slice; an unrotated picture has slice 0 in front. A height that is
// not finite is undefined: the surface has a hole there. The places of the samples are normalised, because a picture needs only
// these; axes and messages use the domain.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::scene {

// From low to high, both included.
struct Interval {
  double low = 0;
  double high = 0;

  friend bool operator==(const Interval&, const Interval&) = default;
};

// Where a function is sampled.
struct HeightDomain {
  Interval x;
  Interval z;

  friend bool operator==(const HeightDomain&, const HeightDomain&) = default;
};

struct GridSize {
  std::size_t points = 33;  // along x, in every slice
  std::size_t slices = 30;  // along z
};

// Limits of every reader and sampler. A program may build smaller grids, down to a single point.
inline constexpr GridSize smallest_grid{2, 2};
inline constexpr GridSize largest_grid{1024, 1024};
// The limit of a file before it is thinned: a binary Surfer grid counts in 16 bits.
inline constexpr GridSize largest_file_grid{32767, 32767};

struct HeightGrid {
  std::vector<double> x;        // of the points, ascending in [-1, 1]
  std::vector<double> z;        // of the slices, ascending in [-1, 1]
  std::vector<double> heights;  // z.size() slices of x.size() heights
  Interval domain_x;            // what [-1, 1] stands for
  Interval domain_z;
  Interval range;  // heights drawn at -1 and +1; equal: the surface is flat
  std::array<std::string, 3> names = {};  // of x, z and the heights, as a file's heading has them; empty: none
  std::string note = {};  // how a file was read if its layout was guessed or points were left out; empty: as the file says

  [[nodiscard]] std::size_t points() const { return x.size(); }
  [[nodiscard]] std::size_t slices() const { return z.size(); }
  [[nodiscard]] double height(std::size_t point, std::size_t slice) const {
    return heights[slice * x.size() + point];
  }
};

// `count` positions at equal distances from -1 to 1, of exact symmetry about 0; a single one is at 0.
[[nodiscard]] std::vector<double> even_positions(std::size_t count);

// Maps ascending places from the domain to [-1, 1]. The first and the last place are the ends of the domain.
[[nodiscard]] std::vector<double> normalised(std::vector<double> places, Interval domain);

// The same with the range of the places as the domain. Empty if two places become equal.
[[nodiscard]] std::optional<std::vector<double>> positions_of(const std::vector<double>& ascending);

// The order of the rows in a file.
enum class RowOrder : std::uint8_t { south_first, north_first };

// A grid of equidistant places, without its range. The error names the ends of a domain if they do not rise or are not finite.
// `heights` are in the order of the file, as many as the size has (precondition).
[[nodiscard]] base::Result<HeightGrid> even_grid(HeightDomain domain, GridSize size, std::vector<double> heights,
                                                 RowOrder order, std::string_view source);

// Every `step`-th point of every `step`-th slice, beginning with the first. At least two of each remain: a larger step is reduced.
// The range and the note do not change.
[[nodiscard]] HeightGrid thinned(const HeightGrid& grid, std::size_t step);

// A number as the shortest text that reads back the same.
[[nodiscard]] std::string shortest_text(double number);

// Whether a height of a file is the value that stands for no height. Values beyond 1e30 need not have the same digits: those of a file of
// floats rarely are what a header or a person writes.
[[nodiscard]] inline bool is_nodata(double height, double nodata) {
  constexpr double beyond_heights = 1e30;
  return height == nodata || (std::abs(nodata) > beyond_heights && std::abs(height - nodata) <= 1e-5 * std::abs(nodata));
}

// The least and the greatest finite value. {0, 0} if there is none.
[[nodiscard]] Interval finite_range(const std::vector<double>& values);

[[nodiscard]] bool anywhere_finite(const std::vector<double>& values);

}  // namespace sightline::scene
