// What `sightline turn`, `spin --tape` and `demo` share: a scene made into a tape for the PDP-7, and a turn of it with hidden
// lines and as a wire frame.
#pragma once

#include <cstdint>
#include <string>

#include "host/programs/turn/session.hpp"
#include "host/programs/turn/tape.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

// `source` names the scene in errors. Error bad_input: the model does not fit, by how many words.
[[nodiscard]] programs::turn::Tape turn_tape(const scene::PolyScene& scene, const std::string& source, bool large,
                                           bool tilted = true);
// As punched. Error as turn_tape, or io.
void write_turn_tape(const scene::PolyScene& scene, const std::string& source, bool large, const std::string& path);

using programs::turn::TurnMeasure;
// One turn at the step that takes nearest to 8 s, or so many pictures of it. Error differs: a picture is not its twin's;
// guest_failed: the machine stopped.
[[nodiscard]] TurnMeasure measure_turn(const programs::turn::Session& session, const std::string& source,
                                       std::uint32_t pictures, bool keep_strokes);

}  // namespace sightline::app
