#include "host/picture/overlay.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "host/picture/lettering.hpp"

namespace sightline::picture {
namespace {

constexpr double picture_side = 1024;
constexpr double legend_height = 96;
constexpr double border = 16;
constexpr double text_height = 16;
constexpr std::uint32_t legend = 0;
constexpr std::uint32_t agreed = 1;
constexpr std::uint32_t missing = 2;
constexpr std::uint32_t extra = 3;

VectorDrawing empty_overlay(double picture_height) {
  VectorDrawing drawing;
  drawing.width = picture_side;
  drawing.height = picture_height + legend_height;
  drawing.layers = {{"legend", {0, 0, 0}},
                    {"agreed", difference_colours::agreed},
                    {"missing", difference_colours::missing},
                    {"extra", difference_colours::extra}};
  return drawing;
}

// As large as fits, but at most the usual size.
void append_fitted_text(VectorDrawing& drawing, double x, double y, double room, const std::string& text) {
  const double width = text_width(text_height, text);
  append_text(drawing, legend, x, y, width > room ? text_height * room / width : text_height, text);
}

void add_legend(VectorDrawing& drawing, const OverlayCaption& caption) {
  append_line(drawing, legend, 0, legend_height - 1, picture_side, legend_height - 1);
  append_fitted_text(drawing, border, legend_height - 40, picture_side - 2 * border, caption.title);
  constexpr double column = (picture_side - border) / 3;
  constexpr double swatch = 40;
  double x = border;
  for (const auto& [layer, text] : {std::pair{agreed, &caption.agreed}, std::pair{missing, &caption.missing},
                                    std::pair{extra, &caption.extra}}) {
    append_line(drawing, layer, x, border + text_height / 2, x + swatch, border + text_height / 2);
    append_fitted_text(drawing, x + swatch + border, border, column - swatch - 2 * border, *text);
    x += column;
  }
}

}  // namespace

Overlay overlay_of(const LineDifference& difference, const PixelPoint& low, const PixelPoint& high,
                   const OverlayCaption& caption) {
  const double scale = picture_side / std::max(high.x - low.x, 1e-9);
  Overlay overlay{empty_overlay((high.y - low.y) * scale), 2};
  const auto add = [&](std::uint32_t layer, const std::vector<PixelSegment>& segments) {
    for (const PixelSegment& s : segments)
      append_line(overlay.drawing, layer, (s.a.x - low.x) * scale, (s.a.y - low.y) * scale + legend_height,
                  (s.b.x - low.x) * scale, (s.b.y - low.y) * scale + legend_height);
  };
  add(agreed, difference.agreed);
  add(missing, difference.missing);
  add(extra, difference.extra);
  add_legend(overlay.drawing, caption);
  return overlay;
}

Overlay overlay_of(const PixelGrid& reference, const PixelGrid& drawn, const OverlayCaption& caption) {
  assert(reference.width == drawn.width && reference.height == drawn.height);
  const double scale = picture_side / reference.width;
  Overlay overlay{empty_overlay(reference.height * scale), std::max(2.0, std::floor(0.85 * scale))};
  const auto layer_at = [&](int column, int row) {
    const std::uint32_t there = reference.at(column, row);
    const std::uint32_t here = drawn.at(column, row);
    if (there == 0 && here == 0) return legend;  // nothing to draw
    if (here == 0) return missing;
    return there == here ? agreed : extra;
  };
  for (int row = 0; row < reference.height; ++row) {
    const double y = (row + 0.5) * scale + legend_height;
    for (int column = 0; column < reference.width;) {
      const std::uint32_t layer = layer_at(column, row);
      const int first = column;
      while (column < reference.width && layer_at(column, row) == layer) ++column;
      if (layer != legend)
        append_line(overlay.drawing, layer, (first + 0.5) * scale, y, (column - 0.5) * scale, y);
    }
  }
  add_legend(overlay.drawing, caption);
  return overlay;
}

Image overlay_image(const Overlay& overlay) {
  // Leaves half a pen and a smooth edge on every side, so that the drawing's unit is a pixel.
  const auto pixels = [&](double extent) { return static_cast<int>(std::lround(extent + overlay.pen + 1)); };
  return image_of(overlay.drawing,
                  {pixels(overlay.drawing.width), pixels(overlay.drawing.height), overlay.pen});
}

std::string overlay_svg(const Overlay& overlay, const std::string& title) {
  const VectorDrawing& drawing = overlay.drawing;
  constexpr double width = 200;
  constexpr double margin = 5;
  const double scale = (width - 2 * margin) / drawing.width;
  return svg_of(drawing, {width, drawing.height * scale + 2 * margin, margin, overlay.pen * scale}, title);
}

}  // namespace sightline::picture
