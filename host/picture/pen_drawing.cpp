#include "host/picture/pen_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>

#include "host/picture/xml_text.hpp"

namespace sightline::picture {

namespace {

constexpr std::int64_t margin = 10'000;     // micrometres
constexpr std::int64_t half_pen_dash = 10;  // micrometres
constexpr const char* pen_width = "0.300";  // millimetres

class Dots {
 public:
  Dots(const PlotterPaper& paper, int scale)
      : steps_(paper.steps), scale_(scale), image_(paper.steps * scale, paper.steps * scale, 1) {
    std::fill(image_.pixels.begin(), image_.pixels.end(), std::uint8_t{255});
  }

  void dot(PenPoint at) {
    if (at.x < 0 || at.y < 0 || at.x >= steps_ || at.y >= steps_) return;
    for (int row = 0; row < scale_; ++row) {
      const auto first =
          static_cast<std::ptrdiff_t>(image_.index(at.x * scale_, (steps_ - 1 - at.y) * scale_ + row));
      std::fill_n(image_.pixels.begin() + first, scale_, std::uint8_t{0});
    }
  }
  // Along one of the eight directions, without the first point.
  void line(PenPoint from, PenPoint to) {
    const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    for (int n = 1; n <= steps; ++n)
      dot({from.x + (to.x - from.x) * n / steps, from.y + (to.y - from.y) * n / steps});
  }

  [[nodiscard]] Image image() && { return std::move(image_); }

 private:
  int steps_;
  int scale_;
  Image image_;
};

class Sheet {
 public:
  explicit Sheet(const PlotterPaper& paper) : paper_(paper) {}

  [[nodiscard]] std::int64_t side() const {
    return 2 * margin + (paper_.steps - 1) * paper_.micrometres_a_step;
  }

  // SVG counts y downwards.
  void append(std::string& text, PenPoint point, std::int64_t shift = 0) const {
    const std::int64_t across = margin + point.x * paper_.micrometres_a_step + shift;
    const std::int64_t down = side() - margin - point.y * paper_.micrometres_a_step;
    fmt::format_to(std::back_inserter(text), "{}.{:03},{}.{:03}", across / 1000, across % 1000, down / 1000,
                   down % 1000);
  }

 private:
  PlotterPaper paper_;
};

void append_polyline(std::string& text, const Sheet& sheet, const PenPath& path) {
  text += "    <polyline points=\"";
  if (path.corners.size() == 1) {
    sheet.append(text, path.corners.front(), -half_pen_dash);
    text += ' ';
    sheet.append(text, path.corners.front(), half_pen_dash);
  } else {
    for (std::size_t i = 0; i < path.corners.size(); ++i) {
      if (i > 0) text += ' ';
      sheet.append(text, path.corners[i]);
    }
  }
  text += "\"/>\n";
}

}  // namespace

Image pen_image(std::span<const PenPath> paths, const PlotterPaper& paper, int scale) {
  Dots dots(paper, scale);
  for (const PenPath& path : paths) {
    if (path.corners.empty()) continue;
    dots.dot(path.corners.front());
    for (std::size_t i = 1; i < path.corners.size(); ++i) dots.line(path.corners[i - 1], path.corners[i]);
  }
  return std::move(dots).image();
}

std::string pen_svg(std::span<const PenPath> paths, const PlotterPaper& paper, const std::string& title) {
  const Sheet sheet(paper);
  const std::string side = fmt::format("{}.{:03}", sheet.side() / 1000, sheet.side() % 1000);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
      "     width=\"{0}mm\" height=\"{0}mm\" viewBox=\"0 0 {0} {0}\">\n"
      "  <title>{1}</title>\n"
      "  <g id=\"pen-1\" inkscape:groupmode=\"layer\" inkscape:label=\"1 pen\"\n"
      "     fill=\"none\" stroke=\"#000000\" stroke-width=\"{2}\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\">\n",
      side, xml_text(title), pen_width);
  for (const PenPath& path : paths)
    if (!path.corners.empty()) append_polyline(text, sheet, path);
  text += "  </g>\n</svg>\n";
  return text;
}

}  // namespace sightline::picture
