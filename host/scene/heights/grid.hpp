// A function of two variables as a rectangle of heights: what Skala's programs draw (Skala 1985, section 2).
//
// x runs along a slice, z from slice to slice; an unrotated picture has slice 0 in front. A height that is
// not finite is undefined: the surface has a hole there. Where the samples lie is kept in normalised
// coordinates, since a picture only needs those; the domain is kept to be shown to people.
#pragma once

#include <array>
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

// At the door of every reader and sampler; a program may also build smaller grids, down to a single point.
inline constexpr GridSize smallest_grid{2, 2};
inline constexpr GridSize largest_grid{1024, 1024};
// Of a grid format, before it is thinned.
inline constexpr GridSize largest_file_grid{32767, 32767};

struct HeightGrid {
  std::vector<double> x;        // of the points, ascending in [-1, 1]
  std::vector<double> z;        // of the slices, ascending in [-1, 1]
  std::vector<double> heights;  // z.size() slices of x.size() heights
  Interval domain_x;            // what [-1, 1] stands for
  Interval domain_z;
  Interval range;  // heights drawn at -1 and +1; equal ones: everything is flat
  std::array<std::string, 3> names = {};  // of x, z and the heights, as a file's heading has them; empty: none
  std::string note = {};  // how a file was read where its layout was guessed or points were left out; empty: as the file says

  [[nodiscard]] std::size_t points() const { return x.size(); }
  [[nodiscard]] std::size_t slices() const { return z.size(); }
  [[nodiscard]] double height(std::size_t point, std::size_t slice) const {
    return heights[slice * x.size() + point];
  }
};

// `count` positions at equal distances from -1 to 1, of exact symmetry about 0; a single one is at 0.
[[nodiscard]] std::vector<double> even_positions(std::size_t count);

// Ascending places of a domain, whose ends they have, in [-1, 1].
[[nodiscard]] std::vector<double> normalised(std::vector<double> places, Interval domain);

// The same of their own range. None: two of them come to the same.
[[nodiscard]] std::optional<std::vector<double>> positions_of(const std::vector<double>& ascending);

// In what order a file has its rows.
enum class RowOrder : std::uint8_t { south_first, north_first };

// A grid of even places, without its range. The error names the ends of a domain that do not rise or are no finite numbers.
// `heights` are those of the file in its order, as many as the size has (precondition).
[[nodiscard]] base::Result<HeightGrid> even_grid(HeightDomain domain, GridSize size, std::vector<double> heights, RowOrder order, std::string_view source);

// Every `step`-th point of every `step`-th slice from the first ones on, at least two of each: the step is made smaller where it
// would leave fewer. The range and the note stay.
[[nodiscard]] HeightGrid thinned(const HeightGrid& grid, std::size_t step);

// A number as the shortest text that reads back the same.
[[nodiscard]] std::string shortest_text(double number);

// The least and the greatest finite value. {0, 0} if there is none.
[[nodiscard]] Interval finite_range(const std::vector<double>& values);

[[nodiscard]] bool anywhere_finite(const std::vector<double>& values);

}  // namespace sightline::scene
