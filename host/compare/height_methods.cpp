#include "host/compare/height_methods.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "host/algorithms/oracle/column_oracle.hpp"
#include "host/algorithms/skala/draw.hpp"
#include "host/compare/view_chains.hpp"
#include "host/programs/skala/skala.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/programs/skala/twin/twin.hpp"

namespace sightline::compare {

namespace {

namespace native = algorithms::skala;
namespace skala = programs::skala;
using algorithms::oracle::Chain;
using algorithms::oracle::SegmentRole;
using picture::PixelGrid;
using algorithms::skala::View;
using scene::HeightGrid;

// --- the programs

PixelGrid lit_points(const core::Raster& raster) {
  PixelGrid grid(skala::raster_side, skala::raster_side);
  for (std::size_t i = 0; i < grid.values.size(); ++i) grid.values[i] = raster.points()[i] != 0 ? 1 : 0;
  return grid;
}

std::optional<std::string> any_grid(const HeightGrid&, const View&) {
  return std::nullopt;
}

HeightPicture draw_on_machine(const HeightGrid& grid, const View& view) {
  const auto run = skala::run({.grid = grid, .view = view, .check = true});
  HeightPicture picture;
  picture.drawing_time = core::TStates{};
  if (!run) {
    picture.dots = PixelGrid(skala::raster_side, skala::raster_side);
    picture.fault = run.error().message();
    return picture;
  }
  picture.dots = lit_points(run->picture.raster);
  picture.drawing_time = run->picture.drawing;
  return picture;
}

HeightPicture draw_twin(const HeightGrid& grid, const View& view) {
  const skala::TwinPicture twin = skala::run_twin(skala::stream_of(grid, view));
  HeightPicture picture;
  picture.dots = lit_points(twin.raster(skala::Device::ef9365));
  if (twin.status != skala::Status::complete) picture.fault = "stops: " + std::string(text_of(twin.status));
  return picture;
}

// --- the native algorithm

std::optional<std::string> why_no_native(const HeightGrid&, const View& view) {
  if (view.zoom != 1) return "it has no zoom, because its drawings can have any size";
  return std::nullopt;
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
    const int x = std::clamp(steep ? across : along, 0, skala::raster_side - 1);
    const int y = std::clamp(steep ? along : across, 0, skala::raster_side - 1);
    grid.set(x, y, 1);
  }
}

PixelGrid raster_of_lines(const picture::VectorDrawing& drawing) {
  PixelGrid grid(skala::raster_side, skala::raster_side);
  for (const picture::DrawingLine& line : drawing.lines) {
    for (std::uint32_t i = 0; i + 1 < std::max(line.count, 2U); ++i)
      put_line(grid, drawing.points[line.first + i],
               drawing.points[line.first + std::min(i + 1, line.count - 1)]);
  }
  return grid;
}

HeightPicture draw_native(const HeightGrid& grid, const View& view) {
  HeightPicture picture;
  picture.drawing = native::draw(grid, view);
  if (view.subject != native::Subject::surface) picture.dots = raster_of_lines(*picture.drawing);
  return picture;
}

// --- the oracle

std::optional<std::string> why_no_oracle(const HeightGrid& grid, const View& view) {
  if (view.zoom != 1) return "the column oracle knows pictures without zoom only";
  if (!view.visibility) return "without the visibility test there is nothing to compare";
  if (grid.points() < 2 || grid.slices() < 2) return "the column oracle needs a grid of at least two by two";
  if (std::any_of(grid.heights.begin(), grid.heights.end(), [](double h) { return !std::isfinite(h); }))
    return "the column oracle knows grids without undefined heights only";
  const skala::SineCosine turn = skala::sine_and_cosine(view.rotation);
  const bool x_is_less_end_on = std::abs(turn.cosine) >= std::abs(turn.sine);
  const native::Family end_on = x_is_less_end_on ? native::Family::along_z : native::Family::along_x;
  if (view.subject != native::Subject::contours && view.family == end_on)
    return "the column oracle draws the family that is less end-on";
  return std::nullopt;
}

std::vector<Chain> chains_of(const HeightGrid& grid, const View& view, const ViewChains& chains) {
  if (view.subject == native::Subject::contours) return chains.contours(grid, view.levels);
  if (view.subject == native::Subject::surface) return chains.slices(SegmentRole::shade, SegmentRole::rim);
  if (view.family == native::Family::both) return chains.cells();
  return chains.slices(SegmentRole::draw, SegmentRole::draw);
}

HeightPicture draw_oracle(const HeightGrid& grid, const View& view) {
  HeightPicture picture;
  picture.dots = oracle_dots(grid, view, view.subject == native::Subject::contours);
  return picture;
}

constexpr std::array rows{
    HeightMethod{"guest", "Skala's program (1985) on the emulated 8080 with its raster board", any_grid,
                 draw_on_machine},
    HeightMethod{"twin", "The same program in C++, dot for dot", any_grid, draw_twin},
    HeightMethod{"native", "Skala's masks as a modern algorithm: vectors on masks finer than a dot",
                 why_no_native, draw_native},
    HeightMethod{"oracle", "What depth alone lets be seen in each column: what the others are checked by",
                 why_no_oracle, draw_oracle},
};

}  // namespace

PixelGrid oracle_dots(const HeightGrid& grid, const View& view, bool outline) {
  const skala::Projection projection(grid, view);
  const ViewChains chains(projection);
  const bool by_cells = view.subject == native::Subject::contours || view.family == native::Family::both;
  const auto seen = algorithms::oracle::column_picture(
      chains_of(grid, view, chains), by_cells ? chains.cell_tolerance() : chains.slice_tolerance());
  PixelGrid raster(skala::raster_side, skala::raster_side);
  for (int x = 0; x < skala::raster_side; ++x) {
    auto lit = seen.lit[static_cast<std::size_t>(x)];
    if (outline) lit |= seen.outline[static_cast<std::size_t>(x)];
    for (int y = 0; y < skala::raster_side; ++y) raster.set(x, y, lit[static_cast<std::size_t>(y)] ? 1 : 0);
  }
  return raster;
}

std::span<const HeightMethod> height_methods() {
  return rows;
}

const HeightMethod* find_height_method(std::string_view name) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [name](const HeightMethod& method) { return method.name == name; });
  return found != rows.end() ? &*found : nullptr;
}

}  // namespace sightline::compare
