// The files that `sightline jones` and `sightline demo` write of a run: one complete pass of the display as a crisp raster and as
// a drawing, and a photograph of the screen.
#pragma once

#include <string>
#include <vector>

#include "host/programs/jones/jones.hpp"

namespace sightline::app {

// "house, Jones 1971 on the PDP-7 with EAE": the title of its pictures.
[[nodiscard]] std::string title_of(const std::string& scene_name, bool eae);

// What the photograph needs: the shutter stands open this long.
inline constexpr core::Duration photograph_time = core::milliseconds(200);

// Writes DIRECTORY/STEM.png, .svg and, of an outcome with a photograph, -phosphor.png; makes the directory. Returns the paths.
// Error io.
std::vector<std::string> write_jones_pictures(const std::string& directory, const std::string& stem, const std::string& title,
                                              const programs::jones::Outcome& outcome);

}  // namespace sightline::app
