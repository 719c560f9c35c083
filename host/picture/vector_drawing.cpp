// Writes SVG; the image is in vector_image.cpp.
#include "host/picture/vector_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "host/base/text.hpp"
#include "host/picture/svg.hpp"

namespace sightline::picture {

namespace {

// Converts from the drawing to integer parts of a millimetre, from the paper's bottom left.
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

class DrawingSvg {
 public:
  DrawingSvg(const VectorDrawing& drawing, const Paper& paper, const std::string& title)
      : drawing_(drawing),
        pen_(fmt::format("{:.3f}", paper.pen)),
        place_(drawing, paper, 1000),
        height_(static_cast<std::int64_t>(std::floor(paper.height * 1000 + 0.5))),
        svg_(paper.width, paper.height, title, {.needless_zeros = false}) {}

  std::string write() {
    svg_.reserve(1000 + 10 * drawing_.points.size() + 30 * drawing_.lines.size() +
                 60 * (drawing_.areas.empty() ? drawing_.facets.size() : drawing_.areas.size()));
    if (!drawing_.facets.empty()) facets();
    for (std::uint32_t layer = 0; layer < drawing_.layers.size(); ++layer) lines_of(layer);
    return std::move(svg_).finish();
  }

 private:
  void points(std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i)
      svg_.point(place_.x(drawing_.points[i]), height_ - place_.y(drawing_.points[i]));
  }

  void facets() {
    // Each facet has a line of its own colour around it, because facets only meet.
    const bool with_line = drawing_.areas.empty();
    // Very many areas are written in integer hundredths of a millimetre.
    constexpr std::size_t many = 20'000;
    const bool coarse = drawing_.areas.size() > many;
    svg_.open_areas("surface", "0 surface",
                    with_line ? "stroke-width=\"0.05\" stroke-linejoin=\"round\"" : coarse ? "transform=\"scale(.01)\"" : "");
    const auto area = [this, with_line](const auto& each) {
      svg_.begin_area(each.colour, with_line);
      points(each.first, each.count);
      svg_.end_area();
    };
    if (coarse) {
      for (const DrawingArea& each : drawing_.areas) coarse_area(each);
    } else {
      std::for_each(drawing_.areas.begin(), drawing_.areas.end(), area);
    }
    if (drawing_.areas.empty()) std::for_each(drawing_.facets.begin(), drawing_.facets.end(), area);
    svg_.close_layer();
  }

  void coarse_area(const DrawingArea& area) {
    svg_.begin_short_area(area.colour);
    for (std::uint32_t i = area.first; i < area.first + area.count; ++i)
      svg_.whole_point((place_.x(drawing_.points[i]) + 5) / 10, (height_ - place_.y(drawing_.points[i]) + 5) / 10);
    svg_.end_area();
  }

  void lines_of(std::uint32_t layer) {
    const auto in_layer = [layer](const DrawingLine& line) { return line.layer == layer; };
    auto line = std::find_if(drawing_.lines.begin(), drawing_.lines.end(), in_layer);
    if (line == drawing_.lines.end()) return;
    const DrawingLayer& about = drawing_.layers[layer];
    svg_.open_lines(fmt::format("layer-{}", layer + 1), fmt::format("{} {}", layer + 1, about.label),
                    about.colour, pen_);
    // In a drawing of very many lines, several share a path, which makes the file a third shorter.
    constexpr std::size_t many = 100'000;
    constexpr std::size_t in_a_path = 64;
    const std::size_t together = drawing_.lines.size() > many ? in_a_path : 1;
    std::size_t begun = 0;
    for (; line != drawing_.lines.end(); ++line) {
      if (!in_layer(*line) || !can_be_seen(*line)) continue;
      begun % together == 0 ? svg_.begin_line() : svg_.begin_distances();
      polyline(*line);
      if (++begun % together == 0) svg_.end_shape();
    }
    if (begun % together != 0) svg_.end_shape();
    svg_.close_layer();
  }

