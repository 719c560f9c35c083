#include "host/picture/pdf.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/text.hpp"

namespace sightline::picture {
namespace {

// Collects the objects and the position of each for the cross-reference table at the end of the file.
class PdfFile {
 public:
  PdfFile() : text_("%PDF-1.5\n%\xe2\xe3\xcf\xd3\n") {}

  void object(const std::string& body) {
    places_.push_back(text_.size());
    base::append(text_, "{} 0 obj\n{}\nendobj\n", places_.size(), body);
  }

  std::string finish(std::size_t root, std::size_t about) && {
    const std::size_t table = text_.size();
    base::append(text_, "xref\n0 {}\n0000000000 65535 f \n", places_.size() + 1);
    for (const std::size_t place : places_) base::append(text_, "{:010} 00000 n \n", place);
    base::append(text_, "trailer\n<< /Size {} /Root {} 0 R /Info {} 0 R >>\nstartxref\n{}\n%%EOF\n", places_.size() + 1, root, about, table);
    return std::move(text_);
  }

 private:
  std::string text_;
  std::vector<std::size_t> places_;
};

std::string pdf_text(const std::string& text) {
  std::string result = "(";
  for (const char c : text) {
    if (c == '(' || c == ')' || c == '\\') result += '\\';
    result += c >= ' ' && c <= '~' ? c : '?';
  }
  return result + ")";
}

class PdfPage {
 public:
  PdfPage(const VectorDrawing& drawing, const Paper& paper)
      : drawing_(drawing),
        margin_(paper.margin),
        across_((paper.width - 2 * paper.margin) / drawing.width),
        up_((paper.height - 2 * paper.margin) / drawing.height) {}

  // In millimetres; the page's unit is 1/72 inch.
  std::string content(const Paper& paper) {
    base::append(text_, "{:.6f} 0 0 {:.6f} 0 0 cm\n1 J 1 j {:.3f} w\n", 72 / 25.4, 72 / 25.4, paper.pen);
    // Each facet has a line of its own colour around it; otherwise the paper would shine through between facets.
    const bool with_line = drawing_.areas.empty();
    text_ += "0.05 w\n";
    const auto area = [this, with_line](const auto& each) {
      colour(each.colour, "rg");
      if (with_line) colour(each.colour, "RG");
      for (std::uint32_t i = 0; i < each.count; ++i) point(each.first + i, i == 0 ? 'm' : 'l');
      text_ += with_line ? "b\n" : "f\n";
    };
    std::for_each(drawing_.areas.begin(), drawing_.areas.end(), area);
    if (drawing_.areas.empty()) std::for_each(drawing_.facets.begin(), drawing_.facets.end(), area);
    base::append(text_, "{:.3f} w\n", paper.pen);
    for (std::uint32_t layer = 0; layer < drawing_.layers.size(); ++layer) {
      base::append(text_, "/OC /L{} BDC\n", layer);
      colour(drawing_.layers[layer].colour, "RG");
      for (const DrawingLine& line : drawing_.lines) {
        if (line.layer != layer || line.count == 0) continue;
        std::string before = place(line.first);
        if (line.count == 1) base::append(text_, "{} m\n{} l\nS\n", before, before);
        bool begun = false;
        // Parts of a line shorter than a thousandth of a millimetre are skipped.
        for (std::uint32_t i = 1; i < line.count; ++i) {
          std::string at = place(line.first + i);
          if (at == before) continue;
          if (!begun) base::append(text_, "{} m\n", before);
          begun = true;
          base::append(text_, "{} l\n", at);
          before = std::move(at);
        }
        if (begun) text_ += "S\n";
      }
      text_ += "EMC\n";
    }
    return std::move(text_);
  }

 private:
  void colour(Colour colour, std::string_view what) {
    base::append(text_, "{:.4f} {:.4f} {:.4f} {}\n", colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0, what);
  }

  [[nodiscard]] std::string place(std::uint32_t number) const {
    const DrawingPoint& p = drawing_.points[number];
    return fmt::format("{:.3f} {:.3f}", margin_ + p.x * across_, margin_ + p.y * up_);
  }
  void point(std::uint32_t number, char what) { base::append(text_, "{} {}\n", place(number), what); }

  const VectorDrawing& drawing_;
  double margin_;
  double across_;
  double up_;
  std::string text_;
};

}  // namespace

std::string pdf_of(const VectorDrawing& drawing, const Paper& paper, const std::string& title) {
  // Objects: 1 catalogue, 2 pages, 3 page, 4 content, 5 about, layers from 6 on.
  constexpr std::size_t first_layer = 6;
  std::string all;
  std::string names;
  for (std::size_t layer = 0; layer < drawing.layers.size(); ++layer) {
    base::append(all, "{} 0 R ", first_layer + layer);
    base::append(names, "/L{} {} 0 R ", layer, first_layer + layer);
  }
  std::string page;
  base::append(page, "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {:.3f} {:.3f}] /Contents 4 0 R /Resources << /Properties << {}>> >> >>",
               paper.width * 72 / 25.4, paper.height * 72 / 25.4, names);
  const std::string content = PdfPage(drawing, paper).content(paper);
  PdfFile file;
  file.object("<< /Type /Catalog /Pages 2 0 R /OCProperties << /OCGs [ " + all + "] /D << /Order [ " + all + "] >> >> >>");
  file.object("<< /Type /Pages /Kids [3 0 R] /Count 1 >>");
  file.object(page);
  file.object("<< /Length " + std::to_string(content.size()) + " >>\nstream\n" + content + "endstream");
  file.object("<< /Title " + pdf_text(title) + " /Creator (sightline) >>");
  for (const DrawingLayer& layer : drawing.layers) file.object("<< /Type /OCG /Name " + pdf_text(layer.label) + " >>");
  return std::move(file).finish(1, 5);
}

}  // namespace sightline::picture
