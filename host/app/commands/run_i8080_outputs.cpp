// See run_i8080_outputs.hpp.
#include "host/app/commands/run_i8080_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "host/app/outputs.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/raster_image.hpp"

namespace sightline::app {

namespace {

constexpr std::size_t most_kept_of_console = std::size_t{1} << 24;

constexpr std::string_view printed_on_stdout =
    "-: standard output has what the program prints; --console FILE puts that elsewhere";

// The paper is as large as the drawing needs, from step (0, 0) on.
std::string svg_of(const harness::I8080Report& report, picture::PlotterPaper paper) {
  for (const picture::PenPath& path : report.drawing) {
    for (const picture::PenPoint corner : path.corners)
      paper.steps = std::max({paper.steps, corner.x + 1, corner.y + 1});
  }
  if (report.drawing_left_out != 0)
    warn(fmt::format("the drawing lacks the last {} marks of the pen", report.drawing_left_out));
  return picture::pen_svg(report.drawing, paper,
                          fmt::format("8080: plotter at T-state {}", core::t_states_of(report.end)));
}

}  // namespace

RunI8080Outputs::RunI8080Outputs(const RunI8080Arguments& arguments)
    : grey_(arguments.grey), minigraf_(arguments.plotter == "minigraf") {
  std::string console = arguments.console;
  if (arguments.cpm && console.empty()) {
    if (arguments.json) {
      kept_console_.emplace();
    } else {
      console.assign(1, '-');  // a literal makes g++ 12 warn of an overlap there is not
    }
  }
  const std::array<NamedOutput, 9> files{{{&arguments.dump, &dump_},
                                          {&arguments.trace, &trace_},
                                          {&arguments.bus, &bus_},
                                          {&console, &console_},
                                          {&arguments.png, &png_},
                                          {&arguments.strokes, &strokes_},
                                          {&arguments.svg, &svg_},
                                          {&arguments.parallel_out, &parallel_out_},
                                          {&arguments.serial_out, &serial_out_}}};
  uses_stdout_ = arguments.cpm && arguments.console.empty()
                     ? open_outputs(files, arguments.json, printed_on_stdout)
                     : open_outputs(files, arguments.json);
}

void RunI8080Outputs::attach(harness::I8080Job& job) {
  const auto write_to = [](Output& output) {
    return [&output](std::string_view text) { output.write(text); };
  };
  if (trace_) job.trace = write_to(*trace_);
  if (bus_) job.bus = write_to(*bus_);
  if (strokes_) job.strokes = write_to(*strokes_);
  job.drawing = svg_.has_value();
  if (console_) job.console = write_to(*console_);
  if (kept_console_) job.console = [this](std::string_view text) { keep(text); };
}

void RunI8080Outputs::keep(std::string_view printed) {
  const std::size_t room = most_kept_of_console - kept_console_->size();
  const std::string_view kept = printed.substr(0, room);
  *kept_console_ += kept;
  console_left_out_ += printed.size() - kept.size();
}

void RunI8080Outputs::write(const harness::I8080Report& report) {
  if (console_left_out_ != 0)
    warn(fmt::format("the report's \"console\" lacks the last {} bytes printed; --console FILE takes all",
                     console_left_out_));
  if (dump_) dump_->write(harness::dump_text(report));
  if (png_ && report.raster) {
    const auto palette = grey_ ? picture::RasterPalette::grey : picture::RasterPalette::colour;
    write_png(*png_, picture::raster_image(*report.raster, palette, 1),
              {{"Software", "sightline " SIGHTLINE_VERSION},
               {"End of run", fmt::format("T-state {}", core::t_states_of(report.end))}});
  }
  if (svg_) svg_->write(svg_of(report, minigraf_ ? picture::minigraf_paper : picture::calcomp_paper));
  if (parallel_out_) parallel_out_->write(std::span<const std::uint8_t>(report.parallel_received));
  if (serial_out_) serial_out_->write(std::span<const std::uint8_t>(report.serial_received));
  for (auto* output :
       {&dump_, &trace_, &bus_, &console_, &png_, &strokes_, &svg_, &parallel_out_, &serial_out_}) {
    if (*output) (*output)->commit();
  }
}

}  // namespace sightline::app
