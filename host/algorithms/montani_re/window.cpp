#include "host/algorithms/montani_re/window.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Int128;

// Clips one face to one window, stripe by stripe.
class ClippedFace {
 public:
  ClippedFace(const Image& image, const Window& window, int far_side)
      : image_(image), window_(window), far_east_(far_side > 0) {}

  void add(std::uint32_t line) {
    if (image_.lines()[line].horizontal() || !image_.before_eye(line)) return;
    Span span{line, extent_of(image_, line, &window_)};
    if (image_.compare(span.extent.low, window_.bottom) < 0) span.extent.low = window_.bottom;
    if (image_.compare(span.extent.high, window_.top) > 0) span.extent.high = window_.top;
    if (image_.compare(span.extent.low, span.extent.high) >= 0) return;
    spans_.push_back(span);
    levels_.push_back(span.extent.low);
    levels_.push_back(span.extent.high);
    for (const std::uint32_t border : {window_.west, window_.east}) add_crossing(span, border);
  }

  TrapezoidPcs run() {
    std::sort(levels_.begin(), levels_.end(),
              [this](const Ordinate& a, const Ordinate& b) { return image_.compare(a, b) < 0; });
    levels_.erase(
        std::unique(levels_.begin(), levels_.end(),
                    [this](const Ordinate& a, const Ordinate& b) { return image_.compare(a, b) == 0; }),
        levels_.end());
    TrapezoidPcs pcs;
    for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
      collect(levels_[k], levels_[k + 1]);
      append_band(image_, pcs, levels_[k], levels_[k + 1], kept_sides(levels_[k], levels_[k + 1]));
    }
    return pcs;
  }

 private:
  struct Span {
    std::uint32_t line = 0;
    Extent extent;
  };

  void add_crossing(const Span& span, std::uint32_t border) {
    const int below = image_.order_at(span.line, border, span.extent.low);
    const int above = image_.order_at(span.line, border, span.extent.high);
    if (below * above < 0) levels_.push_back(image_.crossing(span.line, border));
  }

  // The sides between two levels, from west to east.
  void collect(const Ordinate& low, const Ordinate& high) {
    sides_.clear();
    for (const Span& span : spans_) {
      if (image_.compare(span.extent.low, low) <= 0 && image_.compare(span.extent.high, high) >= 0)
        sides_.push_back(span.line);
    }
    std::sort(sides_.begin(), sides_.end(), [&](std::uint32_t a, std::uint32_t b) {
      const int order = image_.order_at(a, b, low);
      return order != 0 ? order < 0 : image_.order_at(a, b, high) < 0;
    });
  }

  // Negative, zero, positive: the side is to the west of a border, on it, to the east of it.
  [[nodiscard]] int place(std::uint32_t side, std::uint32_t border, const Ordinate& low,
                          const Ordinate& high) const {
    const int order = image_.order_at(side, border, low);
    return order != 0 ? order : image_.order_at(side, border, high);
  }

  // Everything beyond a border is replaced by the border.
  [[nodiscard]] std::vector<Side> kept_sides(const Ordinate& low, const Ordinate& high) const {
    std::vector<Side> result;
    bool inside = sides_.size() % 2 != 0 && !far_east_;
    std::size_t k = 0;
    Side border{window_.west, false};
    for (; k < sides_.size(); ++k) {
      const int at = place(sides_[k], window_.west, low, high);
      if (at > 0) break;
      inside = !inside;
      if (at == 0) border = {sides_[k], true};
    }
    if (inside) result.push_back(border);
    border = {window_.east, false};
    for (; k < sides_.size(); ++k) {
      const int at = place(sides_[k], window_.east, low, high);
      if (at == 0) border = {sides_[k], true};
      if (at >= 0) break;
      result.push_back({sides_[k], true});
      inside = !inside;
    }
    if (inside) result.push_back(border);
    return result;
  }

  const Image& image_;
  const Window& window_;
  bool far_east_;
  std::vector<Span> spans_;
  std::vector<Ordinate> levels_;
  std::vector<std::uint32_t> sides_;
};

}  // namespace

Window add_window(Image& image, const WindowBounds& bounds) {
  const auto corner = [&](std::int64_t x, std::int64_t y) { return image.add_vertex({x, y, bounds.unit}); };
  const std::uint32_t south_west = corner(bounds.low[0], bounds.low[1]);
  const std::uint32_t north_west = corner(bounds.low[0], bounds.high[1]);
  const std::uint32_t south_east = corner(bounds.high[0], bounds.low[1]);
  const std::uint32_t north_east = corner(bounds.high[0], bounds.high[1]);
  Window window;
  window.bounds = bounds;
  window.west = image.add_line(south_west, north_west);
  window.east = image.add_line(south_east, north_east);
  window.bottom = image.ordinate_of(south_west);
  window.top = image.ordinate_of(north_west);
  return window;
}

TrapezoidPcs clipped_pcs(const Image& image, std::span<const std::uint32_t> lines, const Window& window,
                         int far_side) {
  ClippedFace face(image, window, far_side);
  for (const std::uint32_t line : lines) face.add(line);
  return face.run();
}

Extent extent_of(const Image& image, std::uint32_t line, const Window* window) {
  const ImageLine& l = image.lines()[line];
  if (image.weight(l.from) > 0 && image.weight(l.to) > 0) {
    Extent extent{image.ordinate_of(l.from), image.ordinate_of(l.to)};
    if (image.compare(extent.low, extent.high) > 0) std::swap(extent.low, extent.high);
    return extent;
  }
  const std::uint32_t seen = image.end_before_eye(line);
  const std::uint32_t other = seen == l.from ? l.to : l.from;
  const Vertex& p = image.vertices()[seen];
  const Vertex& q = image.vertices()[other];
  const bool up = Int128{q.y} * p.z > Int128{p.y} * q.z;
  const Ordinate start = image.ordinate_of(seen);
  return up ? Extent{start, window->top} : Extent{window->bottom, start};
}

}  // namespace sightline::algorithms::montani_re
