// Skala's program on the 8080: the eight functions as lines, surfaces and contours, as `sightline demo` draws them,
// and as lines in long slices. What drawing takes with and without the visibility test, and what of the memory.
//
//   pictures  a function and picture each, with its raster
//   curves    the same functions in 30 slices of 256 points, not rotated: sent as curves of dots, the picture in
//             which the test is the larger part of the work on a dot
//   memory    what the 64 KB hold, by kind of picture
//   machine   the 8080's clock, and what the board shows
#include <fmt/core.h>

#include <set>
#include <utility>
#include <vector>

#include "emulators/core/raster.hpp"
#include "emulators/core/tstates.hpp"
#include "host/guests/skala/commands.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/guest_runs.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::report {

namespace {

namespace skala = guests::skala;
// How much longer with the visibility test.
Value cost_percent(const SkalaRun& run) {
  if (!run.plain) return {};
  const auto plain = static_cast<double>(run.plain->count());
  return 100 * (static_cast<double>(run.guest.drawing.count()) - plain) / plain;
}

std::size_t colours_of(const core::Raster& raster) {
  return std::set(raster.points().begin(), raster.points().end()).size();
}

NamedValues row_of(const SkalaOrder& order, const SkalaRun& run) {
  return {{"function", order.function},
          {"picture", name_of(order.picture)},
          {"drawing_s", seconds(run.guest.drawing)},
          {"drawing_t_states", run.guest.drawing.count()},
          {"plain_t_states", run.plain ? Value(run.plain->count()) : Value()},
          {"cost_percent", cost_percent(run)},
          {"walked", run.twin.points_walked},
          {"dots", run.twin.points_plotted},
          {"lit", run.points_lit}};
}

NamedValues full_row_of(const SkalaOrder& order, const SkalaRun& run) {
  NamedValues row = row_of(order, run);
  for (NamedValues::value_type value : NamedValues{{"receipt_s", seconds(run.guest.total - run.guest.drawing)},
                                                   {"command_bytes", run.stream_bytes},
                                                   {"blocks", run.guest.blocks},
                                                   {"instructions", run.guest.instructions},
                                                   {"dots_busy_t_states", run.dots_busy.count()},
                                                   {"colours", colours_of(run.guest.raster)},
                                                   {"raster", raster_png(run, order)}})
    row.push_back(std::move(value));
  return row;
}

RowSet memory_of(const skala::Program& program) {
  constexpr std::size_t page = 256;
  const std::size_t image = program.memory.size();
  RowSet rows;
  const auto add = [&rows](std::string_view what, std::size_t lines, std::size_t surface, std::size_t contours) {
    rows.add({{"what", what}, {"lines_bytes", lines}, {"surface_bytes", surface}, {"contours_bytes", contours}});
  };
  add("state and command table (page 0)", page, page, page);
  add("program", image - page, image - page, image - page);
  add("masks: top and bottom of what is hidden", 2 * page, 2 * page, 2 * page);
  add("the slice before: rows and levels", 0, 2 * page, 0);
  add("folds, for silhouettes", 0, 0, 2 * page);
  add("pages written but never read, and the stack", 3 * page, 3 * page, 3 * page);
  add("buffer of commands", skala::buffer_bytes, skala::buffer_bytes, skala::buffer_bytes);
  add("capacity", 65536, 65536, 65536);
  return rows;
}

}  // namespace

Records skala_pictures(const Context& context) {
  const skala::Session session;
  Records records;
  for (const scene::HeightFunction& function : scene::height_functions().first(scene::figure_functions)) {
    context.progress(fmt::format("{} on the 8080", function.name));
    const std::string name(function.name);
    for (const skala::PictureKind picture : {skala::PictureKind::lines, skala::PictureKind::surface, skala::PictureKind::contours}) {
      SkalaOrder order{name, picture};
      if (picture == skala::PictureKind::contours) order.size = {33, 33};
      order.compare_plain = picture != skala::PictureKind::contours;
      records["pictures"].add(full_row_of(order, run_skala(session, order)));
    }
    const SkalaOrder curves{name, skala::PictureKind::lines, {256, 30}, 0, true};
    records["curves"].add(row_of(curves, run_skala(session, curves)));
  }
  records["memory"] = memory_of(session.program());
  records["machine"].add({{"clock_mhz", static_cast<double>(core::ClockRate{}.hertz) / 1e6},
                          {"points_a_side", core::Raster::width}});
  return records;
}

}  // namespace sightline::report
