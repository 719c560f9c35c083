#include "host/report/experiments/skala_wishes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "emulators/core/raster.hpp"
#include "host/base/value_of.hpp"
#include "host/picture/raster_image.hpp"
#include "host/programs/skala/skala.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/report/page.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/heights/subdivide.hpp"

namespace sightline::report {

namespace {

namespace skala = programs::skala;
using algorithms::skala::Subject;

constexpr std::size_t known_points = 17;
constexpr std::array<std::size_t, 4> all_parts{1, 2, 4, 8};
constexpr std::size_t reference_points = (known_points - 1) * all_parts.back() + 1;

skala::Order order_of(scene::HeightGrid grid, Subject subject) {
  skala::Order order;
  order.grid = std::move(grid);
  order.view.subject = subject;
  order.view.silhouette = subject == Subject::contours;
  order.view.rotation = 30;
  order.check = true;
  return order;
}

std::uint64_t dots_lit(const core::Raster& raster) {
  return static_cast<std::uint64_t>(std::count_if(raster.points().begin(), raster.points().end(), [](std::uint8_t level) { return level != 0; }));
}

std::uint64_t different_dots(const core::Raster& one, const core::Raster& other) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < one.points().size(); ++i) count += one.points()[i] != other.points()[i] ? 1U : 0U;
  return count;
}

// The mesh is straight between its heights.
double height_at(const scene::HeightGrid& mesh, std::size_t point, std::size_t slice, std::size_t step) {
  const std::size_t p = std::min(point / step, mesh.points() - 2);
  const std::size_t s = std::min(slice / step, mesh.slices() - 2);
  const double u = static_cast<double>(point - p * step) / static_cast<double>(step);
  const double v = static_cast<double>(slice - s * step) / static_cast<double>(step);
  const double near = mesh.height(p, s) * (1 - u) + mesh.height(p + 1, s) * u;
  const double far = mesh.height(p, s + 1) * (1 - u) + mesh.height(p + 1, s + 1) * u;
  return near * (1 - v) + far * v;
}

double mean_error_percent(const scene::HeightGrid& mesh, const scene::HeightGrid& reference) {
  const std::size_t step = (reference.points() - 1) / (mesh.points() - 1);
  double sum = 0;
  for (std::size_t slice = 0; slice < reference.slices(); ++slice)
    for (std::size_t point = 0; point < reference.points(); ++point)
      sum += std::abs(height_at(mesh, point, slice, step) - reference.height(point, slice));
  return 100 * sum / static_cast<double>(reference.heights.size()) / (reference.range.high - reference.range.low);
}

void add_contours(std::vector<SmoothContours>& rows, const std::string& name) {
  const scene::HeightFunction function = *scene::height_function(name);
  const scene::HeightGrid reference = scene::sample(function, {reference_points, reference_points});
  const skala::Outcome right = base::value_of(skala::run(order_of(reference, Subject::contours)), name);
  scene::HeightGrid known = scene::sample(function, {known_points, known_points});
  known.range = reference.range;  // the same levels
  for (const std::size_t parts : all_parts) {
    scene::HeightGrid mesh = base::value_of(scene::subdivided(known, {parts, parts}), name);
    mesh.range = reference.range;
    const skala::Outcome drawn = base::value_of(skala::run(order_of(mesh, Subject::contours)), name);
    SmoothContours& row = rows.emplace_back();
    row.function = name;
    row.parts = parts;
    row.command_bytes = drawn.bytes;
    row.drawing_s = core::in_seconds(drawn.picture.drawing);
    row.wrong_dots = different_dots(drawn.picture.raster, right.picture.raster);
    row.mean_error_percent = mean_error_percent(mesh, reference);
    row.raster = png_picture(picture::raster_image(drawn.picture.raster, picture::RasterPalette::colour, 1), true);
  }
}

// The dots of the right picture: red where `drawn` has none, white elsewhere.
picture::Image marked(const core::Raster& drawn, const core::Raster& right) {
  constexpr std::uint8_t white = 7;
  constexpr std::uint8_t red = 4;
  core::Raster marks;
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      const auto i = static_cast<std::size_t>(y * core::Raster::width + x);
      if (right.points()[i] == 0) continue;
      marks.set(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), drawn.points()[i] == 0 ? red : white);
    }
  }
  return picture::raster_image(marks, picture::RasterPalette::colour, 1);
}

DirectMasks direct_masks(const std::string& name, Subject subject) {
  skala::Order order = order_of(scene::sample(*scene::height_function(name), {33, 60}), subject);
  const skala::Outcome right = base::value_of(skala::run(order), name);
  order.direct_masks = true;
  const skala::Outcome drawn = base::value_of(skala::run(order), name);
  DirectMasks row;
  row.function = name;
  row.picture = subject == Subject::lines ? "lines" : "surface";
  row.dots = dots_lit(right.picture.raster);
  row.missing = drawn.wrong_dots->missing;
  row.extra = drawn.wrong_dots->extra;
  row.raster = png_picture(marked(drawn.picture.raster, right.picture.raster), true);
  return row;
}

}  // namespace

