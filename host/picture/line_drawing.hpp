// Makes a drawing of an exact line picture: coinciding lines are united, lines are projected, clipped to a window and
// joined, and hidden lines become a layer of dashed lines.
//
// The steps can be called one by one: united_lines (line_union.hpp) unites coinciding parts; drawing_window chooses the
// part of the image shown; strokes_in places the lines in it; line_drawing joins strokes to lines. The camera's image
// (see PolyCamera) is placed undistorted in the middle of the drawing's field.
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

// Angle of the shown image of a perspective camera when the scene surrounds the eye.
inline constexpr double widest_fitted_angle = 120;  // degrees
inline constexpr double usual_angle = 90;

struct DrawingField {
  double width = 200;  // of the drawing; dashes are measured in the same unit
  double height = 200;
  // The image's extent across the shorter side: degrees in perspective (0 < angle < 180), otherwise scene units. If
  // absent, the picture is fitted to the field; a perspective picture wider than widest_fitted_angle is cut to
  // usual_angle.
  std::optional<double> extent;
  // Units of the drawing per unit of the scene in parallel projection, instead of an extent. The middle of the drawn
  // lines is placed in the middle of the field, and nothing is clipped; the drawing is larger than the field if
  // necessary.
  std::optional<double> scale = {};
  double dash = 2;  // of hidden lines; the gap is three quarters as long
  // Shorter lines are left out, unless they close a gap: both of their ends meet other lines, at an end or between ends.
  double min_length = 0;
};

// The part of the image that a drawing shows. It has the drawing's proportions.
struct ImageWindow {
  std::array<double, 2> low{};
  std::array<double, 2> high{};

  // Units of the field per unit of the image.
  [[nodiscard]] double units(const DrawingField& field) const { return field.scale ? *field.scale : field.width / (high[0] - low[0]); }
  // The position in the field of a place of the image, in the field's unit from the bottom left.
  [[nodiscard]] std::array<double, 2> in_field(const std::array<double, 2>& place, const DrawingField& field) const;
};

// A straight line of a drawing. Strokes do not overlap.
struct LineStroke {
  std::array<double, 2> from{};  // in the image; the lesser end, by x and then by y
  std::array<double, 2> to{};
  std::uint32_t layer = 0;         // index of the given layers
  std::uint32_t first_source = 0;  // index into UnitedLines::sources
  std::uint32_t source_count = 0;
};

[[nodiscard]] ImageWindow drawing_window(const UnitedLines& lines, const scene::PolyCamera& camera, const DrawingField& field);
// Ordered by layer, then by position. A stroke on the border of the window belongs to it completely.
[[nodiscard]] std::vector<LineStroke> strokes_in(const UnitedLines& lines, std::span<const LineLayer> layers,
                                                 const ImageWindow& window, const DrawingField& field);
[[nodiscard]] VectorDrawing line_drawing(std::span<const LineStroke> strokes, std::span<const LineLayer> layers,
                                         const ImageWindow& window, const DrawingField& field);

// All steps. Precondition: the pictures are of this scene from this camera and share no piece of an edge.
[[nodiscard]] VectorDrawing line_drawing(std::span<const LineLayer> layers, const scene::PolyScene& scene,
                                         const scene::PolyCamera& camera, const DrawingField& field);
// The same with one layer, "visible".
[[nodiscard]] VectorDrawing line_drawing(const LinePicture& picture, const scene::PolyScene& scene,
                                         const scene::PolyCamera& camera, const DrawingField& field);

// The layer of hidden lines.
[[nodiscard]] LineLayer hidden_layer(LinePicture picture, std::string kind = {});

// All edges whole, hidden or not: a wire frame.
[[nodiscard]] LinePicture wire_frame(const scene::PolyScene& scene);

}  // namespace sightline::picture
