// The options that the methods of `sightline draw` share.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "host/app/commands/draw.hpp"
#include "host/base/json.hpp"
#include "host/base/number.hpp"
#include "host/picture/dxf.hpp"
#include "host/picture/pdf.hpp"
#include "host/picture/pen_order.hpp"
#include "host/picture/png.hpp"
#include "host/picture/step_file.hpp"

namespace sightline::app {

namespace {

// --- where to

constexpr std::string_view calcomp = "calcomp";
constexpr double widest_paper = 10'000;  // millimetres

std::pair<int, int> size_argument(const char* option, const std::string& text, int most) {
  if (const auto size = base::whole_numbers<int, 2>(text, 'x', 1, most)) return {(*size)[0], (*size)[1]};
  throw Failure(ExitCode::usage,
                fmt::format("{}: found \"{}\", expected WIDTHxHEIGHT, both 1 to {}", option, text, most));
}

constexpr std::string_view format_endings = ".svg, .png, .plt, .hpgl, .pdf, .dxf or .steps";

std::optional<DrawingFormat> format_of(const DrawOutput& output) {
  std::string ending = output.format;
  if (ending.empty() && output.file == "-") return DrawingFormat::svg;
  if (ending.empty()) {
    const std::size_t dot = output.file.rfind('.');
    ending = dot == std::string::npos ? std::string() : output.file.substr(dot + 1);
  }
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == "svg") return DrawingFormat::svg;
  if (ending == "png") return DrawingFormat::png;
  if (ending == "plt" || ending == "hpgl") return DrawingFormat::hpgl;
  if (ending == "pdf") return DrawingFormat::pdf;
  if (ending == "dxf") return DrawingFormat::dxf;
  if (ending == "steps") return DrawingFormat::steps;
  return std::nullopt;
}

void refuse_options_of_others(const DrawOutput& output, DrawingFormat format) {
  constexpr std::string_view on_paper = "--size, or a name that does not end in .png";
  constexpr std::string_view with_pens = "a name that does not end in .png";
  constexpr std::string_view of_plotters = "a name that ends in .plt or .hpgl";
  if (format != DrawingFormat::png) {
    for (const char* option : {"--pixels", "--dpi"}) refuse_option(output, option, "a name that ends in .png");
  } else if (output.is_sheet()) {
    if (output.command->is_given("--pixels"))
      throw Failure(ExitCode::usage, "--pixels: found with --size, which --dpi makes pixels");
  } else {
    for (const char* option : {"--margin", "--landscape", "--dpi"}) refuse_option(output, option, on_paper);
  }
  if (format == DrawingFormat::png)
    for (const char* option : {"--as-found", "--min-gap", "--plot-report"}) refuse_option(output, option, with_pens);
  if (format != DrawingFormat::hpgl)
    for (const char* option : {"--pens", "--speed", "--relative"}) refuse_option(output, option, of_plotters);
  if (format != DrawingFormat::hpgl && format != DrawingFormat::steps) refuse_option(output, "--device", of_plotters);
  if (format == DrawingFormat::hpgl || format == DrawingFormat::steps || format == DrawingFormat::dxf ||
      (format == DrawingFormat::png && !output.is_sheet()))
    refuse_option(output, "--pen", "a name that ends in .svg or .pdf");
}

struct PaperSize {
  std::string_view name;
  double width, height;  // mm, upright
};
// ISO 216 and ANSI Y14.1.
constexpr std::array paper_sizes{
    PaperSize{"A0", 841, 1189}, PaperSize{"A1", 594, 841},           PaperSize{"A2", 420, 594},
    PaperSize{"A3", 297, 420},  PaperSize{"A4", 210, 297},           PaperSize{"A5", 148, 210},
    PaperSize{"A6", 105, 148},  PaperSize{"Letter", 215.9, 279.4},   PaperSize{"Legal", 215.9, 355.6},
    PaperSize{"Tabloid", 279.4, 431.8},
};

bool same_letters(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [small](char c, char d) { return small(c) == small(d); });
}

void read_paper(DrawOutput& output) {
  picture::Paper& paper = output.paper;
  std::string names;
  for (const PaperSize& size : paper_sizes) {
    names += std::string(size.name) + ", ";
    if (!same_letters(size.name, output.size)) continue;
    paper.width = size.width;
    paper.height = size.height;
    if (output.landscape) std::swap(paper.width, paper.height);
    return;
  }
  std::string_view text = output.size;
  double unit = 1;
  if (text.ends_with("in")) {
    unit = 25.4;
    text.remove_suffix(2);
  } else if (text.ends_with("mm")) {
    text.remove_suffix(2);
  }
  const std::size_t cross = text.find('x');
  const auto width = base::fixed_number(text.substr(0, cross), 1, widest_paper);
  const auto height = cross == std::string_view::npos
                          ? std::nullopt
                          : base::fixed_number(text.substr(cross + 1), 1, widest_paper);
  if (!width || !height) {
    throw Failure(
        ExitCode::usage,
        fmt::format(
            "--size: found \"{}\", expected {}or WIDTHxHEIGHT in mm, both 1 to {}; 8x10in is in inches",
            output.size, names, widest_paper));
  }
  paper.width = *width * unit;
  paper.height = *height * unit;
  if (output.landscape && paper.width < paper.height) std::swap(paper.width, paper.height);
}

}  // namespace

