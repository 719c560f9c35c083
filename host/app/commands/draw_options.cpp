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
#include "host/base/text.hpp"
#include "host/picture/png.hpp"

namespace sightline::app {

namespace {

// --- Output

constexpr std::string_view calcomp = "calcomp";
constexpr double widest_paper = 10'000;  // millimetres

std::pair<int, int> size_argument(const char* option, const std::string& text, int most) {
  if (const auto size = base::whole_numbers<int, 2>(text, 'x', 1, most)) return {(*size)[0], (*size)[1]};
  throw base::usage_error(fmt::format("{}: found \"{}\", expected WIDTHxHEIGHT, both 1 to {}", option, text, most));
}

constexpr std::string_view format_endings = ".svg, .png, .plt, .hpgl, .pdf, .dxf or .steps";

std::optional<hidden_lines::Format> format_of(const DrawOutput& output) {
  if (output.format.empty() && output.file == "-") return hidden_lines::Format::svg;
  if (!output.format.empty()) return hidden_lines::format_named(output.format);
  const std::size_t dot = output.file.rfind('.');
  return dot == std::string::npos ? std::nullopt : hidden_lines::format_named(std::string_view(output.file).substr(dot + 1));
}

void reject_options_of_others(const DrawOutput& output, hidden_lines::Format format) {
  constexpr std::string_view on_paper = "--size, or a name that does not end in .png";
  constexpr std::string_view with_pens = "a name that does not end in .png";
  constexpr std::string_view of_plotters = "a name that ends in .plt or .hpgl";
  if (format != hidden_lines::Format::png) {
    for (const char* option : {"--pixels", "--dpi"}) reject_option(output, option, "a name that ends in .png");
  } else if (output.is_sheet()) {
    if (output.command->is_given("--pixels"))
      throw base::usage_error("--pixels: found with --size, which --dpi makes pixels");
  } else {
    for (const char* option : {"--margin", "--landscape", "--dpi"}) reject_option(output, option, on_paper);
  }
  if (format == hidden_lines::Format::png)
    for (const char* option : {"--as-found", "--min-gap", "--plot-report"}) reject_option(output, option, with_pens);
  if (format != hidden_lines::Format::hpgl)
    for (const char* option : {"--pens", "--speed", "--relative"}) reject_option(output, option, of_plotters);
  if (format != hidden_lines::Format::hpgl && format != hidden_lines::Format::steps) reject_option(output, "--device", of_plotters);
  if (format == hidden_lines::Format::hpgl || format == hidden_lines::Format::steps || format == hidden_lines::Format::dxf ||
      (format == hidden_lines::Format::png && !output.is_sheet()))
    reject_option(output, "--pen", "a name that ends in .svg or .pdf");
}

struct PaperSize {
  std::string_view name;
  double width, height;  // mm, portrait
};
// ISO 216 and ANSI Y14.1.
constexpr std::array paper_sizes{
    PaperSize{"A0", 841, 1189}, PaperSize{"A1", 594, 841},           PaperSize{"A2", 420, 594},
    PaperSize{"A3", 297, 420},  PaperSize{"A4", 210, 297},           PaperSize{"A5", 148, 210},
    PaperSize{"A6", 105, 148},  PaperSize{"Letter", 215.9, 279.4},   PaperSize{"Legal", 215.9, 355.6},
    PaperSize{"Tabloid", 279.4, 431.8},
};

void read_paper(DrawOutput& output) {
  picture::Paper& paper = output.paper;
  if (output.command->is_given("--device") && !output.command->is_given("--size")) {
    const picture::PlotterPaperLimits& usual = output.plotter()->papers.front();
    output.size = usual.paper;
    paper.width = usual.width;
    paper.height = usual.height;
    return;
  }
  std::string names;
  for (const PaperSize& size : paper_sizes) {
    names += std::string(size.name) + ", ";
    if (base::lower_case(size.name) != base::lower_case(output.size)) continue;
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
    throw base::usage_error(fmt::format(
            "--size: found \"{}\", expected {}or WIDTHxHEIGHT in mm, both 1 to {}; 8x10in is in inches",
            output.size, names, widest_paper));
  }
  paper.width = *width * unit;
  paper.height = *height * unit;
  if (output.landscape && paper.width < paper.height) std::swap(paper.width, paper.height);
}

// The part of a sheet that a drawing with a scale can use. A plotter's limits are its margins, which differ by axis; there is no
// other margin unless --margin is given.
std::array<double, 2> room_of(const DrawOutput& output, const picture::Paper& paper) {
  std::array<double, 2> room{paper.width - 2 * output.margin, paper.height - 2 * output.margin};
  if (output.plotter() == nullptr) return room;
  const auto area = picture::plotting_area(*output.plotter(), paper);
  if (!area) return {};
  if (!output.command->is_given("--margin")) return *area;
  for (std::size_t a = 0; a < 2; ++a) room[a] = std::min(room[a], (*area)[a]);
  return room;
}

// Sets the margin: --margin, which must be wide enough for the plotter, or the wider of the default and what the plotter needs. With a
// scale, the drawing may fill all of room_of() instead.
void read_margin(DrawOutput& output) {
  picture::Paper& paper = output.paper;
  const picture::Plotter* const plotter = output.plotter();
  paper.margin = output.margin;
  if (plotter != nullptr && output.scale.empty()) {
    const auto least = picture::least_margin(*plotter, paper);
    if (!least) throw base::usage_error(least.error().message());
    if (!output.command->is_given("--margin")) paper.margin = std::max(paper.margin, *least);
    if (paper.margin < *least)
      throw base::usage_error(fmt::format("--margin: found {:g} mm, expected {:g} or more, where the {} can draw",
                                paper.margin, *least, plotter->name));
  }
  if (2 * paper.margin >= std::min(paper.width, paper.height)) {
    throw base::usage_error(fmt::format("--margin: found {} mm on both sides of {}, expected less",
                                               paper.margin, output.size));
  }
  if (output.scale.empty()) return;
  output.room = room_of(output, paper);
  if (plotter != nullptr) {
    const auto area = picture::plotting_area(*plotter, paper);
    if (!area) throw base::usage_error(area.error().message());
  }
  paper.margin = 0;
}

picture::HpglOptions hpgl_options(const DrawOutput& output) {
  return {output.plotter(), output.pens, output.speed, output.relative};
}

void warn_of_speed(const DrawOutput& output) {
  const auto reached = picture::reachable_speed(hpgl_options(output));
  if (reached == output.speed) return;
  warn(fmt::format("--speed: found {:g} cm/s, which {} does not reach: the file says {:g}", *output.speed, output.plotter()->name,
                   *reached));
}

// "a", "a and b", "a, b, c and 5 more"
std::string list_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 4;
  if (names.size() == 1) return names[0];
  const std::size_t shown = names.size() > most ? most - 1 : names.size() - 1;
  const std::vector<std::string> first(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown));
  return base::joined(first, ", ") + " and " + (names.size() > most ? fmt::format("{} more", names.size() - shown) : names.back());
}

