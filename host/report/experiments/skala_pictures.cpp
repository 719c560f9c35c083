#include "host/report/experiments/skala_pictures.hpp"

#include <fmt/core.h>

#include <set>
#include <utility>

#include "emulators/core/raster.hpp"
#include "emulators/core/tstates.hpp"
#include "emulators/devices/ef9365_timing.hpp"
#include "host/base/value_of.hpp"
#include "host/picture/raster_image.hpp"
#include "host/programs/skala/program.hpp"
#include "host/programs/skala/skala.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::report {

namespace {

namespace skala = programs::skala;
using algorithms::skala::Subject;

std::size_t colours_of(const core::Raster& raster) {
  return std::set(raster.points().begin(), raster.points().end()).size();
}

double clock_mhz() {
  return static_cast<double>(core::ClockRate{}.hertz) / 1e6;
}

std::string_view name_of(Subject subject) {
  switch (subject) {
    case Subject::lines: return "lines";
    case Subject::surface: return "surface";
    case Subject::contours: return "contours";
  }
  return "";
}

// The program on the 8080 draws every dot of the EF9365 with a separate command.
core::TStates dot_time() {
  return core::ClockRate{}.t_states_in(devices::ef9365::clocks(devices::ef9365::start_up_clocks + 1));
}

SkalaPicture picture_of(const std::string& function, Subject subject, scene::GridSize size, double rotation,
                        skala::Device board) {
  skala::Order order;
  order.grid = scene::sample(*scene::height_function(function), size);
  order.view.subject = subject;
  order.view.silhouette = subject == Subject::contours;
  order.view.rotation = rotation;
  order.device = board;
  order.time_plain = true;
  order.check = true;
  const skala::Outcome run = base::value_of(skala::run(order), function);
  SkalaPicture made;
  made.function = function;
  made.picture = name_of(subject);
  made.drawing_s = core::in_seconds(run.picture.drawing);
  made.drawing_t_states = static_cast<std::uint64_t>(run.picture.drawing.count());
  if (run.plain_drawing) made.plain_t_states = static_cast<std::uint64_t>(run.plain_drawing->count());
  made.walked = run.points_walked;
  made.dots = run.counts->points_plotted;
  made.lit = run.points_lit;
  made.receipt_s = core::in_seconds(run.picture.total - run.picture.drawing);
  made.command_bytes = run.bytes;
  made.blocks = run.picture.blocks;
  made.instructions = run.picture.instructions;
  made.dots_busy_t_states = static_cast<std::uint64_t>((dot_time() * static_cast<std::int64_t>(made.dots)).count());
  made.colours = colours_of(run.picture.raster);
  const auto palette = subject == Subject::surface ? picture::RasterPalette::grey : picture::RasterPalette::colour;
  made.raster = png_picture(picture::raster_image(run.picture.raster, palette, 1), true);
  return made;
}

constexpr std::string_view masks = "masks: top and bottom of what is hidden";
constexpr std::string_view slice_before = "the slice before: rows and levels";
constexpr std::string_view folds = "folds, for silhouettes";

std::vector<SkalaMemory> memory_of(const skala::Program& program) {
  constexpr std::size_t page = 256;
  const std::size_t image = program.memory.size();
  const auto same = [](std::string_view what, std::size_t bytes) { return SkalaMemory{std::string(what), bytes, bytes, bytes}; };
  return {same("state and command table (page 0)", page),
          same("program", image - page),
          same(masks, 2 * page),
          {std::string(slice_before), 0, 2 * page, 0},
          {std::string(folds), 0, 0, 2 * page},
          same("pages written but never read, and the stack", 3 * page),
          same("buffer of commands", skala::buffer_bytes),
          same("capacity", 65536)};
}

// The time of a kind of picture, and the paper's.
ClaimRow time_row(const Page& page, const SkalaPictures& skala, std::string_view picture, std::string condition,
                  const std::string& more = {}) {
  const auto here = range_of(skala.of(picture), &SkalaPicture::drawing_s);
  const double paper = page.paper_figure("skala.time").greatest;
  const bool near = here.least / paper >= 0.2 && here.greatest / paper <= 5;
  return {"skala.time", {as_cell(here.least), as_cell(here.greatest)}, 3, std::move(condition),
          (near ? "within a factor of five" : "not within a factor of five") + more};
}

template <class Rows>
ClaimRow cost_row(const Page& page, const Rows& rows, std::string condition, const std::string& why_more, bool tell_below) {
  const auto here = range_of(rows, &SkalaPicture::cost_percent);
  const double paper = page.paper_figure("skala.cost").least;
  std::string compared = here.least > paper      ? "more for every function" + why_more
                         : here.greatest < paper ? "less for every function"
                                                 : "the paper's figure is between the least and the greatest here";
  if (tell_below && here.least < 0) compared += "; below 0 where hidden dots save more than the test costs";
  return {"skala.cost", {as_cell(here.least), as_cell(here.greatest)}, 1, std::move(condition), std::move(compared)};
}

template <class T>
ClaimRow same_row(const Page& page, const std::string& claim, T here, int places, std::string condition) {
  const bool equal = static_cast<double>(here) == page.paper_figure(claim).least;
  return {claim, one_figure(here), places, std::move(condition), equal ? "equal" : "not equal"};
}

void paper_claims(Page& page, const SkalaPictures& skala) {
  const auto memory = [&](std::string_view what) -> const SkalaMemory& {
    return only(skala.memory, equals(&SkalaMemory::what, what));
  };
  const auto on_alt256 = where(skala.costs, equals(&SkalaCost::board, "ALT-256"));
  page.claims(
      "skala-paper", "Skala 1985: every number for time and size",
      {time_row(page, skala, "lines",
                "lines, 60 slices of 33 points, rotated 30 degrees, 8080 at 3 MHz, EF9365 board, eight functions",
                "; an exact comparison needs the function, the number of slices and the raster board; the paper names none of "
                "them"),
       time_row(page, skala, "surface", "surface, 60 slices of 33 points, rotated 30 degrees, the same machine and functions"),
       time_row(page, skala, "contours", "contours, 8 levels on 33 by 33 points, the same machine and functions"),
       cost_row(page, skala.curves, "lines, 30 slices of 256 points, not rotated, EF9365 board", "", true),
       cost_row(page, skala.of("lines"), "lines, 60 slices of 33 points, rotated, EF9365 board", ": lines of a few dots", false),
       cost_row(page, skala.of("surface"), "surfaces, the same board", "", true),
       cost_row(page, skala.of("contours"), "contours, the same board", ": the edges of all triangles are walked for the masks",
                false),
       {"skala.cost",
        {as_cell(least(on_alt256, &SkalaCost::least_percent)), as_cell(greatest(on_alt256, &SkalaCost::greatest_percent))},
        1,
        "all of these on the ALT-256 board, which takes a dot in each line of the screen",
        "see the table of both boards"},
       {"skala.not_included", least_and_greatest(skala.pictures, &SkalaPicture::receipt_s), 3,
        "receiving the commands from the host, parallel",
        "left out here as well, and so is the receipt; no number is given to compare: that needs the host computer and its "
        "link"},
       same_row(page, "skala.resolution", core::Raster::width, Real::as_needed, "EF9365 board"),
       same_row(page, "skala.colours", greatest(skala.pictures, &SkalaPicture::colours), Real::as_needed,
                "values of the points of one picture"),
       same_row(page, "skala.clock", clock_mhz(), 0, "the emulated 8080, no wait states"),
       {"skala.masks",
        {as_cell(memory(masks).lines_bytes),
         as_cell(memory(masks).surface_bytes + memory(slice_before).surface_bytes + memory(folds).contours_bytes)},
        Real::as_needed,
        "pages of bytes for lines, and with surfaces and contours",
        "cannot be compared: the listing is of a finer raster than the one drawn on; needs the listing of the 8080 program"}});
}

template <class Rows>
SkalaCost cost_of(const Rows& rows, std::string picture, std::string board) {
  const auto time = range_of(rows, &SkalaPicture::drawing_s);
  const auto cost = range_of(rows, &SkalaPicture::cost_percent);
  const double average = mean(rows, &SkalaPicture::cost_percent);
  return {std::move(picture), std::move(board), time.least, time.greatest, cost.least, average, cost.greatest};
}

std::vector<SkalaCost> costs_on(const SkalaPictures& skala, const std::string& board) {
  return {cost_of(skala.of("lines"), "lines, 60 slices of 33 points, rotated", board),
          cost_of(skala.curves, "lines, 30 slices of 256 points, not rotated", board),
          cost_of(skala.of("surface"), "surfaces, 60 slices of 33 points, rotated", board),
          cost_of(skala.of("contours"), "contours, 8 levels on 33 by 33 points, rotated", board)};
}

// The eight functions as all kinds of picture.
SkalaPictures pictures_on(skala::Device board) {
  SkalaPictures made;
  for (const scene::HeightFunction& function : scene::height_functions().first(scene::figure_functions)) {
    const std::string name(function.name);
    for (const Subject subject : {Subject::lines, Subject::surface, Subject::contours}) {
      const scene::GridSize size = subject == Subject::contours ? scene::GridSize{33, 33} : scene::GridSize{33, 60};
      made.pictures.push_back(picture_of(name, subject, size, 30, board));
    }
    made.curves.push_back(picture_of(name, Subject::lines, {256, 30}, 0, board));
  }
  return made;
}

std::vector<RowColumn<SkalaPicture>> drawing_columns() {
  using Row = SkalaPicture;
  return {{"function", "Function", &Row::function},
          {"picture", "Picture", &Row::picture},
          {"drawing_s", "Drawing", "s", &Row::drawing_s, 3},
          {"drawing_t_states", "Drawing", "T-states", &Row::drawing_t_states},
          {"cost_percent", "Visibility costs", "%", &Row::cost_percent, 1},
          {"walked", "Points walked", &Row::walked},
          {"lit", "Points lit", &Row::lit}};
}

}  // namespace

