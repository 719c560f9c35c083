// See height_devices.hpp.
#include "host/compare/height_devices.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "host/algorithms/registry/heights.hpp"
#include "host/compare/device_raster.hpp"
#include "host/compare/height_truth.hpp"
#include "host/programs/skala/session.hpp"
#include "host/programs/skala/stream.hpp"

namespace sightline::compare {
namespace {

namespace skala = programs::skala;
using picture::PixelGrid;

constexpr std::array<std::pair<skala::Device, std::string_view>, 4> devices{{{skala::Device::ef9365, "ef9365"},
                                                                             {skala::Device::alt256, "alt256"},
                                                                             {skala::Device::calcomp, "calcomp"},
                                                                             {skala::Device::minigraf, "minigraf"}}};

// As registry::height_methods() has the program: of contours no silhouettes.
std::vector<std::uint8_t> stream_without_silhouettes(const scene::HeightGrid& grid, const skala::View& view) {
  constexpr std::size_t colour_of_silhouette = 4;
  auto stream = skala::stream_of(grid, view);
  if (view.picture == skala::PictureKind::contours) stream.at(colour_of_silhouette) = 0;
  return stream;
}

}  // namespace

std::vector<ComparedDevice> compare_devices(const scene::HeightGrid& grid, const skala::View& view,
                                            const std::function<void(std::string_view)>& progress, bool ef9365_alone) {
  const skala::Session session;
  const HeightLines lines(grid, view);
  const auto seen = visible_segments(lines.lines());
  PixelGrid outline(skala::raster_side, skala::raster_side);
  if (view.picture == skala::PictureKind::contours) {
    const registry::HeightView asked = registry::height_view(view);
    const PixelGrid with = registry::oracle_dots(grid, asked, true);
    const PixelGrid without = registry::oracle_dots(grid, asked, false);
    for (std::size_t i = 0; i < outline.values.size(); ++i)
      outline.values[i] = with.values[i] != 0 && without.values[i] == 0 ? 1 : 0;
  }
  std::vector<ComparedDevice> compared;
  for (const auto& [device, name] : devices) {
    if (ef9365_alone && device != skala::Device::ef9365) continue;
    progress(name);
    skala::View shown = view;
    shown.device = device;
    skala::GuestOptions options;
    options.device = device;
    const skala::CheckedPicture run = session.run(stream_without_silhouettes(grid, shown), options);
    ComparedDevice row{device, name, run.difference, run.guest.drawing, {}, {}, {}, {}};
    const bool board = skala::is_raster(device);
    row.dots = board ? points_of(run.guest.raster) : points_of(skala::pen_paths(run.guest.moves), skala::raster_side);
    for (std::size_t i = 0; i < outline.values.size(); ++i)
      if (outline.values[i] != 0) row.dots.values[i] = 0;
    const bool filled = board && view.picture == skala::PictureKind::surface;
    row.truth = filled ? nearest_cells(grid, view)
                       : skala_points(lines.lines(), board ? SkalaDevice::raster : SkalaDevice::plotter);
    // Boards show the same dots, plotters too.
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
