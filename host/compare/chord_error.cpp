// See chord_error.hpp.
#include "host/compare/chord_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "host/programs/skala/projection.hpp"
#include "host/picture/line_metrics_parts.hpp"

namespace sightline::compare {
namespace {

constexpr std::size_t densely = 16;
constexpr std::size_t least_dense = 4;

// As many times as densely as the largest grid allows.
std::size_t density(std::size_t samples, std::size_t largest) {
  return std::min(densely, (largest - 1) / (samples - 1));
}

// The height on the screen, in points, of one unit of height in this view; the grid's range is 2 units.
double points_of_unit_height(const scene::HeightGrid& grid, const algorithms::skala::View& view,
                             const programs::skala::Projection& projection) {
  // Screen y is a linear function of 0.6 h cos E + depth sin E; its scale follows from the lowest and the highest
  // sample.
  const auto elevation = programs::skala::sine_and_cosine(view.elevation);
  std::array<double, 2> screen{};
  std::array<double, 2> image{};
  bool first = true;
  for (std::size_t slice = 0; slice < projection.slices(); ++slice) {
    for (std::size_t point = 0; point < projection.points(); ++point) {
      const programs::skala::Vertex& vertex = projection.at(point, slice);
      const double h = programs::skala::normalised_height(grid, grid.height(point, slice));
      const double y = 0.6 * h * elevation.cosine + vertex.depth * elevation.sine;
      if (first || vertex.y < screen[0]) std::tie(screen[0], image[0]) = std::pair{vertex.y, y};
      if (first || vertex.y > screen[1]) std::tie(screen[1], image[1]) = std::pair{vertex.y, y};
      first = false;
    }
  }
  return image[1] > image[0] ? (screen[1] - screen[0]) / (image[1] - image[0]) * 0.6 * elevation.cosine : 0;
}

}  // namespace

std::optional<ChordError> chord_error(const HeightLines& lines, const scene::HeightGrid& grid,
                                      const algorithms::skala::View& view, const HeightSampler& sampler) {
  if (!sampler || grid.points() < 2 || grid.slices() < 2) return std::nullopt;
  const std::size_t across = density(grid.points(), scene::largest_grid.points);
  const std::size_t deep = density(grid.slices(), scene::largest_grid.slices);
  if (std::min(across, deep) < least_dense) return std::nullopt;
  const scene::HeightGrid along_x = sampler({(grid.points() - 1) * across + 1, grid.slices()});
  const scene::HeightGrid along_z = sampler({grid.points(), (grid.slices() - 1) * deep + 1});
  const programs::skala::Projection projection(grid, view);
  const double unit = points_of_unit_height(grid, view, projection);

  ChordError error{0, std::min(across, deep) - 1};
  for (std::size_t i = 0; i < lines.lines().size(); ++i) {
    const auto& side = lines.sides()[i];
    if (!side) continue;
    const picture::ReferenceLine& chord = lines.lines()[i];
    const auto& [from, to] = *side;
    const bool is_along_x = from.slice == to.slice;
    const auto height_of = [&](const programs::skala::GridIndex& at) {
      return programs::skala::normalised_height(grid, grid.height(at.point, at.slice));
    };
    const double low = height_of(from);
    const double high = height_of(to);
    const std::size_t parts = is_along_x ? across : deep;
    for (std::size_t part = 1; part < parts; ++part) {
      const double place = static_cast<double>(part) / static_cast<double>(parts);
      if (!picture::contains(chord.visible, place)) continue;
      const double height = programs::skala::normalised_height(
          grid, is_along_x ? along_x.height(from.point * across + part, from.slice)
                           : along_z.height(from.point, from.slice * deep + part));
      if (!std::isfinite(height)) continue;
      picture::PixelPoint point = picture::point_at(chord.image, place);
      point.y += (height - (low + place * (high - low))) * unit;
      error.greatest = std::max(error.greatest, picture::distance(point, chord.image));
    }
  }
  return error;
}

}  // namespace sightline::compare
