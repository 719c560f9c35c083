// The image of a VectorDrawing. Uses only +, -, *, / and square roots, which all machines round alike.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {
namespace {

constexpr int samples = 3;  // of a facet per pixel, in each direction

struct ImagePlace {
  double x = 0;
  double y = 0;  // downwards
};

class Canvas {
 public:
  Canvas(const VectorDrawing& drawing, const ImageSize& size)
      : drawing_(drawing),
        image_(std::clamp(size.width, 1, 8192), std::clamp(size.height, 1, 8192), 3),
        pen_(size.pen),
        margin_(size.unit > 0 ? 0 : size.pen / 2 + 0.5),
        across_(size.unit > 0 ? size.unit : (image_.width - 2 * margin_) / drawing.width),
        down_(size.unit > 0 ? size.unit : (image_.height - 2 * margin_) / drawing.height) {
    std::fill(image_.pixels.begin(), image_.pixels.end(), std::uint8_t{255});
  }

  void facets() {
    if (drawing_.facets.empty()) return;
    // A band of rows at a time, so that samples take little memory.
    constexpr int band = 64;
    std::vector<Colour> paint;
    for (int top = 0; top < image_.height; top += band) {
      const int rows = std::min(band, image_.height - top) * samples;
      paint.assign(static_cast<std::size_t>(rows) * static_cast<std::size_t>(image_.width * samples), {255, 255, 255});
      for (const DrawingFacet& facet : drawing_.facets) {
        std::array<ImagePlace, 4> corners{};
        double least = 1e9;
        double most = -1e9;
        for (std::size_t i = 0; i < facet.count; ++i) {
          corners[i] = place(drawing_.points[facet.first + i]);
          corners[i].x = corners[i].x * samples - 0.5;
          corners[i].y = (corners[i].y - top) * samples - 0.5;
          least = std::min(least, corners[i].y);
          most = std::max(most, corners[i].y);
        }
        if (most < 0 || least > rows) continue;
        triangle(paint, rows, {corners[0], corners[1], corners[2]}, facet.colour);
        if (facet.count == 4) triangle(paint, rows, {corners[0], corners[2], corners[3]}, facet.colour);
      }
      take(paint, top, rows / samples);
    }
  }

  void lines() {
    for (std::uint32_t layer = 0; layer < drawing_.layers.size(); ++layer) {
      const auto in_layer = [&](const DrawingLine& line) { return line.layer == layer; };
      if (std::none_of(drawing_.lines.begin(), drawing_.lines.end(), in_layer)) continue;
      coverage_.assign(image_.pixels.size() / 3, 0.0F);
      for (const DrawingLine& line : drawing_.lines)
        if (in_layer(line)) polyline(line);
      ink(drawing_.layers[layer].colour);
    }
  }

  [[nodiscard]] Image image() && { return std::move(image_); }

 private:
  [[nodiscard]] ImagePlace place(DrawingPoint point) const {
    return {margin_ + double{point.x} * across_, image_.height - margin_ - double{point.y} * down_};
  }

  // Sample (c, r) is at (c, r); samples on the edge are inside.
  void triangle(std::vector<Colour>& paint, int rows, const std::array<ImagePlace, 3>& corners, Colour shade) const {
    const int columns = image_.width * samples;
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const int last = std::min(static_cast<int>(std::floor(std::min(high, 1e6))), rows - 1);
    for (int row = static_cast<int>(std::ceil(std::max(low, 0.0))); row <= last; ++row) {
      double left = 1e9;
      double right = -1e9;
      for (std::size_t i = 0; i < 3; ++i) {
        const ImagePlace a = corners[i];
        const ImagePlace b = corners[(i + 1) % 3];
        if ((a.y > row && b.y > row) || (a.y < row && b.y < row)) continue;
        const double x = a.y == b.y ? a.x : a.x + (b.x - a.x) * ((row - a.y) / (b.y - a.y));
        left = std::min({left, x, a.y == b.y ? b.x : x});
        right = std::max({right, x, a.y == b.y ? b.x : x});
      }
      const int from = static_cast<int>(std::ceil(std::max(left, 0.0)));
      const int to = std::min(static_cast<int>(std::floor(std::max(right, -1.0))), columns - 1);
      if (from > to) continue;
      const auto start = paint.begin() + static_cast<std::ptrdiff_t>(row) * columns;
      std::fill(start + from, start + to + 1, shade);
    }
  }

