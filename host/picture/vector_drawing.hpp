// A drawing of lines and filled facets at real coordinates, written as SVG in millimetres with Inkscape layers, or as an
// image of any size. plotter.hpp writes HP-GL.
//
// Coordinates range from (0, 0) at the bottom left to (width, height). Facets are painted first, each over those before
// it. The lines follow, which facets do not cover: the caller has already removed hidden lines. Deterministic: positions
// are rounded once, to a micrometre (SVG), or not at all (image: coverage by the distance of a pixel's middle from the
// line).
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
  double dash = 0;  // in the drawing's unit; the gap is three quarters as long; 0: solid lines
};

// `count` points from index `first`. A line of one point is a dot.
struct DrawingLine {
  std::uint32_t layer = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  friend bool operator==(const DrawingLine&, const DrawingLine&) = default;
};

// A simple polygon of 3 or 4 corners. With 4 corners, the diagonal from the first to the third is inside it.
struct DrawingFacet {
  std::uint32_t first = 0;
  std::uint8_t count = 0;
  Colour colour = {};

  friend bool operator==(const DrawingFacet&, const DrawingFacet&) = default;
};

// The facets joined to larger polygons, for vector files. A program that smooths edges lets the paper shine through
// between polygons that only meet, so each area also extends under nearer adjacent areas, which are painted over it.
// Everything within the outline is filled, whatever the direction and number of turns.
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
  std::vector<DrawingArea> areas = {};  // far to near; empty: use the facets
};

// The same drawing without layers that have no lines. Every file of a drawing is made from it, so a layer has the same
// number, and the same pen, in all of them.
[[nodiscard]] VectorDrawing without_empty_layers(VectorDrawing drawing);

// The paper. The drawing is stretched to the area inside its margin.
struct Paper {
  double width = 200;  // millimetres
  double height = 200;
  double margin = 10;  // on every side
  double pen = 0.2;    // width of a line
};

// One user unit is one millimetre. A dot becomes a dash of 0.02 mm, because many programs do not draw a path of length 0.
// Facets are in the layer "0 surface", lines in layers from 1 on.
[[nodiscard]] std::string svg_of(const VectorDrawing& drawing, const Paper& paper, const std::string& title);

// A white image, RGB. Lines are `pen` pixels wide with smooth edges; facets are sampled 3 x 3 times per pixel.
struct ImageSize {
  int width = 1024;  // pixels, 1 .. 8192
  int height = 1024;
  double pen = 1.2;
  // Pixels per unit of the drawing, whose bottom left corner is then that of the image. 0: the drawing is stretched to
  // the image, except for half a pen and a smooth edge at its borders.
  double unit = 0;
};
[[nodiscard]] Image image_of(const VectorDrawing& drawing, const ImageSize& size);

// Replaces lines of dashed layers by dashes, for each straight part of a line from end to end. For formats without
// dashes.
[[nodiscard]] VectorDrawing with_dashes(const VectorDrawing& drawing);

// The same drawing with the paper's margin around it, for an image of the whole sheet.
[[nodiscard]] VectorDrawing with_margin(VectorDrawing drawing, const Paper& paper);

// Filled areas with holes as SVG in millimetres, for algorithms that rebuild the outlines of the visible regions of
// faces. Precondition: areas do not overlap, so their order does not matter.

// Closed lines. What is inside an odd number of them is filled.
struct FilledArea {
  Colour colour;
  std::vector<std::vector<PixelPoint>> loops;  // micrometres from the bottom left of the area inside the margin
};

// Clipped to the area inside the margin. Positions are rounded to a micrometre.
[[nodiscard]] std::string svg_of(const std::vector<FilledArea>& areas, const Paper& paper,
                                 const std::string& title);

}  // namespace sightline::picture
