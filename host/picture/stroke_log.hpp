// The stroke log: a text line for every flash, `t_ns x y intensity address`.
//
// Time, coordinates and intensity are decimal counts; the address is a core address and stands
// in octal, five digits. One space between fields, one line feed after each line, nothing else. Passes are
// not marked.
#pragma once

#include <string>

#include "emulators/core/stroke.hpp"

namespace sightline::picture {

// With its line feed.
void append_stroke_line(std::string& text, const core::Stroke& stroke);

}  // namespace sightline::picture
