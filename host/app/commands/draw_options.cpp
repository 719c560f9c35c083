// The options that the methods of `sightline draw` share.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

#include "host/app/commands/draw.hpp"
#include "host/base/number.hpp"
#include "host/picture/png.hpp"

namespace sightline::app {

namespace {

// --- where to

constexpr double widest_paper = 10'000;  // millimetres

std::pair<int, int> size_argument(const char* option, const std::string& text, int most) {
  if (const auto size = base::whole_numbers<int, 2>(text, 'x', 1, most)) return {(*size)[0], (*size)[1]};
  throw Failure(ExitCode::usage,
                fmt::format("{}: found \"{}\", expected WIDTHxHEIGHT, both 1 to {}", option, text, most));
}

std::optional<DrawingFormat> format_of(const std::string& file) {
  const std::size_t dot = file.rfind('.');
  std::string ending = dot == std::string::npos ? std::string() : file.substr(dot);
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".svg") return DrawingFormat::svg;
  if (ending == ".png") return DrawingFormat::png;
  if (ending == ".plt" || ending == ".hpgl") return DrawingFormat::hpgl;
  return std::nullopt;
}

void refuse_sizes_of_others(const DrawOutput& output, DrawingFormat format) {
  constexpr std::string_view on_paper = "a name that ends in .svg, .plt or .hpgl";
  if (format != DrawingFormat::png) {
    refuse_option(output, "--pixels", "a name that ends in .png");
  } else {
    refuse_option(output, "--size", on_paper);
    refuse_option(output, "--margin", on_paper);
  }
  if (format != DrawingFormat::svg) refuse_option(output, "--pen", "a name that ends in .svg");
}

}  // namespace

void add_draw_output_options(const Command& command, DrawOutput& output) {
  output.command = command;
  command
      .option("-o,--output", output.file,
              "The drawing; the ending says what it is: .svg, .png, .plt or .hpgl")
      .required()
      .value("FILE");
  command.option("--size", output.size, "Size of the paper in mm, for .svg, .plt and .hpgl")
      .default_value()
      .value("WxH");
  command.option("--margin", output.paper.margin, "Margin around the drawing in mm, for .svg, .plt and .hpgl")
      .default_value()
      .range(0.0, 1000.0)
      .value("MM");
  command.option("--pen", output.paper.pen, "Width of a line in mm, for .svg")
      .default_value()
      .range(0.01, 10.0)
      .value("MM");
  command.option("--pixels", output.pixels, "Size of the image, for .png").default_value().value("WxH");
}

void refuse_option(const DrawOutput& output, const std::string& option, std::string_view needed) {
  if (output.command->is_given(option))
    throw Failure(ExitCode::usage, fmt::format("{}: found without {}", option, needed));
}

DrawingFormat read_draw_output(DrawOutput& output) {
  const auto format = format_of(output.file);
  if (!format)
    throw Failure(ExitCode::usage,
                  fmt::format("{}: expected a name that ends in .svg, .png, .plt or .hpgl", output.file));
  refuse_sizes_of_others(output, *format);
  const auto [width, height] = size_argument("--size", output.size, static_cast<int>(widest_paper));
  output.paper.width = width;
  output.paper.height = height;
  // A value that is not a number (nan) passes the ranges of the options.
  if (!std::isfinite(output.paper.margin) || !std::isfinite(output.paper.pen)) {
    throw Failure(ExitCode::usage, fmt::format("{}: found no number, expected millimetres",
                                               std::isfinite(output.paper.pen) ? "--margin" : "--pen"));
  }
  if (2 * output.paper.margin >= std::min(width, height)) {
    throw Failure(ExitCode::usage, fmt::format("--margin: found {} mm on both sides of {}, expected less",
                                               output.paper.margin, output.size));
  }
  const auto [columns, rows] = size_argument("--pixels", output.pixels, picture::png_size_limit);
  output.image.width = columns;
  output.image.height = rows;
  return *format;
}

void write_drawing(const picture::VectorDrawing& drawing, const DrawOutput& output, DrawingFormat format,
                   const std::string& title, Output& file) {
  if (drawing.lines.empty() && drawing.facets.empty())
    warn(fmt::format("{}: the drawing is empty, nothing is in view", output.file));
  if (format == DrawingFormat::svg) {
    file.write(std::string_view(svg_of(drawing, output.paper, title)));
  } else if (format == DrawingFormat::hpgl) {
    file.write(std::string_view(hpgl_of(drawing, output.paper)));
  } else {
    const auto bytes =
        picture::encode_png(image_of(drawing, output.image), {{"Title", title}, {"Software", "sightline"}});
    if (!bytes) throw Failure(ExitCode::io, bytes.error().message());
    file.write(std::span<const std::uint8_t>(*bytes));
  }
  file.commit();
}

}  // namespace sightline::app