  [[nodiscard]] bool is_at(std::uint32_t number, const DrawingPoint& place) const {
    const DrawingPoint& p = drawing_.points[number];
    return place_.x(p) == place_.x(place) && place_.y(p) == place_.y(place);
  }

  // A line shorter than a micrometre is skipped; a dot is drawn.
  [[nodiscard]] bool can_be_seen(const DrawingLine& line) const {
    for (std::uint32_t i = 1; i < line.count; ++i)
      if (!is_at(line.first + i, drawing_.points[line.first])) return true;
    return line.count == 1;
  }

  void polyline(const DrawingLine& line) {
    const DrawingPoint at = drawing_.points[line.first];
    if (line.count == 1) {
      svg_.dot(place_.x(at), height_ - place_.y(at));
      return;
    }
    points(line.first, 1);
    for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
      if (!is_at(i, drawing_.points[i - 1])) points(i, 1);
  }

  const VectorDrawing& drawing_;
  std::string pen_;
  OnPaper place_;
  std::int64_t height_;
  SvgWriter svg_;
};

std::int64_t whole(double micrometres) {
  constexpr double farthest = 1e9;
  return static_cast<std::int64_t>(std::floor(std::clamp(micrometres, -farthest, farthest) + 0.5));
}

}  // namespace

std::string svg_of(const VectorDrawing& drawing, const Paper& paper, const std::string& title) {
  return DrawingSvg(drawing, paper, title).write();
}

VectorDrawing with_dashes(const VectorDrawing& drawing) {
  VectorDrawing result = drawing;
  const auto dashed = [&](const DrawingLine& line) { return drawing.layers[line.layer].dash > 0; };
  if (std::none_of(drawing.lines.begin(), drawing.lines.end(), dashed)) return result;
  result.lines.clear();
  constexpr double gap = 0.75;
  for (const DrawingLine& line : drawing.lines) {
    if (!dashed(line)) {
      result.lines.push_back(line);
      continue;
    }
    for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
      const DrawingPoint a = drawing.points[i - 1];
      const DrawingPoint b = drawing.points[i];
      const double across = double{b.x} - a.x;
      const double up = double{b.y} - a.y;
      const double size = std::hypot(across, up) / drawing.layers[line.layer].dash;
      const double count = std::clamp(std::floor((size + gap) / (1 + gap) + 0.5), 1.0, 1e4);
      const double step = 1 / (count * (1 + gap) - gap);  // one dash, as a share of the line
      for (int n = 0; n < static_cast<int>(count); ++n) {
        const double from = n * (1 + gap) * step;
        result.lines.push_back({line.layer, static_cast<std::uint32_t>(result.points.size()), 2});
        for (const double t : {from, std::min(from + step, 1.0)})
          result.points.push_back({static_cast<float>(a.x + t * across), static_cast<float>(a.y + t * up)});
      }
    }
  }
  return result;
}

VectorDrawing without_empty_layers(VectorDrawing drawing) {
  std::vector<std::uint32_t> number(drawing.layers.size(), 0);
  for (const DrawingLine& line : drawing.lines)
    if (line.count > 0) number[line.layer] = 1;
  std::uint32_t next = 0;
  for (std::size_t layer = 0; layer < number.size(); ++layer) {
    if (number[layer] == 0) continue;
    number[layer] = next;
    if (next != layer) drawing.layers[next] = std::move(drawing.layers[layer]);
    ++next;
  }
  drawing.layers.resize(next);
  std::erase_if(drawing.lines, [](const DrawingLine& line) { return line.count == 0; });
  for (DrawingLine& line : drawing.lines) line.layer = number[line.layer];
  return drawing;
}

VectorDrawing with_margin(VectorDrawing drawing, const Paper& paper) {
  const double across = drawing.width / (paper.width - 2 * paper.margin);  // units of a millimetre
  const double up = drawing.height / (paper.height - 2 * paper.margin);
  for (DrawingPoint& p : drawing.points)
    p = {static_cast<float>(p.x + paper.margin * across), static_cast<float>(p.y + paper.margin * up)};
  drawing.width = paper.width * across;
  drawing.height = paper.height * up;
  return drawing;
}

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
