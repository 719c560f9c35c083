#include "host/picture/light_spread.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host/picture/repeatable_math.hpp"
#include "host/picture/stroke_recorders.hpp"

namespace sightline::picture {

namespace {

constexpr double reach_sigmas = 4.0;  // 6e-5 of a Gaussian is beyond
constexpr int cell_points = 4;
constexpr int cell_padding = 16;  // cells around the lattice: the widest margin, 64 points
constexpr int cells_a_side = screen_points / cell_points + 2 * cell_padding;

// Integral of e^(-x^2 / 2 sigma^2) over one pixel around x, by Simpson's rule.
double light_on_pixel(double middle, double sigma) {
  constexpr int intervals = 16;
  double sum = 0.0;
  for (int i = 0; i <= intervals; ++i) {
    const double z = (middle - 0.5 + static_cast<double>(i) / intervals) / sigma;
    const double weight = i == 0 || i == intervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * decay(0.5 * z * z);
  }
  return sum;
}

std::size_t cell_index(int column, int row) {
  return static_cast<std::size_t>(row) * cells_a_side + static_cast<std::size_t>(column);
}

// Both passes of the blur. Light that would leave the grid is dropped.
std::vector<double> blur(const std::vector<double>& cells, const SpotProfile& profile) {
  std::vector<double> across(cells.size());
  std::vector<double> both(cells.size());
  const int reach = static_cast<int>(profile.weights.size());
  for (int row = 0; row < cells_a_side; ++row) {
    for (int column = 0; column < cells_a_side; ++column) {
      const double light = cells[cell_index(column, row)];
      if (light == 0.0) continue;
      for (int i = 0; i < reach; ++i) {
        const int to = column + profile.first + i;
        if (to < 0 || to >= cells_a_side) continue;
        across[cell_index(to, row)] += light * profile.weights[static_cast<std::size_t>(i)];
      }
    }
  }
  for (int row = 0; row < cells_a_side; ++row) {
    for (int i = 0; i < reach; ++i) {
      const int to = row + profile.first + i;
      if (to < 0 || to >= cells_a_side) continue;
      const double weight = profile.weights[static_cast<std::size_t>(i)];
      for (int column = 0; column < cells_a_side; ++column) {
        both[cell_index(column, to)] += across[cell_index(column, row)] * weight;
      }
    }
  }
  return both;
}

// The position of a pixel's middle between the middles of two cells.
struct Between {
  int cell;      // the lower one
  double share;  // weight of the upper one
};

Between between_cells(int pixel, FilmSize size) {
  const double point = (pixel + 0.5) / size.pixels_per_point - size.margin_points;
  const double cell = point / cell_points + cell_padding - 0.5;
  const int lower = std::clamp(static_cast<int>(std::floor(cell)), 0, cells_a_side - 2);
  return {lower, std::clamp(cell - lower, 0.0, 1.0)};
}

}  // namespace

int FilmSize::pixels() const {
  return (screen_points + 2 * margin_points) * pixels_per_point;
}

SpotProfile spot_profile(double sigma, int pixels_per_point) {
  const double in_pixels = sigma * pixels_per_point;
  const int reach = static_cast<int>(std::ceil(reach_sigmas * in_pixels));
  SpotProfile profile{-reach, {}};
  double sum = 0.0;
  for (int pixel = -reach; pixel < reach + pixels_per_point; ++pixel) {
    profile.weights.push_back(light_on_pixel(pixel + 0.5 - 0.5 * pixels_per_point, in_pixels));
    sum += profile.weights.back();
  }
  for (double& weight : profile.weights) weight /= sum;
  return profile;
}

void spread_spots(std::span<const std::uint64_t> sums, double scale, const SpotProfile& profile,
                  FilmSize size, std::vector<float>& film) {
  const int side = size.pixels();
  const int reach = static_cast<int>(profile.weights.size());
  std::vector<double> across(static_cast<std::size_t>(side));
  for (int y = 0; y < screen_points; ++y) {
    const auto row = sums.subspan(static_cast<std::size_t>(y) * screen_points, screen_points);
    if (std::all_of(row.begin(), row.end(), [](std::uint64_t sum) { return sum == 0; })) continue;
    std::fill(across.begin(), across.end(), 0.0);
    for (int x = 0; x < screen_points; ++x) {
      const std::uint64_t sum = row[static_cast<std::size_t>(x)];
      if (sum == 0) continue;
      const double light = static_cast<double>(sum) * scale;
      const int left = (x + size.margin_points) * size.pixels_per_point + profile.first;
      for (int i = std::max(0, -left); i < reach && left + i < side; ++i) {
        across[static_cast<std::size_t>(left + i)] += light * profile.weights[static_cast<std::size_t>(i)];
      }
    }
    const int top = (screen_points - 1 - y + size.margin_points) * size.pixels_per_point + profile.first;
    for (int i = std::max(0, -top); i < reach && top + i < side; ++i) {
      const double weight = profile.weights[static_cast<std::size_t>(i)];
      float* const out = film.data() + static_cast<std::size_t>(top + i) * static_cast<std::size_t>(side);
      for (std::size_t column = 0; column < across.size(); ++column) {
        out[column] += static_cast<float>(across[column] * weight);
      }
    }
  }
}

Halo::Halo() : cells_(cell_index(0, cells_a_side)) {}

void Halo::add(std::span<const std::uint64_t> sums, double scale) {
  for (int y = 0; y < screen_points; ++y) {
    const int row = (screen_points - 1 - y) / cell_points + cell_padding;
    for (int x = 0; x < screen_points; ++x) {
      const std::uint64_t sum =
          sums[static_cast<std::size_t>(y) * screen_points + static_cast<std::size_t>(x)];
      if (sum != 0)
        cells_[cell_index(x / cell_points + cell_padding, row)] += static_cast<double>(sum) * scale;
    }
  }
}

void Halo::spread(double sigma, FilmSize size, std::vector<float>& film) const {
  const auto halo = blur(cells_, spot_profile(sigma / cell_points, 1));
  const int side = size.pixels();
  const double pixels_a_cell = cell_points * size.pixels_per_point;
  const double a_pixel = 1.0 / (pixels_a_cell * pixels_a_cell);
  for (int row = 0; row < side; ++row) {
    const Between down = between_cells(row, size);
    for (int column = 0; column < side; ++column) {
      const Between over = between_cells(column, size);
      const std::size_t corner = cell_index(over.cell, down.cell);
      const double upper = halo[corner] + (halo[corner + 1] - halo[corner]) * over.share;
      const double lower = halo[corner + cells_a_side] +
                           (halo[corner + cells_a_side + 1] - halo[corner + cells_a_side]) * over.share;
      film[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
           static_cast<std::size_t>(column)] +=
          static_cast<float>((upper + (lower - upper) * down.share) * a_pixel);
    }
  }
}

}  // namespace sightline::picture
