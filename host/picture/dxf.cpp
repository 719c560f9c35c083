#include "host/picture/dxf.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/text.hpp"

namespace sightline::picture {
namespace {

// A layer name may have letters, digits, $, - and _.
std::string layer_name(std::size_t number, std::string_view label) {
  std::string name = std::to_string(number + 1) + "-";
  for (const char c : label) {
    const bool small = c >= 'a' && c <= 'z';
    const bool plain = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name += small ? static_cast<char>(c - 'a' + 'A') : plain ? c : '_';
  }
  constexpr std::size_t longest = 31;
  return name.substr(0, longest);
}

}  // namespace

std::string dxf_of(const VectorDrawing& drawing, const Paper& paper) {
  const double across = (paper.width - 2 * paper.margin) / drawing.width;
  const double up = (paper.height - 2 * paper.margin) / drawing.height;
  std::string text;
  const auto put = [&text](int code, std::string_view value) { base::append(text, "{:3}\n{}\n", code, value); };
  const auto number = [&text](int code, double value) { base::append(text, "{:3}\n{:.3f}\n", code, value); };
  put(0, "SECTION");
  put(2, "HEADER");
  put(9, "$ACADVER");
  put(1, "AC1009");
  put(9, "$EXTMIN");
  for (const int code : {10, 20, 30}) number(code, 0);
  put(9, "$EXTMAX");
  number(10, paper.width);
  number(20, paper.height);
  number(30, 0);
  put(0, "ENDSEC");
  put(0, "SECTION");
  put(2, "TABLES");
  put(0, "TABLE");
  put(2, "LTYPE");
  const auto dash = std::max_element(drawing.layers.begin(), drawing.layers.end(),
                                     [](const DrawingLayer& a, const DrawingLayer& b) { return a.dash < b.dash; });
  const bool dashed = dash != drawing.layers.end() && dash->dash > 0;
  put(70, dashed ? "2" : "1");
  put(0, "LTYPE");
  put(2, "CONTINUOUS");
  put(70, "64");
  put(3, "Solid line");
  put(72, "65");
  put(73, "0");
  number(40, 0);
  if (dashed) {
    put(0, "LTYPE");
    put(2, "DASHED");
    put(70, "64");
    put(3, "__ __ __ __");
    put(72, "65");
    put(73, "2");
    const double millimetres = dash->dash * across;
    number(40, 1.75 * millimetres);
    number(49, millimetres);
    number(49, -0.75 * millimetres);
  }
  put(0, "ENDTAB");
  put(0, "TABLE");
  put(2, "LAYER");
  put(70, std::to_string(drawing.layers.size()));
  for (std::size_t layer = 0; layer < drawing.layers.size(); ++layer) {
    put(0, "LAYER");
    put(2, layer_name(layer, drawing.layers[layer].label));
    put(70, "64");
    // 7 is black on white; then the first pen colours: red, yellow, green, cyan, blue, magenta.
    put(62, layer == 0 ? "7" : std::to_string(1 + (layer - 1) % 6));
    put(6, drawing.layers[layer].dash > 0 ? "DASHED" : "CONTINUOUS");
  }
  put(0, "ENDTAB");
  put(0, "ENDSEC");
  put(0, "SECTION");
  put(2, "ENTITIES");
  for (std::uint32_t layer = 0; layer < drawing.layers.size(); ++layer) {
    const std::string name = layer_name(layer, drawing.layers[layer].label);
    for (const DrawingLine& line : drawing.lines) {
      if (line.layer != layer || line.count == 0) continue;
      const auto place = [&](std::uint32_t i) {
        const DrawingPoint& p = drawing.points[line.first + i];
        std::string at;
        base::append(at, " 10\n{:.3f}\n 20\n{:.3f}\n", paper.margin + p.x * across, paper.margin + p.y * up);
        return at;
      };
      std::vector<std::string> places{place(0)};
      for (std::uint32_t i = 1; i < line.count; ++i)
        if (std::string at = place(i); at != places.back()) places.push_back(std::move(at));
      if (places.size() == 1) {
        if (line.count > 1) continue;  // shorter than a thousandth of a millimetre
        put(0, "POINT");
        put(8, name);
        text += places[0];
        number(30, 0);
        continue;
      }
      put(0, "POLYLINE");
      put(8, name);
      put(66, "1");
      if (drawing.layers[layer].dash > 0) put(70, "128");  // dashes continue around corners
      for (const int code : {10, 20, 30}) number(code, 0);
      for (const std::string& at : places) {
        put(0, "VERTEX");
        put(8, name);
        text += at;
        number(30, 0);
      }
      put(0, "SEQEND");
      put(8, name);
    }
  }
  put(0, "ENDSEC");
  put(0, "EOF");
  return text;
}

}  // namespace sightline::picture
