// A frame in the form that the priority display receives: for every surface turned to the eye, its priority and the
// points it covers, by scan line.
//
// Column c from the left and line r from the top have their point at (c + 1/2, r + 1/2). All pieces of a face have the
// face's number, so cuts are invisible. They overlap by a millionth of a point, so no point falls between them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

// The shown part of the image plane (PolyCamera): the point (x, y) is at column `left + scale x` and line `top - scale
// y`.
struct ImageWindow {
  int width = 512;
  int height = 512;
  double scale = 256;
  double left = 256;  // column of x = 0
  double top = 256;   // line of y = 0
};

// A window straight ahead, with `extent` across the shorter side of the picture: in degrees, or in scene units for
// parallel projection.
[[nodiscard]] ImageWindow window_ahead(const scene::PolyCamera& camera, int width, int height, double extent);
// A window that shows the whole part of the scene in front of the eye, but at most 90 degrees.
[[nodiscard]] ImageWindow window_around(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                        int width, int height);

struct Span {
  std::uint16_t from = 0;  // column
  std::uint16_t to = 0;    // exclusive
};

struct SurfaceSpans {
  std::uint32_t piece = 0;
  std::uint32_t face = 0;
  std::uint32_t priority = 0;  // from 1
  std::uint32_t first_line = 0;
  std::uint32_t first_span = 0;  // one per line
  std::uint32_t line_count = 0;
};

struct FrameSpans {
  std::vector<SurfaceSpans> surfaces;  // ascending by priority
  std::vector<Span> spans;
};

// Computes what pieces, given in ascending priority, cover. Pieces that cover no point are omitted. Overwrites the last
// frame.
void make_spans(const Model& model, std::span<const std::uint32_t> order, const scene::PolyCamera& camera,
                const ImageWindow& window, FrameSpans& frame);

// At each point, the face number + 1 of the highest priority, or 0. The bottom row is first.
[[nodiscard]] picture::PixelGrid resolve_priorities(const FrameSpans& frame, const ImageWindow& window);

// 1 where the face to the left or below differs, otherwise 0.
[[nodiscard]] picture::PixelGrid outlines(const picture::PixelGrid& faces);

}  // namespace sightline::algorithms::willis
