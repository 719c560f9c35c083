// See run_i8080_outputs.hpp.
#include "host/app/run_i8080_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "host/picture/png.hpp"

namespace sightline::app {

namespace {

// Row 0 of the image is the top one. Bit 2 of a point is red, bit 1 green, bit 0 blue, as the board's latch
// has them; in grey the eight values are eight levels.
picture::Image image_of(const core::Raster& raster, bool grey) {
  picture::Image image(core::Raster::width, core::Raster::height, grey ? 1 : 3);
  const auto byte = [](unsigned value, unsigned most) {
    return static_cast<std::uint8_t>(255U * value / most);
  };
  std::size_t i = 0;
  for (int y = core::Raster::height - 1; y >= 0; --y) {
    for (const unsigned point : raster.row(static_cast<std::uint8_t>(y))) {
      if (grey) {
        image.pixels[i++] = byte(point, 7);
        continue;
      }
      for (const unsigned bit : {2U, 1U, 0U}) image.pixels[i++] = byte(point >> bit & 1U, 1);
    }
  }
  return image;
}

void write_png(Output& output, const picture::Image& image, core::TStateInstant end) {
  const auto bytes =
      picture::encode_png(image, {{"Software", "sightline " SIGHTLINE_VERSION},
                                  {"End of run", fmt::format("T-state {}", core::t_states_of(end))}});
  if (!bytes) throw Failure(ExitCode::io, bytes.error().message());
  output.write(std::span<const std::uint8_t>(*bytes));
}

}  // namespace

RunI8080Outputs::RunI8080Outputs(const RunI8080Arguments& arguments) : grey_(arguments.grey) {
  std::string console = arguments.console;
  if (arguments.cpm && console.empty()) {
    if (arguments.json) {
      kept_console_.emplace();
    } else {
      console = "-";
    }
  }
  const std::vector<std::pair<const std::string*, std::optional<Output>*>> files{
      {&arguments.dump, &dump_},
      {&arguments.trace, &trace_},
      {&arguments.bus, &bus_},
      {&console, &console_},
      {&arguments.png, &png_},
      {&arguments.strokes, &strokes_},
      {&arguments.parallel_out, &parallel_out_},
      {&arguments.serial_out, &serial_out_}};
  std::vector<std::string> named;
  for (const auto& [path, output] : files) {
    if (path->empty()) continue;
    if (std::find(named.begin(), named.end(), *path) != named.end()) {
      throw Failure(ExitCode::usage,
                    *path == "-" && arguments.cpm && arguments.console.empty()
                        ? "-: standard output has what the program prints; --console FILE puts that elsewhere"
                        : fmt::format("{}: named for two outputs", *path));
    }
    named.push_back(*path);
    uses_stdout_ = uses_stdout_ || *path == "-";
  }
  if (uses_stdout_ && arguments.json)
    throw Failure(ExitCode::usage, "--json needs standard output; an output cannot be `-`");
  for (const auto& [path, output] : files) {
    if (!path->empty()) output->emplace(*path);
  }
}

void RunI8080Outputs::attach(harness::I8080Job& job) {
  const auto write_to = [](Output& output) {
    return [&output](std::string_view text) { output.write(text); };
  };
  if (trace_) job.trace = write_to(*trace_);
  if (bus_) job.bus = write_to(*bus_);
  if (strokes_) job.strokes = write_to(*strokes_);
  if (console_) job.console = write_to(*console_);
  if (kept_console_) job.console = [this](std::string_view text) { *kept_console_ += text; };
}

void RunI8080Outputs::write(const harness::I8080Report& report) {
  if (dump_) dump_->write(harness::dump_text(report));
  if (png_ && report.raster) write_png(*png_, image_of(*report.raster, grey_), report.end);
  if (parallel_out_) parallel_out_->write(std::span<const std::uint8_t>(report.parallel_received));
  if (serial_out_) serial_out_->write(std::span<const std::uint8_t>(report.serial_received));
  for (auto* output : {&dump_, &trace_, &bus_, &console_, &png_, &strokes_, &parallel_out_, &serial_out_}) {
    if (*output) (*output)->commit();
  }
}

}  // namespace sightline::app
