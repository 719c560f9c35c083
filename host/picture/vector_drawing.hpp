// A drawing made of lines and filled facets at real coordinates, and two of the files it can become: SVG in
// millimetres with Inkscape layers, and an image of any size. plotter.hpp makes HP-GL of it.
//
// Coordinates run from (0, 0) at the bottom left to (width, height). Facets are painted first, each over
// those before it; then the lines, which the facets do not cover: the caller has removed
// what is hidden. Deterministic: positions are rounded once, to a micrometre (SVG) or not at all (image:
// coverage by the distance of a pixel's middle from the line).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/picture/image.hpp"
#include "host/picture/line_metrics.hpp"

namespace sightline::picture {

struct DrawingPoint {
  float x = 0;
  float y = 0;

  friend bool operator==(const DrawingPoint&, const DrawingPoint&) = default;
};

struct DrawingLayer {
  std::string label;
  Colour colour;
  double dash = 0;  // in the drawing's unit, the gap after it three quarters of that; 0: its lines are solid
};

// `count` points from `first` on; a line of one point is a dot.
struct DrawingLine {
  std::uint32_t layer = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  friend bool operator==(const DrawingLine&, const DrawingLine&) = default;
};

// A simple polygon of 3 or 4 corners; one of 4 can be divided from its first corner to its third.
struct DrawingFacet {
  std::uint32_t first = 0;
  std::uint8_t count = 0;
  Colour colour = {};

  friend bool operator==(const DrawingFacet&, const DrawingFacet&) = default;
};

// The same as facets, joined to larger polygons for files of vectors. A program that smooths edges lets the paper shine through where
// two polygons only meet; so each also reaches under those that are nearer and next to it, which are painted over it.
// What lies within the line counts, whichever way and however often it runs around.
struct DrawingArea {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  Colour colour = {};

  friend bool operator==(const DrawingArea&, const DrawingArea&) = default;
};

struct VectorDrawing {
  double width = 0;
  double height = 0;
  std::vector<DrawingLayer> layers;
  std::vector<DrawingPoint> points;
  std::vector<DrawingLine> lines;
  std::vector<DrawingFacet> facets;  // far to near
  std::vector<DrawingArea> areas = {};  // far to near; empty: the facets
};

// The same drawing without the layers that have no lines: what every file of a drawing is made of, so that the number of a
// layer, and its pen, is the same in all of them.
[[nodiscard]] VectorDrawing without_empty_layers(VectorDrawing drawing);

// The paper: the drawing is stretched to its inside.
struct Paper {
  double width = 200;  // millimetres
  double height = 200;
  double margin = 10;  // on every side
  double pen = 0.2;    // width of a line
};

// One user unit is one millimetre. A dot becomes a dash of 0.02 mm, because many programs do not draw a path
// of no length. Facets are the layer "0 surface", lines the layers from 1 on.
[[nodiscard]] std::string svg_of(const VectorDrawing& drawing, const Paper& paper, const std::string& title);

// White paper, RGB. Lines have `pen` pixels of width with smooth edges; facets are sampled 3 x 3 in a pixel.
struct ImageSize {
  int width = 1024;  // pixels, 1 .. 8192
  int height = 1024;
  double pen = 1.2;
  // Pixels of a unit of the drawing, whose bottom left corner is then that of the image. 0: the drawing is stretched to
  // the image, half a pen and a smooth edge away from its borders.
  double unit = 0;
};
[[nodiscard]] Image image_of(const VectorDrawing& drawing, const ImageSize& size);

// Lines of dashed layers as dashes, each straight part of a line from end to end; for what draws no dashes by itself.
[[nodiscard]] VectorDrawing with_dashes(const VectorDrawing& drawing);

// The same drawing with the paper's margin around it, for an image of the whole sheet.
[[nodiscard]] VectorDrawing with_margin(VectorDrawing drawing, const Paper& paper);

// Filled areas with holes as SVG in millimetres: what an algorithm gives that rebuilds the outlines of what
// is seen of faces. Areas do not overlap (precondition), so that their order means nothing.

// Closed lines; what lies inside an odd number of them is filled.
struct FilledArea {
  Colour colour;
  std::vector<std::vector<PixelPoint>> loops;  // micrometres from the bottom left of the paper's inside
};

// Cut to the inside of the paper. Positions are rounded to a micrometre.
[[nodiscard]] std::string svg_of(const std::vector<FilledArea>& areas, const Paper& paper,
                                 const std::string& title);

}  // namespace sightline::picture
