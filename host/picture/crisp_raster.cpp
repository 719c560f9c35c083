// See crisp_raster.hpp.
#include "host/picture/crisp_raster.hpp"

#include "host/picture/stroke_sinks.hpp"

namespace sightline::picture {

Image crisp_raster(std::span<const core::Stroke> strokes) {
  Image image(screen_points, screen_points, 1);
  for (const core::Stroke& stroke : strokes) {
    if (on_screen(stroke)) image.pixels[image.index(stroke.x, screen_points - 1 - stroke.y)] = 255;
  }
  return image;
}

}  // namespace sightline::picture
