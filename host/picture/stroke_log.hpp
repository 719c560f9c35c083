// The stroke log: a text line for every flash, `t_ns x y intensity address`.
//
// Time, coordinates and intensity are decimal counts; the address is a core address and stands
// in octal, five digits. One space between fields, one line feed after each line, nothing else. Passes are
// not marked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "host/base/result.hpp"

namespace sightline::picture {

// With its line feed.
void append_stroke_line(std::string& text, const core::Stroke& stroke);

// `name` names the file in error messages. Every line must be exactly as written above; values must fit
// the display (x and y 0..1023, intensity 0..7, address up to 77777 octal).
[[nodiscard]] base::Result<std::vector<core::Stroke>> parse_stroke_log(std::string_view text,
                                                                       const std::string& name);

}  // namespace sightline::picture
