#include "host/compare/hard_cases/case_images.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/picture/lettering.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/overlay.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::compare {

namespace {

// One value per pixel; the bottom row of the grid is last.
template <class Value>
picture::Image greys(int width, int height, Value value) {
  picture::Image image(width, height, 1);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) image.pixels[image.index(column, height - 1 - row)] = value(column, row);
  return image;
}

// Black lines as greys, one byte per pixel.
picture::Image image_of(const picture::VectorDrawing& drawing, int side) {
  const picture::Image colours = picture::image_of(drawing, {side, side, 1.1});
  picture::Image image(colours.width, colours.height, 1);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = colours.pixels[3 * i];
  return image;
}

}  // namespace

picture::Image lines_image(const picture::LinePicture& lines, const scene::PolyScene& scene, const scene::PolyCamera& camera,
                           std::optional<double> extent, int side) {
  picture::DrawingField field;
  field.dash = 3;
  field.extent = extent;
  if (!extent && camera.perspective) field.extent = picture::usual_angle;
  std::vector<picture::LineLayer> layers{{"visible", lines}};
  if (!extent) layers.push_back(picture::hidden_layer(picture::hidden_pieces(picture::wire_frame(scene), lines)));
  return image_of(picture::with_dashes(picture::line_drawing(layers, scene, camera, field)), side);
}

picture::Image screen_image(const std::vector<picture::DrawnPiece>& pieces, int side) {
  picture::VectorDrawing drawing;
  drawing.width = drawing.height = 1024;
  drawing.layers = {{"visible", {0, 0, 0}}};
  for (const picture::DrawnPiece& piece : pieces) {
    drawing.lines.push_back({0, static_cast<std::uint32_t>(drawing.points.size()), 2});
    for (const picture::PixelPoint& end : {piece.image.a, piece.image.b})
      drawing.points.push_back({static_cast<float>(end.x), static_cast<float>(end.y)});
  }
  return image_of(drawing, side);
}

picture::Image faces_image(const picture::PixelGrid& faces, int side) {
  return greys(side, side, [&](int column, int row) {
    const std::uint32_t face = faces.at(column * faces.width / side, row * faces.height / side);
    return static_cast<std::uint8_t>(face == 0 ? 255 : 120 + face * 53 % 115);
  });
}

picture::Image dots_image(const picture::PixelGrid& dots) {
  return greys(dots.width, dots.height,
               [&](int column, int row) { return static_cast<std::uint8_t>(dots.at(column, row) == 0 ? 255 : 0); });
}

picture::Image side_by_side(const picture::Image& expected, const picture::Image& found, const std::string& found_by) {
  constexpr int gap = 8;
  constexpr int band = 32;  // height of the text's band
  const int width = expected.width;
  const int height = expected.height;
  picture::VectorDrawing text;
  text.width = 3 * width + 4 * gap;
  text.height = height + band + gap;
  text.layers = {{"text", {0, 0, 0}}, {"frame", {190, 190, 190}}};
  const auto left = [&](int panel) { return gap + panel * (width + gap); };
  const std::array titles{std::string("expected"), "found by " + found_by, std::string("difference: orange missing, blue extra")};
  for (int panel = 0; panel < 3; ++panel) {
    const std::string& title = titles[static_cast<std::size_t>(panel)];
    constexpr double high = 12;
    picture::append_text(text, 0, left(panel), height + gap + (band - high) / 2,
                         high * std::min(1.0, (width - gap) / picture::text_width(high, title)), title);
    const double x = left(panel);
    for (const auto& [x0, y0, x1, y1] : {std::array{x, 0.0 + gap, x + width, 0.0 + gap}, std::array{x + width, 0.0 + gap, x + width, 0.0 + gap + height},
                                         std::array{x + width, 0.0 + gap + height, x, 0.0 + gap + height}, std::array{x, 0.0 + gap + height, x, 0.0 + gap}})
      picture::append_line(text, 1, x0, y0, x1, y1);
  }
  picture::Image image = picture::image_of(text, {static_cast<int>(text.width), static_cast<int>(text.height), 1.2, 1});
  const auto put = [&](int panel, int column, int row, const picture::Colour& colour) {
    const std::size_t at = image.index(left(panel) + column, band + row);
    image.pixels[at] = colour.red;
    image.pixels[at + 1] = colour.green;
    image.pixels[at + 2] = colour.blue;
  };
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const std::uint8_t right = expected.pixels[expected.index(column, row)];
      const std::uint8_t wrong = found.pixels[found.index(column, row)];
      const auto pale = static_cast<std::uint8_t>(255 - (255 - right) / 4);
      put(0, column, row, {right, right, right});
      put(1, column, row, {wrong, wrong, wrong});
      put(2, column, row, right == wrong ? picture::Colour{pale, pale, pale} : wrong > right ? picture::difference_colours::missing
                                                                                     : picture::difference_colours::extra);
    }
  }
  return image;
}

}  // namespace sightline::compare
