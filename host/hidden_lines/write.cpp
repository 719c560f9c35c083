// Writes drawings as files; see hidden_lines.hpp.
#include <algorithm>
#include <array>
#include <utility>

#include "host/base/text.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/picture/dxf.hpp"
#include "host/picture/pdf.hpp"
#include "host/picture/pen_order.hpp"
#include "host/picture/png.hpp"
#include "host/picture/step_file.hpp"

namespace sightline::hidden_lines {
namespace {

// With `sheet`, every millimetre has ImageSize::unit pixels.
picture::Image image_on(const picture::VectorDrawing& drawing, const WriteOptions& options) {
  if (!options.sheet) return image_of(drawing, options.image);
  const picture::VectorDrawing sheet = with_margin(drawing, options.paper);
  picture::ImageSize size = options.image;
  size.unit *= options.paper.width / sheet.width;
  return image_of(sheet, size);
}

// `counted` is the plotting time if the file itself determines it. In a file for a plotter, layers that share a pen count
// as one.
PenPlot plot_of(picture::VectorDrawing drawing, const WriteOptions& options, std::optional<double> counted) {
  if (options.format == Format::hpgl || options.format == Format::steps) {
    const auto last = static_cast<std::uint32_t>(picture::pen_count(options.plotter)) - 1;
    for (picture::DrawingLine& line : drawing.lines) line.layer = std::min(line.layer, last);
  }
  const picture::PenTravel travel = picture::pen_travel(drawing, options.paper);
  const picture::Plotter& plotter = options.plotter.plotter != nullptr ? *options.plotter.plotter : picture::plotters().front();
  picture::PlotterSpeeds speeds = plotter.speeds;
  if (options.plotter.speed) speeds.down = std::min(speeds.down, 10 * *options.plotter.speed);
  return {travel.down, travel.up,    travel.lifts,
          travel.pens, plotter.name, counted ? *counted : plot_seconds(drawing, options.paper, speeds)};
}

}  // namespace

std::optional<Format> format_named(std::string_view ending) {
  constexpr std::array<std::pair<std::string_view, Format>, 7> formats{{{"svg", Format::svg},
                                                                        {"png", Format::png},
                                                                        {"plt", Format::hpgl},
                                                                        {"hpgl", Format::hpgl},
                                                                        {"pdf", Format::pdf},
                                                                        {"dxf", Format::dxf},
                                                                        {"steps", Format::steps}}};
  const std::string small = base::lower_case(ending);
  for (const auto& [name, format] : formats)
    if (name == small) return format;
  return std::nullopt;
}

base::Result<Written> write(const picture::VectorDrawing& with_empty, const WriteOptions& options) {
  const picture::VectorDrawing found = picture::without_empty_layers(with_empty);
  Written written;
  for (const picture::DrawingLayer& layer : found.layers) written.layers.push_back(layer.label);
  if (found.lines.empty() && found.facets.empty()) written.notes.emplace_back("the drawing is empty, nothing is in view");
  if (options.format == Format::png) {
    auto bytes = picture::encode_png(image_on(with_dashes(found), options), {{"Title", options.title}, {"Software", "sightline"}},
                                     options.image.unit);
    if (!bytes) {
      bytes.error().kind = base::ErrorKind::io;
      return std::move(bytes.error());
    }
    written.bytes.assign(bytes->begin(), bytes->end());
    return written;
  }
  // DXF has its own dashed lines.
  const picture::VectorDrawing lines = options.format == Format::dxf ? found : with_dashes(found);
  picture::VectorDrawing drawing = options.as_found ? lines : in_pen_order(lines, options.paper, {.min_gap = options.min_gap});
  std::optional<double> seconds;
  switch (options.format) {
    case Format::png: break;
    case Format::svg: written.bytes = svg_of(drawing, options.paper, options.title); break;
    case Format::pdf: written.bytes = pdf_of(drawing, options.paper, options.title); break;
    case Format::dxf: written.bytes = dxf_of(drawing, options.paper); break;
    case Format::hpgl: {
      picture::HpglOptions plotter = options.plotter;
      plotter.speed = picture::reachable_speed(plotter);
      written.bytes = hpgl_of(drawing, options.paper, plotter);
      break;
    }
    case Format::steps:
      written.bytes = step_file_of(drawing, options.paper);
      seconds = picture::step_file_time(written.bytes).seconds;
      break;
  }
  written.plot = plot_of(std::move(drawing), options, seconds);
  return written;
}

}  // namespace sightline::hidden_lines
