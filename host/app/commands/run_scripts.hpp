// The texts a run reads: register settings, seconds, and the scripts of what a person does at the console in
// time.
//
// A script is a text of lines `SECONDS WHAT`; SECONDS is emulated time from the start of the run, a decimal
// number. Empty lines and lines that begin with # are passed over.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/time.hpp"
#include "host/guests/run/pdp7.hpp"

namespace sightline::app {

// "NAME=OCTAL", NAME one of PC AC L MQ SC SR ION in either case. Failure usage. `core_words` bounds PC.
void set_register(harness::RegisterSettings& registers, const std::string& text, std::uint32_t core_words);

// A decimal number of emulated seconds, 0 to 9e9, to the nearest nanosecond. Failure usage.
[[nodiscard]] core::Instant seconds_argument(std::string_view option, std::string_view text);

// A whole decimal number. Failure usage.
[[nodiscard]] std::uint64_t count_argument(std::string_view option, std::string_view text);

// WHAT is the octal value of the AC switches from then on; # begins a comment anywhere. Failure bad_input.
[[nodiscard]] std::vector<pdp7::SwitchSetting> read_switch_script(std::string_view text,
                                                                  const std::string& file);

// WHAT is what is typed, from the first character after one blank to the end of the line; \r \n \t \\ and
// \NNN (octal) stand for codes. Nothing follows by itself. Failure bad_input.
[[nodiscard]] std::vector<harness::KeyPress> read_keyboard_script(std::string_view text,
                                                                  const std::string& file);

// WHAT is `X Y [RADIUS]`, decimal display points, or `off`: from then on the pen sees the square of RADIUS (4
// if not given) points around (X, Y), as far as it is on the screen, or nothing; # begins a comment anywhere.
// Failure bad_input.
[[nodiscard]] std::vector<harness::PenMove> read_light_pen_script(std::string_view text,
                                                                  const std::string& file);

}  // namespace sightline::app
