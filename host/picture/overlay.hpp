// Two pictures overlaid, with a legend: common parts are grey, missing parts orange, extra parts blue. Colour-blind
// readers can distinguish these colours.
//
// Missing and extra are drawn over agreed, so an extra part on a visible line is shown. The result is a VectorDrawing for
// an image, for an SVG with one layer each, or for a page.
#pragma once

#include <string>

#include "host/picture/image.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

// For all pictures of differences. Missing is an orange of Okabe and Ito (2008).
namespace difference_colours {
inline constexpr Colour agreed{110, 110, 110};
inline constexpr Colour missing{213, 94, 0};
inline constexpr Colour extra{0, 90, 200};
}  // namespace difference_colours

// Printable ASCII.
struct OverlayCaption {
  std::string title;
  std::string agreed = "agreed";
  std::string missing = "missing";
  std::string extra = "extra";
};

struct Overlay {
  VectorDrawing drawing;  // layers legend, agreed, missing, extra
  double pen = 1;         // in the drawing's units, an integer
};

// The part of the screen from low to high, inclusive, becomes 1024 units wide.
[[nodiscard]] Overlay overlay_of(const LineDifference& difference, const PixelPoint& low,
                                 const PixelPoint& high, const OverlayCaption& caption);
// Pixels that are not 0 are lit; those lit in both with different values count as extra. Precondition: both grids have
// the same size.
[[nodiscard]] Overlay overlay_of(const PixelGrid& reference, const PixelGrid& drawn,
                                 const OverlayCaption& caption);

// One pixel per unit, surrounded by the pen's width: 1027 pixels wide for lines.
[[nodiscard]] Image overlay_image(const Overlay& overlay);
// 200 mm wide.
[[nodiscard]] std::string overlay_svg(const Overlay& overlay, const std::string& title);

}  // namespace sightline::picture
