// The symbolic source tape of a scene: what is assembled after the program and loaded into core with it ("A
// symbolic source tape prepared with the aid of the diagram is assembled and loaded into core together with
// the program").
#pragma once

#include <string>

#include "host/base/result.hpp"
#include "host/guests/jones/encode.hpp"

namespace sightline::guests::jones {

// PDP-7 symbolic source of encode(scene, options), one word a line, numbers in octal, decimal in the
// comments; tags scene, c0.., o0... The first line is a comment with the scene's name and counts. Errors are
// those of encode.
[[nodiscard]] base::Result<std::string> write_tape(const scene::CellScene& scene, const TapeOptions& options = {});

}  // namespace sightline::guests::jones
