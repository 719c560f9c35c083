// A frame as the priority display is given it: for every surface turned to the eye the points it covers, line
// by line of the scan, with its priority.
//
// Column c from the left and line r from the top have their point at (c + 1/2, r + 1/2). Pieces of one face
// have its number, so that cuts do not show; they overlap by a millionth of a point, so that no point falls
// between them either.
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

// What of the image plane (PolyCamera) is shown: the point (x, y) at column `left + scale x` and line
// `top - scale y`.
struct ImageWindow {
  int width = 512;
  int height = 512;
  double scale = 256;
  double left = 256;  // column of x = 0
  double top = 256;   // line of y = 0
};

// Square with the picture, straight ahead, `extent` across its shorter side: degrees, or scene units without
// perspective.
[[nodiscard]] ImageWindow window_ahead(const scene::PolyCamera& camera, int width, int height, double extent);
// Shows all of the scene that is before the eye, at most 90 degrees of it.
[[nodiscard]] ImageWindow window_around(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                        int width, int height);

struct Span {
  std::uint16_t from = 0;  // column
  std::uint16_t to = 0;    // excluded
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

// Pieces in ascending priority -> what they cover; those that cover no point are left out. Written over the
// last frame's.
void make_spans(const Model& model, std::span<const std::uint32_t> order, const scene::PolyCamera& camera,
                const ImageWindow& window, FrameSpans& frame);

// Face number + 1 of the highest priority at each point, 0 where there is nothing. The bottom row first.
[[nodiscard]] picture::PixelGrid resolved(const FrameSpans& frame, const ImageWindow& window);

// 1 where the face to the left or below is another one, 0 elsewhere.
[[nodiscard]] picture::PixelGrid outlines(const picture::PixelGrid& faces);

}  // namespace sightline::algorithms::willis
