// See height_devices.hpp.
#include "host/compare/height_devices.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "host/compare/height_methods.hpp"
#include "host/compare/device_raster.hpp"
#include "host/compare/height_truth.hpp"
#include "host/programs/skala/projection.hpp"
#include "host/programs/skala/skala.hpp"

namespace sightline::compare {
namespace {

namespace skala = programs::skala;
using picture::PixelGrid;

constexpr std::array<std::pair<skala::Device, std::string_view>, 4> devices{{{skala::Device::ef9365, "ef9365"},
                                                                             {skala::Device::alt256, "alt256"},
                                                                             {skala::Device::calcomp, "calcomp"},
                                                                             {skala::Device::minigraf, "minigraf"}}};

}  // namespace

std::vector<ComparedDevice> compare_devices(const scene::HeightGrid& grid, const skala::View& view,
                                            const std::function<void(std::string_view)>& progress, bool ef9365_alone) {
  const HeightLines lines(grid, view);
  const auto seen = visible_segments(lines.lines());
  PixelGrid outline(skala::raster_side, skala::raster_side);
  if (view.subject == skala::Subject::contours) {
    const PixelGrid with = oracle_dots(grid, view, true);
    const PixelGrid without = oracle_dots(grid, view, false);
    for (std::size_t i = 0; i < outline.values.size(); ++i)
      outline.values[i] = with.values[i] != 0 && without.values[i] == 0 ? 1 : 0;
  }
  std::vector<ComparedDevice> compared;
  for (const auto& [device, name] : devices) {
    if (ef9365_alone && device != skala::Device::ef9365) continue;
    progress(name);
    const auto run = skala::run({.grid = grid, .view = view, .device = device, .check = true});
    ComparedDevice row{device, name, run ? "" : run.error().message(), {}, {}, {}, {}, {}};
    const bool board = skala::is_raster(device);
    row.dots = PixelGrid(skala::raster_side, skala::raster_side);
    if (run) {
      row.time = run->picture.drawing;
      row.dots = board ? points_of(run->picture.raster) : points_of(skala::pen_paths(run->picture.moves), skala::raster_side);
    }
    for (std::size_t i = 0; i < outline.values.size(); ++i)
      if (outline.values[i] != 0) row.dots.values[i] = 0;
    const bool filled = board && view.subject == skala::Subject::surface;
    row.truth = filled ? nearest_cells(grid, view)
                       : skala_points(lines.lines(), board ? SkalaDevice::raster : SkalaDevice::plotter);
    // All boards show the same dots, and so do all plotters.
    const auto same = std::find_if(compared.begin(), compared.end(), [&](const ComparedDevice& other) {
      return other.dots == row.dots && other.truth == row.truth;
    });
    if (same != compared.end()) {
      row.raster = same->raster;
      row.unrounded = same->unrounded;
    } else {
      row.raster = picture::raster_difference(row.truth, row.dots);
      if (!filled) row.unrounded = picture::dots_and_lines(row.dots, seen);
    }
    compared.push_back(std::move(row));
  }
  return compared;
}

}  // namespace sightline::compare