std::optional<double> SkalaPicture::cost_percent() const {
  if (!plain_t_states) return std::nullopt;
  const auto plain = static_cast<double>(*plain_t_states);
  return 100 * (static_cast<double>(drawing_t_states) - plain) / plain;
}

SkalaPictures skala_pictures(const Context& context) {
  context.progress("eight functions on the 8080 with the EF9365 board");
  SkalaPictures made = pictures_on(skala::Device::ef9365);
  made.costs = costs_on(made, "EF9365");
  context.progress("eight functions on the 8080 with the ALT-256 board");
  for (SkalaCost& cost : costs_on(pictures_on(skala::Device::alt256), "ALT-256")) made.costs.push_back(std::move(cost));
  made.memory = memory_of(skala::resident_program());
  return made;
}

void skala_timing(Page& page, const SkalaPictures& skala) {
  paper_claims(page, skala);
  page.table("skala-functions", "Skala: drawing time of the eight functions", skala.pictures, drawing_columns(),
             {{"Seconds of the emulated 8080 at " + text_of(clock_mhz()) +
               " MHz, from the first command in memory to the last dot. Lines and surfaces: 60 slices of 33 points, contours: "
               "8 levels on 33 by 33, rotated 30 degrees, elevation 30. A surface costs less with the test of visibility than "
               "without, because facets that are hidden are neither shaded nor drawn: its cost is below zero. A picture must "
               "equal the native twin's, dot for dot, or the report ends with an error."}});
  page.table("skala-long-slices", "Skala: the same functions in 30 slices of 256 points, not rotated", skala.curves,
             drawing_columns());
  using Cost = SkalaCost;
  page.table(
      "skala-costs", "Skala: what visibility costs on both boards, eight functions", skala.costs,
      {{"picture", "Picture", &Cost::picture},
       {"board", "Board", &Cost::board},
       {"fastest_s", "Drawing", "s, fastest", &Cost::fastest_s, 2},
       {"slowest_s", "Drawing", "s, slowest", &Cost::slowest_s, 2},
       {"least_percent", "Visibility costs", "%, least", &Cost::least_percent, 1},
       {"mean_percent", "Visibility costs", "%, mean", &Cost::mean_percent, 1},
       {"greatest_percent", "Visibility costs", "%, greatest", &Cost::greatest_percent, 1}},
      {{"Without the test, only contours are drawn; with it, the edges of all triangles are walked, too, for the masks."}});
  page.gallery("skala-rasters", "Skala: what the raster board shows", skala.pictures, [](const SkalaPicture& row) {
    return figure(row.raster, fmt::format("raster-{}-{}", row.function, row.picture),
                  fmt::format("{}, {}", row.function, row.picture), text_of(row.drawing_s, 3) + " s",
                  fmt::format("The function {} drawn by the 8080 as {} on 256 by 256 points", row.function, row.picture));
  });
}

