// See agreement_pictures.hpp.
#include "host/report/agreement/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "host/picture/line_drawing.hpp"
#include "host/picture/png.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::harness::report {

namespace {

constexpr int side = 200;  // pixels of one picture
constexpr int gap = 8;

picture::Image lines_image(const compare::CommonScene& scene, const compare::CrossCheckView& view,
                           const picture::LinePicture& lines) {
  const FaceWindow window = view.window();
  const double half = window.width / 2.0 / window.scale;
  picture::DrawingField field;
  field.extent = view.camera.perspective ? 360 / std::numbers::pi * std::atan(half) : 2 * half;
  return picture::image_of(picture::line_drawing(lines, scene.scene, view.camera, field), {side, side, 1.0});
}

// Every face in a light grey of its own, the background white.
picture::Image faces_image(const picture::PixelGrid& faces) {
  picture::Image image(side, side, 3);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const std::uint32_t face = faces.at(column * faces.width / side, row * faces.height / side);
      const auto grey = static_cast<std::uint8_t>(face == 0 ? 255 : 120 + face * 53 % 115);
      std::fill_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(column, side - 1 - row)), 3,
                  grey);
    }
  }
  return image;
}

picture::Image side_by_side(const std::vector<picture::Image>& images) {
  const auto count = static_cast<int>(images.size());
  picture::Image all(count * (side + gap) - gap, side, 3);
  std::fill(all.pixels.begin(), all.pixels.end(), std::uint8_t{255});
  for (int i = 0; i < count; ++i) {
    const picture::Image& image = images[static_cast<std::size_t>(i)];
    for (int row = 0; row < side; ++row)
      std::copy_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(0, row)), 3 * side,
                  all.pixels.begin() + static_cast<std::ptrdiff_t>(all.index(i * (side + gap), row)));
  }
  return all;
}

}  // namespace

Outcome<Figure> agreement_strip(const compare::CommonScene& scene,
                                const compare::SceneCrossCheck& agreement) {
  std::vector<picture::Image> images;
  std::string names;
  for (std::size_t who = 0; who < compare::participants().size(); ++who) {
    const compare::CrossCheckPicture& picture = agreement.pictures[who].front();
    const auto add = [&](picture::Image image, std::string_view what) {
      images.push_back(std::move(image));
      names += fmt::format("{}{}{}", names.empty() ? "" : ", ", compare::participants()[who].name, what);
    };
    if (picture.lines) add(lines_image(scene, scene.views.front(), *picture.lines), "");
    if (picture.faces) add(faces_image(*picture.faces), picture.lines ? " (faces)" : "");
  }
  if (images.empty())
    return ReportError{ErrorKind::differs, fmt::format("{}: nobody has a picture", scene.name)};
  auto png = picture::encode_png(side_by_side(images), {{"Software", "sightline"}});
  if (!png) return ReportError{ErrorKind::file, png.error().message()};
  std::string id = "agreement-";
  for (const char c : scene.name) id += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return Figure{id,
                fmt::format("{}: {}", scene.name, scene.title),
                fmt::format("From the left: {}.", names),
                fmt::format("The same picture of the scene {} by {} methods", scene.name, images.size()),
                "image/png",
                std::move(*png),
                false,
                false};
}

}  // namespace sightline::harness::report