  void take(const std::vector<Colour>& paint, int top, int rows) {
    const std::size_t width = static_cast<std::size_t>(image_.width) * samples;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < image_.width; ++column) {
        std::array<int, 3> sums{};
        for (std::size_t i = 0; i < samples; ++i)
          for (std::size_t j = 0; j < samples; ++j) {
            const Colour& sample = paint[(static_cast<std::size_t>(row) * samples + i) * width +
                                         static_cast<std::size_t>(column) * samples + j];
            sums[0] += sample.red;
            sums[1] += sample.green;
            sums[2] += sample.blue;
          }
        constexpr int all = samples * samples;
        for (std::size_t k = 0; k < 3; ++k)
          image_.pixels[image_.index(column, top + row) + k] = static_cast<std::uint8_t>((2 * sums[k] + all) / (2 * all));
      }
  }

  void polyline(const DrawingLine& line) {
    ImagePlace before = place(drawing_.points[line.first]);
    if (line.count == 1) stroke(before, before);
    for (std::uint32_t i = 1; i < line.count; ++i) {
      const ImagePlace here = place(drawing_.points[line.first + i]);
      stroke(before, here);
      before = here;
    }
  }

  // A pixel's coverage is how far the line's round-ended body extends over its middle.
  void stroke(ImagePlace a, ImagePlace b) {
    const double reach = pen_ / 2 + 0.5;
    const double ux = b.x - a.x;
    const double uy = b.y - a.y;
    const double square = ux * ux + uy * uy;
    const auto pixel = [](double value, int size) {
      return std::clamp(static_cast<int>(std::floor(value)), 0, size - 1);
    };
    const int bottom = pixel(std::max(a.y, b.y) + reach, image_.height);
    for (int row = pixel(std::min(a.y, b.y) - reach, image_.height); row <= bottom; ++row) {
      const double y = row + 0.5;
      // The columns where the line comes near this row.
      double from = std::min(a.x, b.x);
      double to = std::max(a.x, b.x);
      if (std::abs(uy) > 1) {
        const double s = std::clamp((y - 1.5 * reach - a.y) / uy, 0.0, 1.0);
        const double t = std::clamp((y + 1.5 * reach - a.y) / uy, 0.0, 1.0);
        from = a.x + ux * std::min(s, t);
        to = a.x + ux * std::max(s, t);
        if (from > to) std::swap(from, to);
      }
      const int right = pixel(to + reach, image_.width);
      for (int column = pixel(from - reach, image_.width); column <= right; ++column) {
        const double x = column + 0.5;
        const double along =
            square > 0 ? std::clamp(((x - a.x) * ux + (y - a.y) * uy) / square, 0.0, 1.0) : 0.0;
        const double dx = x - (a.x + along * ux);
        const double dy = y - (a.y + along * uy);
        const double away = dx * dx + dy * dy;
        if (away >= reach * reach) continue;
        const auto cover = static_cast<float>(std::min(1.0, reach - std::sqrt(away)));
        float& covered = coverage_[image_.index(column, row) / 3];
        covered = std::max(covered, cover);
      }
    }
  }

  void ink(Colour colour) {
    const std::array<std::uint8_t, 3> parts{colour.red, colour.green, colour.blue};
    for (std::size_t i = 0; i < coverage_.size(); ++i) {
      const float cover = coverage_[i];
      if (cover <= 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint8_t& value = image_.pixels[3 * i + k];
        const float mixed = static_cast<float>(value) + cover * static_cast<float>(parts[k] - value);
        value = static_cast<std::uint8_t>(mixed + 0.5F);
      }
    }
  }

  const VectorDrawing& drawing_;
  Image image_;
  double pen_;
  double margin_;  // half a pen and a smooth edge on every side, or 0
  double across_;
  double down_;
  std::vector<float> coverage_;  // of every pixel by the current layer
};

}  // namespace

Image image_of(const VectorDrawing& drawing, const ImageSize& size) {
  Canvas canvas(drawing, size);
  canvas.facets();
  canvas.lines();
  return std::move(canvas).image();
}

}  // namespace sightline::picture