SkalaWishes skala_wishes(const Context& context) {
  SkalaWishes measured;
  measured.reference_points = reference_points;
  for (const std::string_view name : {"sinc", "peaks", "rogers", "franke"}) {
    context.progress(fmt::format("contours of {} by a subdivided mesh", name));
    add_contours(measured.contours, std::string(name));
  }
  for (const Subject subject : {Subject::lines, Subject::surface}) {
    for (const scene::HeightFunction& function : scene::height_functions().first(scene::figure_functions)) {
      context.progress(fmt::format("{} without the temporary masks", function.name));
      measured.masks.push_back(direct_masks(std::string(function.name), subject));
    }
  }
  return measured;
}

void skala_smooth_chapter(Page& page, const SkalaWishes& measured) {
  const auto& contours = measured.contours;
  const auto with = [&contours](std::size_t parts) { return where(contours, equals(&SmoothContours::parts, parts)); };
  const std::uint64_t coarse = sum(with(1), &SmoothContours::wrong_dots);
  const std::uint64_t fine = sum(with(4), &SmoothContours::wrong_dots);
  page.table("skala-smooth-contours", "Contours smoothed by subdividing the mesh", contours,
             {{"function", "Function", &SmoothContours::function},
              {"parts", "Cells along a side of a cell", &SmoothContours::parts},
              {"command_bytes", "Commands", "bytes", &SmoothContours::command_bytes},
              {"drawing_s", "Drawing on the 8080", "emulated s", &SmoothContours::drawing_s, 2},
              {"wrong_dots", "Dots that differ from the reference", &SmoothContours::wrong_dots},
              {"mean_error_percent", "Mean error of the mesh, natively", "% of the range of heights", &SmoothContours::mean_error_percent, 3}},
             {.notes = {fmt::format("\"If any user needs smaller grids or smoothly interpolate contours he can subdivide grid mesh.\" `--subdivide N` of "
                                    "`skala` and `draw skala` puts cubic curves through the heights, here of {0} by {0} points. The reference is the "
                                    "function itself at {1} by {1} points.",
                                    known_points, measured.reference_points),
                        page.claim(fine < coarse,
                                   fmt::format("Cells cut in 4 by 4 have {} wrong dots instead of {}.", fine, coarse),
                                   fmt::format("{} against {}", fine, coarse))}});
  page.gallery("skala-smooth-pictures", "Contours of the mesh, and of cells cut in 4 by 4",
               where(contours, [](const SmoothContours& row) { return row.parts == 1 || row.parts == 4; }), [](const SmoothContours& row) {
                 return figure(row.raster, fmt::format("skala-smooth-{}-{}", row.function, row.parts), fmt::format("{}, {} by {}.", row.function, row.parts, row.parts),
                               fmt::format("{} wrong dots, {} s.", row.wrong_dots, text_of(row.drawing_s, 1)), fmt::format("Contours of {}", row.function));
               });
  const auto& masks = measured.masks;
  page.table("skala-direct-masks", "Without the temporary masks M1T and M1B", masks,
             {{"function", "Function", &DirectMasks::function},
              {"picture", "Picture", &DirectMasks::picture},
              {"dots", "Dots of the right picture", &DirectMasks::dots},
              {"missing", "Missing", "dots", &DirectMasks::missing},
              {"missing_percent", "Missing", "% of the dots", &DirectMasks::missing_percent, 1},
              {"extra", "Extra or of another level", "dots", &DirectMasks::extra}},
             {.notes = {"\"There are two temporary arrays for new masks in order to get rid of all very special problems with near "
                        "horizontal lines.\" Without them each dot changes the masks at once (`sightline skala --direct-masks`), so a line that falls in a "
                        "column is hidden by its own first dot there. " +
                        page.claim(sum(where(masks, equals(&DirectMasks::picture, "lines")), &DirectMasks::extra) == 0,
                                   "Lines lose dots and gain none.")}});
  page.gallery("skala-direct-pictures", "Dots that are missing without the temporary masks, in red",
               where(masks, [](const DirectMasks& row) { return row.missing != 0; }), [](const DirectMasks& row) {
    return figure(row.raster, fmt::format("skala-direct-{}-{}", row.function, row.picture), fmt::format("{}, {}.", row.function, row.picture),
                  fmt::format("{} of {} dots missing.", row.missing, row.dots), fmt::format("{} of {} with missing dots in red", row.picture, row.function));
  });
}

}  // namespace sightline::report