// Warns of more layers than pens, and of pens without a layer.
void warn_of_pens(const std::vector<std::string>& labels, const DrawOutput& output) {
  const picture::Plotter* const plotter = output.plotter();
  const picture::HpglOptions options = hpgl_options(output);
  const std::size_t layers = labels.size();
  const std::size_t pens = picture::pen_count(options);
  const std::string count = fmt::format("{}: {} layer{} for {}{} pen{}{}", output.file, layers, layers == 1 ? "" : "s",
                                        output.pens.empty() && plotter == nullptr ? "" : "the ", pens == 1 ? "one" : std::to_string(pens),
                                        pens == 1 ? "" : "s",
                                        !output.pens.empty()  ? " of --pens"
                                        : plotter != nullptr ? fmt::format(" of {}", plotter->name)
                                                             : std::string());
  if (layers > pens) {
    const int last = picture::pen_of_layer(layers - 1, options);
    std::vector<std::string> sharing;
    for (std::size_t layer = 0; layer < layers; ++layer)
      if (picture::pen_of_layer(layer, options) == last) sharing.push_back(labels[layer]);
    warn(fmt::format("{}: {} share {}", count, list_of(sharing), pens == 1 ? std::string("it") : fmt::format("pen {}", last)));
  } else if (!output.pens.empty() && layers < pens && layers > 0) {
    std::vector<std::string> idle;
    for (std::size_t i = layers; i < pens; ++i) idle.push_back(std::to_string(output.pens[i]));
    warn(fmt::format("{}: pen{} {} draw{} nothing", count, idle.size() == 1 ? "" : "s", list_of(idle), idle.size() == 1 ? "s" : ""));
  }
}

