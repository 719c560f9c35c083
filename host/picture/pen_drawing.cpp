#include "host/picture/pen_drawing.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "host/picture/svg.hpp"

namespace sightline::picture {

namespace {

constexpr std::int64_t margin = 10'000;     // micrometres
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
  // Along one of the eight directions, excluding the first point.
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
  const std::int64_t side = 2 * margin + (paper.steps - 1) * paper.micrometres_per_step;
  SvgWriter svg(static_cast<double>(side) / 1000, static_cast<double>(side) / 1000, title);
  svg.open_lines("pen-1", "1 pen", {}, pen_width);
  const auto across = [&](PenPoint at) { return margin + at.x * paper.micrometres_per_step; };
  const auto down = [&](PenPoint at) { return side - margin - at.y * paper.micrometres_per_step; };
  for (const PenPath& path : paths) {
    if (path.corners.empty()) continue;
    svg.begin_polyline();
    if (path.corners.size() == 1)
      svg.dot(across(path.corners.front()), down(path.corners.front()));
    else
      for (const PenPoint corner : path.corners) svg.point(across(corner), down(corner));
    svg.end_shape();
  }
  svg.close_layer();
  return std::move(svg).finish();
}

}  // namespace sightline::picture
