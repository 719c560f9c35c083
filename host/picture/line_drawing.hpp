// An exact line picture as a drawing: lines that coincide united, projected, cut to a window, lines that follow each other
// joined, hidden ones as a layer of dashed lines.
//
// In three steps, which a caller may take one by one: united_lines (line_union.hpp) gives each stretch of the image once;
// drawing_window chooses what is shown; strokes_in places the stretches in it. line_drawing joins strokes to lines.
// The camera's image (see PolyCamera) is placed undistorted in the middle of the drawing's field.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/picture/line_picture.hpp"
#include "host/picture/line_union.hpp"
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
  // Lines shorter than this are left out, unless they close a gap: both of their ends meet other lines, at an end or within.
  double min_length = 0;
};

// The part of the image that a drawing shows; it is as wide and as high as the drawing.
struct ImageWindow {
  std::array<double, 2> low{};
  std::array<double, 2> high{};

  // Units of the field for one of the image.
  [[nodiscard]] double units(const DrawingField& field) const { return field.scale ? *field.scale : field.width / (high[0] - low[0]); }
  // Where a place of the image lies in the field, in its unit from the bottom left.
  [[nodiscard]] std::array<double, 2> in_field(const std::array<double, 2>& place, const DrawingField& field) const;
};

// A straight line of a drawing: a stretch of the image that is drawn once.
struct LineStroke {
  std::array<double, 2> from{};  // in the image; the lower of both ends, by x and then by y
  std::array<double, 2> to{};
  std::uint32_t layer = 0;         // of the layers that were united
  std::uint32_t first_source = 0;  // of UnitedLines::sources
  std::uint32_t source_count = 0;
};

[[nodiscard]] ImageWindow drawing_window(const UnitedLines& lines, const scene::PolyCamera& camera, const DrawingField& field);
// By layer, and then ascending. A stroke on the border of the window is in it as a whole.
[[nodiscard]] std::vector<LineStroke> strokes_in(const UnitedLines& lines, std::span<const LineLayer> layers,
                                                 const ImageWindow& window, const DrawingField& field);
[[nodiscard]] VectorDrawing line_drawing(std::span<const LineStroke> strokes, std::span<const LineLayer> layers,
                                         const ImageWindow& window, const DrawingField& field);

// All steps: pictures of this scene from this camera, which share no piece of an edge.
[[nodiscard]] VectorDrawing line_drawing(std::span<const LineLayer> layers, const scene::PolyScene& scene,
                                         const scene::PolyCamera& camera, const DrawingField& field);
// With one layer, "visible".
[[nodiscard]] VectorDrawing line_drawing(const LinePicture& picture, const scene::PolyScene& scene,
                                         const scene::PolyCamera& camera, const DrawingField& field);

// The layer of hidden lines.
[[nodiscard]] LineLayer hidden_layer(LinePicture picture, std::string kind = {});

// Every edge whole, hidden or not: what a wire frame shows.
[[nodiscard]] LinePicture wire_frame(const scene::PolyScene& scene);

}  // namespace sightline::picture
