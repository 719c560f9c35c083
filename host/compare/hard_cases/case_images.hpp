// Small images of a method's result: of lines, of faces and dots, and of pieces on the screen of the Type 340; and a
// triple of expected, found and difference.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/picture/image.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

inline constexpr int case_image_side = 160;  // pixels

// Visible lines. `extent` is that of picture::DrawingField. Without it, the whole image, or 90 degrees in
// perspective, with hidden edges dashed.
[[nodiscard]] picture::Image lines_image(const picture::LinePicture& lines, const scene::PolyScene& scene,
                                         const scene::PolyCamera& camera, std::optional<double> extent = {},
                                         int side = case_image_side);
// The pieces on 1024 x 1024 points.
[[nodiscard]] picture::Image screen_image(const std::vector<picture::DrawnPiece>& pieces, int side = case_image_side);
// Each face in a light grey of its own, the background white; `side` pixels a side.
[[nodiscard]] picture::Image faces_image(const picture::PixelGrid& faces, int side);
// Lit dots in black, one pixel each.
[[nodiscard]] picture::Image dots_image(const picture::PixelGrid& dots);

// Two grey images of one size (precondition) side by side, and their difference at the right: common parts in pale
// grey, orange where `found` lacks something dark, blue where it has more. RGB; with a line of text above each.
[[nodiscard]] picture::Image side_by_side(const picture::Image& expected, const picture::Image& found, const std::string& found_by);

}  // namespace sightline::compare