base::Json plot_json(const hidden_lines::PenPlot& plot) {
  const auto metres = [](double millimetres) { return std::round(millimetres) / 1000; };
  return {{"pen_down_m", metres(plot.down)}, {"pen_up_m", metres(plot.up)}, {"lifts", plot.lifts},
          {"pens", plot.pens},               {"plotter", plot.plotter},     {"seconds", std::round(10 * plot.seconds) / 10}};
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
              fmt::format("The drawing; the extension selects the format: {}; - is standard output, in SVG unless "
                          "--format is given",
                          format_endings))
      .required()
      .value("FILE");
  command.option("--format", output.format, "Format of the drawing, whatever its name")
      .one_of({"svg", "png", "plt", "pdf", "dxf", "steps"})
      .default_value("by the extension");
  command
      .option("--size", output.size,
              "Size of the paper: A0 to A6, Letter, Legal, Tabloid, or WIDTHxHEIGHT in mm, or in inches as "
              "8x10in")
      .default_value()
      .value("SIZE")
      .group("Paper");
  command.flag("--landscape", output.landscape, "The longer side of the paper is horizontal").group("Paper");
  command.option("--margin", output.margin, "Margin around the drawing in mm")
      .default_value("10, or what the plotter needs")
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
              "Keep the pen down across gaps between lines that are shorter than this, in mm")
      .default_value()
      .range(0.0, 10.0)
      .value("MM")
      .group("Pen");
  command
      .flag("--as-found", output.as_found,
            "Keep the order in which the lines were found; otherwise they are ordered so that the raised pen travels little")
      .group("Pen");
  std::vector<std::string> devices;
  for (const picture::Plotter& plotter : picture::plotters()) devices.emplace_back(plotter.name);
  command.option("--device", output.device, "Observe the limits and the number of pens of this plotter; its own paper unless --size is given")
      .one_of(devices)
      .default_value("any")
      .group("Pen");
  command.option("--pens", output.pens, "The pens of the layers, in order; the last one also draws all further layers")
      .default_value("1,2,3 and so on, as many as there are")
      .separated_by(',')
      .value("N,...")
      .group("Pen");
  command.option("--speed", output.speed, "Speed of the lowered pen in cm/s, for .plt")
      .default_value("the plotter's own")
      .range(0.1, 110.0)
      .value("SPEED")
      .group("Pen");
  command.flag("--relative", output.relative, "Write HP-GL with relative coordinates").group("Pen");
  command.flag("--plot-report", output.report, "Report how far the pen travels and how long that takes").group("Pen");
  command.option("--pixels", output.pixels, "Size of the image, for .png").default_value().value("WxH");
  command.option("--dpi", output.dpi, "Pixels per inch, for .png with --size").default_value().range(10.0, 2400.0).value("N");
}

void reject_option(const DrawOutput& output, const std::string& option, std::string_view needed) {
  if (output.command->is_given(option))
    throw base::usage_error(fmt::format("{}: found without {}", option, needed));
}

hidden_lines::Format read_draw_output(DrawOutput& output) {
  const auto format = format_of(output);
  if (!format)
    throw base::usage_error(fmt::format("{}: expected a name that ends in {}, or --format", output.file, format_endings));
  if (*format == hidden_lines::Format::steps && output.device.empty()) output.device = calcomp;
  if ((output.device == calcomp) != (*format == hidden_lines::Format::steps)) {
    throw base::usage_error(output.device == calcomp
            ? fmt::format("{}: expected a name that ends in .steps for the CalComp, or --format steps",
                          output.file)
            : fmt::format("--device: found {} with a step file, which is for calcomp", output.device));
  }
  reject_options_of_others(output, *format);
  read_paper(output);
  picture::Paper& paper = output.paper;
  // nan passes the range checks of the options.
  require_finite("--margin", output.margin);
  require_finite("--pen", paper.pen);
  require_finite("--min-gap", output.min_gap);
  const int most_pens = output.plotter() != nullptr ? output.plotter()->pens : picture::most_hpgl_pens;
  for (const int pen : output.pens) {
    if (pen < 1 || pen > most_pens)
      throw base::usage_error(fmt::format("--pens: found {}, expected 1 to {}", pen, most_pens));
  }
  read_margin(output);
  const auto [columns, rows] = size_argument("--pixels", output.pixels, picture::png_size_limit);
  output.image.width = columns;
  output.image.height = rows;
  if (*format == hidden_lines::Format::png && output.is_sheet()) {
    require_finite("--dpi", output.dpi);
    constexpr double inch = 25.4;
    const auto pixels = [&](double length) { return static_cast<int>(std::lround(length / inch * output.dpi)); };
    output.image = {pixels(paper.width), pixels(paper.height), paper.pen / inch * output.dpi, output.dpi / inch};
    if (std::max(output.image.width, output.image.height) > picture::png_size_limit)
      throw base::usage_error(fmt::format("--dpi: found {}, which makes {} x {} pixels, expected at most {} a side", output.dpi,
                      output.image.width, output.image.height, picture::png_size_limit));
  }
  return *format;
}

std::string size_text(const DrawOutput& output, hidden_lines::Format format) {
  if (format == hidden_lines::Format::png) return fmt::format("{} x {} pixels", output.image.width, output.image.height);
  return fmt::format("{:.4g} x {:.4g} mm", output.paper.width, output.paper.height);
}

// --- a drawing with a scale