bool DrawOutput::is_sheet() const {
  return command->is_given("--size");
}

const picture::Plotter* DrawOutput::plotter() const {
  return device.empty() ? nullptr : picture::find_plotter(device);
}

void add_draw_output_options(const Command& command, DrawOutput& output) {
  output.command = command;
  command
      .option("-o,--output", output.file,
              fmt::format("The drawing; the ending says what it is: {}; - is standard output, SVG unless "
                          "--format says otherwise",
                          format_endings))
      .required()
      .value("FILE");
  command.option("--format", output.format, "What it is, whatever its name")
      .one_of({"svg", "png", "plt", "pdf", "dxf", "steps"})
      .default_value("as the name says");
  command
      .option("--size", output.size,
              "Size of the paper: A0 to A6, Letter, Legal, Tabloid, or WIDTHxHEIGHT in mm, or in inches as "
              "8x10in")
      .default_value()
      .value("SIZE")
      .group("Paper");
  command.flag("--landscape", output.landscape, "The longer side of the paper is horizontal").group("Paper");
  command.option("--margin", output.paper.margin, "Margin around the drawing in mm")
      .default_value("10, or as much as the plotter needs")
      .range(0.0, 1000.0)
      .value("MM")
      .group("Paper");
  command.option("--pen", output.paper.pen, "Width of a line in mm, for .svg and .pdf, and .png with --size")
      .default_value()
      .range(0.01, 10.0)
      .value("MM")
      .group("Pen");
  command
      .option("--min-gap", output.min_gap,
              "Draw over gaps between lines that are shorter than this, in mm, so that the pen stays down")
      .default_value()
      .range(0.0, 10.0)
      .value("MM")
      .group("Pen");
  command
      .flag("--as-found", output.as_found,
            "Lines in the order they were found in, not in that of a pen, which travels little in the air")
      .group("Pen");
  std::vector<std::string> devices;
  for (const picture::Plotter& plotter : picture::plotters()) devices.emplace_back(plotter.name);
  command.option("--device", output.device, "A plotter whose limits and number of pens are kept")
      .one_of(devices)
      .default_value("any")
      .group("Pen");
  command.option("--pens", output.pens, "The pens of the layers in their order")
      .default_value("1,2,3 and so on")
      .separated_by(',')
      .value("N,...")
      .group("Pen");
  command.option("--speed", output.speed, "Of the lowered pen in cm/s, for .plt")
      .default_value("the plotter's own")
      .range(0.1, 110.0)
      .value("SPEED")
      .group("Pen");
  command.flag("--relative", output.relative, "HP-GL with distances from point to point").group("Pen");
  command.flag("--plot-report", output.report, "Say how far the pen travels and how long that takes").group("Pen");
  command.option("--pixels", output.pixels, "Size of the image, for .png").default_value().value("WxH");
  command.option("--dpi", output.dpi, "Pixels of an inch, for .png with --size").default_value().range(10.0, 2400.0).value("N");
}

void refuse_option(const DrawOutput& output, const std::string& option, std::string_view needed) {
  if (output.command->is_given(option))
    throw Failure(ExitCode::usage, fmt::format("{}: found without {}", option, needed));
}

