// Two pictures over each other: common parts in grey, parts missing in the drawing in orange, extra parts
// in blue, with a legend. Colour-blind people can distinguish the colours, too.
//
// Missing and extra lie over what agrees, so an extra stretch on a line that is seen anyhow is shown. The
// result is a VectorDrawing, for an image, an SVG with a layer each, or a page.
#pragma once

#include <string>

#include "host/picture/image.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

// Of every picture of a difference. Missing is an orange of Okabe and Ito (2008).
namespace difference_colours {
inline constexpr Colour agreed{110, 110, 110};
inline constexpr Colour missing{213, 94, 0};
inline constexpr Colour extra{0, 90, 200};
}  // namespace difference_colours

// Printable ASCII; small letters are shown as capitals.
struct OverlayCaption {
  std::string title;
  std::string agreed = "agreed";
  std::string missing = "missing";
  std::string extra = "extra";
};

struct Overlay {
  VectorDrawing drawing;  // layers legend, agreed, missing, extra
  double pen = 1;         // in the drawing's units, a whole number
};

// The part of the screen from low to high, ends included, becomes 1024 units wide.
[[nodiscard]] Overlay overlay_of(const LineDifference& difference, const PixelPoint& low,
                                 const PixelPoint& high, const OverlayCaption& caption);
// Pixels that are not 0 are lit; those lit in both but with different values count as extra. Both grids of
// the same size (precondition).
[[nodiscard]] Overlay overlay_of(const PixelGrid& truth, const PixelGrid& drawn,
                                 const OverlayCaption& caption);

// A pixel a unit, with the pen's width around: 1027 pixels wide for lines.
[[nodiscard]] Image overlay_image(const Overlay& overlay);
// 200 mm wide.
[[nodiscard]] std::string overlay_svg(const Overlay& overlay, const std::string& title);

}  // namespace sightline::picture
