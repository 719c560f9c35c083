#include "host/picture/region_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>

#include "host/picture/xml_text.hpp"

namespace sightline::picture {
namespace {

void append_length(std::string& text, double micrometres) {
  constexpr double farthest = 1e9;
  const auto whole =
      static_cast<std::int64_t>(std::floor(std::clamp(micrometres, -farthest, farthest) + 0.5));
  const std::int64_t size = std::abs(whole);
  fmt::format_to(std::back_inserter(text), "{}{}.{:03}", whole < 0 ? "-" : "", size / 1000, size % 1000);
}

void append_loop(std::string& text, const std::vector<PixelPoint>& loop, const Paper& paper) {
  char command = 'M';
  for (const PixelPoint& p : loop) {
    text += command;
    append_length(text, p.x + paper.margin * 1000);
    text += ',';
    append_length(text, (paper.height - paper.margin) * 1000 - p.y);
    command = 'L';
  }
  if (!loop.empty()) text += 'Z';
}

}  // namespace

std::string svg_of(const std::vector<FilledArea>& areas, const Paper& paper, const std::string& title) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                 "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
                 "     width=\"{0:.3f}mm\" height=\"{1:.3f}mm\" viewBox=\"0 0 {0:.3f} {1:.3f}\">\n"
                 "  <title>{2}</title>\n"
                 "  <clipPath id=\"inside\"><rect x=\"{3:.3f}\" y=\"{3:.3f}\" width=\"{4:.3f}\" "
                 "height=\"{5:.3f}\"/></clipPath>\n",
                 paper.width, paper.height, xml_text(title), paper.margin, paper.width - 2 * paper.margin,
                 paper.height - 2 * paper.margin);
  // Every area has a line of its own colour around it, or the paper would shine through where two meet.
  text +=
      "  <g id=\"faces\" inkscape:groupmode=\"layer\" inkscape:label=\"0 faces\" fill-rule=\"evenodd\" "
      "stroke-width=\"0.2\" stroke-linejoin=\"round\" clip-path=\"url(#inside)\">\n";
  for (const FilledArea& area : areas) {
    fmt::format_to(out, "    <path fill=\"#{0:02x}{1:02x}{2:02x}\" stroke=\"#{0:02x}{1:02x}{2:02x}\" d=\"",
                   area.colour.red, area.colour.green, area.colour.blue);
    for (const auto& loop : area.loops) append_loop(text, loop, paper);
    text += "\"/>\n";
  }
  text += "  </g>\n</svg>\n";
  return text;
}

}  // namespace sightline::picture
