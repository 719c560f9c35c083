// See heights.hpp.
#include "host/compare/heights.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/algorithms/oracle/column_oracle.hpp"
#include "host/algorithms/skala/draw.hpp"
#include "host/compare/height_cells.hpp"
#include "host/compare/height_lines.hpp"
#include "host/compare/view_chains.hpp"
#include "host/guests/skala/guest.hpp"
#include "host/guests/skala/program.hpp"
#include "host/guests/skala/stream.hpp"
#include "host/guests/skala/twin/twin.hpp"

namespace sightline::compare {
namespace {

using algorithms::oracle::Chain;
using algorithms::oracle::SegmentRole;
using picture::PixelGrid;
using picture::PixelSegment;

std::vector<Chain> chains_of(const scene::HeightGrid& grid, const guests::skala::View& view,
                             const ViewChains& chains) {
  if (view.picture == guests::skala::PictureKind::contours) return chains.contours(grid, view.levels);
  if (view.picture == guests::skala::PictureKind::surface)
    return chains.slices(SegmentRole::shade, SegmentRole::rim);
  if (view.family == guests::skala::Family::both) return chains.cells();
  return chains.slices(SegmentRole::draw, SegmentRole::draw);
}

// With the polygon around all that hides, which Skala's contour pictures have, or without.
PixelGrid oracle_raster(const scene::HeightGrid& grid, const guests::skala::View& view, bool outline) {
  const guests::skala::Projection projection(grid, view);
  const ViewChains chains(projection);
  const bool contours = view.picture == guests::skala::PictureKind::contours;
  const bool by_cells = contours || view.family == guests::skala::Family::both;
  const auto seen = algorithms::oracle::column_picture(
      chains_of(grid, view, chains), by_cells ? chains.cell_tolerance() : chains.slice_tolerance());
  PixelGrid raster(guests::skala::raster_side, guests::skala::raster_side);
  for (int x = 0; x < guests::skala::raster_side; ++x) {
    auto lit = seen.lit[static_cast<std::size_t>(x)];
    if (outline) lit |= seen.outline[static_cast<std::size_t>(x)];
    for (int y = 0; y < guests::skala::raster_side; ++y)
      raster.set(x, y, lit[static_cast<std::size_t>(y)] ? 1 : 0);
  }
  return raster;
}

PixelGrid lit_points(const core::Raster& raster) {
  PixelGrid grid(guests::skala::raster_side, guests::skala::raster_side);
  for (std::size_t i = 0; i < grid.values.size(); ++i) grid.values[i] = raster.points()[i] != 0 ? 1 : 0;
  return grid;
}

// One point a column, or a row if it is steep: the nearest to the line.
void put_line(PixelGrid& grid, picture::DrawingPoint from, picture::DrawingPoint to) {
  const bool steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
  picture::PixelPoint a{steep ? from.y : from.x, steep ? from.x : from.y};
  picture::PixelPoint b{steep ? to.y : to.x, steep ? to.x : to.y};
  if (a.x > b.x) std::swap(a, b);
  const auto nearest = [](double value) { return static_cast<int>(std::floor(value + 0.5)); };
  for (int along = nearest(a.x); along <= nearest(b.x); ++along) {
    const double place = b.x > a.x ? std::clamp((along - a.x) / (b.x - a.x), 0.0, 1.0) : 0;
    const int across = nearest(a.y + place * (b.y - a.y));
    const int x = std::clamp(steep ? across : along, 0, guests::skala::raster_side - 1);
    const int y = std::clamp(steep ? along : across, 0, guests::skala::raster_side - 1);
    grid.set(x, y, 1);
  }
}

picture::VectorDrawing native_drawing(const scene::HeightGrid& heights, const guests::skala::View& view) {
  algorithms::skala::View native;
  constexpr std::array subjects{algorithms::skala::Subject::lines, algorithms::skala::Subject::surface,
                                algorithms::skala::Subject::contours};
  native.subject = subjects[static_cast<std::size_t>(view.picture)];
  native.rotation = view.rotation;
  native.elevation = view.elevation;
  native.visibility = view.visibility;
  native.levels = view.levels;
  constexpr std::array families{algorithms::skala::Family::along_x, algorithms::skala::Family::along_z,
                                algorithms::skala::Family::both, algorithms::skala::Family::automatic};
  native.family = families[static_cast<std::size_t>(view.family)];
  return algorithms::skala::draw(heights, native);
}

PixelGrid raster_of_lines(const picture::VectorDrawing& drawing) {
  PixelGrid grid(guests::skala::raster_side, guests::skala::raster_side);
  for (const picture::DrawingLine& line : drawing.lines) {
    for (std::uint32_t i = 0; i + 1 < std::max(line.count, 2U); ++i)
      put_line(grid, drawing.points[line.first + i],
               drawing.points[line.first + std::min(i + 1, line.count - 1)]);
  }
  return grid;
}

PixelGrid lit_where_painted(PixelGrid cells) {
  for (std::uint32_t& value : cells.values) value = value != 0 ? 1 : 0;
  return cells;
}

// All sides of all cells, hidden or not.
std::vector<PixelSegment> projected_edges(const scene::HeightGrid& grid, const guests::skala::View& view) {
  const guests::skala::Projection projection(grid, view);
  const auto at = [&](std::size_t point, std::size_t slice) {
    const guests::skala::Vertex& vertex = projection.at(point, slice);
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

guests::skala::View comparable(guests::skala::View view) {
  view.device = guests::skala::Device::ef9365;
  return view;
}

// Contours without silhouettes: a colour of 0 is none.
std::vector<std::uint8_t> board_stream(const scene::HeightGrid& grid, const guests::skala::View& view) {
  constexpr std::size_t colour_of_silhouette = 4;
  auto stream = guests::skala::stream_of(grid, view);
  if (view.picture == guests::skala::PictureKind::contours) stream.at(colour_of_silhouette) = 0;
  return stream;
}

}  // namespace

std::optional<std::string> why_not_comparable(const scene::HeightGrid& grid,
                                              const guests::skala::View& view) {
  if (view.zoom != 1) return "the column oracle knows pictures without zoom only";
  if (!view.visibility) return "without the visibility test there is nothing to compare";
  if (grid.points() < 2 || grid.slices() < 2) return "the column oracle needs a grid of at least two by two";
  if (std::any_of(grid.heights.begin(), grid.heights.end(), [](double h) { return !std::isfinite(h); }))
    return "the column oracle knows grids without undefined heights only";
  const guests::skala::SineCosine turn = guests::skala::sine_and_cosine(view.rotation);
  const bool x_is_less_end_on = std::abs(turn.cosine) >= std::abs(turn.sine);
  const guests::skala::Family end_on =
      x_is_less_end_on ? guests::skala::Family::along_z : guests::skala::Family::along_x;
  if (view.picture != guests::skala::PictureKind::contours && view.family == end_on)
    return "the column oracle draws the family that is less end-on";
  return std::nullopt;
}

HeightComparison compare_heights(const scene::HeightGrid& grid, const guests::skala::View& asked,
                                 const std::function<void(std::string_view)>& progress) {
  HeightComparison comparison;
  const guests::skala::View view = comparison.view = comparable(asked);
  progress("column oracle");
  comparison.truth = oracle_raster(grid, view, view.picture == guests::skala::PictureKind::contours);
  const auto edges = projected_edges(grid, view);
  const auto add = [&](const char* name, PixelGrid raster) {
    const auto metrics = picture::pixel_metrics(comparison.truth, raster, edges);
    comparison.rasters.push_back({name, metrics, std::move(raster)});
  };
  const auto stream = board_stream(grid, view);
  progress("guest");
  const guests::skala::GuestPicture guest =
      guests::skala::run_guest(guests::skala::assemble_program(), stream);
  comparison.guest_time = guest.drawing;
  add("guest", lit_points(guest.raster));
  progress("twin");
  const guests::skala::TwinPicture twin = guests::skala::run_twin(stream);
  comparison.guest_difference = guests::skala::difference_from_twin(guest, twin, view.device);
  add("twin", lit_points(twin.raster(view.device)));
  progress("native");
  const picture::VectorDrawing native = native_drawing(grid, view);
  if (view.picture == guests::skala::PictureKind::surface) {
    PixelGrid cells = painted_cells(grid, view, native);
    add("native", lit_where_painted(cells));
    PixelGrid truth = nearest_cells(grid, view);
    const auto metrics = picture::pixel_metrics(truth, cells, edges);
    comparison.rasters.push_back(
        {"native cells", metrics, std::move(cells), std::move(truth), "the nearest cells"});
    return comparison;
  }
  PixelGrid raster = raster_of_lines(native);
  if (view.picture == guests::skala::PictureKind::contours) {
    PixelGrid truth = oracle_raster(grid, view, false);
    const auto metrics = picture::pixel_metrics(truth, raster, edges);
    comparison.rasters.push_back(
        {"native", metrics, std::move(raster), std::move(truth), "the column oracle, without the outline"});
  } else {
    add("native", std::move(raster));
  }
  const HeightLines lines(grid, view);
  const auto pieces = lines.pieces_of(native);
  comparison.vectors = {"native lines", picture::line_metrics(lines.lines(), pieces),
                        picture::line_difference(lines.lines(), pieces, 1)};
  return comparison;
}

}  // namespace sightline::compare
