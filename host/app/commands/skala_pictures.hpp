// The files that `sightline skala` and `sightline demo` write for a picture by Skala's program, and the names of their contents.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/picture/raster_image.hpp"
#include "host/programs/skala/skala.hpp"

namespace sightline::app {

struct SkalaRequest {
  std::string name;  // of the function, in messages and titles
  programs::skala::Order order;
};

// "EF9365 board", "ALT-256 board", "CalComp 565", "Minigraf 0507".
[[nodiscard]] std::string_view name_of(programs::skala::Device device);
// "hidden lines", "shaded surface", "contours"
[[nodiscard]] std::string_view name_of(algorithms::skala::Subject picture);

// Greys for a surface, colours for everything else.
[[nodiscard]] picture::RasterPalette usual_palette(algorithms::skala::Subject picture);

struct SkalaFiles {
  std::string directory;  // created if necessary
  std::string stem;
  picture::RasterPalette palette = picture::RasterPalette::colour;
  int scale = 3;  // pixels per point
};

// Writes DIRECTORY/STEM.png, for a plotter also .svg and .hpgl; none if one cannot be opened. Returns the paths. Error io.
std::vector<std::string> write_skala_pictures(const SkalaFiles& files, const SkalaRequest& request,
                                              const programs::skala::Outcome& outcome);

}  // namespace sightline::app
