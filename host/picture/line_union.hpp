// Unites pieces of different edges that lie on one line of the image, so that each part of the line is drawn once.
//
// Edges that coincide in the image are common: bricks side by side, a view along an axis, an edge exactly behind another.
// Where pieces overlap, the first layer with a piece there keeps the stretch; hidden layers come last, so that no dash
// lies on a visible line. Pieces of one layer that touch on one line are joined. Edges seen as points are left out.
//
// Exact for edges between vertices: they are grouped by the plane through the eye and the edge, and ends in a group that
// are near each other are compared as fractions. Ends of crossings (PolyScene::crossings), which have more than 128 bits,
// are equal to others if they are within 10^-9 of their place in the image.
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

// Pieces that are drawn with one pen. Consecutive layers with the same label, colour and `hidden` are one layer of a
// drawing.
struct LineLayer {
  std::string label;
  LinePicture picture;
  Colour colour = {};     // black
  std::string kind = {};  // kind of the edges, as in Stroke::kind; empty: unknown
  bool hidden = false;    // drawn dashed
};

struct UnitedLine {
  // The ends are points of source edges: right, up and depth relative to the eye, along axes of length 1; depth is 1 in
  // parallel projection. In perspective a line may reach infinity, where its depth is 0, and a line of a single edge may
  // pass the eye.
  std::array<double, 3> from{};
  std::array<double, 3> to{};
  std::uint32_t layer = 0;
  std::uint32_t first_source = 0;
  std::uint32_t source_count = 0;
};

struct UnitedLines {
  std::vector<UnitedLine> lines;
  // The edges on each line, ascending: for a visible line those with a visible piece there, otherwise hidden ones.
  std::vector<LineEdge> sources;
};

// Precondition: the pictures are of this scene from this camera and share no piece of an edge.
[[nodiscard]] UnitedLines united_lines(std::span<const LineLayer> layers, const scene::PolyScene& scene,
                                       const scene::PolyCamera& camera);

// The parts of whole edges (from parameter 0 to 1, ascending) that the visible picture lacks.
[[nodiscard]] LinePicture hidden_pieces(const LinePicture& edges, const LinePicture& visible);

}  // namespace sightline::picture
