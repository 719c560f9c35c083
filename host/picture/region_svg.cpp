#include "host/picture/region_svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "host/picture/svg.hpp"

namespace sightline::picture {
namespace {

std::int64_t whole(double micrometres) {
  constexpr double farthest = 1e9;
  return static_cast<std::int64_t>(std::floor(std::clamp(micrometres, -farthest, farthest) + 0.5));
}

}  // namespace

std::string svg_of(const std::vector<FilledArea>& areas, const Paper& paper, const std::string& title) {
  SvgWriter svg(paper.width, paper.height, title);
  svg.clip_rectangle("inside", paper.margin, paper.margin, paper.width - 2 * paper.margin,
                     paper.height - 2 * paper.margin);
  svg.open_areas(
      "faces", "0 faces",
      "fill-rule=\"evenodd\" stroke-width=\"0.2\" stroke-linejoin=\"round\" clip-path=\"url(#inside)\"");
  for (const FilledArea& area : areas) {
    svg.begin_path(area.colour);
    for (const auto& loop : area.loops) {
      if (loop.empty()) continue;
      svg.begin_loop();
      for (const PixelPoint& p : loop)
        svg.point(whole(p.x + paper.margin * 1000), whole((paper.height - paper.margin) * 1000 - p.y));
      svg.end_loop();
    }
    svg.end_shape();
  }
  svg.close_layer();
  return std::move(svg).finish();
}

}  // namespace sightline::picture