DrawingFormat read_draw_output(DrawOutput& output) {
  const auto format = format_of(output);
  if (!format)
    throw Failure(ExitCode::usage, fmt::format("{}: expected a name that ends in {}, or --format", output.file, format_endings));
  if (*format == DrawingFormat::steps && output.device.empty()) output.device = calcomp;
  if ((output.device == calcomp) != (*format == DrawingFormat::steps)) {
    throw Failure(
        ExitCode::usage,
        output.device == calcomp
            ? fmt::format("{}: expected a name that ends in .steps for the CalComp, or --format steps",
                          output.file)
            : fmt::format("--device: found {} with a step file, which is for calcomp", output.device));
  }
  refuse_options_of_others(output, *format);
  read_paper(output);
  picture::Paper& paper = output.paper;
  // A value that is not a number (nan) passes the ranges of the options.
  require_finite("--margin", paper.margin);
  require_finite("--pen", paper.pen);
  require_finite("--min-gap", output.min_gap);
  if (const picture::Plotter* plotter = output.plotter()) {
    const auto least = picture::least_margin(*plotter, paper);
    if (!least) throw Failure(ExitCode::usage, least.error().message());
    if (!output.command->is_given("--margin")) paper.margin = std::max(paper.margin, *least);
    if (paper.margin < *least)
      throw Failure(ExitCode::usage,
                    fmt::format("--margin: found {:g} mm, expected {:g} or more, where the {} can draw",
                                paper.margin, *least, plotter->name));
  }
  const int most_pens = output.plotter() != nullptr ? output.plotter()->pens : picture::most_hpgl_pens;
  for (const int pen : output.pens) {
    if (pen < 1 || pen > most_pens)
      throw Failure(ExitCode::usage, fmt::format("--pens: found {}, expected 1 to {}", pen, most_pens));
  }
  if (2 * paper.margin >= std::min(paper.width, paper.height)) {
    throw Failure(ExitCode::usage, fmt::format("--margin: found {} mm on both sides of {}, expected less",
                                               paper.margin, output.size));
  }
  const auto [columns, rows] = size_argument("--pixels", output.pixels, picture::png_size_limit);
  output.image.width = columns;
  output.image.height = rows;
  if (*format == DrawingFormat::png && output.is_sheet()) {
    require_finite("--dpi", output.dpi);
    constexpr double inch = 25.4;
    const auto pixels = [&](double length) { return static_cast<int>(std::lround(length / inch * output.dpi)); };
    output.image = {pixels(paper.width), pixels(paper.height), paper.pen / inch * output.dpi};
    if (std::max(output.image.width, output.image.height) > picture::png_size_limit)
      throw Failure(
          ExitCode::usage,
          fmt::format("--dpi: found {}, which makes {} x {} pixels, expected at most {} a side", output.dpi,
                      output.image.width, output.image.height, picture::png_size_limit));
  }
  return *format;
}

namespace {

// `counted`: the seconds, where the file itself says them.
base::Json plot_json(const picture::VectorDrawing& drawing, const DrawOutput& output, std::optional<double> counted) {
  const picture::PenTravel travel = picture::pen_travel(drawing, output.paper);
  const picture::Plotter& plotter = output.plotter() != nullptr ? *output.plotter() : picture::plotters().front();
  picture::PlotterSpeeds speeds = plotter.speeds;
  if (output.speed) speeds.down = std::min(speeds.down, 10 * *output.speed);
  const auto metres = [](double millimetres) { return std::round(millimetres) / 1000; };
  return {{"pen_down_m", metres(travel.down)},
          {"pen_up_m", metres(travel.up)},
          {"lifts", travel.lifts},
          {"pens", travel.pens},
          {"plotter", plotter.name},
          {"seconds", std::round(10 * counted.value_or(plot_seconds(drawing, output.paper, speeds))) / 10}};
}

}  // namespace

std::optional<base::Json> write_drawing(const picture::VectorDrawing& found, const DrawOutput& output, DrawingFormat format,
                                        const std::string& title, Output& file) {
  if (found.lines.empty() && found.facets.empty())
    warn(fmt::format("{}: the drawing is empty, nothing is in view", output.file));
  if (format == DrawingFormat::png) {
    const picture::VectorDrawing dashed = with_dashes(found);
    const auto bytes = picture::encode_png(image_of(output.is_sheet() ? with_margin(dashed, output.paper) : dashed, output.image),
                                           {{"Title", title}, {"Software", "sightline"}});
    if (!bytes) throw Failure(ExitCode::io, bytes.error().message());
    file.write(std::span<const std::uint8_t>(*bytes));
    file.commit();
    return std::nullopt;
  }
  // DXF has dashed lines of its own.
  const picture::VectorDrawing lines = format == DrawingFormat::dxf ? found : with_dashes(found);
  const picture::VectorDrawing drawing =
      output.as_found ? lines : in_pen_order(lines, output.paper, {.min_gap = output.min_gap});
  std::optional<double> seconds;
  switch (format) {
    case DrawingFormat::png: break;
    case DrawingFormat::svg: file.write(std::string_view(svg_of(drawing, output.paper, title))); break;
    case DrawingFormat::pdf: file.write(std::string_view(pdf_of(drawing, output.paper, title))); break;
    case DrawingFormat::dxf: file.write(std::string_view(dxf_of(drawing, output.paper))); break;
    case DrawingFormat::steps: {
      const std::string steps = step_file_of(drawing, output.paper);
      file.write(std::string_view(steps));
      seconds = picture::step_file_time(steps).seconds;
      break;
    }
    case DrawingFormat::hpgl: {
      const picture::HpglOptions options{output.plotter(), output.pens, output.speed, output.relative};
      file.write(std::string_view(hpgl_of(drawing, output.paper, options)));
      break;
    }
  }
  file.commit();
  base::Json plot = plot_json(drawing, output, seconds);
  if (output.report) {
    complain(fmt::format(
        "{}: {} m drawn, {} m in the air, {} lifts; {} s on a {}", output.file, plot["pen_down_m"].dump(),
        plot["pen_up_m"].dump(), plot["lifts"].dump(), plot["seconds"].dump(),
        std::string(output.plotter() != nullptr ? output.device : picture::plotters().front().name)));
  }
  return plot;
}

}  // namespace sightline::app
