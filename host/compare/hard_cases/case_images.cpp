#include "host/compare/hard_cases/case_images.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/picture/line_drawing.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::compare {

namespace {

// One value for each pixel, the bottom row of the grid last.
template <class Value>
picture::Image greys(int width, int height, Value value) {
  picture::Image image(width, height, 1);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) image.pixels[image.index(column, height - 1 - row)] = value(column, row);
  return image;
}

// Black lines as greys: one byte for each pixel.
picture::Image image_of(const picture::VectorDrawing& drawing) {
  const picture::Image colours = picture::image_of(drawing, {case_image_side, case_image_side, 1.1});
  picture::Image image(colours.width, colours.height, 1);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = colours.pixels[3 * i];
  return image;
}

}  // namespace

picture::Image lines_image(const picture::LinePicture& lines, const scene::PolyScene& scene, const scene::PolyCamera& camera,
                           std::optional<double> extent) {
  picture::DrawingField field;
  field.dash = 3;
  field.extent = extent;
  if (!extent && camera.perspective) field.extent = picture::usual_angle;
  std::vector<picture::LineLayer> layers{{"visible", lines}};
  if (!extent) layers.push_back(picture::hidden_layer(picture::hidden_pieces(picture::wire_frame(scene), lines)));
  return image_of(picture::with_dashes(picture::line_drawing(layers, scene, camera, field)));
}

picture::Image screen_image(const std::vector<picture::DrawnPiece>& pieces) {
  picture::VectorDrawing drawing;
  drawing.width = drawing.height = 1024;
  drawing.layers = {{"visible", {0, 0, 0}}};
  for (const picture::DrawnPiece& piece : pieces) {
    drawing.lines.push_back({0, static_cast<std::uint32_t>(drawing.points.size()), 2});
    for (const picture::PixelPoint& end : {piece.image.a, piece.image.b})
      drawing.points.push_back({static_cast<float>(end.x), static_cast<float>(end.y)});
  }
  return image_of(drawing);
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

}  // namespace sightline::compare
