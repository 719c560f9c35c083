#include "host/report/speed_error/skala_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "host/report/speed_error/plot.hpp"

namespace sightline::harness::report {

namespace {

struct Measure {
  std::string_view key;
  std::string_view title;
  std::string_view unit;
  double SurfaceError::*value;
};
constexpr std::array<Measure, 2> measures{
    {{"h", "greatest distance, H", "pixels of 1024", &SurfaceError::hausdorff},
     {"pmr", "pixels that differ, PMR", "% of the raster", &SurfaceError::mismatch}}};

struct Knob {
  std::string_view key;
  std::string_view title;
  std::string_view column;
  std::vector<SkalaCurve> SkalaMeasured::*curves;
  std::string_view caption;
  bool trades = true;  // error for time; else distances say nothing
};
constexpr std::array<Knob, 3> knobs{
    {{"raster", "rasters of more and more dots a side", "Dots a side", &SkalaMeasured::rasters,
      "33 slices of 17 points. The program on the 8080 has 256 dots and is made to use fewer by zooming out. "
      "An error is a dot or two of the raster at hand."},
     {"grid", "8 to 256 points in each of 33 slices", "Points a slice", &SkalaMeasured::grids,
      "Held against slices of 1024 points. The error falls with the square of the distance of the points, "
      "until the 8080's raster of 256 dots is the limit; the native program, whose lines end where they "
      "meet the horizon, goes on. From 128 points on they are nearer than two dots, and are sent as curves "
      "of dots, which take longer."},
     {"levels", "1 to 32 contour levels", "Levels", &SkalaMeasured::levels,
      "33 x 33 points, held against 129 x 129. Levels cost time; the error is that of the grid and depends "
      "on which level happens to touch a peak. More lines differ in more dots.",
      false}}};

bool is_lowest(const Knob& knob, const SkalaCurve& curve) {
  return curve.function == (knob.key == "levels" ? "cosr" : "sinc");
}

double seconds(core::TStates time) {
  return static_cast<double>(time.count()) / static_cast<double>(core::ClockRate{}.hertz);
}

Plot plot_of(const SkalaMeasured& measured, const Knob& knob, const Measure& measure, bool host_time) {
  Plot plot;
  plot.id = fmt::format("skala-{}-{}-{}", knob.key, measure.key, host_time ? "host" : "emulated");
  plot.title = fmt::format("Skala{}: {}: {}", host_time ? " in C++" : " on the 8080", knob.title,
                           symbol_of(measure.title));
  plot.caption = std::string(knob.caption);
  plot.caption.text += host_time ? " Times are medians of interleaved repetitions, of this computer."
                            : " Drawing on the EF9365 board, 8080 at 3 MHz.";
  plot.alternative = fmt::format(
      "Log-log plot of the time of a drawing against its error, {}, one curve a "
      "function{}.",
      knob.title, host_time ? " and program" : "");
  plot.host_time = host_time;
  plot.x = {std::string(measure.title), std::string(measure.unit), true, {}};
  plot.y = host_time ? Axis{fmt::format("a drawing, {}", host_title), "ms", true, {}}
                     : Axis{fmt::format("a drawing, {}", emulated_title), "s", true, {}};
  for (const bool native : {false, true}) {
    if (native && !host_time) continue;
    for (const SkalaCurve& of : measured.*knob.curves) {
      Curve curve;
      curve.name = !host_time ? of.function : fmt::format("{}, {}", of.function, native ? "native" : "twin");
      for (const SkalaPoint& point : native ? of.native : of.program) {
        const double time = host_time ? point.host_ns.value_or(0) / 1e6 : seconds(*point.drawing);
        curve.points.push_back(
            {point.error.*measure.value, time, is_lowest(knob, of) ? fmt::format("{}", point.setting) : ""});
      }
      plot.curves.push_back(std::move(curve));
    }
  }
  return plot;
}

void add_cells(std::vector<Cell>& row, const SurfaceError& error) {
  for (const double value : {error.mismatch, error.far, error.hausdorff, error.usual})
    row.emplace_back(Real{value});
}

void add_columns(Table& table) {
  for (Column column : {Column{"pmr_per_cent", "PMR", "% of the raster", false},
                        Column{"pmr_far_per_cent", "PMR, no lit dot beside", "%", false},
                        Column{"h_px", "H", "pixels of 1024", false},
                        Column{"h_usual_px", "H, all but 1 in 1000", "pixels of 1024", false}})
    table.columns.push_back(std::move(column));
}

Table table_of(const SkalaMeasured& measured, const Knob& knob) {
  Table table;
  table.id = fmt::format("skala-speed-error-{}", knob.key);
  table.title = fmt::format("Skala: {}", knob.title);
  table.columns = {{"function", "Function", "", false},
                   {"program", "Program", "", false},
                   {std::string(knob.key), std::string(knob.column), "", false}};
  add_columns(table);
  table.columns.push_back({"drawing_t_states", "Drawing on the 8080", "T-states", false});
  table.columns.push_back({"drawing_s", "at 3 MHz", "s", false});
  table.columns.push_back({"host_us", "Drawing in C++", "us", true});
  for (const SkalaCurve& curve : measured.*knob.curves) {
    for (const auto* const points : {&curve.program, &curve.native}) {
      for (const SkalaPoint& point : *points) {
        std::vector<Cell> row{curve.function, std::string(point.drawing ? "8080 and its twin" : "native"),
                              std::int64_t{point.setting}};
        add_cells(row, point.error);
        row.push_back(point.drawing ? Cell(std::int64_t{point.drawing->count()}) : Cell());
        row.push_back(point.drawing ? Cell(Real{seconds(*point.drawing), 3}) : Cell());
        row.push_back(point.host_ns ? Cell(Real{*point.host_ns / 1000, 1}) : Cell());
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

std::string name_of(guests::skala::Device device, guests::skala::Link link) {
  return fmt::format("{}, {} link", device == guests::skala::Device::ef9365 ? "EF9365" : "ALT-256",
                     link == guests::skala::Link::serial ? "serial" : "parallel");
}

Table boards_table(const std::vector<SkalaBoard>& boards) {
  Table table;
  table.id = "skala-boards";
  table.title = "Skala: two boards and two links";
  table.columns = {{"function", "Function", "", false}, {"board", "Board and link", "", false}};
  add_columns(table);
  table.columns.push_back({"drawing_t_states", "Drawing", "T-states", false});
  table.columns.push_back({"drawing_s", "Drawing", "s at 3 MHz", false});
  table.columns.push_back({"total_t_states", "With the receipt of commands", "T-states", false});
  table.columns.push_back({"total_s", "With the receipt", "s at 3 MHz", false});
  table.columns.push_back({"dots_not_shown", "Dots in rows not shown", "", false});
  for (const SkalaBoard& board : boards) {
    std::vector<Cell> row{board.function, name_of(board.device, board.link)};
    add_cells(row, board.error);
    row.emplace_back(std::int64_t{board.drawing.count()});
    row.emplace_back(Real{seconds(board.drawing), 3});
    row.emplace_back(std::int64_t{board.total.count()});
    row.emplace_back(Real{seconds(board.total), 3});
    row.emplace_back(static_cast<std::int64_t>(board.dots_not_shown));
    table.rows.push_back(std::move(row));
  }
  table.notes = {
      "33 slices of 65 points. Both boards hold the same dots, so the error is the same; the ALT-256 shows "
      "fewer rows than it holds. The link has no part in the drawing, and all in the receipt."};
  return table;
}

Plot boards_plot(const std::vector<SkalaBoard>& boards) {
  Plot plot;
  const Measure& measure = measures.back();
  plot.id = "skala-boards-pmr";
  plot.title = "Skala on the 8080: two boards and two links, receipt included";
  plot.caption =
      "33 slices of 65 points of three functions, from the first byte of a command to the last dot. The "
      "board does not change the picture, so that points of a function stand above one another.";
  plot.alternative =
      "Plot of the time of a picture against its error: the parallel link with the EF9365 board is "
      "fastest, the serial link takes several times as long with either board.";
  plot.x = {std::string(measure.title), std::string(measure.unit), false, {}};
  plot.y = {fmt::format("a picture, {}", emulated_title), "s", true, {}};
  for (const guests::skala::Device device : {guests::skala::Device::ef9365, guests::skala::Device::alt256}) {
    for (const guests::skala::Link link : {guests::skala::Link::parallel, guests::skala::Link::serial}) {
      Curve curve;
      curve.name = name_of(device, link);
      for (const SkalaBoard& board : boards) {
        if (board.device == device && board.link == link)
          curve.points.push_back({board.error.*measure.value, seconds(board.total), board.function});
      }
      std::sort(curve.points.begin(), curve.points.end(),
                [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
      plot.curves.push_back(std::move(curve));
    }
  }
  return plot;
}

// Those that are plotted.
std::span<const Measure> measures_of(const Knob& knob, bool host_time) {
  const std::span all(measures);
  if (!knob.trades) return all.last(1);
  return host_time ? all.first(1) : all;
}

bool timed(const SkalaMeasured& measured) {
  return !measured.rasters.empty() && !measured.rasters.front().program.empty() &&
         measured.rasters.front().program.front().host_ns.has_value();
}

}  // namespace

Outcome<std::vector<Block>> skala_error_blocks(const SkalaMeasured& measured) {
  std::vector<Block> blocks;
  for (const Knob& knob : knobs) {
    for (const bool host_time : {false, true}) {
      if (host_time && !timed(measured)) continue;
      for (const Measure& measure : measures_of(knob, host_time)) {
        if (auto error = add_figure(blocks, plot_of(measured, knob, measure, host_time)))
          return std::move(*error);
      }
    }
    blocks.emplace_back(table_of(measured, knob));
  }
  if (auto error = add_figure(blocks, boards_plot(measured.boards))) return std::move(*error);
  blocks.emplace_back(boards_table(measured.boards));
  return blocks;
}

}  // namespace sightline::harness::report
