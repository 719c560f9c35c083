// The stroke log: one text line per flash, `t_ns x y intensity address`.
//
// Time, coordinates and intensity are decimal; the address is a core address of five octal digits. There is one space
// between fields and one line feed after each line. Passes are not marked.
#pragma once

#include <string>

#include "emulators/core/stroke.hpp"

namespace sightline::picture {

// Includes the line feed.
void append_stroke_line(std::string& text, const core::Stroke& stroke);

}  // namespace sightline::picture
