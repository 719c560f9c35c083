#include "host/report/hard_cases/skala.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "host/algorithms/skala/draw.hpp"
#include "host/compare/heights.hpp"
#include "host/guests/skala/guest.hpp"
#include "host/guests/skala/program.hpp"
#include "host/guests/skala/projection.hpp"
#include "host/guests/skala/stream.hpp"
#include "host/guests/skala/twin/twin.hpp"
#include "host/report/hard_cases/hard_cases.hpp"
#include "host/scene/heights/read_grid.hpp"

namespace sightline::harness::report {

namespace {

using picture::PixelGrid;
using scene::HeightGrid;

Cell verdict(const std::vector<Complaint>& complaints) {
  std::string text;
  for (const Complaint& complaint : complaints) {
    if (complaint) text += (text.empty() ? "" : "; ") + *complaint;
  }
  if (text.empty()) return Verdict{true, "right"};
  return Verdict{false, "differs: " + text};
}

Complaint check_dots(const SkalaHardCase& hard, const HeightGrid& grid, const PixelGrid& dots) {
  return hard.dots != nullptr ? hard.dots(grid, hard.view, dots) : std::nullopt;
}

algorithms::skala::View native_view(const SkalaHardCase& hard) {
  constexpr std::array families{algorithms::skala::Family::along_x, algorithms::skala::Family::along_z,
                                algorithms::skala::Family::both, algorithms::skala::Family::automatic};
  constexpr std::array subjects{algorithms::skala::Subject::lines, algorithms::skala::Subject::surface,
                                algorithms::skala::Subject::contours};
  algorithms::skala::View view;
  view.subject = subjects[static_cast<std::size_t>(hard.view.picture)];
  view.family = families[static_cast<std::size_t>(hard.view.family)];
  view.rotation = hard.view.rotation;
  view.elevation = hard.view.elevation;
  view.levels = hard.view.levels;
  view.columns = hard.columns;
  view.rims = false;
  return view;
}

// Each line as the dots nearest to it.
PixelGrid dots_of(const picture::VectorDrawing& drawing) {
  PixelGrid grid(guests::skala::raster_side, guests::skala::raster_side);
  const auto dot = [](double value) {
    return std::clamp(static_cast<int>(std::floor(value + 0.5)), 0, guests::skala::raster_side - 1);
  };
  for (const picture::DrawingLine& line : drawing.lines) {
    for (std::uint32_t i = 0; i < line.count; ++i) {
      const picture::DrawingPoint from = drawing.points[line.first + i];
      const picture::DrawingPoint to = drawing.points[line.first + std::min(i + 1, line.count - 1)];
      const double along = to.x - from.x;
      const double up = to.y - from.y;
      const int steps = 1 + static_cast<int>(4 * std::max(std::abs(along), std::abs(up)));
      for (int step = 0; step <= steps; ++step) {
        const double share = static_cast<double>(step) / steps;
        grid.set(dot(from.x + share * along), dot(from.y + share * up), 1);
      }
    }
  }
  return grid;
}

// Straight on, rims are in one column with the ends of all slices. The raster's order, slices first, hides
// one of the two there; vectors show both.
PixelGrid without_outer_columns(PixelGrid grid) {
  for (int y = 0; y < guests::skala::raster_side; ++y) {
    for (const int x : {0, guests::skala::raster_side - 1}) grid.set(x, y, 0);
  }
  return grid;
}

// Vectors may be a dot away from where a raster rounds them to.
Complaint within_a_dot(const SkalaHardCase& hard, const HeightGrid& grid, const PixelGrid& truth) {
  auto view = native_view(hard);
  view.rims = true;
  const PixelGrid drawn = dots_of(algorithms::skala::draw(grid, view));
  const bool straight_on = std::fmod(hard.view.rotation, 90) == 0;
  const auto metrics =
      straight_on ? picture::pixel_metrics(without_outer_columns(truth), without_outer_columns(drawn), {})
                  : picture::pixel_metrics(truth, drawn, {});
  if (metrics.missing_far + metrics.extra_far == 0) return std::nullopt;
  return fmt::format("{} dots missing, {} too many, by more than a dot", metrics.missing_far,
                     metrics.extra_far);
}

// `truth`: the oracle's picture, if there is one.
Cell native_cell(const SkalaHardCase& hard, const HeightGrid& grid, const PixelGrid* truth) {
  if (hard.view.zoom != 1) return "not applicable: its drawings have any size, and are not cut";
  std::vector<Complaint> complaints;
  if (truth != nullptr && hard.view.picture == guests::skala::PictureKind::lines)
    complaints.push_back(within_a_dot(hard, grid, *truth));
  if (hard.lines != nullptr)
    complaints.push_back(hard.lines(grid, algorithms::skala::draw(grid, native_view(hard))));
  return verdict(complaints);
}

Complaint exactly(const picture::PixelMetrics& metrics) {
  if (metrics.missing + metrics.extra == 0) return std::nullopt;
  return fmt::format("{} dots missing, {} too many", metrics.missing, metrics.extra);
}

SkalaHardResult run_against_oracle(const SkalaHardCase& hard, const HeightGrid& grid) {
  const compare::HeightComparison comparison = compare::compare_heights(grid, hard.view);
  SkalaHardResult result;
  result.oracle = verdict({check_dots(hard, grid, comparison.truth)});
  for (const compare::ComparedRaster& raster : comparison.rasters) {
    const std::vector<Complaint> complaints{exactly(raster.metrics), check_dots(hard, grid, raster.grid)};
    if (raster.name == "guest") {
      const std::string& difference = comparison.guest_difference;
      result.guest =
          difference.empty() ? verdict(complaints) : verdict({"not its twin's picture: " + difference});
    }
    if (raster.name == "twin") result.twin = verdict(complaints);
  }
  result.native = native_cell(hard, grid, &comparison.truth);
  return result;
}

PixelGrid lit_dots(const core::Raster& raster) {
  PixelGrid grid(guests::skala::raster_side, guests::skala::raster_side);
  for (std::size_t i = 0; i < grid.values.size(); ++i) grid.values[i] = raster.points()[i] != 0 ? 1 : 0;
  return grid;
}

SkalaHardResult run_without_oracle(const SkalaHardCase& hard, const HeightGrid& grid,
                                   const std::string& reason) {
  const auto stream = guests::skala::stream_of(grid, hard.view);
  const guests::skala::TwinPicture twin = guests::skala::run_twin(stream);
  const guests::skala::GuestPicture guest =
      guests::skala::run_guest(guests::skala::assemble_program(), stream);
  const std::string difference =
      guests::skala::difference_from_twin(guest, twin, guests::skala::Device::ef9365);
  SkalaHardResult result;
  result.guest = difference.empty() ? verdict({check_dots(hard, grid, lit_dots(guest.raster))})
                                    : verdict({"not its twin's picture: " + difference});
  result.twin = verdict({check_dots(hard, grid, lit_dots(twin.raster(guests::skala::Device::ef9365)))});
  result.native = native_cell(hard, grid, nullptr);
  result.oracle = "not applicable: " + reason;
  return result;
}

}  // namespace

SkalaHardResult run_hard_case(const SkalaHardCase& hard) {
  if (hard.file.empty()) return run_all_octants();
  if (hard.file.ends_with(".txt")) return run_commands(hard);
  const auto read = scene::read_height_grid(hard_case_text(hard.file), std::string(hard.file));
  if (!read) {
    const Cell cell = Verdict{false, "refused: " + read.error().message(base::MessageStyle::position)};
    return {cell, cell, cell, cell};
  }
  const auto& grid = *read;
  if (const auto reason = compare::why_not_comparable(grid, hard.view)) return run_without_oracle(hard, grid, *reason);
  return run_against_oracle(hard, grid);
}

}  // namespace sightline::harness::report