double scale_argument(const std::string& text) {
  constexpr double most = 1e6;
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos) {
    const auto drawn = base::fixed_number(std::string_view(text).substr(0, colon), 1 / most, most);
    const auto real = base::fixed_number(std::string_view(text).substr(colon + 1), 1 / most, most);
    if (drawn && real) return *drawn / *real;
  }
  throw base::usage_error(fmt::format("--scale: found \"{}\", expected N:M, such as 1:50 or 2:1, both 0.000001 to 1000000", text));
}

void require_room(const picture::VectorDrawing& drawing, const DrawOutput& output) {
  if (drawing.points.empty()) return;
  picture::DrawingPoint low = drawing.points.front();
  picture::DrawingPoint high = low;
  for (const picture::DrawingPoint& p : drawing.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  constexpr double rounding = 0.002;  // mm; rounding error of two floats on the largest paper
  const std::array<double, 2> size{double{high.x} - low.x, double{high.y} - low.y};
  const auto fits = [&size](const std::array<double, 2>& room) {
    return size[0] <= room[0] + rounding && size[1] <= room[1] + rounding;
  };
  if (fits(output.room)) return;
  const std::string found = fmt::format("--scale {}: found a drawing of {:.1f}x{:.1f} mm on paper with room for {:.1f}x{:.1f}", output.scale,
                                        size[0], size[1], output.room[0], output.room[1]);
  // Portrait before landscape, small before large.
  const picture::Plotter* const plotter = output.plotter();
  const auto sheet_that_fits = [&](std::string_view name, double width, double height) -> std::string {
    for (const bool lying : {width > height, width <= height}) {
      picture::Paper paper = output.paper;
      paper.width = lying ? std::max(width, height) : std::min(width, height);
      paper.height = lying ? std::min(width, height) : std::max(width, height);
      if (fits(room_of(output, paper))) return fmt::format("--size {}{}", name, lying ? " --landscape" : "");
    }
    return {};
  };
  std::string sheet;
  if (plotter != nullptr && plotter->carriage == 0) {
    for (const picture::PlotterPaperLimits& each : plotter->papers)
      if (sheet.empty()) sheet = sheet_that_fits(each.paper, each.height, each.width);
  } else {
    for (const std::string_view name : {"A6", "A5", "A4", "A3", "A2", "A1", "A0"})
      for (const PaperSize& each : paper_sizes)
        if (sheet.empty() && each.name == name) sheet = sheet_that_fits(name, each.width, each.height);
  }
  const std::array<double, 2> needed{size[0] + output.paper.width - output.room[0], size[1] + output.paper.height - output.room[1]};
  const std::string paper = fmt::format("a paper of at least {:.0f}x{:.0f} mm with its margins", std::ceil(needed[0] - rounding),
                                        std::ceil(needed[1] - rounding));
  const bool too_large = std::max(needed[0], needed[1]) > widest_paper ||
                         (plotter != nullptr && (plotter->carriage == 0 || size[1] > plotter->carriage));
  throw base::usage_error(sheet.empty() && too_large
                                     ? fmt::format("{}, expected a smaller scale: {} is larger than {}", found, paper,
                                                   plotter != nullptr ? fmt::format("what {} takes", plotter->name)
                                                                      : fmt::format("{:g} mm a side", widest_paper))
                                     : fmt::format("{}, expected {}{}", found, paper, sheet.empty() ? std::string() : ", such as " + sheet));
}

std::optional<base::Json> write_drawing(const picture::VectorDrawing& drawing, const DrawOutput& output, hidden_lines::Format format,
                                        const std::string& title, Output& file) {
  hidden_lines::WriteOptions options{.format = format, .title = title, .paper = output.paper, .image = output.image};
  options.sheet = output.is_sheet();
  options.as_found = output.as_found;
  options.min_gap = output.min_gap;
  options.plotter = hpgl_options(output);
  const hidden_lines::Written written = value_of(hidden_lines::write(drawing, options));
  if (format == hidden_lines::Format::hpgl || format == hidden_lines::Format::steps) warn_of_pens(written.layers, output);
  if (format == hidden_lines::Format::hpgl) warn_of_speed(output);
  for (const std::string& note : written.notes) warn(fmt::format("{}: {}", output.file, note));
  file.write(std::string_view(written.bytes));
  file.commit();
  if (!written.plot) return std::nullopt;
  base::Json plot = plot_json(*written.plot);
  if (output.report) {
    print_message(fmt::format(
        "{}: {} m drawn, {} m in the air, {} lifts; {} s on a {}", output.file, plot["pen_down_m"].dump(),
        plot["pen_up_m"].dump(), plot["lifts"].dump(), plot["seconds"].dump(),
        std::string(output.plotter() != nullptr ? output.device : picture::plotters().front().name)));
  }
  return plot;
}

}  // namespace sightline::app
