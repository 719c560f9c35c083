// What `sightline skala` and `sightline demo` share: a picture ordered from the 8080, compared with its
// native twin, and the files it leaves.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/programs/skala/session.hpp"
#include "host/programs/skala/view.hpp"
#include "host/picture/raster_image.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::app {

struct SkalaRequest {
  std::string name;  // of the function, as messages and titles show it
  scene::HeightGrid grid;
  programs::skala::View view;
  programs::skala::Link link = programs::skala::Link::parallel;
  core::ClockRate clock{};
  bool measure_visibility = true;  // by a second run without the test
};

struct SkalaOutcome {
  programs::skala::GuestPicture picture;
  std::size_t bytes = 0;  // of the command stream
  std::uint64_t points_walked = 0;
  std::uint64_t points_lit = 0;
  programs::skala::PlotterWork plotter;  // nothing on a raster board
  // How much longer than without the visibility test, in per cent; below 0 if not. Empty if the order is
  // without the test itself, or if nothing is drawn.
  std::optional<double> visibility_cost;
};

// Runs the program, and where asked again without the visibility test. Error program_failed: it did not
// end, stopped with an error or did what a device does not allow. Error differs: its picture is not its
// twin's, which is a defect of this program.
[[nodiscard]] SkalaOutcome run_skala_request(const programs::skala::Session& session,
                                             const SkalaRequest& order);

// "EF9365 board", "ALT-256 board", "CalComp 565", "Minigraf 0507".
[[nodiscard]] std::string_view name_of(programs::skala::Device device);
// "hidden lines", "shaded surface", "contours"
[[nodiscard]] std::string_view name_of(programs::skala::PictureKind picture);

// Greys for a surface, colours for everything else.
[[nodiscard]] picture::RasterPalette usual_palette(programs::skala::PictureKind picture);

struct SkalaFiles {
  std::string directory;  // made if it is not there
  std::string stem;
  picture::RasterPalette palette = picture::RasterPalette::colour;
  int scale = 3;  // pixels a point
};

// DIRECTORY/STEM.png, for a plotter also .svg and .hpgl: none if one cannot be opened. Returns the paths.
// Error io.
std::vector<std::string> write_skala_pictures(const SkalaFiles& files, const SkalaRequest& order,
                                              const SkalaOutcome& outcome);

}  // namespace sightline::app
