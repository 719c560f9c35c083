// Scripts of console actions: switches, keys and the light pen of a PDP-7 at given times.
//
// A script is a text of lines `SECONDS WHAT`; SECONDS is emulated time from the start of the run, a decimal
// number. Empty lines and lines that begin with # are passed over. A malformed script is refused with its file
// and line.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "emulators/core/time.hpp"
#include "emulators/pdp7/console.hpp"
#include "emulators/type340/display.hpp"
#include "host/machines/machine.hpp"

namespace sightline::machines {

struct KeyPress {
  core::Instant time;
  std::uint8_t code;  // 7 bits
};

// Someone holds the light pen elsewhere: at the first instruction boundary at or after `time`.
struct PenMove {
  core::Instant time;
  std::optional<type340::LightPen> pen;  // nullopt: taken away
};

// To the nearest nanosecond; empty if the text is malformed.
[[nodiscard]] std::optional<core::Instant> parse_seconds(std::string_view text);
inline constexpr std::string_view seconds_expected = "a decimal number of seconds from 0 to 9000000000";

// WHAT is the octal value of the AC switches from then on; # begins a comment anywhere.
[[nodiscard]] Result<Done> read_switches(const Input& script, std::vector<pdp7::SwitchSetting>& settings);

// WHAT is what is typed, from the first character after one blank to the end of the line; \r \n \t \\ and
// \NNN (octal) stand for codes. Nothing follows by itself.
[[nodiscard]] Result<Done> read_keyboard(const Input& script, std::vector<KeyPress>& keys);

// WHAT is `X Y [RADIUS]`, decimal display points, or `off`: from then on the pen sees the square of RADIUS (4
// if not given) points around (X, Y), as far as it is on the screen, or nothing; # begins a comment anywhere.
[[nodiscard]] Result<Done> read_light_pen(const Input& script, std::vector<PenMove>& moves);

}  // namespace sightline::machines
