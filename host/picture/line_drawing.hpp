// An exact line picture as a drawing: projected, cut to a window, pieces that follow each other joined to
// lines, parts that are hidden as dashes.
//
// The camera's image (see PolyCamera) is placed undistorted in the middle of the drawing's field. Only here
// do exact parameters become real coordinates. Lines that coincide are drawn once where both their ends do.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "host/picture/line_picture.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

// Angle of the image of a camera in perspective that is shown when a scene is all around the eye.
inline constexpr double widest_fitted_angle = 120;  // degrees
inline constexpr double usual_angle = 90;

struct DrawingField {
  double width = 200;  // of the drawing; its unit is what dashes are measured in
  double height = 200;
  // The image's extent across the shorter side: degrees in perspective (0 < angle < 180), otherwise scene
  // units. Without it the picture is fitted to the field; where a perspective picture is wider than
  // widest_fitted_angle, it is cut to usual_angle.
  std::optional<double> extent;
  // Units of the drawing for one of the scene, without perspective, instead of an extent: the middle of what is drawn is
  // that of the field, and nothing is cut off. The drawing is larger than the field where it has to be.
  std::optional<double> scale = {};
  double dash = 2;  // of hidden lines, and the gap after it three quarters of that
};

// Lines of one layer of a drawing.
struct LineLayer {
  std::string label;
  LinePicture picture;
  Colour colour = {};  // black
};

// The part of the image that a drawing shows; it is as wide and as high as the drawing.
struct ImageWindow {
  std::array<double, 2> low{};
  std::array<double, 2> high{};
};

// Of pictures of this scene from this camera, which share no piece: a layer each. With `edges`, whole edges from
// parameter 0 to 1, the last layer is what of them is before the eye and in none of the pictures.
[[nodiscard]] VectorDrawing line_drawing(std::span<const LineLayer> layers, const scene::PolyScene& scene,
                                         const scene::PolyCamera& camera, const DrawingField& field,
                                         const LinePicture* edges = nullptr);
// The window that such a drawing has, and a drawing with a window.
[[nodiscard]] ImageWindow drawing_window(std::span<const LineLayer> layers, const scene::PolyScene& scene,
                                         const scene::PolyCamera& camera, const DrawingField& field,
                                         const LinePicture* edges = nullptr);
[[nodiscard]] VectorDrawing line_drawing(std::span<const LineLayer> layers, const scene::PolyScene& scene,
                                         const scene::PolyCamera& camera, const DrawingField& field,
                                         const ImageWindow& window, const LinePicture* edges = nullptr);
// With one layer, "visible".
[[nodiscard]] VectorDrawing line_drawing(const LinePicture& picture, const scene::PolyScene& scene,
                                         const scene::PolyCamera& camera, const DrawingField& field,
                                         const LinePicture* edges = nullptr);

// Every edge whole, hidden or not: what a wire frame shows.
[[nodiscard]] LinePicture wire_frame(const scene::PolyScene& scene);

}  // namespace sightline::picture
