// Numbers: V. Skala, "Hidden-Line, Hidden-Surface and Hidden-Contouring Problem Solutions by the Modified
// Bresenham's Algorithm", sections 3 and 6.
#include "host/report/timing/skala.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host/report/guest_runs.hpp"
#include "host/report/timing/paper_numbers.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::harness::report {

namespace {

using Runs = std::vector<std::pair<SkalaOrder, SkalaRun>>;

// How much longer with the visibility test, in per cent.
double cost(const SkalaRun& run) {
  const auto plain = static_cast<double>(run.plain->count());
  return 100 * (static_cast<double>(run.guest.drawing.count()) - plain) / plain;
}

struct Extremes {
  double least = 1e300;
  double greatest = -1e300;

  void add(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
};

Extremes drawing_times(const Runs& runs, guests::skala::PictureKind picture) {
  Extremes times;
  for (const auto& [order, run] : runs)
    if (order.picture == picture) times.add(seconds(run.guest.drawing));
  return times;
}

Extremes costs(const Runs& runs) {
  Extremes all;
  for (const auto& [order, run] : runs)
    if (run.plain) all.add(cost(run));
  return all;
}

// Long slices sent as curves, the picture where the test is the larger part of the work per dot.
Outcome<Runs> run_curves(const Context& context, const guests::skala::Program& program) {
  Runs runs;
  for (const scene::HeightFunction& function : scene::height_functions().first(scene::figure_functions)) {
    context.progress(fmt::format("{} in long slices on the 8080", function.name));
    SkalaOrder order{std::string(function.name), guests::skala::PictureKind::lines, {256, 30}, 0, true};
    auto run = run_skala(program, order);
    if (!run) return std::move(run.error());
    runs.emplace_back(std::move(order), std::move(*run));
  }
  return runs;
}

constexpr const char* machine = "8080 at 3 MHz, EF9365 board, eight functions";

PaperNumber time_row(const Runs& runs, guests::skala::PictureKind picture, const std::string& what) {
  const Extremes times = drawing_times(runs, picture);
  return {"6, conclusion",
          "\"drawn in 2 sec. approximately including the visibility solution\"",
          Real{times.least, 3},
          Real{times.greatest, 3},
          "s",
          fmt::format("{}, {}", what, machine),
          "the same order; which function, how many slices and which raster board is not said"};
}

std::vector<PaperNumber> numbers(const Runs& runs, const Runs& curves) {
  const Extremes rotated = costs(runs);
  const Extremes straight = costs(curves);
  Extremes receipt;
  for (const auto& [order, run] : runs) receipt.add(seconds(run.guest.total - run.guest.drawing));
  const auto count = [](std::int64_t value) { return Cell(value); };
  const std::string says = "\"about 15% slower than drawing without the solution of the visibility\"";
  return {
      time_row(runs, guests::skala::PictureKind::lines, "lines, 60 slices of 33 points, rotated 30 degrees"),
      time_row(runs, guests::skala::PictureKind::surface,
               "surface, 60 slices of 33 points, rotated 30 degrees"),
      time_row(runs, guests::skala::PictureKind::contours, "contours, 8 levels on 33 by 33 points"),
      {"6, conclusion", says, Real{straight.least, 1}, Real{straight.greatest, 1}, "%",
       fmt::format("lines, 30 slices of 256 points, not rotated, {}", machine),
       "about the same; below 0 where hidden dots save more than the test costs"},
      {"6, conclusion", says, Real{rotated.least, 1}, Real{rotated.greatest, 1}, "%",
       fmt::format("lines, 60 slices of 33 points, rotated, {}", machine),
       "more: lines of a few dots, and drawing without the test is as fast as it can be made"},
      {"6, conclusion", "\"the time of function computation, scaling and rotation is not included\"",
       Real{receipt.least, 3}, Real{receipt.greatest, 3}, "s",
       "receiving the commands from the host, parallel",
       "left out here as well, and so is the receipt; no number is given to compare"},
      {"6, conclusion", "\"the resolution 256x256 points\"", count(256), count(256), "points", "EF9365 board",
       "the same"},
      {"6, conclusion", "\"with 8 colours\"", count(8), count(8), "colours", "three bit planes", "the same"},
      {"6, conclusion",
       "\"8-bit microcomputer with 8080 microprocessor running at 3MHz\"",
       {},
       Real{3, 0},
       "MHz",
       "the emulated 8080, no wait states",
       "the same"},
      {"3, algorithm 3.1", "four mask vectors for 1024 columns of integers", count(512), count(1536), "bytes",
       "two pages of bytes for lines, six with surfaces and contours",
       "cannot be compared: the listing is of a finer raster than the one drawn on; what the 8080 kept is "
       "not said"},
  };
}

Table functions_table(const Runs& runs, std::string id, std::string title) {
  Table table;
  table.id = std::move(id);
  table.title = std::move(title);
  table.columns = {{"function", "Function", "", false},
                   {"picture", "Picture", "", false},
                   {"drawing_s", "Drawing", "s", false},
                   {"drawing_t_states", "Drawing", "T-states", false},
                   {"cost_percent", "Visibility costs", "%", false},
                   {"walked", "Points walked", "", false},
                   {"lit", "Points lit", "", false}};
  for (const auto& [order, run] : runs) {
    table.rows.push_back(
        {order.function, std::string(name_of(order.picture)), Real{seconds(run.guest.drawing), 3},
         static_cast<std::int64_t>(run.guest.drawing.count()), run.plain ? Cell(Real{cost(run), 1}) : Cell(),
         static_cast<std::int64_t>(run.twin.points_walked), static_cast<std::int64_t>(run.points_lit)});
  }
  return table;
}

Outcome<Gallery> rasters(const Runs& runs) {
  Gallery gallery{"skala-rasters", "Skala: what the raster board shows", {}};
  for (const auto& [order, run] : runs) {
    auto png = raster_png(run, order);
    if (!png) return std::move(png.error());
    const std::string_view picture = name_of(order.picture);
    gallery.figures.push_back(
        {fmt::format("raster-{}-{}", order.function, picture), fmt::format("{}, {}", order.function, picture),
         fmt::format("{:.3f} s", seconds(run.guest.drawing)),
         fmt::format("The function {} drawn by the 8080 as {} on 256 by 256 points", order.function, picture),
         "image/png", std::move(*png), false, true});
  }
  return gallery;
}

}  // namespace

Outcome<std::vector<Block>> timing_of_skala(const Context& context) {
  const guests::skala::Program program = guests::skala::assemble_program();
  auto made = run_all_skala(context, program, true);
  if (!made) return std::move(made.error());
  auto long_slices = run_curves(context, program);
  if (!long_slices) return std::move(long_slices.error());
  const Runs runs = std::move(*made);
  const Runs curves = std::move(*long_slices);
  auto gallery = rasters(runs);
  if (!gallery) return std::move(gallery.error());
  Table functions = functions_table(runs, "skala-functions", "Skala: drawing time of the eight functions");
  functions.notes = {
      "Seconds of the emulated 8080 at 3 MHz, from the first command in memory to the last dot. Lines and "
      "surfaces: 60 slices of 33 points, contours: 8 levels on 33 by 33, rotated 30 degrees, elevation 30. "
      "In every run the picture is, dot for dot, the one the native twin makes."};
  std::vector<Block> blocks;
  blocks.emplace_back(
      paper_table("skala-paper", "Skala 1985: every number for time and size", numbers(runs, curves)));
  blocks.emplace_back(std::move(functions));
  blocks.emplace_back(functions_table(curves, "skala-long-slices",
                                      "Skala: the same functions in 30 slices of 256 points, not rotated"));
  blocks.emplace_back(std::move(*gallery));
  return blocks;
}

}  // namespace sightline::harness::report
