#include "host/algorithms/skala/surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "host/scene/heights/subdivide.hpp"

namespace sightline::algorithms::skala {
namespace {

// 255 units of y and 16384 columns both take 24 bits, the precision of a float.
constexpr double lattice_x = 1024;
constexpr double lattice_y = 65536;
// Smaller extents are rounding errors of a picture without extent.
constexpr double smallest_extent = 1e-12;
// Values that are larger, infinite or not a number are undefined.
constexpr double farthest = 1e300;

struct Turn {
  double sine = 0;
  double cosine = 1;
};

// Exact at multiples of 45 degrees, except for the root, and exactly symmetric about them.
Turn within_quadrant(double degrees) {
  if (degrees == 45) return {std::sqrt(0.5), std::sqrt(0.5)};
  const double radians = std::min(degrees, 90 - degrees) / 180 * std::numbers::pi;
  const double least = std::sin(radians);
  const double most = std::cos(radians);
  return degrees < 45 ? Turn{least, most} : Turn{most, least};
}

Turn turn_of(double degrees) {
  double angle = std::fmod(degrees, 360.0);
  if (angle < 0) angle += 360.0;
  if (angle >= 360.0) angle = 0;
  const auto [sine, cosine] = within_quadrant(std::fmod(angle, 90.0));
  switch (static_cast<int>(angle / 90.0)) {
    case 0: return {sine, cosine};
    case 1: return {cosine, 0.0 - sine};
    case 2: return {0.0 - sine, 0.0 - cosine};
    default: return {0.0 - cosine, sine};
  }
}

struct Extremes {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(double value) {
    low = value < low ? value : low;
    high = value > high ? value : high;
  }
};

// Maps an extent to 0..size, in steps of 1 / lattice; to the middle if it is empty.
class Fit {
 public:
  Fit(Extremes extremes, double size, double lattice) : step_(1 / lattice) {
    const double extent = extremes.high - extremes.low;
    if (extent > smallest_extent) {
      low_ = extremes.low;
      scale_ = size * lattice / extent;
    } else {
      shift_ = size * lattice / 2;
    }
  }
  // As value * scale + shift, for values relative to `from`.
  [[nodiscard]] double from() const { return low_; }
  [[nodiscard]] double scale() const { return scale_ * step_; }
  [[nodiscard]] double shift() const { return shift_ * step_; }
  [[nodiscard]] double place(double value) const {
    const double steps = (value - low_) * scale_ + shift_ + 0.5;
    return static_cast<double>(static_cast<std::int32_t>(steps)) * step_;
  }

 private:
  double step_;
  double low_ = 0;
  double scale_ = 0;
  double shift_ = 0;
};

// What a coordinate along one axis of the grid adds to the screen x and the depth of a point.
struct Term {
  double x = 0;
  double depth = 0;
};

std::vector<Term> terms(const std::vector<double>& places, double to_x, double to_depth, bool reversed) {
  std::vector<Term> all;
  for (const double place : places) all.push_back({place * to_x, place * to_depth});
  if (reversed) std::reverse(all.begin(), all.end());
  return all;
}

// Heights on the screen: the middle and the factor of an affine map.
struct Upwards {
  double middle = 0;
  double factor = 0;

