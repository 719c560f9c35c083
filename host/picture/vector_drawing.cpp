// SVG and HP-GL; the image is in vector_image.cpp.
#include "host/picture/vector_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "host/picture/hpgl.hpp"
#include "host/picture/xml_text.hpp"

namespace sightline::picture {
namespace {

constexpr std::int64_t half_dash = 10;  // micrometres
constexpr std::size_t most_pens = 8;

// From the drawing to whole parts of a millimetre, from the paper's bottom left.
class OnPaper {
 public:
  OnPaper(const VectorDrawing& drawing, const Paper& paper, double parts)
      : shift_(paper.margin * parts),
        across_((paper.width - 2 * paper.margin) * parts / drawing.width),
        up_((paper.height - 2 * paper.margin) * parts / drawing.height) {}
  [[nodiscard]] std::int64_t x(DrawingPoint point) const {
    return rounded(double{point.x} * across_ + shift_);
  }
  [[nodiscard]] std::int64_t y(DrawingPoint point) const { return rounded(double{point.y} * up_ + shift_); }

 private:
  [[nodiscard]] static std::int64_t rounded(double value) {
    return static_cast<std::int64_t>(std::floor(value + 0.5));
  }
  double shift_;
  double across_;
  double up_;
};

// Micrometres, not negative, as millimetres without needless zeros.
void append_millimetres(std::string& text, std::int64_t value) {
  char digits[24];
  char* const end = digits + sizeof digits;
  char* at = end;
  std::int64_t rest = value;
  for (int place = 0; place < 4 || rest > 0; ++place) {
    if (place == 3) *--at = '.';
    *--at = static_cast<char>('0' + rest % 10);
    rest /= 10;
  }
  std::size_t length = static_cast<std::size_t>(end - at);
  while (at[length - 1] == '0') --length;
  if (at[length - 1] == '.') --length;
  text.append(at, length);
}

class SvgWriter {
 public:
  SvgWriter(const VectorDrawing& drawing, const Paper& paper)
      : drawing_(drawing),
        paper_(paper),
        place_(drawing, paper, 1000),
        height_(static_cast<std::int64_t>(std::floor(paper.height * 1000 + 0.5))) {}

  std::string write(const std::string& title) {
    std::size_t corners = drawing_.points.size();
    text_.reserve(1000 + 16 * corners + 30 * drawing_.lines.size() + 60 * drawing_.facets.size());
    fmt::format_to(std::back_inserter(text_),
                   "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                   "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
                   "     width=\"{0:.3f}mm\" height=\"{1:.3f}mm\" viewBox=\"0 0 {0:.3f} {1:.3f}\">\n"
                   "  <title>{2}</title>\n",
                   paper_.width, paper_.height, xml_text(title));
    if (!drawing_.facets.empty()) facets();
    for (std::uint32_t layer = 0; layer < drawing_.layers.size(); ++layer) lines_of(layer);
    text_ += "</svg>\n";
    return std::move(text_);
  }

 private:
  void point(DrawingPoint at, std::int64_t shift = 0) {
    append_millimetres(text_, place_.x(at) + shift);
    text_ += ',';
    append_millimetres(text_, height_ - place_.y(at));
  }

  // Every facet has a line of its own grey around it, or the paper would shine through where two meet.
  void facets() {
    text_ +=
        "  <g id=\"surface\" inkscape:groupmode=\"layer\" inkscape:label=\"0 surface\" "
        "stroke-width=\"0.05\" stroke-linejoin=\"round\">\n";
    for (const DrawingFacet& facet : drawing_.facets) {
      fmt::format_to(
          std::back_inserter(text_),
          "    <polygon fill=\"#{0:02x}{0:02x}{0:02x}\" stroke=\"#{0:02x}{0:02x}{0:02x}\" points=\"",
          facet.grey);
      for (std::uint32_t i = 0; i < facet.count; ++i) {
        if (i > 0) text_ += ' ';
        point(drawing_.points[facet.first + i]);
      }
      text_ += "\"/>\n";
    }
    text_ += "  </g>\n";
  }

  void lines_of(std::uint32_t layer) {
    const auto in_layer = [layer](const DrawingLine& line) { return line.layer == layer; };
    auto line = std::find_if(drawing_.lines.begin(), drawing_.lines.end(), in_layer);
    if (line == drawing_.lines.end()) return;
    const DrawingLayer& about = drawing_.layers[layer];
    fmt::format_to(std::back_inserter(text_),
                   "  <g id=\"layer-{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0} {1}\"\n"
                   "     fill=\"none\" stroke=\"#{2:02x}{3:02x}{4:02x}\" stroke-width=\"{5:.3f}\" "
                   "stroke-linecap=\"round\" "
                   "stroke-linejoin=\"round\">\n",
                   layer + 1, xml_text(about.label), about.colour.red, about.colour.green, about.colour.blue,
                   paper_.pen);
    for (; line != drawing_.lines.end(); ++line)
      if (in_layer(*line)) polyline(*line);
    text_ += "  </g>\n";
  }

  void polyline(const DrawingLine& line) {
    text_ += "    <polyline points=\"";
    if (line.count == 1) {
      point(drawing_.points[line.first], -half_dash);
      text_ += ' ';
      point(drawing_.points[line.first], half_dash);
    }
    for (std::uint32_t i = 0; i < line.count && line.count > 1; ++i) {
      if (i > 0) text_ += ' ';
      point(drawing_.points[line.first + i]);
    }
    text_ += "\"/>\n";
  }

  const VectorDrawing& drawing_;
  const Paper& paper_;
  OnPaper place_;
  std::int64_t height_;
  std::string text_;
};

}  // namespace

std::string svg_of(const VectorDrawing& drawing, const Paper& paper, const std::string& title) {
  return SvgWriter(drawing, paper).write(title);
}

std::string hpgl_of(const VectorDrawing& drawing, const Paper& paper) {
  const OnPaper place(drawing, paper, 1000.0 / static_cast<double>(hpgl_unit_micrometres));
  std::string text = "IN;\n";
  std::size_t held = 0;
  for (std::uint32_t layer = 0; layer < drawing.layers.size(); ++layer)
    for (const DrawingLine& line : drawing.lines) {
      if (line.layer != layer || line.count == 0) continue;
      const std::size_t pen = std::min<std::size_t>(layer + 1, most_pens);
      const auto out = std::back_inserter(text);
      if (pen != held) fmt::format_to(out, "SP{};\n", pen);
      held = pen;
      const DrawingPoint start = drawing.points[line.first];
      fmt::format_to(out, "PU{},{};\nPD", place.x(start), place.y(start));
      for (std::uint32_t i = 1; i < line.count; ++i) {
        const DrawingPoint point = drawing.points[line.first + i];
        if (i > 1) text += (i - 1) % hpgl_most_corners == 0 ? ";\nPD" : ",";
        fmt::format_to(out, "{},{}", place.x(point), place.y(point));
      }
      text += ";\n";
    }
  text += "PU;\nSP0;\n";
  return text;
}

}  // namespace sightline::picture