void skala_needs(Page& page, const SkalaPictures& skala) {
  using Memory = SkalaMemory;
  page.table("skala-memory", "Skala: memory of the 8080", skala.memory,
             {{"what", "What", &Memory::what},
              {"lines_bytes", "For lines", "bytes", &Memory::lines_bytes},
              {"surface_bytes", "For surfaces", "bytes", &Memory::surface_bytes},
              {"contours_bytes", "For contours", "bytes", &Memory::contours_bytes}},
             {{"One program draws all three kinds of picture. The paper does not describe the use of its memory."}});
  using Row = SkalaPicture;
  page.table("skala-work", "Skala: work of a picture", skala.pictures,
             {{"function", "Function", &Row::function},
              {"picture", "Picture", &Row::picture},
              {"command_bytes", "Commands", "bytes", &Row::command_bytes},
              {"blocks", "Blocks", &Row::blocks},
              {"instructions", "Instructions", &Row::instructions},
              {"drawing_t_states", "Drawing", "T-states", &Row::drawing_t_states},
              {"walked", "Points walked", &Row::walked},
              {"dots", "Dots written", &Row::dots},
              {"dots_busy_t_states", "Board busy with them", "T-states", &Row::dots_busy_t_states},
              {"dots_busy_percent", "Busy", "% of drawing",
               [](const Row& row) {
                 return 100 * static_cast<double>(row.dots_busy_t_states) / static_cast<double>(row.drawing_t_states);
               },
               1}},
             {{"Clearing the picture, two fields of the display or 120,000 T-states, is in the drawing time. Instructions "
               "include the receipt of the commands. The machine: 8080 at 3 MHz, 64 KB, EF9365 board, parallel link."}});
}

}  // namespace sightline::report
