// Scripts of console actions: switches, keys and the light pen of a PDP-7 at given times.
//
// A script is a text of lines `SECONDS WHAT`; SECONDS is emulated time from the start of the run, a decimal number. Empty
// lines and lines that begin with # are ignored. An error in a script names its file and line.
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

// Moves the light pen at the first instruction boundary at or after `time`.
struct PenMove {
  core::Instant time;
  std::optional<type340::LightPen> pen;  // nullopt: removed
};

// To the nearest nanosecond; nullopt if the text is malformed.
[[nodiscard]] std::optional<core::Instant> parse_seconds(std::string_view text);
inline constexpr std::string_view seconds_expected = "a decimal number of seconds from 0 to 9000000000";

// WHAT is the new octal value of the AC switches; # begins a comment anywhere.
[[nodiscard]] Result<Done> read_switches(const Input& script, std::vector<pdp7::SwitchSetting>& settings);

// WHAT is the typed text, from the first character after one blank to the end of the line, with the escapes \r \n \t \\ and
// \NNN (octal). No line end is added.
[[nodiscard]] Result<Done> read_keyboard(const Input& script, std::vector<KeyPress>& keys);

// WHAT is `X Y [RADIUS]`, decimal display points, or `off`: from then on the pen sees the square of RADIUS (default 4)
// points around (X, Y), clipped to the screen, or nothing; # begins a comment anywhere.
[[nodiscard]] Result<Done> read_light_pen(const Input& script, std::vector<PenMove>& moves);

}  // namespace sightline::machines
