// See heights.hpp.
#include "host/compare/heights.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <utility>

#include "host/compare/height_methods.hpp"
#include "host/compare/device_raster.hpp"
#include "host/compare/height_truth.hpp"
#include "host/compare/host_time.hpp"
#include "host/compare/work_bounds.hpp"
#include "host/programs/skala/projection.hpp"

namespace sightline::compare {
namespace {

using picture::PixelGrid;
using picture::PixelSegment;

constexpr std::string_view oracle_method = "oracle";

PixelGrid lit_where_painted(PixelGrid cells) {
  for (std::uint32_t& value : cells.values) value = value != 0 ? 1 : 0;
  return cells;
}

// Removes dots that belong to the outline only, according to the oracle's pictures with and without it.
PixelGrid without_outline(PixelGrid dots, const PixelGrid& with, const PixelGrid& without) {
  for (std::size_t i = 0; i < dots.values.size(); ++i)
    if (with.values[i] != 0 && without.values[i] == 0) dots.values[i] = 0;
  return dots;
}

// All sides of all cells, hidden or not.
std::vector<PixelSegment> projected_edges(const scene::HeightGrid& grid, const algorithms::skala::View& view) {
  const programs::skala::Projection projection(grid, view);
  const auto at = [&](std::size_t point, std::size_t slice) {
    const programs::skala::Vertex& vertex = projection.at(point, slice);
    return picture::PixelPoint{vertex.x, vertex.y};
  };
  std::vector<PixelSegment> edges;
  for (std::size_t slice = 0; slice < projection.slices(); ++slice) {
    for (std::size_t point = 0; point < projection.points(); ++point) {
      if (point + 1 < projection.points()) edges.push_back({at(point, slice), at(point + 1, slice)});
      if (slice + 1 < projection.slices()) edges.push_back({at(point, slice), at(point, slice + 1)});
    }
  }
  return edges;
}

}  // namespace

std::optional<std::string> why_not_comparable(const scene::HeightGrid& grid,
                                              const algorithms::skala::View& view) {
  if (const std::size_t points = grid.points() * grid.slices(); points > most_grid_points)
    return fmt::format("found {} points of the grid, expected at most {}: computing the reference lines of more takes too long", points, most_grid_points);
  return find_height_method(oracle_method)->why_not(grid, view);
}

HeightComparison compare_heights(const scene::HeightGrid& grid, const algorithms::skala::View& asked,
                                 const std::function<void(std::string_view)>& progress, const HeightSampler& sampler, bool host_times) {
  HeightComparison comparison;
  comparison.view = asked;
  const algorithms::skala::View& view = comparison.view;
  progress("column oracle");
  const bool contours = view.subject == algorithms::skala::Subject::contours;
  comparison.truth = oracle_dots(grid, view, contours);
  const auto edges = projected_edges(grid, comparison.view);
  const auto add = [&](std::string_view name, PixelGrid raster) {
    const auto metrics = picture::pixel_metrics(comparison.truth, raster, edges);
    comparison.rasters.push_back({std::string(name), metrics, std::move(raster)});
  };
  const auto add_against = [&](const std::string& name, PixelGrid raster, PixelGrid truth,
                               const char* against) {
    const auto metrics = picture::pixel_metrics(truth, raster, edges);
    comparison.rasters.push_back({name, metrics, std::move(raster), std::move(truth), against});
  };
  const bool surface = view.subject == algorithms::skala::Subject::surface;
  std::optional<HeightLines> lines;
  if (!surface) lines.emplace(grid, comparison.view);
  const auto add_drawing = [&](const std::string& name, HeightPicture drawn) {
    if (surface) {
      PixelGrid cells = painted_cells(grid, comparison.view, *drawn.drawing);
      comparison.native_dots = lit_where_painted(cells);
      add(name, comparison.native_dots);
      add_against(name + " cells", std::move(cells), nearest_cells(grid, comparison.view),
                  "the nearest cells");
      return;
    }
    if (contours)
      add_against(name, std::move(drawn.dots), oracle_dots(grid, view, false),
                  "the column oracle, without the outline");
    else
      add(name, std::move(drawn.dots));
    const auto pieces = lines->pieces_of(*drawn.drawing);
    comparison.native_dots = skala_points(lines_as_drawn(lines->lines(), pieces));
    comparison.vectors.push_back({name + " lines", picture::line_metrics(lines->lines(), pieces),
                                  picture::line_difference(lines->lines(), pieces, 1)});
  };
  for (const HeightMethod& method : height_methods()) {
    if (method.name == oracle_method || method.why_not(grid, view)) continue;
    progress(method.name);
    HeightPicture drawn = method.draw(grid, view);
    if (drawn.drawing) {
      if (host_times) comparison.native_seconds = median_seconds([&] { static_cast<void>(method.draw(grid, view)); });
      add_drawing(std::string(method.name), std::move(drawn));
      continue;
    }
    if (drawn.drawing_time) {
      comparison.guest_time = *drawn.drawing_time;
      comparison.guest_difference = std::move(drawn.fault);
    }
    add(method.name, std::move(drawn.dots));
  }
  progress("unrounded lines");
  const std::vector<PixelSegment> seen = surface ? std::vector<PixelSegment>{} : visible_segments(lines->lines());
  const PixelGrid without = contours ? oracle_dots(grid, view, false) : comparison.truth;
  for (ComparedRaster& row : comparison.rasters) {
    const bool program = row.name == "guest" || row.name == "twin";
    row.rounding = program ? "ends of lines to the nearest dot, then a dot a step" : "to the nearest dots, to be compared";
    if (row.truth && !contours) continue;  // its numbers are those of cells
    if (row.name == "twin" && row.grid == comparison.rasters.front().grid) {
      row.unrounded = comparison.rasters.front().unrounded;
      row.from_native = comparison.rasters.front().from_native;
      continue;
    }
    const PixelGrid dots = program && contours ? without_outline(row.grid, comparison.truth, without) : row.grid;
    if (!surface) row.unrounded = picture::dots_and_lines(dots, seen);
    if (program) row.from_native = picture::raster_difference(comparison.native_dots, dots);
  }
  if (view.subject == algorithms::skala::Subject::lines) comparison.chord = chord_error(*lines, grid, comparison.view, sampler);
  return comparison;
}

}  // namespace sightline::compare
