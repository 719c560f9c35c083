// The files that a run of Jones's program leaves: one complete pass of the display as a crisp raster and as a drawing,
// the photograph of the screen, and the display file itself.
#pragma once

#include <string>
#include <vector>

#include "host/harness/jones_guest.hpp"

namespace sightline::app {

// What the photograph needs: the shutter stands open this long.
inline constexpr core::Duration photograph_time = std::chrono::milliseconds(200);

// Writes DIRECTORY/STEM.png, -phosphor.png and .svg; makes the directory. Returns the paths. Failure io.
std::vector<std::string> write_jones_pictures(const std::string& directory, const std::string& stem,
                                              const std::string& title, const harness::jones::GuestRun& run);

// A scene's name as part of a file name: anything but letters, digits, - and _ becomes _.
[[nodiscard]] std::string file_stem(const std::string& scene_name);

}  // namespace sightline::app
