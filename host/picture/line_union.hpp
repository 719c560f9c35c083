// Each stretch of a line of the image once: pieces of different edges that lie on one line of the image are united.
//
// Edges that coincide in the image are common: bricks side by side, any view along an axis, an edge exactly behind
// another. Where pieces overlap, the first layer that has one there keeps the stretch; hidden layers come last, so that no
// dash lies on a visible line. Pieces of one layer that touch on one line become one. What is seen as a point is left out.
//
// Exact for edges between vertices: they are grouped by the plane through the eye and the edge, and within a group ends that are
// near each other are compared as fractions. Ends of crossings (PolyScene::crossings), which have more than 128 bits, are equal
// to others within 10^-9 of their place in the image.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/picture/image.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

// Pieces that are drawn with one pen. Layers that follow each other and have the same label and colour, and are hidden or not, are
// one layer of a drawing.
struct LineLayer {
  std::string label;
  LinePicture picture;
  Colour colour = {};     // black
  std::string kind = {};  // of the edges, as strokes are named; empty: not known
  bool hidden = false;    // drawn dashed
};

struct UnitedLine {
  // Ends: right, up and depth of points of source edges, relative to the eye, by axes of length 1; depth is 1 without
  // perspective. In perspective a line may reach infinity, where its depth is 0, and one of a single edge may pass the eye.
  std::array<double, 3> from{};
  std::array<double, 3> to{};
  std::uint32_t layer = 0;
  std::uint32_t first_source = 0;
  std::uint32_t source_count = 0;
};

struct UnitedLines {
  std::vector<UnitedLine> lines;
  // Edges that lie on each line, ascending for each: of a visible line those with a visible piece there, else hidden ones.
  std::vector<LineEdge> sources;
};

// The pictures are of this scene from this camera and share no piece of an edge.
[[nodiscard]] UnitedLines united_lines(std::span<const LineLayer> layers, const scene::PolyScene& scene,
                                       const scene::PolyCamera& camera);

// What of whole edges, from parameter 0 to 1 and ascending, the visible picture does not have.
[[nodiscard]] LinePicture hidden_pieces(const LinePicture& edges, const LinePicture& visible);

}  // namespace sightline::picture
