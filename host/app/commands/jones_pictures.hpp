// The pictures of a run that `sightline jones` and `sightline demo` write: one complete pass of the display as a raster and as a
// drawing, and a photograph of the screen.
#pragma once

#include <string>
#include <vector>

#include "host/programs/jones/jones.hpp"

namespace sightline::app {

// The title of the pictures: "house, Jones 1971 on the PDP-7 with EAE".
[[nodiscard]] std::string title_of(const std::string& scene_name, bool eae);

// The exposure time of the photograph.
inline constexpr core::Duration photograph_time = core::milliseconds(200);

// Writes DIRECTORY/STEM.png, .svg, if the outcome has a photograph -phosphor.png and if it has a film .apng; creates the directory. Returns the
// paths. Error io.
std::vector<std::string> write_jones_pictures(const std::string& directory, const std::string& stem, const std::string& title,
                                              const programs::jones::Outcome& outcome);

}  // namespace sightline::app