  Upwards(scene::Interval range, double to_screen) {
    // Computed from halves, because the difference of two heights may overflow.
    const double half = range.high / 2 - range.low / 2;
    if (!(half > 0) || !std::isfinite(1 / half)) return;
    middle = range.high / 2 + range.low / 2;
    factor = to_screen / half;
  }
  // NaN for an undefined height, whatever the range.
  [[nodiscard]] double operator()(double height) const { return (height - middle) * factor; }
};

}  // namespace

Family resolved_family(const View& view) {
  if (view.family != Family::automatic) return view.family;
  const auto [sine, cosine] = turn_of(view.rotation);
  return std::abs(cosine) >= std::abs(sine) ? Family::along_x : Family::along_z;
}

Family smoothed_family(const View& view) {
  return view.subject == Subject::lines ? resolved_family(view) : Family::both;
}

base::Result<scene::HeightGrid> finer_mesh(const scene::HeightGrid& grid, std::size_t parts, Family along) {
  return scene::subdivided(grid, {along == Family::along_z ? 1 : parts, along == Family::along_x ? 1 : parts});
}

Surface::Surface(const scene::HeightGrid& grid, const View& view, Family family, std::span<const scene::HeightGrid> sharing)
    : row_is_slice_(family != Family::along_z), vertices_(grid.points() * grid.slices()), range_(grid.range) {
  const Turn rotation = turn_of(view.rotation);
  const Turn elevation = turn_of(view.elevation);
  rows_ = row_is_slice_ ? grid.slices() : grid.points();
  columns_ = row_is_slice_ ? grid.points() : grid.slices();
  // If all depths are equal, the order is from left to right on the screen.
  const bool along_x_back =
      rotation.sine > 0 || (rotation.sine == 0 && rotation.cosine < 0);  // greater x is nearer
  const bool along_z_back = rotation.cosine < 0 || (rotation.cosine == 0 && rotation.sine < 0);
  rows_reversed_ = row_is_slice_ ? along_z_back : along_x_back;
  columns_reversed_ = row_is_slice_ ? along_x_back : along_z_back;

  const BoxSides& sides = view.sides;
  const auto x_terms = terms(grid.x, rotation.cosine * sides.x, -rotation.sine * sides.x, along_x_back);
  const auto z_terms = terms(grid.z, rotation.sine * sides.z, rotation.cosine * sides.z, along_z_back);
  const std::vector<Term>& row_terms = row_is_slice_ ? z_terms : x_terms;
  const std::vector<Term>& column_terms = row_is_slice_ ? x_terms : z_terms;
  const Upwards upwards(grid.range, sides.height * elevation.cosine);
  // Visits every vertex, row by row, with its number and its position before fitting.
  const auto for_each = [&](const scene::HeightGrid& of, const auto& visit) {
    std::size_t vertex = 0;
    for (std::size_t row = 0; row < rows_; ++row) {
      const Term in_row = row_terms[row];
      std::size_t index = height_index(row, 0);
      // The last step may be below 0 and is then not used.
      const std::size_t step = columns_ > 1 ? height_index(row, 1) - index : 0;
      for (std::size_t column = 0; column < columns_; ++column, index += step) {
        const Term in_column = column_terms[column];
        const double depth = in_row.depth + in_column.depth;
        visit(vertex++, in_row.x + in_column.x, upwards(of.heights[index]) + depth * elevation.sine);
      }
    }
  };
  Extremes extremes_x;
  Extremes extremes_y;
  const auto take = [&](std::size_t, double x, double y) {
    if (!(std::abs(y) < farthest)) return;
    extremes_y.take(y);
    extremes_x.take(x);
  };
  if (sharing.empty()) for_each(grid, take);
  for (const scene::HeightGrid& each : sharing) for_each(each, take);
  const double width = std::clamp(view.columns, fewest_columns, most_columns);
  const Fit fit_x(extremes_x, width, lattice_x);
  const Fit fit_y(extremes_y, picture_extent, lattice_y);
  across_ = {rotation.cosine * sides.x, rotation.sine * sides.z, 0};
  up_ = {-rotation.sine * sides.x * elevation.sine, rotation.cosine * sides.z * elevation.sine, sides.height * elevation.cosine};
  from_ = {fit_x.from(), fit_y.from()};
  scale_ = {fit_x.scale(), fit_y.scale()};
  shift_ = {fit_x.shift(), fit_y.shift()};
  if (extremes_x.high >= extremes_x.low) origin_ = {extremes_x.low, extremes_y.low};
  extents_ = {std::max(extremes_x.high - extremes_x.low, 0.0), std::max(extremes_y.high - extremes_y.low, 0.0)};
  to_eye_ = {rotation.sine * elevation.cosine, -rotation.cosine * elevation.cosine, elevation.sine};
  for_each(grid, [&](std::size_t vertex, double x, double y) {
    if (std::abs(y) < farthest) {
      vertices_[vertex] = {static_cast<float>(fit_x.place(x) - 0.5), static_cast<float>(fit_y.place(y))};
    } else {
      vertices_[vertex] = {0, std::numeric_limits<float>::quiet_NaN()};
      whole_ = false;
    }
  });
}

std::array<double, 2> Surface::project(double x, double z, double height) const {
  return {x * across_[0] + z * across_[1], x * up_[0] + z * up_[1] + height * up_[2]};
}

Vertex Surface::place(double x, double z, double height) const {
  const auto [across, up] = project(x, z, height);
  return {static_cast<float>((across - from_[0]) * scale_[0] + shift_[0] - 0.5),
          static_cast<float>((up - from_[1]) * scale_[1] + shift_[1])};
}

double Surface::normalised_height(double height) const {
  const double half = range_.high / 2 - range_.low / 2;
  if (!(half > 0) || !std::isfinite(1 / half)) return 0;
  return (height - (range_.high / 2 + range_.low / 2)) / half;
}

std::array<double, 3> Surface::to_eye() const {
  return to_eye_;
}

}  // namespace sightline::algorithms::skala
