// See skala_8080.hpp.
#include "host/compare/skala_8080.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "host/compare/device_raster.hpp"
#include "host/compare/height_truth.hpp"
#include "host/programs/skala/projection.hpp"
#include "host/programs/skala/skala.hpp"
#include "host/picture/dots_and_lines.hpp"

namespace sightline::compare {
namespace {

namespace skala = programs::skala;
using picture::PixelPoint;
using picture::PixelSegment;

constexpr std::array ink_devices{skala::Device::ef9365, skala::Device::alt256, skala::Device::calcomp, skala::Device::minigraf};
constexpr std::array<std::string_view, 4> ink_device_names{"EF9365", "ALT-256", "CalComp 565", "Minigraf"};
constexpr std::array<std::string_view, 3> ink_kind_names{"lines", "surface", "contours"};

std::vector<PixelSegment> ink_of(const std::vector<picture::PenPath>& paths) {
  std::vector<PixelSegment> ink;
  for (const picture::PenPath& path : paths) {
    const auto place = [&](std::size_t i) {
      return PixelPoint{static_cast<double>(path.corners[i].x), static_cast<double>(path.corners[i].y)};
    };
    for (std::size_t i = 0; i + 1 < path.corners.size(); ++i) ink.push_back({place(i), place(i + 1)});
  }
  return ink;
}

// The highest and the lowest points of the surface, column by column.
std::vector<PixelSegment> outline_of(const skala::Projection& projection) {
  std::vector<PixelSegment> sides;
  const auto place = [&](std::size_t point, std::size_t slice) {
    const skala::Vertex& vertex = projection.at(point, slice);
    return PixelPoint{vertex.x, vertex.y};
  };
  const bool rising = rising_diagonals(projection.rotation());
  std::vector<double> columns;
  constexpr int parts = 16;  // per dot
  for (int i = 0; i <= 255 * parts; ++i) columns.push_back(static_cast<double>(i) / parts);
  for (std::size_t slice = 0; slice < projection.slices(); ++slice) {
    for (std::size_t point = 0; point < projection.points(); ++point) {
      columns.push_back(place(point, slice).x);
      const bool beside = point + 1 < projection.points();
      const bool behind = slice + 1 < projection.slices();
      if (beside) sides.push_back({place(point, slice), place(point + 1, slice)});
      if (behind) sides.push_back({place(point, slice), place(point, slice + 1)});
      if (beside && behind)
        sides.push_back({place(rising ? point : point + 1, slice), place(rising ? point + 1 : point, slice + 1)});
    }
  }
  std::sort(columns.begin(), columns.end());
  std::vector<double> top(columns.size(), -std::numeric_limits<double>::infinity());
  std::vector<double> bottom(columns.size(), std::numeric_limits<double>::infinity());
  for (const auto& [a, b] : sides) {
    const auto& [left, right] = a.x <= b.x ? std::pair{a, b} : std::pair{b, a};
    for (auto at = std::lower_bound(columns.begin(), columns.end(), left.x); at != columns.end() && *at <= right.x; ++at) {
      const double y = right.x > left.x ? left.y + (right.y - left.y) * (*at - left.x) / (right.x - left.x) : left.y;
      const auto i = static_cast<std::size_t>(at - columns.begin());
      top[i] = std::max(top[i], y);
      bottom[i] = std::min(bottom[i], y);
    }
  }
  std::vector<PixelSegment> outline;
  for (std::size_t i = 0; i + 1 < columns.size(); ++i)
    for (const std::vector<double>* side : {&top, &bottom})
      if (std::isfinite((*side)[i]) && std::isfinite((*side)[i + 1]))
        outline.push_back({{columns[i], (*side)[i]}, {columns[i + 1], (*side)[i + 1]}});
  return outline;
}

}  // namespace

std::string name_of(const SkalaInk& ink) {
  return fmt::format("{}, {}", ink_kind_names.at(static_cast<std::size_t>(ink.kind)),
                     ink_device_names.at(static_cast<std::size_t>(ink.device)));
}

bool shows_lines(const SkalaInk& ink) {
  return ink.kind != skala::Subject::surface || !skala::is_raster(ink.device);
}

std::vector<SkalaInk> skala_pictures(const scene::HeightGrid& grid, const skala::View& asked) {
  std::vector<SkalaInk> pictures;
  for (const skala::Subject kind : {skala::Subject::lines, skala::Subject::surface, skala::Subject::contours}) {
    for (const skala::Device device : ink_devices) {
      skala::View view = asked;
      view.subject = kind;
      view.silhouette = false;
      const auto run = skala::run({.grid = grid, .view = view, .device = device, .check = true});
      SkalaInk& made = pictures.emplace_back(SkalaInk{kind, device, {}, {}, run ? "" : run.error().message()});
      if (!run) continue;
      const auto paths = skala::pen_paths(run->picture.moves);
      made.dots = skala::is_raster(device) ? points_of(run->picture.raster) : points_of(paths);
      made.ink = skala::is_raster(device) ? picture::dot_segments(made.dots) : ink_of(paths);
    }
  }
  return pictures;
}

std::vector<PixelSegment> unrounded_ink(const scene::HeightGrid& grid, skala::View view, skala::Subject kind) {
  view.subject = kind;
  const HeightLines lines(grid, view);
  if (kind != skala::Subject::contours) return visible_segments(lines.lines());
  std::vector<PixelSegment> ink = outline_of(skala::Projection(grid, view));
  for (const picture::ReferenceLine& line : lines.lines()) ink.push_back(line.image);
  return ink;
}

InkBounds ink_bounds(const SkalaInk& ink) {
  constexpr double of_outline = 2;
  if (!shows_lines(ink)) return {of_outline, std::hypot(1, 1.5)};
  if (ink.kind == skala::Subject::contours) return {of_outline, std::nullopt};
  return {std::numbers::sqrt2, std::hypot(1.5, 3) + (skala::is_raster(ink.device) ? 0 : std::numbers::sqrt2)};
}

}  // namespace sightline::compare
