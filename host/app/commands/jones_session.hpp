// What `sightline jones` and `sightline demo` share: the session of a scene, what is said of a run, and the
// files it leaves - one complete pass of the display as a crisp raster and as a drawing, and a
// photograph of the screen.
#pragma once

#include <string>
#include <vector>

#include "host/programs/jones/session.hpp"

namespace sightline::app {

// `source` names the scene in errors. Error bad_input: the eye is nowhere, or the scene does not fit into
// core.
[[nodiscard]] programs::jones::Session session_of(const scene::CellScene& scene, const std::string& source,
                                                const programs::jones::ProgramOptions& options);

// Error differs: the last view is not its twin's, which is a defect of this program.
void require_twin(const programs::jones::CheckedRun& run, const std::string& source);

// "house, Jones 1971 on the PDP-7 with EAE": the title of its pictures.
[[nodiscard]] std::string title_of(const std::string& scene_name, bool eae);

[[nodiscard]] double seconds(core::Duration time);
// 0 if no refresh was seen.
[[nodiscard]] double refreshes_per_second(const programs::jones::GuestRun& run);

// What the photograph needs: the shutter stands open this long.
inline constexpr core::Duration photograph_time = core::milliseconds(200);

// Writes DIRECTORY/STEM.png, -phosphor.png and .svg; makes the directory. Returns the paths. Error io.
std::vector<std::string> write_jones_pictures(const std::string& directory, const std::string& stem,
                                              const std::string& title, const programs::jones::GuestRun& run);

// A scene's name as part of a file name: anything but letters, digits, - and _ becomes _.
[[nodiscard]] std::string file_stem(const std::string& scene_name);

}  // namespace sightline::app
